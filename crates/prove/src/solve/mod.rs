//! Finds candidates and proves nothing: what comes out of here has to go through `certify`.

pub mod asymmetric;
pub mod expansion;
mod linear;
mod newton;
mod programme;
pub mod rates;
mod standing;
pub mod start;
pub mod tilt;
pub mod voussoir_thrust;
pub mod voussoirs;
mod zero;

pub use linear::{Approximate, inverse, invert, newton_step};
pub use newton::{newton, settle};
pub use standing::{StandingCandidate, standing};

use rug::Float;

/// Approximate values of the unknowns of a system, in its order. Nothing is known of their error.
#[derive(Clone, Debug)]
pub struct Candidate(pub Vec<Float>);
