//! The second arithmetic: intervals whose ends are astro-float numbers, rounded outward.
//!
//! It shares nothing with [`Ball`](super::Ball): another library (pure Rust), another way to hold a
//! set (two ends instead of midpoint and radius), another way to round (each end directly in its
//! direction). Two enclosures of one number, one from each, have to overlap.
//!
//! astro-float rounds precisions up to whole 64-bit words and reports failures as NaN; a NaN, or an
//! end on the wrong side, becomes the whole line here. Of its functions only `+ - * / sqrt`
//! and pi are used, and sine and cosine for few bits; its logarithm is known not to return for some exact arguments.

use super::halving::Halving;
use super::{Enclosure, Field, Real, Ternary};
use astro_float::{BigFloat, Consts, INF_NEG, INF_POS, RoundingMode, Sign, WORD_BIT_SIZE, Word};
use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    /// astro-float's cache of constants; `None` only if its first allocation failed.
    static CONSTANTS: RefCell<Option<Consts>> = RefCell::new(Consts::new().ok());
}

/// From so many bits on sines are computed by products: each end of astro-float's own costs as much as some hundred.
const HALVED: usize = 512;

const DOWN: RoundingMode = RoundingMode::Down;
const UP: RoundingMode = RoundingMode::Up;

/// All real numbers from `low` to `high`.
#[derive(Clone, Debug)]
pub struct AstroInterval {
    pub(super) low: BigFloat,
    pub(super) high: BigFloat,
    pub(super) prec: usize,
}

impl AstroInterval {
    /// The integer `n`, with results to be rounded to `prec` bits (whole words).
    pub fn integer(n: i32, prec: usize) -> Self {
        let value = BigFloat::from_i32(n, WORD_BIT_SIZE);
        Self { low: value.clone(), high: value, prec: prec.max(WORD_BIT_SIZE) }
    }

    /// The same set, its ends rounded outward if they have more bits, with results to be rounded to `prec` bits (whole
    /// words).
    pub fn with_precision(&self, prec: usize) -> Self {
        let mut set = Self { prec, ..self.clone() };
        for (end, round) in [(&mut set.low, DOWN), (&mut set.high, UP)] {
            let is_longer = end.mantissa_max_bit_len().is_some_and(|bits| bits > prec);
            if is_longer && end.set_precision(prec, round).is_err() {
                return Self::whole(prec);
            }
        }
        set
    }

    /// The number `± mantissa * 2^exponent`, exactly; the mantissa in words of 64 bits, the least
    /// significant first and the last not zero.
    pub fn dyadic(negative: bool, mantissa: &[u64], exponent: i32, prec: usize) -> Self {
        let Some(top) = mantissa.last() else { return Self::integer(0, prec) };
        // astro-float wants the mantissa's top bit set and reads it as a fraction below one.
        let shift = top.leading_zeros();
        let shifted = |i: usize| {
            let below = if i > 0 && shift > 0 { mantissa[i - 1] >> (64 - shift) } else { 0 };
            mantissa[i] << shift | below
        };
        let bytes = (0..mantissa.len()).flat_map(|i| shifted(i).to_le_bytes());
        let bytes: Vec<u8> = bytes.collect();
        let word = |chunk: &[u8]| {
            chunk.iter().rev().fold(0, |word: Word, byte| word << 8 | Word::from(*byte))
        };
        let words: Vec<Word> = bytes.chunks(WORD_BIT_SIZE / 8).map(word).collect();
        let sign = if negative { Sign::Neg } else { Sign::Pos };
        let size = 64 * mantissa.len() as i64 - i64::from(shift);
        let Ok(exponent) = i32::try_from(i64::from(exponent) + size) else {
            return Self::whole(prec);
        };
        Self::point(&BigFloat::from_words(&words, sign, exponent), prec.max(WORD_BIT_SIZE))
    }

    /// All numbers that are at most as large as the largest of this set, whatever their sign.
    pub fn symmetric(&self) -> Self {
        let size = self.high.max(&BigFloat::neg(&self.low));
        Self { low: BigFloat::neg(&size), high: size, prec: self.prec }.checked()
    }

    /// The whole line.
    pub fn whole(prec: usize) -> Self {
        Self { low: INF_NEG, high: INF_POS, prec }
    }

    pub(super) fn point(value: &BigFloat, prec: usize) -> Self {
        Self { low: value.clone(), high: value.clone(), prec }.checked()
    }

    /// The interval itself if its ends are in order, the whole line otherwise.
    pub(super) fn checked(self) -> Self {
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

    /// Sine and cosine of an exact number from 1/8 to 3, by products; `None` for others and next to a right angle, where
    /// one of them may be small, and for few bits.
    fn by_halving(&self) -> Option<(Self, Self)> {
        let negative = self.high.is_negative();
        let size = if negative { -self.clone() } else { self.clone() };
        let is_within = size.ratio(1, 8).is_less_than(&size).and(size.is_less_than(&size.int(3)));
        if self.prec < HALVED || !is_within.is_proved() {
            return None;
        }
        let plan = Halving::new(self.prec)?;
        let scaled = |exponent: usize| Self::dyadic(false, &[1], -(exponent as i32), plan.bits);
        let y = size * scaled(plan.halvings);
        let (sin, cos) = plan.sin_cos(&y, &scaled(plan.tail).symmetric());
        // A cosine that is nearly zero has lost too many bits.
        let (size, least) = (cos.square(), scaled(32));
        if !least.is_less_than(&size).is_proved() {
            return None;
        }
        let sin = if negative { -sin } else { sin };
        Some((sin.with_precision(self.prec), cos.with_precision(self.prec)))
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
        let unit = Self::integer(1, prec).symmetric();
        let reducible = self.low.exponent().is_some_and(|e| i64::from(e) <= prec as i64 + 64);
        if !self.is_bounded() || !reducible {
            return (unit.clone(), unit);
        }
        let at = &self.low;
        let (sin, cos) = Self::point(at, prec).by_halving().unwrap_or_else(|| {
            let image = |at: &dyn Fn(RoundingMode, &mut Consts) -> BigFloat| {
                let ends = with_constants(|cc| (at(DOWN, cc), at(UP, cc)));
                ends.map_or(unit.clone(), |(low, high)| Self { low, high, prec }.checked())
            };
            (
                image(&|round, cc| at.sin(prec, round, cc)),
                image(&|round, cc| at.cos(prec, round, cc)),
            )
        });
        let width = self.high.sub(&self.low, prec, UP);
        let widened = |set: Self| {
            let low = set.low.sub(&width, prec, DOWN).max(&unit.low);
            let high = set.high.add(&width, prec, UP).min(&unit.high);
            Self { low, high, prec }.checked()
        };
        (widened(sin), widened(cos))
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
        (self.clone() - &middle).symmetric()
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
