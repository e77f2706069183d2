//! Upper bounds of radii: a 32-bit mantissa with an exponent that cannot overflow.
//!
//! Every operation rounds **up** unless its name says `down`. The exponent is an `i64` held within
//! ±2^40, far outside what MPFR midpoints reach (±2^30): above it a bound becomes infinite, below it
//! becomes the smallest positive bound, so nothing is ever lost.

use rug::Float;
use std::cmp::Ordering;

/// A non-negative bound `mantissa * 2^exponent`, or infinity.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Magnitude {
    /// In `[2^31, 2^32)`, or 0 for zero.
    mantissa: u32,
    exponent: i64,
}

const EXPONENT_LIMIT: i64 = 1 << 40;
const TOP_BIT: u32 = 1 << 31;

impl Magnitude {
    /// Zero.
    pub const ZERO: Self = Self { mantissa: 0, exponent: -EXPONENT_LIMIT };
    /// No bound at all.
    pub const INFINITE: Self = Self { mantissa: TOP_BIT, exponent: i64::MAX };
    const SMALLEST: Self = Self { mantissa: TOP_BIT, exponent: -EXPONENT_LIMIT };

    /// `2^exponent`.
    pub fn power_of_two(exponent: i64) -> Self {
        Self::normalised(TOP_BIT, exponent - 31, true)
    }

    /// The integer `n`, rounded up.
    pub fn from_integer(n: u64) -> Self {
        Self::round(n, 0, true)
    }

    /// The integer `n`, rounded down.
    pub fn from_integer_down(n: u64) -> Self {
        Self::round(n, 0, false)
    }

    /// The absolute value of `x`, rounded up; infinite for an infinity or NaN.
    pub fn upper(x: &Float) -> Self {
        Self::from_float(x, true)
    }

    /// The absolute value of `x`, rounded down; zero for NaN.
    pub fn lower(x: &Float) -> Self {
        Self::from_float(x, false)
    }

    fn from_float(x: &Float, up: bool) -> Self {
        if x.is_zero() || (!up && x.is_nan()) {
            return Self::ZERO;
        }
        if !x.is_finite() {
            return Self::INFINITE;
        }
        let Some((significand, exponent)) = x.get_significand().zip(x.get_exp()) else {
            return Self::INFINITE;
        };
        let Some((head, below)) = significand.as_limbs().split_last() else { return Self::ZERO };
        // The first bit of the topmost limb is set. Where it is all ones, rounding it up adds the unit too.
        #[allow(clippy::useless_conversion, reason = "elsewhere a limb has 32 bits")]
        let head = u64::from(*head);
        let unit = u64::from(up && below.iter().any(|limb| *limb != 0));
        let exponent = i64::from(exponent) - i64::from(u64::BITS - head.leading_zeros());
        Self::round(head.saturating_add(unit), exponent, up)
    }

    /// Tells whether the bound is zero.
    pub fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    /// Tells whether there is a bound.
    pub fn is_finite(self) -> bool {
        self.exponent != i64::MAX
    }

    /// Exponent `e` with `self < 2^e`; `None` for zero and infinity.
    pub fn exponent(self) -> Option<i64> {
        (!self.is_zero() && self.is_finite()).then(|| self.exponent + 32)
    }

    /// `self + other`, rounded up.
    pub fn plus(self, other: Self) -> Self {
        let (large, small) =
            if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        if small.is_zero() || !large.is_finite() {
            return large;
        }
        if large.is_zero() {
            return small;
        }
        let tail = small.aligned(large.exponent);
        Self::round((u64::from(large.mantissa) << 31) + tail, large.exponent - 31, true)
    }

    /// The bound in units of `2^(exponent - 31)`, of an exponent that is not smaller, rounded up.
    fn aligned(self, exponent: i64) -> u64 {
        let distance = exponent - self.exponent;
        if distance >= 63 { 1 } else { (u64::from(self.mantissa) << 31).div_ceil(1 << distance) }
    }

    /// `self * other`, rounded up; zero times infinity is infinite, since zero may stand for an
    /// exact midpoint next to an unbounded radius.
    pub fn times(self, other: Self) -> Self {
        if !self.is_finite() || !other.is_finite() {
            return Self::INFINITE;
        }
        self.product(other, true)
    }

