//! What is asked, stated once: landmarks and states, their unknowns, equations and conditions.
//!
//! | file | what it states |
//! |---|---|
//! | `equation` | the equations by their numbers, residuals and denominators |
//! | `system` | as many equations as unknowns |
//! | `landmark` | the seven landmark points |
//! | `mode` | the seven collapse modes |
//! | `condition` | what makes a state admissible, and the thinnest |
//! | `quantity` | what can be asked of a landmark or a state |
//! | [`published`] | the numbers that the paper prints |
//! | [`tally`] | counters of evaluations |
//!
//! Nothing here searches or proves; it is pure Rust.

#[cfg(feature = "check")]
mod claim;
mod condition;
mod equation;
#[cfg(feature = "check")]
mod known;
mod landmark;
mod mode;
pub mod published;
mod quantity;
mod system;
pub mod tally;

#[cfg(feature = "check")]
pub use claim::{Claim, Exact, State, Subject, first_failure};
pub use condition::{conditions, inner_friction, room_for_steepest, shoulder_friction};
pub use equation::Equation;
#[cfg(feature = "check")]
pub use known::Known;
pub use landmark::Landmark;
pub use mode::Mode;
pub use quantity::Quantity;
pub use system::{Fixed, Point, System};
