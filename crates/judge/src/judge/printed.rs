//! A printed number against the true value: the error, and how good the last place is.

use super::comparable::Comparable;
use super::printed_rational::PrintedRational;
use crate::number::{Ball, Decimal, ExactNumber, Rounded, Ternary, hexadecimal, worded};
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

/// A printed number as it is meant: its value, the units of its last place in one, and how many digits it has.
#[derive(Clone, Debug)]
pub(super) struct PrintedNumber {
    pub(super) value: PrintedRational,
    pub(super) per_unit: PrintedRational,
    pub(super) digits: usize,
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
        let per_unit = PrintedRational::power_of_ten(-(decimal.exponent() + zeros as i64))?;
        Some(Self { value: PrintedRational::decimal(decimal), per_unit, digits: digits.len() })
    }

    /// A double in hexadecimal, whose last place is that of the double.
    pub(super) fn from_hexadecimal(text: &str) -> Option<Self> {
        let exact = ExactNumber::rational(hexadecimal(text)?);
        let (value, per_unit) = (exact.to_rational(), spacings_in_one(exact.nearest_double()?)?);
        let digits = Rounded::from_rational(&value, DOUBLE_DIGITS)?.value.significant_digits();
        Some(Self { value: PrintedRational::Long(value), per_unit, digits: digits.max(1) })
    }
}

/// The digits that tell a double.
const DOUBLE_DIGITS: usize = 17;

/// The units in the last place of a double that make one; none for what is infinite.
pub(super) fn spacings_in_one(x: f64) -> Option<PrintedRational> {
    // A subnormal number has the exponent of the smallest normal ones.
    let biased = ((x.abs().to_bits() >> 52) as i32).max(1);
    x.is_finite().then(|| PrintedRational::power_of_two(1075 - biased))
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
    let place = size.magnitude();
    // Half a unit of the k-th digit is 5 of the place behind it.
    let more = error.against(size, 5, place - 1)?.is_gt();
    Some(usize::try_from(magnitude - place - i64::from(more)).unwrap_or(0))
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
    pub(super) fn error_of(&self, printed: &PrintedRational) -> Self {
        match self {
            Self::Exact(truth) => Self::Exact(printed.to_rational() - truth),
            Self::Enclosed(truth) => Self::Enclosed(truth.rational(printed) - truth),
        }
    }

    /// Error in a unit of which so many are one.
    pub(super) fn times(&self, per_unit: &PrintedRational) -> Self {
        match self {
            Self::Exact(error) => Self::Exact(per_unit.to_rational() * error),
            Self::Enclosed(error) => Self::Enclosed(error.rational(per_unit) * error),
        }
    }

    /// Verdict on the last place, of an error in its units, whose size is given; `None` asks for a narrower enclosure.
    pub(super) fn verdict(&self, size: &Decimal) -> Option<PrintedVerdict> {
        Some(match self.against(size, 5, -1)? {
            Ordering::Less | Ordering::Equal => PrintedVerdict::CorrectlyRounded,
            _ if self.against(size, 1, 0)?.is_lt() => PrintedVerdict::Faithful,
            _ => PrintedVerdict::Wrong,
        })
    }

    /// Order of the size of the error, which is `size` to three digits, and a digit of a decimal place. An enclosure
    /// never decides a tie.
    fn against(&self, size: &Decimal, digit: u8, place: i64) -> Option<Ordering> {
        // Both have three digits at most, and rounding keeps the order: only equals tell nothing.
        let rounded = match size.digits().trim_end_matches('0').as_bytes() {
            [] => Ordering::Less,
            leading => size.magnitude().cmp(&(place + 1)).then(leading.cmp(&[b'0' + digit])),
        };
        if rounded.is_ne() {
            return Some(rounded);
        }
        let (digit, power) =
            (PrintedRational::integer(digit.into()), PrintedRational::power_of_ten(place)?);
        match self {
            Self::Exact(error) => {
                Some(error.clone().abs().cmp(&(digit.to_rational() * power.to_rational())))
            }
            Self::Enclosed(error) => {
                let limit = error.rational(&digit) * error.rational(&power);
                let is_below = error.is_less_than(&limit).and((-limit).is_less_than(error));
                Some(if decided(is_below)? { Ordering::Less } else { Ordering::Greater })
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
        let verdict = |n: i32, d: i32| {
            let error = KnownValue::<Ball>::Exact(Rational::from((n, d)));
            error.verdict(&error.shown().unwrap()).unwrap()
        };
        assert_eq!(verdict(1, 2), PrintedVerdict::CorrectlyRounded);
        assert_eq!(verdict(-1, 2), PrintedVerdict::CorrectlyRounded);
        assert_eq!(verdict(501, 1000), PrintedVerdict::Faithful);
        assert_eq!(verdict(-501, 1000), PrintedVerdict::Faithful);
        assert_eq!(verdict(1, 1), PrintedVerdict::Wrong);
        let above = Rational::from((1, 2)) + (Rational::from(1) >> 200u32);
        let near = Ball::enclosing(&above, 256);
        let sized = KnownValue::Enclosed(near.clone()).verdict(&"0.500".parse().unwrap());
        assert_eq!(sized, Some(PrintedVerdict::Faithful), "a hair above a half");
        let tie = KnownValue::Enclosed(Ball::enclosing(&(1 - above), 256).hull(&near));
        assert_eq!(tie.verdict(&"0.5".parse().unwrap()), None);
    }

    #[test]
    fn the_last_place_of_a_double_is_its_own() {
        let unit = |x: f64| spacings_in_one(x).unwrap().to_rational().recip().to_f64();
        assert_eq!(
            (unit(1.0), unit(2.0), unit(2.0f64.next_down())),
            (2f64.powi(-52), 2f64.powi(-51), 2f64.powi(-52))
        );
        assert_eq!((unit(0.0), unit(1e-320)), (5e-324, 5e-324));
        assert!(spacings_in_one(f64::INFINITY).is_none() && spacings_in_one(f64::NAN).is_none());
        let read = PrintedNumber::from_hexadecimal("0x1.8p+1").unwrap();
        assert_eq!(
            (read.value.to_rational(), read.per_unit.to_rational()),
            (Rational::from(3), Rational::from(1) << 51)
        );
    }

    #[test]
    fn an_enclosure_decides_as_its_numbers_do() {
        let third = KnownValue::Enclosed(Ball::integer(1, 100) / Ball::integer(3, 100));
        let exact = KnownValue::Exact(Rational::from((1, 3)));
        for text in ["0.3333", "0.3334", "0.3335", "-0.3333", "0.33333333333333333333"] {
            let printed = PrintedNumber::from_decimal(&text.parse().unwrap()).unwrap();
            let error =
                |known: &KnownValue| known.error_of(&printed.value).times(&printed.per_unit);
            let verdict = |known: &KnownValue| error(known).verdict(&error(known).shown()?);
            assert_eq!(verdict(&third), verdict(&exact), "{text}");
            assert_eq!(error(&third).shown(), error(&exact).shown(), "{text}");
            assert_eq!(error(&third).order(), error(&exact).order(), "{text}");
        }
    }
}
