//! An arch to be drawn, as data: its lines of thrust and of friction, the joints at their limits, and how it falls.
//!
//! | file | what it does |
//! |---|---|
//! | `sketch` | which arch: at its least thickness, at a landmark, or as it stands |
//! | `forces` | the forces of a state, and of an end of a range of thrusts |
//! | `range` | the crown moments that fit a thrust, where there is more than one |
//! | `stones` | the same of an arch of stones |
//! | `falling` | an arch that does not stand |
//! | `bands` | bands of lines of thrust, of all arches of a survey |
//! | `along` | the modes that a half opening passes as the friction grows |
//! | `stability` | what holds for an arch of a given thickness, of stones or not |
//!
//! Joints, contacts, rates and thrusts are enclosures of what is proved; the points of lines and of moved blocks are
//! doubles for the eye: [`sketch`](crate::sketch) computes them in any enclosure.

mod along;
mod bands;
mod falling;
mod forces;
mod range;
#[allow(clippy::module_inception, reason = "the folder is named after what it makes")]
mod sketch;
mod stability;
mod stones;

pub use crate::sketch::{Block, Moved, SketchedLine, moved};
pub use along::Passed;
pub use bands::BandedArch;
pub use sketch::{NoSketch, Sketch, Subject};
pub use stability::{Bound, Stability};

use crate::number::Ball;

/// Motion in which an arch falls in a mode.
pub type Collapse = crate::sketch::Collapse<Ball>;
/// A thrust with its lines.
pub type Forces = crate::sketch::Forces<Ball>;
/// A joint at its limit.
pub type Mark = crate::sketch::Mark<Ball>;

#[cfg(test)]
mod tests;
