//! Questions, stated once: landmarks and states, their unknowns, equations and conditions.
//!
//! | file | what it states |
//! |---|---|
//! | `equation` | the equations by their numbers, residuals and denominators |
//! | `system` | as many equations as unknowns |
//! | `landmark` | the seven landmark points |
//! | `mode` | the seven collapse modes |
//! | `line` | the lines of the map on which two of them meet |
//! | `arch` | an arch: weight, half opening, friction |
//! | [`measures`], `length` | an arch in metres, and the weight of its material; lengths with their units |
//! | `slope` | an acceleration over gravity: a ratio, or an angle |
//! | `thickness` | a thickness as it is written: a ratio, or a length |
//! | [`survey`] | all arches between measured ends, and which of them decide |
//! | [`stones`] | the joints of an arch of voussoirs |
//! | `joints`, `extent` | conditions and motions of all joints of an arch |
//! | `asymmetric` | an asymmetric solution of (19): system, conditions, quantities |
//! | [`asymmetric_region`] | of which arches one is known; what "stands" means |
//! | `problem` | a landmark or the state of an arch: system, what is given, conditions |
//! | `condition` | what makes a state admissible, and the thinnest |
//! | `verdict` | what decides that an arch does not stand |
//! | `examined`, `examined_small` | how much a state has to spare of each |
//! | `quantity`, `known` | what can be asked of a landmark or a state, and what is known of it |
//! | `named` | names, for people, files and serde |
//! | [`tally`] | counters of evaluations |
//!
//! Nothing here searches or proves; it is pure Rust.

mod arch;
mod asymmetric;
pub mod asymmetric_region;
mod condition;
mod equation;
mod examined;
mod examined_small;
mod extent;
mod joints;
mod known;
mod landmark;
mod length;
mod line;
pub mod measures;
mod mode;
mod named;
#[allow(clippy::module_inception, reason = "the room is named after its statement")]
mod problem;
mod quantity;
mod slope;
pub mod stones;
pub mod survey;
mod system;
pub mod tally;
mod thickness;
mod verdict;

pub use arch::{Arch, ArchError, Friction, is_thickness};
pub use condition::Condition;
pub use equation::Equation;
pub use examined::{
    Examined, inner_friction, inward_friction, room_for_steepest, shoulder_friction,
};
pub use examined_small::{
    ExaminedSmall, scaled_inner_friction, scaled_room_for_steepest, scaled_shoulder_friction,
};
pub use extent::Extent;
pub use joints::{JointLimit, Joints};
pub use known::Known;
pub use landmark::{Landmark, NoLandmark};
pub use line::{Line, NoLine, Sought};
pub use mode::Mode;
pub use named::{NoMode, NoQuantity};
pub use problem::Problem;
pub use quantity::Quantity;
pub use slope::{Slope, SlopeError};
pub use system::{Fixed, System};
pub use thickness::{ThicknessError, thickness};
pub use verdict::{Nearest, Standing, Verdict};
