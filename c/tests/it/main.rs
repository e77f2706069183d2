//! The library as programs have it: those of `examples` and `programs` are compiled against it and run, each by the
//! language that it is written in, if that is installed.
//!
//! `COUPLET_C` is the folder that `make c` puts together, with `lib` and `include`, and `COUPLET` the command that
//! answers are compared with.

mod header;
#[cfg(target_os = "linux")]
mod installed;
mod languages;
mod library;
#[path = "../../../tests/it/tool.rs"]
#[allow(dead_code, reason = "the tests of couplet itself ask for more")]
mod tool;
