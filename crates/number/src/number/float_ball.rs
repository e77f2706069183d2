//! Balls of floats: a midpoint of one or two doubles, or of three words, with a radius that is a double; without a
//! heap.
//!
//! With `u = 2^-53` each operation rounds its midpoint `m`, whose leading double is `hi`, with an error of at most
//! [`UNIT`](Midpoint::UNIT)` |hi|` where nothing overflows or underflows, and adds that to a radius computed from the
//! radii of the operands.
//!
//! **The radius is rounded up**: its formula has positive terms only and at most ten roundings on any path, each of
//! which takes away less than a part `u` of what is added up; the last factor is [`UP`] `= 1 + 16 u`, and
//! `(1 - u)^11 (1 + 16 u) > 1`. What has to be bounded from below is multiplied by [`DOWN`] `= 1 - 16 u` in the same
//! way. The leading double stands for the midpoint in a bound: `|m| <= (1 + u) |hi|`, and the factor counts as a
//! rounding.
//!
//! **What overflows or underflows is seen**, in one of two ways: the [`Edge`] of a ball.
//!
//! *[`Settled`].* A leading double is zero or between [`SMALLEST`] `= 2^-220` and [`LARGEST`] `= 2^220` in size, a
//! radius zero, infinite, or between [`LEAST`] `= 2^-330` and `LARGEST`. Hence all that is computed on the way (`a b`,
//! `a/b`, `|m| s / least`, `r²`) is above `2^-1000` and below `2^1000`, or zero. [`settled`] puts each result back into
//! these ranges, outward: a smaller midpoint becomes zero and is added to the radius, a smaller radius becomes `LEAST`,
//! and anything larger, or NaN, becomes the whole line.
//!
//! *[`Branchless`].* What is not a number is the whole line: where the radius is finite, so is the midpoint, and the
//! true value lies within the one of the other; else nothing is known. A radius is a sum and product of sizes in which
//! the operands occur, so that what is not finite stays so, and a comparison with it is false: there is nothing to
//! decide on the way, and many balls go through one text at a time. Overflow in a midpoint makes the radius infinite. A
//! sum of doubles does not underflow. In a product of midpoints, and in that of a quotient with its divisor, each of at
//! most six operations errs by less than `2^-1072` for it, the error of a product among them; so the result errs by
//! less than `2^-1069`, and that of a quotient, whose divisor is above [`LEAST`](Edge::LEAST) `= 2^-60`, by less than
//! `2^-1000`, as does a term of the radius. [`TINY`](Edge::TINY) `= 2^-990` has room for them.

use super::double::exponent;
use super::double_sine::{self, sin_cos};
#[cfg(feature = "mpfr")]
use super::gmp::{TripleWord, triple_word_sine};
use super::stumpff::{from_series, terms};
use super::{DoubleDouble, DoubleDoubleBy, Enclosure, Field, Product, Real, Stumpff, Ternary};
use std::fmt::Debug;
use std::marker::PhantomData;

/// All real numbers within `rad` of `mid`; what lies beyond the range of its numbers is up to its [`Edge`].
#[derive(Clone, Copy, Debug)]
pub struct FloatBall<M, E = Settled> {
    pub(super) mid: M,
    pub(super) rad: f64,
    edge: PhantomData<E>,
}

/// Edge of the range of the numbers of a ball: what becomes of a ball there.
pub trait Edge: Copy + Debug {
    /// Above what underflow takes away from a result.
    const TINY: f64;
    /// The least number by which is divided and of which a root is taken.
    const LEAST: f64;

    /// A midpoint and a radius, put into range.
    fn settled<M: Midpoint>(mid: M, rad: f64) -> (M, f64);
}

/// A midpoint below `2^-220` in size becomes zero and widens the radius by as much; a midpoint or a radius above
/// `2^220`, or not a number, makes the ball the whole line.
#[derive(Clone, Copy, Debug)]
pub struct Settled;

/// A ball with a radius that is not finite is the whole line; nothing is compared, so that many balls go through one
/// text at a time. The midpoint of such a ball may be anything, and must be finite where the radius is.
#[derive(Clone, Copy, Debug)]
pub struct Branchless;

/// The midpoint of a [`FloatBall`]: a number that is led by a double.
pub trait Midpoint: Field + Copy {
    /// Zero.
    const ZERO: Self;
    /// Above the error of every operation, as a part of the leading double of the result.
    const UNIT: f64;
    /// The number of bits.
    const BITS: u32;
    /// Pi, and what it leaves of pi, rounded up.
    const PI: (Self, f64);
    /// A bound of the error of sine and cosine, but for what they leave; relative to its argument, of the sine of at
    /// most 1/64.
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

impl<P: Product> Midpoint for DoubleDoubleBy<P> {
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
        let ball = FloatBall::<DoubleDouble>::of_words(is_negative, mantissa, exponent);
        FloatBall::new(Self::sum(ball.mid.hi(), ball.mid.lo()), ball.rad)
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

impl Edge for Settled {
    const TINY: f64 = 0.0;
    const LEAST: f64 = 0.0;

