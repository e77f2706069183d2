//! Enclosures that printed numbers are compared with: balls of double-doubles, of three words where these are not
//! enough, and of MPFR.

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
use rug::{Integer, Rational};

/// An enclosure that a printed number is compared with.
pub(super) trait Comparable: Enclosure {
    /// A rational number, with as many bits as this one.
    fn rational(&self, x: &Rational) -> Self;

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
    fn rational(&self, x: &Rational) -> Self {
        Self::enclosing(x, self.prec())
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
            fn rational(&self, x: &Rational) -> Self {
                let integer =
                    |x: &Integer| <$number as Midpoint>::of_words(*x < 0, x.as_limbs(), 0);
                match x.denom() == &1 {
                    true => integer(x.numer()),
                    false => integer(x.numer()) / integer(x.denom()),
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

    proptest! {
        #![proptest_config(config(2000))]

        /// Numerators and denominators of one word and of several.
        #[test]
        fn a_rational_number_is_enclosed(
            above in prop::collection::vec(any::<u64>(), 0..4), below in prop::collection::vec(1u64.., 1..4),
            negative in any::<bool>(),
        ) {
            let integer = |words: &[u64]| Integer::from_digits(words, rug::integer::Order::Lsf);
            let x = Rational::from((integer(&above), integer(&below)));
            let x = if negative { -x } else { x };
            let words = TripleWordBall::WHOLE.rational(&x);
            prop_assert!(words.to_ball(300).contains(&x) && words.rad() <= words.mid().hi().abs() * 1e-44);
            let found = DoubleDoubleBall::WHOLE.rational(&x);
            prop_assert!(found.to_ball(300).contains(&x));
            prop_assert!(found.rad() <= found.mid().hi().abs() * 1e-30);
            let beside = found + found * found.ratio(1, 1 << 30) * found.ratio(1, 1 << 30);
            prop_assert!(x == 0 || !beside.to_ball(300).contains(&x), "false twin");
        }
    }
}
