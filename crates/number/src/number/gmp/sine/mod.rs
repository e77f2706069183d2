//! Sines, cosines and arctangents of many digits, quicker than MPFR's own.
//!
//! A [`SineAnchor`] turns the angle by Gaussian primes, whose arguments are computed once, until it is small; the rest
//! is a series.

mod anchor;
mod arctangent;
mod arctangents;
mod burst;
mod gaussian;
mod lattice;
mod product;
mod rectangular;
mod relations;
mod small_angle;
mod splitting;
mod turn;

pub use anchor::SineAnchor;
pub use arctangent::arctangent;

pub(super) use arctangents::known_pi;

use super::ball::fixed;
use super::{Angle, Ball, Enclosure, Field, Magnitude};
