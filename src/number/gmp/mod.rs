//! The numbers over GMP and MPFR: everything that needs a C compiler to build.

mod anchor;
mod astro;
mod ball;
mod binary;
mod burst;
#[cfg(feature = "study")]
mod complex;
mod expansion;
mod hexadecimal;
mod magnitude;
mod mpfr;
mod rational;
mod rounded;
mod stumpff;
mod surd;

pub use anchor::{Anchor, arctangent};
pub use ball::Ball;
pub use binary::Binary;
pub use hexadecimal::hexadecimal;
pub use magnitude::Magnitude;
pub use rational::rational_like;
pub use rounded::{Rounded, bits_of, terminating};
pub use surd::Surd;

use super::{Angle, AstroInterval, Enclosure, ExactField, Field, Real, Ternary};
