//! Arches of voussoirs: for a person, CSV, and JSON (`couplet.voussoirs/1`).

mod arch;
mod convergence;
mod csv;
mod given;
mod json;
mod table;

pub use arch::{GivenThickness, VoussoirArch, VoussoirArches};
pub(crate) use csv::csv;
pub(crate) use json::json;
pub(crate) use table::table;
