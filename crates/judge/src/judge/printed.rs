//! A printed number against the true value: the error, and how good the last place is.

use super::comparable::Comparable;
use crate::number::{
    Ball, Decimal, ExactNumber, Rounded, Ternary, hexadecimal, power_of_ten, worded,
};
use rug::Rational;
use std::cmp::Ordering;

/// Significant digits of an error.
const ERROR_DIGITS: usize = 3;

worded! {
    /// Verdict on the last printed place.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum PrintedVerdict {
        /// The error is at most half a unit of the last place.
        CorrectlyRounded = "correctly rounded",
        /// The error is below one unit.
        Faithful = "faithful",
        /// The error is one unit or more.
        Wrong = "wrong",
    }
    /// All of them, in order.
    pub const ALL;
    /// The words used in files.
    pub fn name -> &'static str;
}

/// A printed number as it is meant: its value, one unit of its last place, its digits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct PrintedNumber {
    pub(super) value: Rational,
    pub(super) unit: Rational,
    pub(super) digits: String,
}

impl PrintedNumber {
    /// A decimal, with the unit of its last written place. Zeros at the end of a whole number only show its
    /// size, as in what we write.
    pub(super) fn from_decimal(decimal: &Decimal) -> Option<Self> {
        let digits = match (decimal.exponent(), decimal.digits()) {
            (_, "") => "0",
            (0.., digits) => digits.trim_end_matches('0'),
            (_, digits) => digits,
        };
        let zeros = decimal.digits().len().saturating_sub(digits.len());
        let last = decimal.exponent() + zeros as i64;
        let unit = unit_of_place(last)?;
        Some(Self { value: decimal.to_rational(), unit, digits: digits.to_owned() })
    }

    /// A double in hexadecimal, whose last place is that of the double.
    pub(super) fn from_hexadecimal(text: &str) -> Option<Self> {
        let exact = ExactNumber::rational(hexadecimal(text)?);
        let (value, unit) = (exact.to_rational(), spacing(exact.nearest_double()?)?);
        let digits = Rounded::from_rational(&value, DOUBLE_DIGITS)?.value.digits().to_owned();
        Some(Self { value, unit, digits: if digits.is_empty() { "0".into() } else { digits } })
    }
}

/// Bits of a double, the exponent of its smallest numbers, and the digits that tell it.
const DOUBLE_BITS: i32 = 53;
const LEAST_SPACING: i32 = -1074;
const DOUBLE_DIGITS: usize = 17;

/// The unit in the last place of a double; none for what is infinite.
pub(super) fn spacing(x: f64) -> Option<Rational> {
    if !x.is_finite() {
        return None;
    }
    let exponent = rug::Float::with_val(64, x).get_exp().unwrap_or(LEAST_SPACING);
    Some(Rational::from(1) << (exponent - DOUBLE_BITS).max(LEAST_SPACING))
}

/// The most digits `k` for which an error is at most half a unit of the `k`-th significant digit of the
/// truth; where that is zero, of the `k`-th decimal place. `size` is that of the error.
pub(super) fn correct_digits<E: Comparable>(
    error: &KnownValue<E>,
    size: &Decimal,
    truth: &Rounded,
) -> Option<usize> {
    let zero = truth.value.digits().is_empty();
    let magnitude = if zero { 0 } else { truth.lower.magnitude() };
    // The size may have been rounded up to a power of ten or down from above a half of one.
    let mut digits = magnitude - size.magnitude() + 1;
    while digits > 0 {
        if error.is_within(&(unit_of_place(magnitude - digits)? / 2u32))? {
            return usize::try_from(digits).ok();
        }
        digits -= 1;
    }
    Some(0)
}

/// A unit of the decimal place of an exponent.
pub(super) fn unit_of_place(exponent: i64) -> Option<Rational> {
    let power = Rational::from(power_of_ten(u32::try_from(exponent.unsigned_abs()).ok()?));
    Some(if exponent < 0 { power.recip() } else { power })
}

/// A value that is certified, or an error in some unit, of either sign: exact, or in an enclosure.
#[derive(Clone, Debug)]
pub(super) enum KnownValue<E = Ball> {
    Exact(Rational),
    Enclosed(E),
}

impl<E: Comparable> KnownValue<E> {
    /// The value to `digits` significant digits; `None` if the rounding is not decided.
    pub(super) fn rounded(&self, digits: usize) -> Option<Rounded> {
        match self {
            Self::Exact(truth) => Rounded::from_rational(truth, digits),
            Self::Enclosed(truth) => truth.rounded(digits),
        }
    }

    /// Difference of what is printed and this.
    pub(super) fn error_of(&self, printed: &Rational) -> Self {
        match self {
            Self::Exact(truth) => Self::Exact(Rational::from(printed - truth)),
            Self::Enclosed(truth) => Self::Enclosed(truth.rational(printed) - truth),
        }
    }

