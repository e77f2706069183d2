//! The second arithmetic: ends of intervals by astro-float.
//!
//! It shares nothing with [`Ball`](super::Ball): another library (pure Rust), another way to hold a
//! set (two ends instead of midpoint and radius), another way to round (each end directly in its
//! direction). Two enclosures of one number, one from each, have to overlap.
//!
//! astro-float rounds precisions up to whole words and reports failures as NaN. Of its functions only
//! `+ - * / sqrt` and pi are used, and sine and cosine for few bits; its logarithm is known not to return for some
//! exact arguments.

/// Directions of astro-float, of which ends take [`RoundingMode::Down`] and [`RoundingMode::Up`].
pub use astro_float_num::RoundingMode;
use astro_float_num::{BigFloat, Consts, INF_NEG, INF_POS, Sign, WORD_BIT_SIZE, Word};
use std::cell::RefCell;
use std::cmp::Ordering;

/// An astro-float number at an end of an interval, infinite or not.
///
/// Each operation has the precision of its result, in bits, and its direction: the answer is at most the true one
/// if that is [`RoundingMode::Down`], at least the true one if it is [`RoundingMode::Up`], and no number at all where
/// there is none. Too large or too small for an exponent makes no exception. More bits than those asked for do no
/// harm.
#[derive(Clone, Debug)]
pub struct Astro(BigFloat);

thread_local! {
    /// astro-float's cache of constants; `None` only if its first allocation failed.
    static CONSTANTS: RefCell<Option<Consts>> = RefCell::new(Consts::new().ok());
}

fn with_constants<R>(f: impl FnOnce(&mut Consts) -> R) -> Option<R> {
    CONSTANTS.with_borrow_mut(|constants| constants.as_mut().map(f))
}

impl Astro {
    /// The number one unit of the last of `prec` bits, in whole words, above; `None` for zero, which has no unit.
    fn next(&self, prec: usize) -> Option<Self> {
        let bits = prec.next_multiple_of(WORD_BIT_SIZE);
        let exponent = i64::from(self.0.exponent().filter(|_| !self.0.is_zero())?);
        // A mantissa is a fraction from one half to one.
        let unit = i32::try_from(exponent - bits as i64 + 1).ok()?;
        let unit = BigFloat::from_words(&[1 << (WORD_BIT_SIZE - 1)], Sign::Pos, unit);
        Some(Self(self.0.add(&unit, bits, RoundingMode::Up)))
    }

    /// An end of the whole line.
    pub fn infinite(negative: bool) -> Self {
        Self(if negative { INF_NEG } else { INF_POS })
    }

    /// The number `± mantissa * 2^exponent`, exactly; the mantissa in words, the least significant first and the
    /// last not zero. `None` where its size is too large or too small for a number.
    pub fn dyadic(negative: bool, mantissa: &[u64], exponent: i32) -> Option<Self> {
        let Some(top) = mantissa.last() else {
            return Some(Self(BigFloat::from_i32(0, WORD_BIT_SIZE)));
        };
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
        let exponent = i32::try_from(i64::from(exponent) + size).ok()?;
        let number = BigFloat::from_words(&words, sign, exponent);
        (!number.is_nan()).then_some(Self(number))
    }

    /// Sign, mantissa and exponent, as they are given to [`Self::dyadic`]; zero has no words. `None` for what is not
    /// finite.
    pub fn parts(&self) -> Option<(bool, Vec<u64>, i32)> {
        if self.0.is_zero() {
            return Some((false, Vec::new(), 0));
        }
        let (words, _, sign, exponent, _) = self.0.as_raw_parts()?;
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        let word = |chunk: &[u8]| {
            chunk.iter().rev().fold(0, |word: u64, byte| word << 8 | u64::from(*byte))
        };
        let bits = (words.len() * WORD_BIT_SIZE) as i32;
        Some((sign == Sign::Neg, bytes.chunks(8).map(word).collect(), exponent.checked_sub(bits)?))
    }

    /// Order of two numbers; `None` if one of them is no number.
    pub fn order(&self, other: &Self) -> Option<Ordering> {
        self.0.cmp(&other.0).map(|order| order.cmp(&0))
    }

    /// Side of zero on which it lies; `None` if it is no number.
    pub fn sign(&self) -> Option<Ordering> {
        match () {
            () if self.0.is_nan() => None,
            () if self.0.is_zero() => Some(Ordering::Equal),
            () if self.0.is_negative() => Some(Ordering::Less),
            () => Some(Ordering::Greater),
        }
    }

    /// Tells whether the end is a number and not infinite.
    pub fn is_finite(&self) -> bool {
        !self.0.is_inf() && !self.0.is_nan()
    }

    /// The least power of two above its size; `None` for zero and for what is not finite.
    pub fn exponent(&self) -> Option<i64> {
        self.0.exponent().filter(|_| !self.0.is_zero()).map(i64::from)
    }

    /// The one of two that lies on the side given of the other; no number if one of them is none.
    pub(super) fn beyond(self, other: &Self, side: Ordering) -> Self {
        match self.order(other) {
            Some(order) if order == side => self,
            None if self.sign().is_none() => self,
            _ => other.clone(),
        }
    }

    /// The number on the other side of zero.
    pub fn negated(&self) -> Self {
        Self(BigFloat::neg(&self.0))
    }

    /// Gives the number itself if it has at most so many bits, and rounds it otherwise.
    pub fn rounded(&self, prec: usize, to: RoundingMode) -> Self {
        let mut number = self.0.clone();
        let is_longer = number.mantissa_max_bit_len().is_some_and(|bits| bits > prec);
        if is_longer && number.set_precision(prec, to).is_err() {
            return Self::infinite(to == RoundingMode::Down);
        }
        Self(number)
    }

    /// `self + other`.
    pub fn plus(&self, other: &Self, prec: usize, to: RoundingMode) -> Self {
        Self(self.0.add(&other.0, prec, to))
    }

    /// `self - other`.
    pub fn minus(&self, other: &Self, prec: usize, to: RoundingMode) -> Self {
        Self(self.0.sub(&other.0, prec, to))
    }

    /// `self * other`.
    pub fn times(&self, other: &Self, prec: usize, to: RoundingMode) -> Self {
        Self(self.0.mul(&other.0, prec, to))
    }

    /// `self / other`.
    pub fn over(&self, other: &Self, prec: usize, to: RoundingMode) -> Self {
        Self(self.0.div(&other.0, prec, to))
    }

    /// The square root; no number below zero.
    pub fn root(&self, prec: usize, to: RoundingMode) -> Self {
        Self(self.0.sqrt(prec, to))
    }

    /// The constant `pi`.
    pub fn pi(prec: usize, to: RoundingMode) -> Self {
        let pi = with_constants(|constants| Self(constants.pi(prec, to)));
        pi.unwrap_or_else(|| Self::infinite(to == RoundingMode::Down))
    }

    /// A number below and one above its sine, and the same of its cosine; `None` where it fails. Neither tiny nor much
    /// longer than its bits ([`AstroInterval`](super::AstroInterval) asks for nothing else).
    ///
    /// Each is rounded down, and the other is the number above that: what an evaluation costs is not paid twice.
    pub fn sin_cos(&self, prec: usize) -> Option<[(Self, Self); 2]> {
        let down = RoundingMode::Down;
        let [sin, cos] = with_constants(|constants| {
            [self.0.sin(prec, down, constants), self.0.cos(prec, down, constants)].map(Self)
        })?;
        let (above_sin, above_cos) = (sin.next(prec)?, cos.next(prec)?);
        Some([(sin, above_sin), (cos, above_cos)])
    }
}
