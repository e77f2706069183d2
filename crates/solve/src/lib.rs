//! Finds candidates and proves nothing: what comes out of here has to go through `certify`.
//!
//! Candidates say where roots, states and lines of thrust seem to be. No proof is known here, and none can be.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

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

use couplet_check::{arch, problem};
// The room `number`, and `symbolic` where there is MPFR.
use couplet_number::*;
