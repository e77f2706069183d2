//! Finds candidates and proves nothing: what comes out of here has to go through `certify`.

pub mod asymmetric;
mod linear;
#[cfg(feature = "mpfr")]
mod mpfr;
mod newton;
mod programme;
pub mod rates;
mod standing;
pub mod start;
pub mod tilt;
mod zero;

pub use linear::{Approximate, inverse, invert, newton_step};
#[cfg(feature = "mpfr")]
pub use mpfr::*;
pub use newton::settle;
pub use standing::{StandingCandidate, standing};
