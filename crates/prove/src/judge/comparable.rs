//! Enclosures that printed numbers are compared with: balls of MPFR, and balls of double-doubles, which cost a tenth where
//! they are enough.

use crate::certify::Undecided;
use crate::certify::state::{
    Assessment, Outcome, assessment_enclosed, decided, outcome_in_double_doubles, sliding_enclosed,
    sliding_in_double_doubles, state_enclosed,
};
use crate::number::{
    Ball, DoubleDoubleBall, Drawable, Enclosure, ExactNumber, Rounded, rounded_double,
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

    /// What holds for an arch of a thickness.
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

impl Comparable for DoubleDoubleBall {
    fn rational(&self, x: &Rational) -> Self {
        let integer = |x: &Integer| Self::of_words(*x < 0, x.as_limbs(), 0);
        match x.denom() == &1 {
            true => integer(x.numer()),
            false => integer(x.numer()) / integer(x.denom()),
        }
    }

    fn rounded(&self, digits: usize) -> Option<Rounded> {
        rounded_double(self, digits)
    }

    fn double(&self) -> Option<f64> {
        self.nearest_double()
    }

    fn is_zero(&self) -> bool {
        self.size() == 0.0
    }

    fn state(arch: &Arch, _bits: u32, frictions: bool) -> Result<Outcome<Self>, Undecided> {
        outcome_in_double_doubles(arch, frictions)
    }

    fn sliding_friction(arch: &Arch, _bits: u32) -> Result<Self, Undecided> {
        sliding_in_double_doubles(arch)
    }

    fn assessment(
        arch: &Arch,
        thickness: &ExactNumber,
        _bits: u32,
    ) -> Result<Assessment<Self>, Undecided> {
        let open = || Undecided::new("more bits are asked for");
        decided(arch, thickness).ok_or_else(open)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Field, test_config::config};
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
            let found = DoubleDoubleBall::WHOLE.rational(&x);
            prop_assert!(found.to_ball(300).contains(&x));
            prop_assert!(found.rad() <= found.mid().hi().abs() * 1e-30);
            let beside = found + found * found.ratio(1, 1 << 30) * found.ratio(1, 1 << 30);
            prop_assert!(x == 0 || !beside.to_ball(300).contains(&x), "false twin");
        }
    }
}
