//! An arch to be drawn, as data: its lines of thrust and of friction, the joints at their limits, and how it falls.
//!
//! | file | what it does |
//! |---|---|
//! | `sketch` | which arch: at its least thickness, at a landmark, or as it stands |
//! | `forces` | a thrust with the lines that belong to it |
//! | `range` | the crown moments that fit a thrust, where there is more than one |
//! | `line` | a line as a chain of points |
//! | `collapse` | a mode: joints, rates, twists, the balance of power |
//! | `moved` | the blocks after a finite motion |
//!
//! Joints, contacts, rates and thrusts are enclosures of what is proved; the points of lines and of moved blocks are
//! doubles for the eye.

mod collapse;
mod forces;
mod line;
mod moved;
mod range;
#[allow(clippy::module_inception, reason = "the folder is named after what it makes")]
mod sketch;

pub use collapse::Collapse;
pub use forces::{Forces, Mark};
pub use line::Line;
pub use moved::{Block, moved};
pub use sketch::{NoSketch, Sketch, Subject};

#[cfg(test)]
mod tests;
