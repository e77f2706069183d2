//! The second arithmetic: intervals whose ends are astro-float numbers, rounded outward.
//!
//! It shares nothing with [`Ball`](super::Ball): another library (pure Rust), another way to hold a
//! set (two ends instead of midpoint and radius), another way to round (each end directly in its
//! direction). Two enclosures of one number, one from each, have to overlap.
//!
//! astro-float rounds precisions up to whole 64-bit words and reports failures as NaN; a NaN, or an
//! end on the wrong side, becomes the whole line here. Of its functions only `+ - * / sqrt sin cos`
//! and pi are used; its logarithm is known not to return for some exact arguments.

use super::{Enclosure, Field, Real, Ternary};
use astro_float::{BigFloat, Consts, INF_NEG, INF_POS, RoundingMode, Sign, WORD_BIT_SIZE, Word};
use rug::integer::Order;
use rug::{Float, Integer, Rational};
use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    /// astro-float's cache of constants; `None` only if its first allocation failed.
    static CONSTANTS: RefCell<Option<Consts>> = RefCell::new(Consts::new().ok());
}

const DOWN: RoundingMode = RoundingMode::Down;
const UP: RoundingMode = RoundingMode::Up;

/// All real numbers from `low` to `high`.
#[derive(Clone, Debug)]
pub struct AstroInterval {
    low: BigFloat,
    high: BigFloat,
    prec: usize,
}

impl AstroInterval {
    /// The integer `n`, with results to be rounded to `prec` bits (whole words).
    pub fn integer(n: i32, prec: usize) -> Self {
        let value = BigFloat::from_i32(n, WORD_BIT_SIZE);
        Self { low: value.clone(), high: value, prec: prec.max(WORD_BIT_SIZE) }
    }

    /// An interval of `prec` bits that holds the rational number `value`.
    pub fn enclosing(value: &Rational, prec: usize) -> Self {
        let point = |n: &Integer| Self::point(&from_integer(n), prec);
        point(value.numer()) / point(value.denom())
    }

    /// The interval from one MPFR number to another, both exact.
    pub fn between(low: &Float, high: &Float, prec: usize) -> Self {
        Self { low: from_float(low), high: from_float(high), prec }.checked()
    }

    /// The whole line.
    pub fn whole(prec: usize) -> Self {
        Self { low: INF_NEG, high: INF_POS, prec }
    }

    /// Both ends as exact MPFR numbers; `None` for an unbounded interval.
    pub fn ends(&self) -> Option<(Float, Float)> {
        Some((to_float(&self.low)?, to_float(&self.high)?))
    }

    fn point(value: &BigFloat, prec: usize) -> Self {
        Self { low: value.clone(), high: value.clone(), prec }.checked()
    }

    /// The interval itself if its ends are in order, the whole line otherwise.
    fn checked(self) -> Self {
        let ordered = self.low.cmp(&self.high).is_some_and(|order| order <= 0);
        if !ordered || self.low.is_inf_pos() || self.high.is_inf_neg() {
            return Self::whole(self.prec);
        }
        self
    }

    fn is_non_negative(&self) -> bool {
        self.low.is_zero() || self.low.is_positive()
    }

    fn is_non_positive(&self) -> bool {
        self.high.is_zero() || self.high.is_negative()
    }

    fn corners(&self, other: &Self) -> Self {
        let prec = self.prec;
        let ends = [
            (&self.low, &other.low),
            (&self.low, &other.high),
            (&self.high, &other.low),
            (&self.high, &other.high),
        ];
        let pick = |round, better: fn(&BigFloat, &BigFloat) -> BigFloat| {
            ends.iter()
                .map(|(a, b)| a.mul(b, prec, round))
                .reduce(|best, next| better(&best, &next))
                .expect("four corners")
        };
        Self { low: pick(DOWN, BigFloat::min), high: pick(UP, BigFloat::max), prec }.checked()
    }
}

impl Field for AstroInterval {
    fn int(&self, n: i32) -> Self {
        Self::integer(n, self.prec)
    }

    fn square(&self) -> Self {
        if self.is_non_negative() {
            let prec = self.prec;
            let (low, high) =
                (self.low.mul(&self.low, prec, DOWN), self.high.mul(&self.high, prec, UP));
            return Self { low, high, prec }.checked();
        }
        if self.is_non_positive() {
            return (-self.clone()).square();
        }
        let product = self.corners(self);
        Self { low: BigFloat::from_i32(0, WORD_BIT_SIZE), ..product }
    }
}

