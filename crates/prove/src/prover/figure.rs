//! A proved value with its digits.

use crate::number::{
    Ball, Binary, DoubleDoubleBall, Drawable, ExactNumber, Rounded, TripleWordBall, rounded_double,
    rounded_words, shown_as_text,
};
use crate::symbolic::Known;
use rug::Rational;
use std::fmt;

/// A proved value: decimal digits with bounds, and the nearest double.
#[derive(Clone)]
#[non_exhaustive]
pub struct Figure {
    /// Correctly rounded, with outward bounds.
    pub decimal: Rounded,
    /// The correctly rounded double.
    pub double: f64,
    /// Bounds of what that double leaves open; the quadruple is known from balls of MPFR alone.
    pub binary: Binary,
}

/// Bits enough for a quadruple.
const GUARDED: u32 = 256;

impl Figure {
    /// The value of a ball to `digits` significant digits, at least one; `None` if the ball is too wide to
    /// decide them or the double.
    pub fn new(x: &Ball, digits: usize) -> Option<Self> {
        let decimal = match x.is_zero() {
            true => Rounded::from_rational(&Rational::new(), digits)?,
            false => Rounded::from_ball(x, digits)?,
        };
        let (double, binary) = Binary::nearest(x)?;
        Some(Self { decimal, double, binary })
    }

    /// The value of a ball, decided too where it may be a decimal of so many digits.
    pub fn around(x: &Ball, digits: usize) -> Option<Self> {
        let wide = || {
            let (decimal, (double, binary)) = (Rounded::around(x, digits)?, Binary::nearest(x)?);
            Some(Self { decimal, double, binary })
        };
        Self::new(x, digits).or_else(wide)
    }

    /// The value of a ball of which `is_value` proves, exactly, whether it is the decimal next to it.
    pub(crate) fn proved(
        x: &Ball,
        digits: usize,
        is_value: impl FnOnce(&Rational) -> bool,
    ) -> Option<Self> {
        let exact = || {
            let near = Self::around(x, digits)?;
            let decimal = near.decimal.value.to_rational();
            match x.contains(&decimal) && is_value(&decimal) {
                true => Self::exact(&ExactNumber::from(decimal), digits),
                false => Some(near),
            }
        };
        Self::new(x, digits).or_else(exact)
    }

    /// A rational number to `digits` significant digits, at least one; ties to even.
    #[doc(hidden)]
    pub fn exact(x: &ExactNumber, digits: usize) -> Option<Self> {
        let ball: Ball = x.enclosure(GUARDED);
        let (decimal, double) =
            (Rounded::from_rational(&x.to_rational(), digits)?, x.nearest_double()?);
        Some(Self { decimal, double, binary: Binary::new(&ball, double) })
    }

    /// Doubles between which the true value lies.
    pub fn bounds(&self) -> [f64; 2] {
        self.binary.bounds()
    }

    /// Ball of `bits` bits about the narrower bounds: of the decimals, or of the double, which is known whatever digits
    /// are.
    pub fn enclosure(&self, bits: u32) -> Ball {
        let decimal = self.decimal.enclosure(bits);
        let bounds = self.bounds().map(Rational::from_f64);
        let [Some(lower), Some(upper)] = bounds else { return decimal };
        let [lower, upper] = [lower, upper].map(|bound| Ball::enclosing(&bound, bits));
        let double = lower.hull(&upper);
        if double.rad() < decimal.rad() { double } else { decimal }
    }
}

/// Rounds a value that may be missing; `None` if the rounding is not decided.
pub fn optional<T, U>(x: Option<T>, round: impl FnOnce(T) -> Option<U>) -> Option<Option<U>> {
    x.map_or(Some(None), |x| round(x).map(Some))
}

/// A value that has figures.
pub(crate) trait Figured {
    /// The value to `digits` significant digits, at least one; `None` if the enclosure is too wide to decide them or
    /// the double.
    fn figure(&self, digits: usize) -> Option<Figure>;
}

impl Figured for Ball {
    fn figure(&self, digits: usize) -> Option<Figure> {
        Figure::new(self, digits)
    }
}

impl Figured for Known {
    fn figure(&self, digits: usize) -> Option<Figure> {
        match self.rational() {
            Some(exact) => Figure::exact(&exact.into(), digits),
            None => Figure::around(&self.ball(), digits),
        }
    }
}

impl Figured for TripleWordBall {
    fn figure(&self, digits: usize) -> Option<Figure> {
        let (decimal, binary) = (rounded_words(self, digits), Binary::of_words(self));
        match decimal.zip(binary) {
            Some((decimal, (double, binary))) => Some(Figure { decimal, double, binary }),
            None => Figure::new(&self.to_ball(GUARDED), digits),
        }
    }
}

impl Figured for DoubleDoubleBall {
    fn figure(&self, digits: usize) -> Option<Figure> {
        // Exactly zero, as a joint at the crown.
        if self.mid().hi() == 0.0 {
            return Figure::new(&self.to_ball(64), digits);
        }
        let decimal = rounded_double(self, digits)?;
        let (double, binary) = Binary::of_double_double(self)?;
        Some(Figure { decimal, double, binary })
    }
}

shown_as_text!(Figure);

impl fmt::Display for Figure {
    /// The correctly rounded digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.decimal.value.to_string())
    }
}

#[cfg(test)]
mod tests {
    use crate::certify::state::Certify;
    use crate::number::{Ball, Rounded};
    use crate::problem::Arch;
    use rug::Rational;

    /// A state that a failed test shows is a line.
    #[test]
    fn figures_are_shown_as_they_are_written() {
        let state = Arch::parse("milankovitch", "80deg", "0.6").unwrap().least(17).unwrap();
        assert_eq!(format!("{:?}", state.thickness), "0.068650463330373536");
        assert_eq!(
            format!("{:?}", state.thickness.decimal),
            "0.068650463330373536 in [0.068650463330373535, 0.068650463330373536]"
        );
        let all = format!("{state:?}");
        assert!(all.len() < 400 && all.contains("thickness: 0.068650463330373536,"), "{all}");
    }

    #[test]
    fn bounds_hold_the_value() {
        let state = Arch::parse("milankovitch", "80deg", "0.6").unwrap().least(17).unwrap();
        let [narrow, wide] = [200, 20].map(|bits| state.thickness.enclosure(bits));
        let (decimal, [lower, upper]) = (&state.thickness.decimal, state.thickness.bounds());
        for bound in [&decimal.lower, &decimal.upper].map(|bound| bound.to_rational()) {
            assert!(narrow.contains(&bound) && wide.contains(&bound));
        }
        assert!(
            narrow.rad() < wide.rad() && lower < upper && upper == state.thickness.double.next_up()
        );
    }

    #[test]
    fn nothing_has_no_digits() {
        assert_eq!(Rounded::from_ball(&Ball::integer(3, 64), 0), None);
        assert_eq!(Rounded::from_rational(&Rational::from((1, 3)), 0), None);
        assert_eq!(Rounded::from_rational(&Rational::new(), 0), None);
    }
}