    /// `self * other`, rounded down, for finite bounds.
    pub fn times_down(self, other: Self) -> Self {
        self.product(other, false)
    }

    fn product(self, other: Self, up: bool) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        let product = u64::from(self.mantissa) * u64::from(other.mantissa);
        Self::round(product, self.exponent.saturating_add(other.exponent), up)
    }

    /// `self - other`, rounded down, and zero where it would be negative.
    pub fn minus_down(self, other: Self) -> Self {
        if !other.is_finite() || self.cmp(&other) != Ordering::Greater {
            return Self::ZERO;
        }
        if other.is_zero() || !self.is_finite() {
            return self;
        }
        // `self > other`, so its exponent is at least as large.
        let tail = other.aligned(self.exponent);
        let difference = (u64::from(self.mantissa) << 31).saturating_sub(tail);
        Self::round(difference, self.exponent - 31, false)
    }

    /// `self / divisor`, rounded up; `divisor` is a **lower** bound of the true divisor.
    pub fn over(self, divisor: Self) -> Self {
        if divisor.is_zero() || !self.is_finite() {
            return Self::INFINITE;
        }
        if self.is_zero() || !divisor.is_finite() {
            return if self.is_zero() { Self::ZERO } else { Self::SMALLEST };
        }
        let quotient = (u64::from(self.mantissa) << 32).div_ceil(u64::from(divisor.mantissa));
        Self::round(quotient, self.exponent - divisor.exponent - 32, true)
    }

    /// `self * 2^shift`.
    pub fn shifted(self, shift: i64) -> Self {
        if self.is_zero() || !self.is_finite() {
            return self;
        }
        Self::normalised(self.mantissa, self.exponent.saturating_add(shift), true)
    }

    /// `self^n`, rounded up.
    pub(super) fn power(self, n: u32) -> Self {
        let bits = (0..u32::BITS - n.leading_zeros()).rev();
        bits.fold(Self::from_integer(1), |power, bit| {
            let square = power.times(power);
            if n >> bit & 1 == 1 { square.times(self) } else { square }
        })
    }

    /// The least integer that is not below the bound; `None` if it has more than 32 bits.
    pub(super) fn ceil(self) -> Option<u64> {
        let mantissa = u64::from(self.mantissa);
        match self.exponent {
            1.. => None,
            -31..=0 => Some(mantissa.div_ceil(1 << -self.exponent)),
            _ => Some(u64::from(mantissa > 0)),
        }
    }

    /// The bound as a 32-bit float, rounded up.
    pub fn to_float(self) -> Float {
        if self.is_zero() {
            return Float::with_val(32, 0);
        }
        let limit = i64::from(i32::MAX);
        if self.exponent > limit {
            return Float::with_val(32, rug::float::Special::Infinity);
        }
        let shift = self.exponent.max(-limit) as i32;
        let scaled = Float::with_val(32, self.mantissa) << shift;
        if scaled.is_zero() {
            // Below what MPFR can hold: its smallest positive number is the bound.
            let mut tiny = Float::with_val(32, 0);
            tiny.next_up();
            return tiny;
        }
        scaled
    }

    fn round(integer: u64, exponent: i64, up: bool) -> Self {
        if integer == 0 {
            return Self::ZERO;
        }
        let bits = 64 - integer.leading_zeros() as i64;
        let shift = bits - 32;
        if shift <= 0 {
            return Self::normalised(
                (integer << -shift) as u32,
                exponent.saturating_add(shift),
                up,
            );
        }
        let kept = if up { integer.div_ceil(1 << shift) } else { integer >> shift };
        if kept >> 32 == 0 {
            Self::normalised(kept as u32, exponent.saturating_add(shift), up)
        } else {
            Self::normalised(TOP_BIT, exponent.saturating_add(shift + 1), up)
        }
    }

    fn normalised(mantissa: u32, exponent: i64, up: bool) -> Self {
        if exponent > EXPONENT_LIMIT {
            if up { Self::INFINITE } else { Self { mantissa: u32::MAX, exponent: EXPONENT_LIMIT } }
        } else if exponent < -EXPONENT_LIMIT {
            if up { Self::SMALLEST } else { Self::ZERO }
        } else {
            Self { mantissa, exponent }
        }
    }
}

