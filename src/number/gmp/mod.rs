//! The numbers over GMP and MPFR: everything that needs a C compiler to build.

mod anchor;
mod astro;
mod ball;
mod binary;
mod burst;
#[cfg(feature = "study")]
mod complex;
mod decimal;
mod exact;
mod magnitude;
mod mpfr;
mod rational;
mod stumpff;
mod surd;

pub use anchor::{Anchor, arctangent};
pub use ball::Ball;
pub use binary::Binary;
pub use decimal::{Decimal, ParseDecimalError, Rounded, bits_of};
pub use exact::{ExactNumber, ParseExactError};
pub use magnitude::Magnitude;
pub use rational::rational_like;
pub use surd::Surd;

use super::{Angle, AstroInterval, Enclosure, ExactField, Field, Real, Ternary};
