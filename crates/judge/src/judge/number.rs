//! One claimed number against its enclosure.

use super::claim::Claimed;
use super::comparable::Comparable;
use super::possible::Possible;
use super::printed::{KnownValue, PrintedNumber, PrintedVerdict, correct_digits, spacings_in_one};
use super::truth::Truth;
use crate::number::{Ball, Decimal, DoubleDoubleBall, ExactNumber, Rounded, nearest_double};
use crate::problem::Quantity;
use crate::prover::figure::optional;
use rug::Rational;
use std::cmp::Ordering;

/// A claimed number beside the certified one.
#[derive(Clone, Debug)]
pub struct Judged {
    /// Quantity that is judged.
    pub quantity: Quantity,
    /// Number as it is claimed.
    pub claimed: String,
    /// The true value, in the unit of the claim.
    pub certified: Certified,
    /// Errors of the claim; `None` unless both are finite.
    pub errors: Option<Errors>,
    /// Number of digits to which the claim is correct.
    pub correct_digits: CorrectDigits,
    /// Rounding of the last place; `None` unless both are finite.
    pub rounding: Option<PrintedVerdict>,
    /// True if the claim, read as a double, is the double nearest to the truth: the best that a program in
    /// double precision can print, however it rounds. `None` unless both are finite.
    pub is_nearest_double: Option<bool>,
    /// Order of the claim and the truth: below, equal or above; `None` unless both are finite.
    pub order: Option<Ordering>,
}

/// The certified value of a number: correctly rounded, with outward bounds.
pub type Certified = Possible<Rounded>;

/// Distance of a claim from the truth: each correctly rounded to three digits.
#[derive(Clone, Debug)]
pub struct Errors {
    /// `|claimed - true|`, in the unit of the claim.
    pub absolute: Decimal,
    /// Distance over the true value; `None` where that is zero and the claim is not.
    pub relative: Option<Decimal>,
    /// Error in units of the last claimed place.
    pub units: Decimal,
    /// Error in units of the last place of the double next to the true value; `None` where that is zero or
    /// beyond all doubles.
    pub ulp: Option<Decimal>,
}

/// Number of digits to which a number is correct.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CorrectDigits {
    /// The number of correct digits.
    Digits(usize),
    /// All digits that there are: the claim is exactly the truth.
    Exact,
}

impl Judged {
    /// Compares a claim with the truth; `None` asks for a narrower enclosure.
    pub(super) fn new<E: Comparable>(claimed: &Claimed, truth: Truth<E>) -> Option<Self> {
        let digits = claimed.shown_digits();
        let truth = match truth {
            Truth::Finite(known) if claimed.degrees => Truth::Finite(in_degrees(known)),
            truth => truth,
        };
        let certified = match &truth {
            Truth::Finite(known) => Certified::Finite(known.rounded(digits)?),
            Truth::Infinite => Certified::Infinite,
            Truth::Missing => Certified::Missing,
        };
        let mut judged = Self {
            quantity: claimed.quantity,
            claimed: claimed.text.clone(),
            certified,
            errors: None,
            correct_digits: CorrectDigits::Digits(0),
            rounding: None,
            is_nearest_double: None,
            order: None,
        };
        match (&claimed.value, &truth) {
            (Possible::Infinite, Truth::Infinite) | (Possible::Missing, Truth::Missing) => {
                judged.correct_digits = CorrectDigits::Exact;
            }
            (Possible::Finite(number), Truth::Finite(known)) => judged.compare(number, known)?,
            // One is a number and the other is not: no digit is correct.
            _ => {}
        }
        Some(judged)
    }