impl PartialOrd for Magnitude {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Magnitude {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self.is_zero(), other.is_zero()) {
            (true, true) => Ordering::Equal,
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
            _ => (self.exponent, self.mantissa).cmp(&(other.exponent, other.mantissa)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use rug::Rational;
    use rug::float::Round;

    fn exact(m: Magnitude) -> Rational {
        Rational::from(m.mantissa) << i32::try_from(m.exponent.max(-200_000)).unwrap()
    }

    fn magnitude() -> impl Strategy<Value = Magnitude> {
        let edge =
            prop_oneof![Just(u64::MAX), Just(1), Just((1 << 32) - 1), Just(1 << 32), any::<u64>()];
        prop_oneof![
            Just(Magnitude::ZERO),
            (edge, -90i64..90).prop_map(|(n, e)| Magnitude::from_integer(n).shifted(e)),
        ]
    }

    proptest! {
        #![proptest_config(crate::number::test_config::config(256))]
        #[test]
        fn every_operation_bounds_the_exact_result(a in magnitude(), b in magnitude()) {
            let (x, y) = (exact(a), exact(b));
            let slack = Rational::from((1, 1 << 30)) + 1;
            let sum = Rational::from(&x + &y);
            prop_assert!(exact(a.plus(b)) >= sum && exact(a.plus(b)) <= Rational::from(&sum * &slack));
            let product = Rational::from(&x * &y);
            prop_assert!(exact(a.times(b)) >= product && exact(a.times(b)) <= Rational::from(&product * &slack));
            prop_assert!(exact(a.times_down(b)) <= product);
            let difference = Rational::from(&x - &y);
            let down = exact(a.minus_down(b));
            prop_assert!(down == 0 || down <= difference);
            if !b.is_zero() {
                prop_assert!(exact(a.over(b)) >= Rational::from(&x / &y));
            }
            prop_assert_eq!(a.cmp(&b), x.cmp(&y));
            prop_assert!(exact(a.power(3)) >= Rational::from(&x * &x) * &x && exact(a.power(0)) == 1);
            match a.ceil() {
                Some(ceil) => prop_assert_eq!(Rational::from(ceil), x.ceil()),
                None => prop_assert!(x > u32::MAX),
            }
        }

        #[test]
        fn floats_are_bounded_on_both_sides(
            head in prop_oneof![any::<u64>(), Just(u64::MAX), any::<u32>().prop_map(|n| u64::from(n) << 32)],
            tail in prop_oneof![Just(0u64), Just(1), any::<u64>()], prec in 1u32..200, negative in any::<bool>(),
            shift in -2000i32..2000,
        ) {
            let whole = Float::with_val(128, head) << 64;
            let x = Float::with_val(prec, whole + tail) << shift;
            let value = x.to_rational().unwrap();
            let signed = if negative { -x } else { x };
            // To 32 bits, rounded once.
            let to = |round| Float::with_val_round(32, &value, round).0.to_rational().unwrap();
            prop_assert_eq!(Magnitude::upper(&signed).to_float().to_rational().unwrap(), to(Round::Up));
            prop_assert_eq!(Magnitude::lower(&signed).to_float().to_rational().unwrap(), to(Round::Down));
        }
    }

    #[test]
    fn exponents_neither_overflow_nor_vanish() {
        let huge = Magnitude::power_of_two(EXPONENT_LIMIT);
        assert!(!huge.times(huge).is_finite());
        let tiny = Magnitude::power_of_two(-EXPONENT_LIMIT);
        assert!(!tiny.times(tiny).is_zero(), "a bound never becomes zero by rounding");
        assert!(!tiny.to_float().is_zero());
        assert!(tiny.times_down(tiny).is_zero());
        assert!(!Magnitude::ZERO.times(Magnitude::INFINITE).is_finite());
        assert!(!Magnitude::upper(&Float::with_val(53, f64::NAN)).is_finite());
    }
}