    #[inline(always)]
    fn settled<M: Midpoint>(mid: M, rad: f64) -> (M, f64) {
        let size = mid.hi().abs();
        // Nearly always, and without a branch between the four. A NaN is in no range.
        let in_range = (size >= SMALLEST || size == 0.0) & (size <= LARGEST);
        if in_range & (rad >= LEAST || rad == 0.0) & (rad <= LARGEST) {
            return (mid, rad);
        }
        match at_the_edge(size, rad) {
            (true, rad) => (mid, rad),
            (false, rad) => (M::ZERO, rad),
        }
    }
}

#[cold]
fn at_the_edge(size: f64, rad: f64) -> (bool, f64) {
    anywhere(size, rad)
}

/// Tells whether a midpoint of size `size` is kept, which else becomes zero, and the radius: without a branch.
#[inline(always)]
#[allow(clippy::manual_range_contains, reason = "a range decides in two steps")]
pub(super) fn anywhere(size: f64, rad: f64) -> (bool, f64) {
    let in_range = (size <= LARGEST) & (rad >= 0.0) & (rad <= LARGEST);
    let is_kept = (size == 0.0) | (size >= SMALLEST);
    // The size of the midpoint exceeds that of its leading double by at most `u` of it.
    let rad = if is_kept { rad } else { (rad + size) * UP };
    let rad = if rad == 0.0 { 0.0 } else { rad.max(LEAST) };
    (in_range & is_kept, if in_range { rad } else { f64::INFINITY })
}

impl Edge for Branchless {
    const TINY: f64 = power_of_two(-990);
    const LEAST: f64 = power_of_two(-60);

    #[inline(always)]
    fn settled<M: Midpoint>(mid: M, rad: f64) -> (M, f64) {
        (mid, rad)
    }
}

impl<M: Midpoint, E: Edge> FloatBall<M, E> {
    /// The whole line: nothing is known.
    pub const WHOLE: Self = Self::within(M::ZERO, f64::INFINITY);

    /// The ball of parts that are in range.
    #[inline(always)]
    pub(super) const fn within(mid: M, rad: f64) -> Self {
        Self { mid, rad, edge: PhantomData }
    }

    /// All numbers within `rad` of `mid`; the whole line unless both are numbers and the second is not negative.
    #[inline(always)]
    pub fn new(mid: M, rad: f64) -> Self {
        let (mid, rad) = E::settled(mid, rad);
        Self::within(mid, rad)
    }

    /// The number `mid`; the whole line if it is none.
    #[inline(always)]
    pub fn exact(mid: M) -> Self {
        Self::new(mid, if mid.hi().is_finite() { 0.0 } else { f64::NAN })
    }

    /// The result of an operation on midpoints, with what its radius is but for the error of that.
    #[inline(always)]
    fn rounded(mid: M, rad: f64) -> Self {
        Self::new(mid, (rad + (M::UNIT * mid.hi().abs() + E::TINY)) * UP)
    }

    /// The midpoint; zero for the whole line of [`Settled`] balls.
    #[inline(always)]
    pub fn mid(&self) -> M {
        self.mid
    }

    /// The radius; infinite for the whole line, or not a number.
    #[inline(always)]
    pub fn rad(&self) -> f64 {
        self.rad
    }

    /// Ball with the midpoint of this one and `more`, not negative, added to the radius.
    #[inline(always)]
    pub fn widened(&self, more: f64) -> Self {
        Self::new(self.mid, (self.rad + more) * UP)
    }

