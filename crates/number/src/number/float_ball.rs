//! Balls of floats: a midpoint of one or two doubles, or of three words, with a radius that is a double; without a
//! heap.
//!
//! With `u = 2^-53` each operation rounds its midpoint `m`, whose leading double is `hi`, with an error of at most
//! [`UNIT`](Midpoint::UNIT)` |hi|`, and adds that to a radius computed from the radii of the operands.
//!
//! **The radius is rounded up**: its formula has positive terms only and at most eight roundings on any path, each of
//! which takes away less than a part `u` of what is added up; the last factor is [`UP`] `= 1 + 16 u`, and
//! `(1 - u)^9 (1 + 16 u) > 1`. What has to be bounded from below is multiplied by [`DOWN`] `= 1 - 16 u` in the same
//! way. The leading double stands for the midpoint in a bound: `|m| <= (1 + u) |hi|`, and the factor counts as a
//! rounding.
//!
//! **Nothing overflows or underflows unseen.** A leading double is zero or between [`SMALLEST`] `= 2^-220` and
//! [`LARGEST`] `= 2^220` in size, a radius zero, infinite, or between [`LEAST`] `= 2^-330` and `LARGEST`. Hence all
//! that is computed on the way (`a b`, `a/b`, `|m| s / least`, `r²`) is above `2^-1000` and below `2^1000`, or zero.
//! [`settled`] puts each result back into these ranges, outward: a smaller midpoint becomes zero and is added to the
//! radius, a smaller radius becomes `LEAST`, and anything larger, or NaN, becomes the whole line.

use super::double_sine::{self, sin_cos};
#[cfg(feature = "mpfr")]
use super::gmp::{TripleWord, triple_word_sine};
use super::stumpff::{from_series, terms};
use super::{DoubleDouble, Enclosure, Field, Real, Stumpff, Ternary};

/// All real numbers within `rad` of `mid`. A midpoint below `2^-220` in size becomes zero and widens the radius by as
/// much; a midpoint or a radius above `2^220` makes the ball the whole line.
#[derive(Clone, Copy, Debug)]
pub struct FloatBall<M> {
    pub(super) mid: M,
    pub(super) rad: f64,
}

/// The midpoint of a [`FloatBall`]: a number that is led by a double.
pub trait Midpoint: Field + Copy {
    /// Zero.
    const ZERO: Self;
    /// Above the error of every operation within `2^±220`, as a part of the leading double of the result.
    const UNIT: f64;
    /// The number of bits.
    const BITS: u32;
    /// Pi, and what it leaves of pi, rounded up.
    const PI: (Self, f64);
    /// A bound of the error of sine and cosine, but for what they leave; relative to its argument, of the sine of at most
    /// 1/64.
    const SINE_ERROR: f64;

    /// The leading double, the nearest to the number.
    fn hi(self) -> f64;

    /// The leading double, or one so little nearer to zero that its size is not above that of the number.
    fn shortened(self) -> f64;

    /// The square root of a positive number.
    fn root(self) -> Self;

    /// Sine and cosine of a number in `[-4, 4]`, each with the size of what it leaves of the value that is found.
    fn sin_cos(self) -> [(Self, f64); 2];

    /// A ball of `± mantissa 2^exponent`, the mantissa in words of 64 bits, the least significant first.
    fn of_words(is_negative: bool, mantissa: &[u64], exponent: i64) -> FloatBall<Self>;
}

/// `2^exponent`, within the range of normal doubles.
pub const fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// Half the distance from one to the next double.
const U: f64 = power_of_two(-53);
/// Rounds a radius up.
pub(super) const UP: f64 = 1.0 + 16.0 * U;
/// Rounds a lower bound down.
pub(super) const DOWN: f64 = 1.0 - 16.0 * U;
/// The smallest midpoint but zero.
pub(super) const SMALLEST: f64 = power_of_two(-220);
/// The largest midpoint, and the largest radius.
const LARGEST: f64 = power_of_two(220);
/// The smallest radius but zero.
pub(super) const LEAST: f64 = power_of_two(-330);

/// Each operation rounds to nearest, with an error of at most `u |m|`.
impl Midpoint for f64 {
    const ZERO: Self = 0.0;
    const UNIT: f64 = U;
    const BITS: u32 = 53;
    const PI: (Self, f64) = (std::f64::consts::PI, 1.2246467991473532e-16);
    const SINE_ERROR: f64 = double_sine::ERROR;

    #[inline(always)]
    fn hi(self) -> f64 {
        self
    }

    #[inline(always)]
    fn shortened(self) -> f64 {
        self
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn sin_cos(self) -> [(Self, f64); 2] {
        let (sin, cos) = sin_cos(DoubleDouble::exact(self));
        [sin, cos].map(|x| (x.hi(), x.lo().abs()))
    }

    fn of_words(is_negative: bool, mantissa: &[u64], exponent: i64) -> FloatBall<Self> {
        DoubleDouble::of_words(is_negative, mantissa, exponent).into()
    }
}

impl Midpoint for DoubleDouble {
    const ZERO: Self = Self::ZERO;
    const UNIT: f64 = Self::UNIT;
    const BITS: u32 = 106;
    const PI: (Self, f64) = (Self::constant(std::f64::consts::PI, 1.2246467991473532e-16), 3e-33);
    const SINE_ERROR: f64 = double_sine::ERROR;

