//! A quicker arithmetic for the checker, in pure Rust: ends of intervals by malachite.
//!
//! Its algorithms are in part those of MPFR, so that it is no witness beside [`Ball`](super::Ball): what an error
//! in those would make of both is the same. [`AstroInterval`](super::AstroInterval) is the independent one.
//!
//! malachite rounds as it is asked, to precisions of any bits, and has exponents to 30 bits: beyond them a number
//! rounded down is the largest, rounded up infinite. It panics at a precision of zero, which no [`Interval`] has.

use super::end::{Direction, End};
use super::interval::Interval;
use malachite_base::num::basic::traits::{Infinity, NegativeInfinity, Zero};
use malachite_base::num::conversion::traits::{IntegerMantissaAndExponent, PowerOf2Digits};
use malachite_base::rounding_modes::RoundingMode;
use malachite_float::Float;
use malachite_nz::natural::Natural;
use std::cmp::Ordering;

/// All real numbers from one malachite number to another.
pub type MalachiteInterval = Interval<Malachite>;

/// A malachite number.
#[derive(Clone, Debug)]
pub struct Malachite(Float);

/// The largest size of a number from outside, as a power of two: half of what malachite has.
const LARGEST: i64 = 1 << 29;

fn mode(to: Direction) -> RoundingMode {
    match to {
        Direction::Down => RoundingMode::Floor,
        Direction::Up => RoundingMode::Ceiling,
    }
}

impl Malachite {
    /// Itself, rounded down, and the number above, if something was lost; `None` for what was lost beside zero.
    fn and_above(self, lost: Ordering) -> Option<(Self, Self)> {
        let mut above = self.clone();
        if lost.is_ne() {
            above.0.is_normal().then(|| above.0.increment())?;
        }
        Some((self, above))
    }
}

impl End for Malachite {
    /// Malachite's own functions are quicker at any number of bits.
    const HALVED: usize = usize::MAX;

    fn infinite(negative: bool) -> Self {
        Self(if negative { Float::NEGATIVE_INFINITY } else { Float::INFINITY })
    }

    fn dyadic(negative: bool, mantissa: &[u64], exponent: i32) -> Option<Self> {
        if mantissa.is_empty() {
            return Some(Self(Float::ZERO));
        }
        let exponent = i64::from(exponent);
        if exponent < -LARGEST || exponent + 64 * mantissa.len() as i64 > LARGEST {
            return None;
        }
        let mantissa = Natural::from_power_of_2_digits_asc(64, mantissa.iter().copied())?;
        let size = Float::from_integer_mantissa_and_exponent(mantissa, exponent)?;
        Some(Self(if negative { -size } else { size }))
    }

    fn parts(&self) -> Option<(bool, Vec<u64>, i32)> {
        if self.0.is_zero() {
            return Some((false, Vec::new(), 0));
        }
        if !self.0.is_finite() {
            return None;
        }
        let (mantissa, exponent): (Natural, i64) = (&self.0).integer_mantissa_and_exponent();
        let words = mantissa.to_power_of_2_digits_asc(64);
        Some((self.0.is_sign_negative(), words, i32::try_from(exponent).ok()?))
    }

    fn order(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }

    fn sign(&self) -> Option<Ordering> {
        self.0.partial_cmp(&0u32)
    }

    fn is_finite(&self) -> bool {
        self.0.is_finite()
    }

    fn exponent(&self) -> Option<i64> {
        self.0.get_exponent().map(i64::from)
    }

    fn negated(&self) -> Self {
        Self(-&self.0)
    }

    fn rounded(&self, prec: usize, to: Direction) -> Self {
        let mut number = self.0.clone();
        if number.get_prec().is_some_and(|bits| bits > prec as u64) {
            number.set_prec_round(prec as u64, mode(to));
        }
        Self(number)
    }

    fn plus(&self, other: &Self, prec: usize, to: Direction) -> Self {
        Self(self.0.add_prec_round_ref_ref(&other.0, prec as u64, mode(to)).0)
    }

    fn minus(&self, other: &Self, prec: usize, to: Direction) -> Self {
        Self(self.0.sub_prec_round_ref_ref(&other.0, prec as u64, mode(to)).0)
    }

    fn times(&self, other: &Self, prec: usize, to: Direction) -> Self {
        Self(self.0.mul_prec_round_ref_ref(&other.0, prec as u64, mode(to)).0)
    }

    fn over(&self, other: &Self, prec: usize, to: Direction) -> Self {
        Self(self.0.div_prec_round_ref_ref(&other.0, prec as u64, mode(to)).0)
    }

    fn root(&self, prec: usize, to: Direction) -> Self {
        Self(self.0.sqrt_prec_round_ref(prec as u64, mode(to)).0)
    }

    fn pi(prec: usize, to: Direction) -> Self {
        Self(Float::pi_prec_round(prec as u64, mode(to)).0)
    }

    fn sin_cos(&self, prec: usize) -> Option<[(Self, Self); 2]> {
        let (sin, cos, sin_lost, cos_lost) =
            self.0.sin_cos_prec_round_ref(prec as u64, RoundingMode::Floor);
        Some([Self(sin).and_above(sin_lost)?, Self(cos).and_above(cos_lost)?])
    }
}
