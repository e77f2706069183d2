//! The crate as others have it: its library, its command and its stored files.
//!
//! One program with a module for each subject, so that it is linked once. It speaks of every room, so it is built
//! with `proptest`.

mod arches;
mod hard;
mod house;
mod json;
mod program;
mod tool;

mod assemblies;
mod branches;
mod certificates;
mod command_line;
mod complementarity;
mod constants;
mod coq;
mod door;
mod draw;
mod ends;
mod equation;
mod export;
mod expressions;
mod identities;
mod judge;
mod landmarks;
mod map;
mod metadata;
mod misuse;
mod number_suite;
#[cfg(unix)]
mod outputs;
mod questions;
#[cfg(unix)]
mod reference;
mod refused;
mod rooms;
mod scenes;
mod states;
mod static_programme;
mod strategies;
#[cfg(feature = "parquet")]
mod sweep;
mod tilt;
mod voussoirs;