    fn compare<E: Comparable>(
        &mut self,
        number: &PrintedNumber,
        truth: &KnownValue<E>,
    ) -> Option<()> {
        let absolute = truth.error_of(&number.value);
        let in_units = absolute.times(&number.per_unit);
        let units = in_units.shown()?;
        let rounding = in_units.verdict(&units)?;
        let order = absolute.order()?;
        let size = absolute.shown()?;
        let relative = match (truth, &absolute) {
            _ if order == Ordering::Equal => Some(size.clone()),
            // Exactly one, which no enclosure decides.
            _ if number.value.is_zero() => "1".parse().ok(),
            (KnownValue::Exact(x), KnownValue::Exact(error)) if *x != 0 => {
                Some(KnownValue::<E>::Exact(Rational::from(error / x)).shown()?)
            }
            (KnownValue::Enclosed(x), KnownValue::Enclosed(error)) => {
                Some(KnownValue::Enclosed(error.clone() / x).shown()?)
            }
            _ => None,
        };
        let nearest = match truth {
            KnownValue::Exact(x) => ExactNumber::from(x).nearest_double(),
            KnownValue::Enclosed(x) => Some(x.double()?),
        };
        let is_exactly_zero = matches!(truth, KnownValue::Exact(x) if *x == 0);
        let spacings = nearest.and_then(spacings_in_one).filter(|_| !is_exactly_zero);
        let ulp = optional(spacings, |spacings| absolute.times(&spacings).shown())?;
        let rounded = self.certified.finite()?;
        self.correct_digits = match order {
            Ordering::Equal => CorrectDigits::Exact,
            _ => CorrectDigits::Digits(correct_digits(&absolute, &size, rounded)?),
        };
        self.errors = Some(Errors { absolute: size, relative, units, ulp });
        let short = DoubleDoubleBall::WHOLE.rational(&number.value);
        let long = |bits| Ball::enclosing(&number.value.to_rational(), bits);
        let double = nearest_double(short, long);
        self.is_nearest_double = Some(double.is_some() && double == nearest);
        (self.rounding, self.order) = (Some(rounding), Some(order));
        Some(())
    }

    /// Tells whether the number is right as far as it goes: exact, or the correct rounding of the truth with
    /// at least one correct digit. A zero that stands for a number below half a unit has none.
    pub fn is_correctly_rounded(&self) -> bool {
        self.is_rounded(&[PrintedVerdict::CorrectlyRounded])
    }

    /// Tells whether the number is right to the digits with which it is printed: exact, or less than one unit
    /// of its last place away, with at least one correct digit.
    pub fn is_right_as_printed(&self) -> bool {
        self.is_rounded(&[PrintedVerdict::CorrectlyRounded, PrintedVerdict::Faithful])
    }

    fn is_rounded(&self, how: &[PrintedVerdict]) -> bool {
        let has_digits = self.correct_digits > CorrectDigits::Digits(0);
        let rounded = self.rounding.is_some_and(|rounding| how.contains(&rounding));
        (rounded && has_digits) || self.correct_digits == CorrectDigits::Exact
    }

    /// Tells whether the number is a least thickness that is too small: the unsafe side.
    pub fn is_too_thin(&self) -> bool {
        self.is_least_thickness() && self.order == Some(Ordering::Less)
    }

    /// Tells whether the number is the least thickness of an arch.
    pub fn is_least_thickness(&self) -> bool {
        matches!(self.quantity, Quantity::Thickness | Quantity::LeastThickness)
    }
}