impl Real for AstroInterval {
    fn pi(&self) -> Self {
        let prec = self.prec;
        with_constants(|cc| Self { low: cc.pi(prec, DOWN), high: cc.pi(prec, UP), prec }.checked())
            .unwrap_or_else(|| Self::whole(prec))
    }

    fn sqrt(&self) -> Self {
        if !self.is_non_negative() {
            return Self::whole(self.prec);
        }
        let (low, high) = (self.low.sqrt(self.prec, DOWN), self.high.sqrt(self.prec, UP));
        Self { low, high, prec: self.prec }.checked()
    }

    /// Sine and cosine at the lower end, widened by the width: neither has a slope above one.
    fn sin_cos(&self) -> (Self, Self) {
        let prec = self.prec;
        let one = BigFloat::from_i32(1, WORD_BIT_SIZE);
        let unit = Self { low: BigFloat::from_i32(-1, WORD_BIT_SIZE), high: one, prec };
        let reducible = self.low.exponent().is_some_and(|e| i64::from(e) <= prec as i64 + 64);
        if !self.is_bounded() || !reducible {
            return (unit.clone(), unit);
        }
        let width = self.high.sub(&self.low, prec, UP);
        let image = |at: &dyn Fn(RoundingMode, &mut Consts) -> BigFloat| {
            let ends = with_constants(|cc| (at(DOWN, cc), at(UP, cc)));
            let Some((low, high)) = ends else { return unit.clone() };
            let low = low.sub(&width, prec, DOWN).max(&unit.low);
            let high = high.add(&width, prec, UP).min(&unit.high);
            Self { low, high, prec }.checked()
        };
        let at = &self.low;
        (image(&|round, cc| at.sin(prec, round, cc)), image(&|round, cc| at.cos(prec, round, cc)))
    }
}

impl Enclosure for AstroInterval {
    fn is_positive(&self) -> Ternary {
        if self.low.is_positive() && !self.low.is_zero() {
            Ternary::True
        } else if self.is_non_positive() {
            Ternary::False
        } else {
            Ternary::Undecided
        }
    }

    fn is_bounded(&self) -> bool {
        let bounded = |x: &BigFloat| !x.is_inf() && !x.is_nan();
        bounded(&self.low) && bounded(&self.high)
    }

    fn midpoint(&self) -> Self {
        if !self.is_bounded() {
            return self.int(0);
        }
        let two = BigFloat::from_i32(2, WORD_BIT_SIZE);
        let sum = self.low.add(&self.high, self.prec, RoundingMode::ToEven);
        Self::point(&sum.div(&two, self.prec, RoundingMode::ToEven), self.prec)
    }

    fn centred(&self) -> Self {
        let middle = self.midpoint();
        let shifted = self.clone() - &middle;
        let radius = shifted.high.max(&BigFloat::neg(&shifted.low));
        Self { low: BigFloat::neg(&radius), high: radius, prec: self.prec }.checked()
    }

    fn lies_inside(&self, outer: &Self) -> bool {
        let below = |a: &BigFloat, b: &BigFloat| a.cmp(b).is_some_and(|order| order < 0);
        self.is_bounded() && below(&outer.low, &self.low) && below(&self.high, &outer.high)
    }

    fn overlaps(&self, other: &Self) -> bool {
        let below = |a: &BigFloat, b: &BigFloat| a.cmp(b).is_some_and(|order| order < 0);
        !below(&self.high, &other.low) && !below(&other.high, &self.low)
    }
}

impl Neg for AstroInterval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: BigFloat::neg(&self.high), high: BigFloat::neg(&self.low), prec: self.prec }
    }
}

impl Add<&AstroInterval> for AstroInterval {
    type Output = Self;
    fn add(self, other: &Self) -> Self {
        let prec = self.prec.max(other.prec);
        let (low, high) =
            (self.low.add(&other.low, prec, DOWN), self.high.add(&other.high, prec, UP));
        Self { low, high, prec }.checked()
    }
}

