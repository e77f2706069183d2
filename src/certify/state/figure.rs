//! A proved value with its digits.

use crate::number::{Ball, Binary, Rounded};
use rug::Rational;
use std::fmt;

/// A proved value: decimal digits with bounds, and the nearest double.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Figure {
    /// Correctly rounded, with outward bounds.
    pub decimal: Rounded,
    /// The correctly rounded double.
    pub double: f64,
    /// What that double leaves open.
    pub binary: Binary,
}

impl Figure {
    /// The value of a ball to `digits` significant digits, at least one; `None` if the ball is too wide to
    /// decide them or the double.
    pub fn new(x: &Ball, digits: usize) -> Option<Self> {
        let decimal = match x.mid().is_zero() && x.rad().is_zero() {
            true => Rounded::from_rational(&Rational::new(), digits)?,
            false => Rounded::from_ball(x, digits)?,
        };
        let double = x.nearest_double()?;
        Some(Self { decimal, double, binary: Binary::new(x, double) })
    }
}

impl fmt::Display for Figure {
    /// The correctly rounded digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.decimal.value.to_string())
    }
}
