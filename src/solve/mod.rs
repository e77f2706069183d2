//! Finds candidates and proves nothing: what comes out of here has to go through `certify`.

pub mod expansion;
mod linear;
mod newton;
mod start;
pub mod start_state;

pub use linear::inverse;
pub use newton::{newton, polish, settle};
pub use start::start;

use rug::Float;

/// Approximate values of the unknowns of a system, in its order. Nothing is known of their error.
#[derive(Clone, Debug)]
pub struct Candidate(pub Vec<Float>);