impl Sub<&AstroInterval> for AstroInterval {
    type Output = Self;
    fn sub(self, other: &Self) -> Self {
        let prec = self.prec.max(other.prec);
        let (low, high) =
            (self.low.sub(&other.high, prec, DOWN), self.high.sub(&other.low, prec, UP));
        Self { low, high, prec }.checked()
    }
}

impl Mul<&AstroInterval> for AstroInterval {
    type Output = Self;
    fn mul(self, other: &Self) -> Self {
        if self.is_non_positive() && !self.is_non_negative() {
            return -((-self) * other);
        }
        if other.is_non_positive() && !other.is_non_negative() {
            return -(self * -other.clone());
        }
        let prec = self.prec.max(other.prec);
        if self.is_non_negative() && other.is_non_negative() {
            let (low, high) =
                (self.low.mul(&other.low, prec, DOWN), self.high.mul(&other.high, prec, UP));
            return Self { low, high, prec }.checked();
        }
        Self { prec, ..self }.corners(other)
    }
}

impl Div<&AstroInterval> for AstroInterval {
    type Output = Self;
    fn div(self, other: &Self) -> Self {
        let prec = self.prec.max(other.prec);
        if !other.excludes_zero() {
            return Self::whole(prec);
        }
        if other.is_non_positive() {
            return -self / -other.clone();
        }
        let by_low = if self.is_non_negative() { &other.high } else { &other.low };
        let by_high = if self.is_non_positive() { &other.high } else { &other.low };
        let (low, high) = (self.low.div(by_low, prec, DOWN), self.high.div(by_high, prec, UP));
        Self { low, high, prec }.checked()
    }
}

owned_operators!(AstroInterval);

fn with_constants<R>(f: impl FnOnce(&mut Consts) -> R) -> Option<R> {
    CONSTANTS.with_borrow_mut(|constants| constants.as_mut().map(f))
}

fn from_integer(n: &Integer) -> BigFloat {
    let words: Vec<Word> = n.to_digits(Order::Lsf);
    let Some(top) = words.last() else { return BigFloat::from_i32(0, WORD_BIT_SIZE) };
    // astro-float wants the mantissa's top bit set and reads it as a fraction below one.
    let shift = top.leading_zeros();
    let exponent = (words.len() * WORD_BIT_SIZE) as i32 - shift as i32;
    let mantissa: Vec<Word> = Integer::from(n << shift).to_digits(Order::Lsf);
    let sign = if *n < 0 { Sign::Neg } else { Sign::Pos };
    BigFloat::from_words(&mantissa, sign, exponent)
}

fn from_float(x: &Float) -> BigFloat {
    let Some((mantissa, exponent)) = x.to_integer_exp() else { return BigFloat::nan(None) };
    let mut value = from_integer(&mantissa);
    if let (false, Some(e)) = (mantissa.is_zero(), value.exponent()) {
        value.set_exponent(e + exponent);
    }
    value
}

fn to_float(x: &BigFloat) -> Option<Float> {
    if x.is_zero() {
        return Some(Float::with_val(64, 0));
    }
    let (words, _, sign, exponent, _) = x.as_raw_parts()?;
    let integer = Integer::from_digits(words, Order::Lsf);
    let bits = (words.len() * WORD_BIT_SIZE) as u32;
    let value = Float::with_val(bits.max(64), &integer) << (exponent - bits as i32);
    Some(if sign == Sign::Neg { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conversions_are_exact() {
        for text in ["0", "1", "-3", "1e-300", "123456789123456789.125", "-7e99"] {
            let x = Float::with_val(300, Float::parse(text).unwrap());
            let interval = AstroInterval::between(&x, &x, 320);
            assert_eq!(interval.ends().unwrap(), (x.clone(), x), "{text}");
        }
    }

    #[test]
    fn bad_ends_become_the_whole_line() {
        let (one, two) = (Float::with_val(64, 1), Float::with_val(64, 2));
        assert!(!AstroInterval::between(&two, &one, 64).is_bounded(), "inverted");
        assert!(!AstroInterval::between(&Float::with_val(64, f64::NAN), &one, 64).is_bounded());
        let straddles = AstroInterval::between(&-one.clone(), &one, 64);
        assert!(!(AstroInterval::integer(1, 64) / &straddles).is_bounded());
        assert!(!straddles.sqrt().is_bounded());
    }
}
