//! The numbers over GMP and MPFR: everything that needs a C compiler to build.

mod anchor;
mod arctangent;
mod arctangents;
mod ball;
mod binary;
mod burst;
#[cfg(feature = "complex")]
mod complex;
mod degrees;
mod expansion;
mod gaussian;
mod hexadecimal;
mod interval;
mod lattice;
mod magnitude;
mod mpfr;
mod product;
mod rational;
mod rectangular;
mod relations;
mod rounded;
mod rounded_double;
mod small_angle;
mod splitting;
mod stumpff;
mod surd;
mod turn;

pub use anchor::Anchor;
pub use arctangent::arctangent;
pub use ball::Ball;
pub use binary::Binary;
pub use degrees::degrees;
pub use hexadecimal::hexadecimal;
pub use magnitude::Magnitude;
pub use rational::rational_like;
pub use rounded::{Rounded, bits_of, terminating};
pub use rounded_double::rounded_double;
pub use surd::Surd;

use super::{Angle, Decimal, Enclosure, ExactField, Field, Real, Ternary};
