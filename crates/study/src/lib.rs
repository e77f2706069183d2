//! Measured, not proved: error against run time, and what is lost where the problem is hard.
//!
//! | file | what it does |
//! |---|---|
//! | `task` | what is computed: systems with exact parameters |
//! | `newton`, `closed`, `double_double`, `static_programme` | how others would compute it |
//! | `condition` | what the problem itself loses |
//! | `cases` | the problems that are measured |
//! | `accuracy` | every method on every case, at every precision |
//! | `stability` | ladders of distances towards each limit |
//! | `limits`, `target` | the limits, and a problem next to one |
//! | `enclosure` | the truth: a proved box at a higher precision; and the error of a value |
//! | `row` | what is measured of one method on one case |
//! | `accuracy_figures`, `stability_figure` | what was measured, as figures |
//!
//! Every error is the distance to a certified enclosure, never to another float.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod accuracy;
pub mod accuracy_figures;
pub mod cases;
pub mod closed;
pub mod condition;
pub mod double_double;
pub mod enclosure;
pub mod limits;
pub mod newton;
pub mod row;
pub mod stability;
pub mod stability_figure;
pub mod static_programme;
mod target;
mod task;

pub use couplet_draw::picture::figure;
pub use task::Task;

use couplet_check::{arch, problem};
use couplet_number::number;
use couplet_prove::{certify, prover};
use couplet_solve as solve;