    #[inline(always)]
    fn hi(self) -> f64 {
        self.hi()
    }

    /// `DOWN` has room for the low part.
    #[inline(always)]
    fn shortened(self) -> f64 {
        self.hi() * DOWN
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn sin_cos(self) -> [(Self, f64); 2] {
        let (sin, cos) = sin_cos(self);
        [(sin, 0.0), (cos, 0.0)]
    }

    fn of_words(is_negative: bool, mantissa: &[u64], exponent: i64) -> FloatBall<Self> {
        FloatBall::<Self>::of_words(is_negative, mantissa, exponent)
    }
}

#[cfg(feature = "mpfr")]
impl Midpoint for TripleWord {
    const ZERO: Self = Self::ZERO;
    const UNIT: f64 = Self::UNIT;
    const BITS: u32 = 150;
    const PI: (Self, f64) = (Self::PI, Self::CUT / 64.0);
    const SINE_ERROR: f64 = triple_word_sine::ERROR;

    #[inline(always)]
    fn hi(self) -> f64 {
        self.hi()
    }

    #[inline(always)]
    fn shortened(self) -> f64 {
        self.shortened()
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn sin_cos(self) -> [(Self, f64); 2] {
        let (sin, cos) = triple_word_sine::sin_cos(self);
        [(sin, 0.0), (cos, 0.0)]
    }

    fn of_words(is_negative: bool, mantissa: &[u64], exponent: i64) -> FloatBall<Self> {
        FloatBall::<Self>::of_words(is_negative, mantissa, exponent)
    }
}

/// A midpoint of size `size` and its radius put into range: `Some((true, rad))` keeps the midpoint, `Some((false,
/// rad))` has it replaced by zero, `None` is the whole line.
#[inline(always)]
fn settled(size: f64, rad: f64) -> Option<(bool, f64)> {
    // Nearly always, and without a branch between the four. A NaN is in no range.
    let in_range = (size >= SMALLEST || size == 0.0) & (size <= LARGEST);
    if in_range & (rad >= LEAST || rad == 0.0) & (rad <= LARGEST) {
        return Some((true, rad));
    }
    at_the_edge(size, rad)
}

#[cold]
fn at_the_edge(size: f64, rad: f64) -> Option<(bool, f64)> {
    if !(size <= LARGEST && (0.0..=LARGEST).contains(&rad)) {
        return None;
    }
    let is_kept = size == 0.0 || size >= SMALLEST;
    // The size of the midpoint exceeds that of its leading double by at most `u` of it.
    let rad = if is_kept { rad } else { (rad + size) * UP };
    Some((is_kept, if rad == 0.0 { 0.0 } else { rad.max(LEAST) }))
}

impl<M: Midpoint> FloatBall<M> {
    /// The whole line: nothing is known.
    pub const WHOLE: Self = Self { mid: M::ZERO, rad: f64::INFINITY };

    /// All numbers within `rad` of `mid`; the whole line unless both are numbers and the second is not negative.
    #[inline(always)]
    pub fn new(mid: M, rad: f64) -> Self {
        match settled(mid.hi().abs(), rad) {
            Some((true, rad)) => Self { mid, rad },
            Some((false, rad)) => Self { mid: M::ZERO, rad },
            None => Self::WHOLE,
        }
    }

    /// The number `mid`.
    #[inline(always)]
    pub fn exact(mid: M) -> Self {
        Self::new(mid, 0.0)
    }

    /// The result of an operation on midpoints, with what its radius is but for the error of that.
    #[inline(always)]
    fn rounded(mid: M, rad: f64) -> Self {
        Self::new(mid, (rad + M::UNIT * mid.hi().abs()) * UP)
    }

    /// The midpoint; zero for the whole line.
    #[inline(always)]
    pub fn mid(&self) -> M {
        self.mid
    }

    /// The radius; infinite for the whole line.
    #[inline(always)]
    pub fn rad(&self) -> f64 {
        self.rad
    }

    /// Ball with the midpoint of this one and `more`, not negative, added to the radius.
    #[inline]
    pub fn widened(&self, more: f64) -> Self {
        Self::new(self.mid, (self.rad + more) * UP)
    }

    /// A ball that holds this one and another; tight where they differ by little.
    pub fn hull(&self, other: &Self) -> Self {
        self.widened((*self - other).size()).widened(other.rad)
    }

    /// An upper bound of the size of all numbers of the ball.
    pub fn size(&self) -> f64 {
        (self.mid.hi().abs() + self.rad) * UP
    }
}

impl<M: Midpoint> Field for FloatBall<M> {
    #[inline(always)]
    fn int(&self, n: i32) -> Self {
        Self { mid: self.mid.int(n), rad: 0.0 }
    }
}

impl<M: Midpoint> Real for FloatBall<M> {
    #[inline]
    fn pi(&self) -> Self {
        let (mid, rad) = M::PI;
        Self { mid, rad }
    }

