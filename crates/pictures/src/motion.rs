//! Words on how blocks are moved, and at which rates.

use super::Sketched;
use super::numbers::length;
use crate::atlas::{Collapse, Sketch, moved};
use crate::problem::Mode;

/// Statement of how far blocks are moved: as far as asked, or in each panel as far as they go.
pub(super) fn reached(drawn: &Sketched) -> String {
    let asked = drawn.style.amplitude;
    let by = |(sketch, collapse): (&Sketch, Option<&Collapse>)| {
        let by = moved(collapse?, &sketch.at, asked).by;
        Some(if by == asked { format!("{asked} r") } else { length(by) })
    };
    let mut all: Vec<String> = drawn.panels().filter_map(by).collect();
    all.dedup();
    all.join(", ")
}

/// The rate that is one.
pub(super) fn unit(mode: Mode) -> &'static str {
    match mode {
        Mode::Rotational | Mode::SlidingRotational => "a rotation of one at the crown",
        Mode::Sliding => "a slip of one at the shoulder",
        _ => "a rotation of one at the shoulder",
    }
}
