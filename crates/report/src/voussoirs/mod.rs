//! Arches of voussoirs: for a person, CSV, and JSON (`couplet.voussoirs/1`).

mod arch;
mod convergence;
mod given;
mod record;
mod words;

pub use arch::{GivenThickness, VoussoirArch, VoussoirArches};
