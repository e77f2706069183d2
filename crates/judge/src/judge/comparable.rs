//! Enclosures that printed numbers are compared with: balls of double-doubles, of three words where these are not
//! enough, and of MPFR.

use super::printed_rational::PrintedRational;
use crate::certify::Undecided;
use crate::certify::state::{
    Assessment, Outcome, Wanted, assessment_enclosed, decided, quick_outcome, quick_sliding,
    sliding_enclosed, state_enclosed,
};
use crate::number::{
    Ball, DoubleDouble, DoubleDoubleBall, Drawable, Enclosure, ExactNumber, FloatBall, Midpoint,
    Rounded, TripleWord, rounded_double, rounded_words,
};
use crate::problem::Arch;
use rug::Integer;

/// An enclosure that a printed number is compared with.
pub(super) trait Comparable: Enclosure {
    /// A rational number, with as many bits as this one.
    fn rational(&self, x: &PrintedRational) -> Self;

    /// The value to `digits` significant digits, correctly rounded; `None` if that is not decided.
    fn rounded(&self, digits: usize) -> Option<Rounded>;

    /// The nearest double; `None` if that is not decided.
    fn double(&self) -> Option<f64>;

    /// Tells whether the set is zero alone.
    fn is_zero(&self) -> bool;

    /// The state of an arch in numbers of `bits` bits, with the frictions at which its mode changes if they are
    /// asked for.
    fn state(arch: &Arch, bits: u32, frictions: bool) -> Result<Outcome<Self>, Undecided>;

    /// The friction of the purely sliding state.
    fn sliding_friction(arch: &Arch, bits: u32) -> Result<Self, Undecided>;

    /// Assessment of an arch of a thickness.
    fn assessment(
        arch: &Arch,
        thickness: &ExactNumber,
        bits: u32,
    ) -> Result<Assessment<Self>, Undecided>;
}

impl Comparable for Ball {
    fn rational(&self, x: &PrintedRational) -> Self {
        Self::enclosing(&x.to_rational(), self.prec())
    }

    fn rounded(&self, digits: usize) -> Option<Rounded> {
        Rounded::from_ball(self, digits)
    }

    fn double(&self) -> Option<f64> {
        self.nearest_double()
    }

    fn is_zero(&self) -> bool {
        Drawable::is_zero(self)
    }

    fn state(arch: &Arch, bits: u32, frictions: bool) -> Result<Outcome, Undecided> {
        state_enclosed(arch, bits, frictions)
    }

    fn sliding_friction(arch: &Arch, bits: u32) -> Result<Self, Undecided> {
        sliding_enclosed(arch, bits)
    }

    fn assessment(
        arch: &Arch,
        thickness: &ExactNumber,
        bits: u32,
    ) -> Result<Assessment, Undecided> {
        Ok(assessment_enclosed(arch, thickness, bits))
    }
}

/// Numbers that lead a ball, with their digits.
macro_rules! quick {
    ($($number:ty: $rounded:ident),+) => {$(
        impl Comparable for FloatBall<$number> {
            fn rational(&self, x: &PrintedRational) -> Self {
                let integer = <$number as Midpoint>::of_words;
                match x {
                    &PrintedRational::Short { negative, integer: above, scale: 1 } => integer(negative, &[above], 0),
                    &PrintedRational::Short { negative, integer: above, scale } => {
                        integer(negative, &[above], 0) / integer(false, &[scale], 0)
                    }
                    PrintedRational::Long(x) => {
                        let [above, below] = [x.numer(), x.denom()].map(Integer::as_limbs);
                        integer(*x < 0, above, 0) / integer(false, below, 0)
                    }
                }
            }

            fn rounded(&self, digits: usize) -> Option<Rounded> {
                $rounded(self, digits)
            }

            fn double(&self) -> Option<f64> {
                DoubleDoubleBall::from(*self).nearest_double()
            }

            fn is_zero(&self) -> bool {
                self.size() == 0.0
            }

            fn state(arch: &Arch, _bits: u32, frictions: bool) -> Result<Outcome<Self>, Undecided> {
                quick_outcome(arch, frictions)
            }

            fn sliding_friction(arch: &Arch, _bits: u32) -> Result<Self, Undecided> {
                quick_sliding(arch)
            }

            fn assessment(
                arch: &Arch,
                thickness: &ExactNumber,
                _bits: u32,
            ) -> Result<Assessment<Self>, Undecided> {
                let open = || Undecided::new("more bits are asked for");
                decided(arch, thickness, Wanted::Everything).ok_or_else(open)
            }
        }
    )+};
}

quick! { DoubleDouble: rounded_double, TripleWord: rounded_words }

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Field, TripleWordBall, test_config::config};
    use proptest::prelude::*;
    use rug::Rational;

    proptest! {
        #![proptest_config(config(2000))]

        /// A decimal is the same number, whether it is short or not.
        #[test]
        fn a_decimal_is_enclosed(integer in any::<i128>(), shift in 0u32..126, exponent in -30i64..20) {
            let x: crate::number::Decimal = format!("{}e{exponent}", integer >> shift).parse().unwrap();
            let short = PrintedRational::decimal(&x);
            prop_assert_eq!(short.to_rational(), x.to_rational());
            for found in [DoubleDoubleBall::WHOLE.rational(&short), DoubleDoubleBall::WHOLE.rational(&PrintedRational::Long(x.to_rational()))] {
                prop_assert!(found.to_ball(300).contains(&x.to_rational()) && found.rad() <= found.mid().hi().abs() * 1e-30);
            }
        }

        /// Numerators and denominators of one word and of several.
        #[test]
        fn a_rational_number_is_enclosed(
            above in prop::collection::vec(any::<u64>(), 0..4), below in prop::collection::vec(1u64.., 1..4),
            negative in any::<bool>(),
        ) {
            let integer = |words: &[u64]| Integer::from_digits(words, rug::integer::Order::Lsf);
            let x = Rational::from((integer(&above), integer(&below)));
            let x = if negative { -x } else { x };
            let long = PrintedRational::Long(x.clone());
            let words = TripleWordBall::WHOLE.rational(&long);
            prop_assert!(words.to_ball(300).contains(&x) && words.rad() <= words.mid().hi().abs() * 1e-44);
            let found = DoubleDoubleBall::WHOLE.rational(&long);
            prop_assert!(found.to_ball(300).contains(&x));
            prop_assert!(found.rad() <= found.mid().hi().abs() * 1e-30);
            let beside = found + found * found.ratio(1, 1 << 30) * found.ratio(1, 1 << 30);
            prop_assert!(x == 0 || !beside.to_ball(300).contains(&x), "false twin");
        }
    }
}
