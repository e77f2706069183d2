//! Number at an end of an interval: a floating-point number that is rounded the way it is told.

use std::cmp::Ordering;
use std::fmt::Debug;

/// Direction in which a number that does not fit is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// The number is rounded to the next number below.
    Down,
    /// The number is rounded to the next number above.
    Up,
}

/// A floating-point number that may stand at an end of an interval, infinite or not.
///
/// Each operation has the precision of its result, in bits, and its direction: the answer is at most the true one
/// if that is [`Direction::Down`], at least the true one if it is [`Direction::Up`], and no number at all where
/// there is none. Too large or too small for an exponent makes no exception. More bits than those asked for do no
/// harm.
pub trait End: Clone + Debug {
    /// From so many bits on sines are computed by products, which are quicker than what the arithmetic has.
    const HALVED: usize;

    /// An end of the whole line.
    fn infinite(negative: bool) -> Self;

    /// The number `± mantissa * 2^exponent`, exactly; the mantissa in words, the least significant first and the
    /// last not zero. `None` where its size is too large or too small for a number.
    fn dyadic(negative: bool, mantissa: &[u64], exponent: i32) -> Option<Self>;

    /// Sign, mantissa and exponent, as they are given to [`End::dyadic`]; zero has no words. `None` for what is not
    /// finite.
    fn parts(&self) -> Option<(bool, Vec<u64>, i32)>;

    /// Order of two numbers; `None` if one of them is no number.
    fn order(&self, other: &Self) -> Option<Ordering>;

    /// Side of zero on which it lies; `None` if it is no number.
    fn sign(&self) -> Option<Ordering>;

    /// Tells whether the end is a number and not infinite.
    fn is_finite(&self) -> bool;

    /// The least power of two above its size; `None` for zero and for what is not finite.
    fn exponent(&self) -> Option<i64>;

    /// The one of two that lies on the side given of the other; no number if one of them is none.
    fn beyond(self, other: &Self, side: Ordering) -> Self {
        match self.order(other) {
            Some(order) if order == side => self,
            None if self.sign().is_none() => self,
            _ => other.clone(),
        }
    }

    /// The number on the other side of zero.
    fn negated(&self) -> Self;

    /// Gives the number itself if it has at most so many bits, and rounds it otherwise.
    fn rounded(&self, prec: usize, to: Direction) -> Self;

    /// `self + other`.
    fn plus(&self, other: &Self, prec: usize, to: Direction) -> Self;

    /// `self - other`.
    fn minus(&self, other: &Self, prec: usize, to: Direction) -> Self;

    /// `self * other`.
    fn times(&self, other: &Self, prec: usize, to: Direction) -> Self;

    /// `self / other`.
    fn over(&self, other: &Self, prec: usize, to: Direction) -> Self;

    /// The square root; no number below zero.
    fn root(&self, prec: usize, to: Direction) -> Self;

    /// The constant `pi`.
    fn pi(prec: usize, to: Direction) -> Self;

    /// A number below and one above its sine, and the same of its cosine; `None` where it fails. Neither tiny nor much
    /// longer than its bits ([`Interval`](super::Interval) asks for nothing else).
    fn sin_cos(&self, prec: usize) -> Option<[(Self, Self); 2]>;
}
