//! Strokes, axes and charts as SVG, and an arch as it is drawn: no proofs, no mathematics of its own.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod picture;
pub mod sketch;

use couplet_check::{arch, problem};
use couplet_number::number;
