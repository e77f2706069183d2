//! The crate as others have it: its library, its command and its stored files.
//!
//! One program with a module for each subject, so that it is linked once. A build without a feature has
//! the modules that do without it; `rooms` and what reads stored certificates are in nearly every build.

#[cfg(feature = "mpfr")]
mod arches;
#[cfg(feature = "mpfr")]
mod hard;
#[cfg(feature = "cli")]
#[macro_use]
mod program;
#[cfg(all(unix, feature = "study", feature = "cli"))]
mod snapshot;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod tool;

#[cfg(feature = "mpfr")]
mod branches;
#[cfg(feature = "mpfr")]
mod certificates;
#[cfg(feature = "cli")]
mod checker;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod command_line;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod complementarity;
#[cfg(feature = "check")]
mod constants;
#[cfg(feature = "mpfr")]
mod coq;
#[cfg(feature = "cli")]
mod door;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod draw;
#[cfg(feature = "mpfr")]
mod ends;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod export;
#[cfg(feature = "mpfr")]
mod identities;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod judge;
#[cfg(feature = "mpfr")]
mod landmarks;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod map;
#[cfg(feature = "mpfr")]
mod misuse;
#[cfg(feature = "mpfr")]
mod number_suite;
#[cfg(all(unix, feature = "study", feature = "cli"))]
mod outputs;
mod rooms;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod scenes;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod standing;
#[cfg(feature = "mpfr")]
mod states;
#[cfg(feature = "study")]
mod static_programme;
#[cfg(feature = "proptest")]
mod strategies;
#[cfg(feature = "parquet")]
mod sweep;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod tilt;
#[cfg(all(feature = "mpfr", feature = "cli"))]
mod voussoirs;