    /// An upper bound of the size of all numbers of the ball.
    #[inline(always)]
    pub fn size(&self) -> f64 {
        (self.mid.hi().abs() + self.rad) * UP
    }
}

impl<P: Product, E: Edge> FloatBall<DoubleDoubleBy<P>, E> {
    /// The set as a ball around the double nearest to the midpoint, outward.
    #[inline(always)]
    pub fn in_doubles(&self) -> FloatBall<f64, E> {
        FloatBall::new(self.mid.hi(), (self.rad + self.mid.lo().abs()) * UP)
    }
}

impl<E: Edge> FloatBall<f64, E> {
    /// The set in numbers of two doubles.
    #[inline(always)]
    pub fn in_double_doubles<P: Product>(&self) -> FloatBall<DoubleDoubleBy<P>, E> {
        FloatBall::new(DoubleDoubleBy::exact(self.mid), self.rad)
    }
}

impl<M: Midpoint> FloatBall<M> {
    /// A ball that holds this one and another; tight where they differ by little.
    pub fn hull(&self, other: &Self) -> Self {
        self.widened((*self - other).size()).widened(other.rad)
    }
}

impl<M: Midpoint, E: Edge> Real for FloatBall<M, E>
where
    Self: Field,
{
    #[inline]
    fn pi(&self) -> Self {
        let (mid, rad) = M::PI;
        Self::within(mid, rad)
    }

    /// The square root; the whole line unless every number of the ball is at least zero.
    ///
    /// Radius: `|√x - √m| = |x - m| / (√x + √m)` is at most `r / (√(m-r) + √m)`.
    #[inline(always)]
    fn sqrt(&self) -> Self {
        let (low, root) = ((self.mid.shortened() - self.rad) * DOWN, self.mid.root());
        let rad = self.rad / ((low.sqrt() + root.hi()) * DOWN);
        // A number has a root without a radius, zero as well.
        let rad = if self.rad == 0.0 { 0.0 } else { rad };
        Self::rounded(root, if low >= E::LEAST { rad } else { f64::NAN })
    }

    /// Sine and cosine. For `|d| <= r`, `|sin(m+d) - sin m| <= min(r, r |cos m| + r²/2)`, and the same with the two
    /// exchanged. Beyond `±4` the answer is `[-1, 1]`.
    #[inline]
    fn sin_cos(&self) -> (Self, Self) {
        let (size, r) = (self.mid.hi().abs(), self.rad);
        if size > double_sine::LARGEST || r >= 1.0 {
            let unit = Self::within(M::ZERO, 1.0);
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
        from_series(self, count, terms(M::BITS, i64::from(exponent(size)) + 1), &tail)
    }
}

impl<M: Midpoint, E: Edge> Enclosure for FloatBall<M, E>
where
    Self: Field,
{
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
        Self::within(if self.is_bounded() { self.mid } else { M::ZERO }, 0.0)
    }

    #[inline(always)]
    fn centred(&self) -> Self {
        Self::within(M::ZERO, self.rad)
    }

    #[inline]
    fn lies_inside(&self, outer: &Self) -> bool {
        ((self.mid - outer.mid).hi().abs() + self.rad) * UP < outer.rad
    }

    #[inline]
    fn overlaps(&self, other: &Self) -> bool {
        let is_apart = (self.mid - other.mid).hi().abs() * DOWN > (self.rad + other.rad) * UP;
        !is_apart
    }
}

/// The operations of balls with an edge, and how they are called.
macro_rules! arithmetic {
    ($edge:ty, $inline:meta) => {
        impl<M: Midpoint> FloatBall<M, $edge> {
            #[inline(always)]
            fn negated(self) -> Self {
                Self { mid: -self.mid, ..self }
            }

            #[$inline]
            fn plus(self, other: &Self) -> Self {
                Self::rounded(self.mid + other.mid, self.rad + other.rad)
            }

            #[$inline]
            fn minus(self, other: &Self) -> Self {
                Self::rounded(self.mid - other.mid, self.rad + other.rad)
            }

            /// Product of balls: for `|x - a| <= r` and `|y - b| <= s`, `|xy - ab| <= |a| s + (|b| + s) r`.
            #[$inline]
            fn times(self, other: &Self) -> Self {
                let (a, b) = (self.mid.hi().abs(), other.mid.hi().abs());
                Self::rounded(self.mid * other.mid, a * other.rad + (b + other.rad) * self.rad)
            }

            /// Quotient of balls: for `|x - a| <= r` and `|y - b| <= s`, `|x/y - a/b| <= (r + |a/b| s) / (|b| - s)`;
            /// the whole line where a divisor may be zero.
            #[$inline]
            fn over(self, other: &Self) -> Self {
                let least = (other.mid.shortened().abs() - other.rad) * DOWN;
                let quotient = self.mid / other.mid;
                let rad = (self.rad + quotient.hi().abs() * other.rad) / least;
                let is_divisor = least > <$edge>::LEAST;
                Self::rounded(quotient, if is_divisor { rad } else { f64::NAN })
            }
        }

        impl<M: Midpoint> Field for FloatBall<M, $edge> {
            #[inline(always)]
            fn int(&self, n: i32) -> Self {
                Self::within(self.mid.int(n), 0.0)
            }
        }

        operators!([M: Midpoint] FloatBall<M, $edge>);
    };
}

arithmetic!(Settled, inline);
arithmetic!(Branchless, inline(always));
