//! The second arithmetic: ends of intervals by astro-float.
//!
//! It shares nothing with [`Ball`](super::Ball): another library (pure Rust), another way to hold a
//! set (two ends instead of midpoint and radius), another way to round (each end directly in its
//! direction). Two enclosures of one number, one from each, have to overlap.
//!
//! astro-float rounds precisions up to whole words and reports failures as NaN. Of its functions only
//! `+ - * / sqrt` and pi are used, and sine and cosine for few bits; its logarithm is known not to return for some
//! exact arguments.

use super::end::{Direction, End};
use super::interval::Interval;
use astro_float_num::{
    BigFloat, Consts, INF_NEG, INF_POS, RoundingMode, Sign, WORD_BIT_SIZE, Word,
};
use std::cell::RefCell;
use std::cmp::Ordering;

/// All real numbers from one astro-float number to another.
pub type AstroInterval = Interval<Astro>;

/// An astro-float number.
#[derive(Clone, Debug)]
pub struct Astro(BigFloat);

thread_local! {
    /// astro-float's cache of constants; `None` only if its first allocation failed.
    static CONSTANTS: RefCell<Option<Consts>> = RefCell::new(Consts::new().ok());
}

fn with_constants<R>(f: impl FnOnce(&mut Consts) -> R) -> Option<R> {
    CONSTANTS.with_borrow_mut(|constants| constants.as_mut().map(f))
}

fn mode(to: Direction) -> RoundingMode {
    match to {
        Direction::Down => RoundingMode::Down,
        Direction::Up => RoundingMode::Up,
    }
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
}

impl End for Astro {
    const HALVED: usize = 512;

    fn infinite(negative: bool) -> Self {
        Self(if negative { INF_NEG } else { INF_POS })
    }

    fn dyadic(negative: bool, mantissa: &[u64], exponent: i32) -> Option<Self> {
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

    fn parts(&self) -> Option<(bool, Vec<u64>, i32)> {
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

    fn order(&self, other: &Self) -> Option<Ordering> {
        self.0.cmp(&other.0).map(|order| order.cmp(&0))
    }

    fn sign(&self) -> Option<Ordering> {
        match () {
            () if self.0.is_nan() => None,
            () if self.0.is_zero() => Some(Ordering::Equal),
            () if self.0.is_negative() => Some(Ordering::Less),
            () => Some(Ordering::Greater),
        }
    }

    fn is_finite(&self) -> bool {
        !self.0.is_inf() && !self.0.is_nan()
    }

    fn exponent(&self) -> Option<i64> {
        self.0.exponent().filter(|_| !self.0.is_zero()).map(i64::from)
    }

    fn negated(&self) -> Self {
        Self(BigFloat::neg(&self.0))
    }

    fn rounded(&self, prec: usize, to: Direction) -> Self {
        let mut number = self.0.clone();
        let is_longer = number.mantissa_max_bit_len().is_some_and(|bits| bits > prec);
        if is_longer && number.set_precision(prec, mode(to)).is_err() {
            return Self::infinite(to == Direction::Down);
        }
        Self(number)
    }

    fn plus(&self, other: &Self, prec: usize, to: Direction) -> Self {
        Self(self.0.add(&other.0, prec, mode(to)))
    }

    fn minus(&self, other: &Self, prec: usize, to: Direction) -> Self {
        Self(self.0.sub(&other.0, prec, mode(to)))
    }

    fn times(&self, other: &Self, prec: usize, to: Direction) -> Self {
        Self(self.0.mul(&other.0, prec, mode(to)))
    }

    fn over(&self, other: &Self, prec: usize, to: Direction) -> Self {
        Self(self.0.div(&other.0, prec, mode(to)))
    }

    fn root(&self, prec: usize, to: Direction) -> Self {
        Self(self.0.sqrt(prec, mode(to)))
    }

    fn pi(prec: usize, to: Direction) -> Self {
        let pi = with_constants(|constants| Self(constants.pi(prec, mode(to))));
        pi.unwrap_or_else(|| Self::infinite(to == Direction::Down))
    }

    /// Sine and cosine, each rounded down, and the number above that: what an evaluation costs is not paid twice.
    fn sin_cos(&self, prec: usize) -> Option<[(Self, Self); 2]> {
        let down = RoundingMode::Down;
        let [sin, cos] = with_constants(|constants| {
            [self.0.sin(prec, down, constants), self.0.cos(prec, down, constants)].map(Self)
        })?;
        let (above_sin, above_cos) = (sin.next(prec)?, cos.next(prec)?);
        Some([(sin, above_sin), (cos, above_cos)])
    }
}