fn in_degrees<E: Comparable>(known: KnownValue<E>) -> KnownValue<E> {
    match known {
        // Only zero is known exactly, and has no unit.
        KnownValue::Exact(x) => KnownValue::Exact(x),
        KnownValue::Enclosed(x) => KnownValue::Enclosed(x.int(180) * &x / x.pi()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(text: &str, truth: &Truth) -> Judged {
        let said = super::super::Said {
            numbers: vec![(Quantity::Thrust, text, false)],
            ..Default::default()
        };
        let claim = super::super::RowClaim::read(&said).unwrap();
        Judged::new(&claim.numbers[0], truth.clone()).unwrap()
    }

    /// A third and a hair, so that no error is a round number: those no enclosure decides.
    fn third() -> Truth {
        let third = Rational::from((1, 3)) + (Rational::from(1) >> 150u32);
        Truth::Finite(KnownValue::Enclosed(Ball::enclosing(&third, 300)))
    }

    #[test]
    fn digits_and_units() {
        use CorrectDigits::Digits;
        use PrintedVerdict::{CorrectlyRounded, Faithful, Wrong};
        for (text, digits, rounding, units) in [
            ("0.333", Digits(3), CorrectlyRounded, "0.333"),
            ("0.3333333333333333", Digits(16), CorrectlyRounded, "0.333"),
            // Half a unit of the third digit is 0.0005.
            ("0.334", Digits(2), Faithful, "0.667"),
            ("0.3338", Digits(3), Wrong, "4.67"),
            ("0.335", Digits(2), Wrong, "1.67"),
            ("0.4", Digits(0), Faithful, "0.667"),
            ("0.30", Digits(1), Wrong, "3.33"),
            ("3.33", Digits(0), Wrong, "300"),
            ("-0.333", Digits(0), Wrong, "666"),
            ("0", Digits(0), CorrectlyRounded, "0.333"),
        ] {
            let found = judged(text, &third());
            assert_eq!(found.correct_digits, digits, "{text}");
            assert_eq!(found.rounding, Some(rounding), "{text}");
            assert_eq!(found.errors.unwrap().units.to_string(), units, "{text}");
        }
    }

    #[test]
    fn leading_digits_need_not_agree() {
        let truth = Truth::Finite(KnownValue::Exact(Rational::from((10_001, 10_000))));
        assert_eq!(judged("0.9999", &truth).correct_digits, CorrectDigits::Digits(4));
        assert_eq!(judged("1.0001", &truth).correct_digits, CorrectDigits::Exact);
    }

    #[test]
    fn units_of_doubles() {
        // The double next to 1/3 is (1 - 2^-54)/3, a third of 2^-54 below: a third of 2^-54 / 2^-54.
        let errors = judged(&format!("{:.60}", 1.0 / 3.0), &third()).errors.unwrap();
        assert_eq!(errors.ulp.unwrap().to_string(), "0.333");
        let tiny = Truth::Finite(KnownValue::Exact(Rational::from(3) >> 1075u32));
        assert!(judged("0", &tiny).errors.unwrap().ulp.unwrap().to_string() == "1.5");
        // The doubles below two are half as far apart as those above; the nearest is two.
        let two = Rational::from(2) - (Rational::from(1) >> 60u32);
        let below = Truth::Finite(KnownValue::Exact(two));
        let ulp = judged("2", &below).errors.unwrap().ulp.unwrap();
        assert_eq!(ulp.to_string(), "0.00195", "2^-60 in units of 2^-51");
        let huge = Truth::Finite(KnownValue::Exact(Rational::from(1) << 1024u32));
        assert!(judged("1", &huge).errors.unwrap().ulp.is_none());
    }

    #[test]
    fn the_nearest_double_whatever_its_digits() {
        let nearest = |text: &str| judged(text, &third()).is_nearest_double.unwrap();
        assert!(nearest("0.3333333333333333") && nearest(&format!("{:.40}", 1.0 / 3.0)));
        assert!(nearest("0.33333333333333330"), "which is rounded wrongly as a decimal");
        assert!(!nearest("0.333333333333333") && !nearest("0.33333333333333339"));
    }

    #[test]
    fn an_exact_zero() {
        let zero = Truth::Finite(KnownValue::Exact(Rational::new()));
        for text in ["0", "-0.0", "0e5"] {
            let found = judged(text, &zero);
            assert_eq!(found.correct_digits, CorrectDigits::Exact, "{text}");
            assert_eq!(found.errors.unwrap().relative.unwrap().to_string(), "0");
        }
        let found = judged("1e-17", &zero);
        assert_eq!(found.correct_digits, CorrectDigits::Digits(16), "decimal places count");
        assert!(found.errors.unwrap().relative.is_none());
    }

    #[test]
    fn a_zero_is_not_a_short_number() {
        assert!(judged("0.3", &third()).is_correctly_rounded());
        assert!(!judged("0", &third()).is_correctly_rounded());
        assert!(!judged("0", &third()).is_right_as_printed());
    }

    #[test]
    fn a_number_is_right_as_printed_within_a_unit_of_its_last_place() {
        let right = |text: &str| judged(text, &third()).is_right_as_printed();
        assert!(right("0.333") && right("0.334") && right("0.3"));
        assert!(!right("0.335") && !right("0.30") && !right("0.33400"));
        assert!(!right("0.4") && !right("1") && !right("1e9"), "no digit is right");
        assert!(right("0x1.5555555555555p-2") && right("0x1.5555555555556p-2"));
        assert!(!right("0x1.5555555555557p-2"));
    }

    #[test]
    fn what_is_no_number() {
        assert_eq!(judged("none", &Truth::Missing).correct_digits, CorrectDigits::Exact);
        for (text, truth) in [("none", third()), ("1", Truth::Missing), ("1", Truth::Infinite)] {
            let found = judged(text, &truth);
            assert_eq!(found.correct_digits, CorrectDigits::Digits(0));
            assert!(found.errors.is_none() && !found.is_correctly_rounded());
        }
    }

    #[test]
    fn a_wide_enclosure_decides_nothing() {
        let said = super::super::Said {
            numbers: vec![(Quantity::Thrust, "0.333", false)],
            ..Default::default()
        };
        let claim = super::super::RowClaim::read(&said).unwrap();
        let wide = KnownValue::Enclosed(Ball::integer(1, 20) / Ball::integer(3, 20));
        assert!(Judged::new(&claim.numbers[0], Truth::Finite(wide)).is_none());
    }
}
