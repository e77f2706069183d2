//! The numbers over GMP and MPFR: everything that needs a C compiler to build.

mod ball;
mod binary;
#[cfg(feature = "complex")]
mod complex;
mod complex_ball;
mod degrees;
mod expansion;
mod interval;
mod magnitude;
mod mpfr;
mod rational;
mod real;
mod rounded;
mod rounded_double;
mod short_expansion;
mod sine;
mod stumpff;
mod surd;
mod triple_word;
mod triple_word_ball;
pub(super) mod triple_word_sine;

pub use ball::Ball;
pub use binary::Binary;
pub use complex_ball::{Complex, ComplexBall};
pub use degrees::degrees;
pub use magnitude::Magnitude;
pub use rational::rational_like;
pub use rounded::{Rounded, bits_of};
pub use rounded_double::{nearest_double, rounded_double, rounded_words};
pub use sine::{SineAnchor, arctangent};
pub use stumpff::stumpff_with;
pub use surd::Surd;
pub use triple_word::TripleWord;
pub use triple_word_ball::TripleWordBall;

use super::{Angle, Decimal, Enclosure, ExactField, Field, Real, Ternary};