    /// The square root; the whole line unless every number of the ball is at least zero.
    ///
    /// Radius: `|√x - √m| = |x - m| / (√x + √m)` is at most `r / (√(m-r) + √m)`.
    #[inline]
    fn sqrt(&self) -> Self {
        let hi = self.mid.hi();
        if hi == 0.0 && self.rad == 0.0 {
            return *self;
        }
        let low = self.mid.shortened() - self.rad;
        let starts_at_zero = low == 0.0 && self.rad == hi;
        if low <= 0.0 && !starts_at_zero {
            return Self::WHOLE;
        }
        let root = self.mid.root();
        Self::rounded(root, self.rad / (((low * DOWN).sqrt() + root.hi()) * DOWN))
    }

    /// Sine and cosine. For `|d| <= r`, `|sin(m+d) - sin m| <= min(r, r |cos m| + r²/2)`, and the same with the two
    /// exchanged. Beyond `±4` the answer is `[-1, 1]`.
    #[inline]
    fn sin_cos(&self) -> (Self, Self) {
        let (size, r) = (self.mid.hi().abs(), self.rad);
        if size > double_sine::LARGEST || r >= 1.0 {
            let unit = Self { mid: M::ZERO, rad: 1.0 };
            return (unit, unit);
        }
        let [sin, cos] = self.mid.sin_cos();
        let relative = if size <= double_sine::RELATIVE { size } else { 1.0 };
        let around = |(mid, rest): (M, f64), slope: M, error: f64| {
            let bent = (slope.hi().abs() + M::SINE_ERROR) * r + r * r / 2.0;
            Self::new(mid, (r.min(bent) + rest + error) * UP)
        };
        (around(sin, cos.0, M::SINE_ERROR * relative), around(cos, sin.0, M::SINE_ERROR))
    }
}

impl<M: Midpoint> Stumpff for FloatBall<M> {
    fn stumpff(&self, count: usize) -> Vec<Self> {
        let size = self.size();
        if size > 2.0 {
            return vec![Self::WHOLE; count];
        }
        // As for balls of MPFR: what follows the terms is within |u| of one.
        let tail = self.int(1).widened(size);
        from_series(self, count, terms(M::BITS, 1), &tail)
    }
}

impl<M: Midpoint> Enclosure for FloatBall<M> {
    #[inline(always)]
    fn is_positive(&self) -> Ternary {
        if self.mid.shortened() > self.rad {
            Ternary::True
        } else if -self.mid.shortened() >= self.rad {
            Ternary::False
        } else {
            Ternary::Undecided
        }
    }

    #[inline(always)]
    fn is_bounded(&self) -> bool {
        self.rad.is_finite()
    }

    #[inline(always)]
    fn midpoint(&self) -> Self {
        Self { rad: 0.0, ..*self }
    }

    #[inline(always)]
    fn centred(&self) -> Self {
        Self { mid: M::ZERO, ..*self }
    }

    #[inline]
    fn lies_inside(&self, outer: &Self) -> bool {
        ((self.mid - outer.mid).hi().abs() + self.rad) * UP < outer.rad
    }

    #[inline]
    fn overlaps(&self, other: &Self) -> bool {
        (self.mid - other.mid).hi().abs() * DOWN <= (self.rad + other.rad) * UP
    }
}

impl<M: Midpoint> FloatBall<M> {
    #[inline(always)]
    fn negated(self) -> Self {
        Self { mid: -self.mid, ..self }
    }

    #[inline]
    fn plus(self, other: &Self) -> Self {
        Self::rounded(self.mid + other.mid, self.rad + other.rad)
    }

    #[inline]
    fn minus(self, other: &Self) -> Self {
        Self::rounded(self.mid - other.mid, self.rad + other.rad)
    }

    /// Product of balls: for `|x - a| <= r` and `|y - b| <= s`, `|xy - ab| <= |a| s + (|b| + s) r`.
    #[inline]
    fn times(self, other: &Self) -> Self {
        let (a, b) = (self.mid.hi().abs(), other.mid.hi().abs());
        Self::rounded(self.mid * other.mid, a * other.rad + (b + other.rad) * self.rad)
    }

    /// Quotient of balls: for `|x - a| <= r` and `|y - b| <= s`, `|x/y - a/b| <= (r + |a/b| s) / (|b| - s)`.
    #[inline]
    fn over(self, other: &Self) -> Self {
        let least = (other.mid.shortened().abs() - other.rad) * DOWN;
        if least <= 0.0 {
            return Self::WHOLE;
        }
        let quotient = self.mid / other.mid;
        Self::rounded(quotient, (self.rad + quotient.hi().abs() * other.rad) / least)
    }
}

operators!([M: Midpoint] FloatBall<M>);