    /// Error in a unit that is not zero.
    pub(super) fn over(&self, unit: &Rational) -> Self {
        match self {
            Self::Exact(error) => Self::Exact(Rational::from(error / unit)),
            Self::Enclosed(error) => Self::Enclosed(error.clone() / error.rational(unit)),
        }
    }

    /// Verdict on the last place, of an error in its units; `None` asks for a narrower enclosure.
    pub(super) fn verdict(&self) -> Option<PrintedVerdict> {
        Some(match self.is_within(&Rational::from((1, 2)))? {
            true => PrintedVerdict::CorrectlyRounded,
            false if self.is_below(&Rational::from(1))? => PrintedVerdict::Faithful,
            false => PrintedVerdict::Wrong,
        })
    }

    /// Tells whether the size of the error is at most so much. An enclosure never decides a tie.
    pub(super) fn is_within(&self, limit: &Rational) -> Option<bool> {
        match self {
            Self::Exact(error) => Some(error.clone().abs() <= *limit),
            Self::Enclosed(_) => self.is_below(limit),
        }
    }

    /// Tells whether the size of the error is less than so much.
    fn is_below(&self, limit: &Rational) -> Option<bool> {
        match self {
            Self::Exact(error) => Some(error.clone().abs() < *limit),
            Self::Enclosed(error) => {
                let limit = error.rational(limit);
                decided(error.is_less_than(&limit).and((-limit).is_less_than(error)))
            }
        }
    }

    /// Order of the error and zero. An enclosure never decides that they are equal.
    pub(super) fn order(&self) -> Option<Ordering> {
        match self {
            Self::Exact(error) => Some(error.cmp0()),
            Self::Enclosed(error) => match decided((-error.clone()).is_positive())? {
                true => Some(Ordering::Less),
                false => Some(Ordering::Greater),
            },
        }
    }

    /// Size of the error, correctly rounded to three digits; `0` where it is exactly zero.
    pub(super) fn shown(&self) -> Option<Decimal> {
        let size = match (self, self.order()?) {
            (Self::Exact(error), Ordering::Less) => Self::Exact((-error).into()),
            (Self::Enclosed(error), Ordering::Less) => Self::Enclosed(-error.clone()),
            _ => self.clone(),
        };
        Some(size.rounded(ERROR_DIGITS)?.value)
    }
}

pub(super) fn decided(answer: Ternary) -> Option<bool> {
    match answer {
        Ternary::True => Some(true),
        Ternary::False => Some(false),
        Ternary::Undecided => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verdicts_at_the_borders() {
        let verdict =
            |n: i32, d: i32| KnownValue::<Ball>::Exact(Rational::from((n, d))).verdict().unwrap();
        assert_eq!(verdict(1, 2), PrintedVerdict::CorrectlyRounded);
        assert_eq!(verdict(-1, 2), PrintedVerdict::CorrectlyRounded);
        assert_eq!(verdict(501, 1000), PrintedVerdict::Faithful);
        assert_eq!(verdict(-501, 1000), PrintedVerdict::Faithful);
        assert_eq!(verdict(1, 1), PrintedVerdict::Wrong);
        let wide = Ball::enclosing(&Rational::from((1, 2)), 256) + Ball::whole(256);
        assert_eq!(KnownValue::Enclosed(wide).verdict(), None);
    }

    #[test]
    fn the_last_place_of_a_double_is_its_own() {
        let unit = |x: f64| spacing(x).unwrap().to_f64();
        assert_eq!(
            (unit(1.0), unit(2.0), unit(2.0f64.next_down())),
            (2f64.powi(-52), 2f64.powi(-51), 2f64.powi(-52))
        );
        assert_eq!((unit(0.0), unit(1e-320)), (5e-324, 5e-324));
        assert_eq!(spacing(f64::INFINITY), None);
        let read = PrintedNumber::from_hexadecimal("0x1.8p+1").unwrap();
        assert_eq!((read.value, read.unit.to_f64()), (Rational::from(3), 2f64.powi(-51)));
    }

    #[test]
    fn an_enclosure_decides_as_its_numbers_do() {
        let third = KnownValue::Enclosed(Ball::integer(1, 100) / Ball::integer(3, 100));
        let exact = KnownValue::Exact(Rational::from((1, 3)));
        for text in ["0.3333", "0.3334", "0.3335", "-0.3333", "0.33333333333333333333"] {
            let printed = PrintedNumber::from_decimal(&text.parse().unwrap()).unwrap();
            let error = |known: &KnownValue| known.error_of(&printed.value).over(&printed.unit);
            assert_eq!(error(&third).verdict(), error(&exact).verdict(), "{text}");
            assert_eq!(error(&third).shown(), error(&exact).shown(), "{text}");
            assert_eq!(error(&third).order(), error(&exact).order(), "{text}");
        }
    }
}
