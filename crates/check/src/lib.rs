//! The equations of circular masonry arches with finite friction, what is asked of them, and the checker of
//! certificates: pure Rust, without a solver.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod arch;
pub mod check;
pub mod problem;

use couplet_number::number;
#[cfg(test)]
use couplet_number::symbolic;
