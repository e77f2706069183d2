//! Enclosures that are drawn: computed as such, seen as doubles.

use super::{DoubleDouble, DoubleDoubleBall, Engine};

/// An enclosure of which a picture shows a double.
pub trait Drawable: Engine {
    /// The nearest double, where the set is narrow enough to tell it, else one next to it.
    fn double(&self) -> f64;

    /// A double, with the precision of this set.
    fn of_double(&self, x: f64) -> Self;

    /// Tells whether the set holds zero and nothing else.
    fn is_zero(&self) -> bool;
}

impl Drawable for DoubleDoubleBall {
    fn double(&self) -> f64 {
        self.nearest_double().unwrap_or(self.mid().hi())
    }

    fn of_double(&self, x: f64) -> Self {
        Self::exact(DoubleDouble::exact(x))
    }

    fn is_zero(&self) -> bool {
        self.mid().hi() == 0.0 && self.rad() == 0.0
    }
}

#[cfg(feature = "mpfr")]
impl Drawable for super::Ball {
    fn double(&self) -> f64 {
        self.nearest_double().unwrap_or_else(|| self.mid().to_f64())
    }

    fn of_double(&self, x: f64) -> Self {
        Self::exact(rug::Float::with_val(53, x), self.prec())
    }

    fn is_zero(&self) -> bool {
        self.mid().is_zero() && self.rad().is_zero()
    }
}
