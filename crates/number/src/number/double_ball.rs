//! Balls of doubles: a double with a radius that is a double, without a heap.
//!
//! With `u = 2^-53` each operation rounds its midpoint `m` to nearest, an error of at most `u |m|`, and adds that to a
//! radius computed from the radii of the operands.
//!
//! **The radius is rounded up**: its formula has positive terms only and at most eight roundings on any path, each
//! of which takes away less than a part `u` of what is added up; the last factor is [`UP`] `= 1 + 16 u`, and
//! `(1 - u)^9 (1 + 16 u) > 1`. What has to be bounded from below is multiplied by [`DOWN`] `= 1 - 16 u` in the same way.
//!
//! **Nothing overflows or underflows unseen.** A midpoint is zero or between [`SMALLEST`] `= 2^-220` and
//! [`LARGEST`] `= 2^220` in size, a radius zero, infinite, or between [`LEAST`] `= 2^-330` and `LARGEST`. Hence all that is computed
//! on the way (`a b`, `a/b`, `|m| s / least`, `r²`) is above `2^-1000` and below `2^1000`, or zero. [`settled`] puts each result
//! back into these ranges, outward: a smaller midpoint becomes zero and is added to the radius, a smaller
//! radius becomes `LEAST`, and anything larger, or NaN, becomes the whole line.

use super::double_sine::{self, sin_cos};
use super::stumpff::{from_series, terms};
use super::{DoubleDouble, Enclosure, Field, Real, Stumpff, Ternary};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All real numbers within `rad` of `mid`. A midpoint below `2^-220` in size becomes zero and widens the radius by as
/// much; a midpoint or a radius above `2^220` makes the ball the whole line.
#[derive(Clone, Copy, Debug)]
pub struct DoubleBall {
    mid: f64,
    rad: f64,
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
pub(super) const LARGEST: f64 = power_of_two(220);
/// The smallest radius but zero.
pub(super) const LEAST: f64 = power_of_two(-330);

/// What becomes of a midpoint of size `size` and its radius: `Some((true, rad))` keeps the midpoint, `Some((false, rad))`
/// has it replaced by zero, `None` is the whole line.
#[inline(always)]
pub(super) fn settled(size: f64, rad: f64) -> Option<(bool, f64)> {
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
    // The size of a double-double exceeds that of its first part by at most `u` of it.
    let rad = if is_kept { rad } else { (rad + size) * UP };
    Some((is_kept, if rad == 0.0 { 0.0 } else { rad.max(LEAST) }))
}

impl DoubleBall {
    /// The whole line: nothing is known.
    pub const WHOLE: Self = Self { mid: 0.0, rad: f64::INFINITY };

    /// All numbers within `rad` of `mid`; the whole line unless both are numbers and the second is not negative.
    #[inline(always)]
    pub fn new(mid: f64, rad: f64) -> Self {
        match settled(mid.abs(), rad) {
            Some((true, rad)) => Self { mid, rad },
            Some((false, rad)) => Self { mid: 0.0, rad },
            None => Self::WHOLE,
        }
    }

    /// The double `mid`.
    #[inline(always)]
    pub fn exact(mid: f64) -> Self {
        Self::new(mid, 0.0)
    }

    /// A midpoint that was rounded to nearest, with what its radius is but for that.
    #[inline(always)]
    fn rounded(mid: f64, rad: f64) -> Self {
        Self::new(mid, (rad + U * mid.abs()) * UP)
    }

    /// The midpoint; zero for the whole line.
    #[inline(always)]
    pub fn mid(&self) -> f64 {
        self.mid
    }

    /// The radius; infinite for the whole line.
    #[inline(always)]
    pub fn rad(&self) -> f64 {
        self.rad
    }

    /// A double not above any number of the ball; `-inf` for the whole line.
    pub fn lower(&self) -> f64 {
        (self.mid - self.rad).next_down()
    }

    /// A double not below any number of the ball; `+inf` for the whole line.
    pub fn upper(&self) -> f64 {
        (self.mid + self.rad).next_up()
    }

    /// The same midpoint with `more`, not negative, added to the radius.
    #[inline]
    pub fn widened(&self, more: f64) -> Self {
        Self::new(self.mid, (self.rad + more) * UP)
    }

    /// An upper bound of the size of all numbers of the ball.
    pub fn size(&self) -> f64 {
        (self.mid.abs() + self.rad) * UP
    }
}

impl Field for DoubleBall {
    #[inline(always)]
    fn int(&self, n: i32) -> Self {
        Self { mid: f64::from(n), rad: 0.0 }
    }
}

impl Real for DoubleBall {
    #[inline]
    fn pi(&self) -> Self {
        // What the double leaves of pi, rounded up.
        Self { mid: std::f64::consts::PI, rad: 1.2246467991473532e-16 }
    }

    /// The square root; the whole line unless every number of the ball is at least zero.
    ///
    /// Radius: `|√x - √m| = |x - m| / (√x + √m)` is at most `r / (√(m-r) + √m)`.
    #[inline]
    fn sqrt(&self) -> Self {
        if self.mid == 0.0 && self.rad == 0.0 {
            return *self;
        }
        if self.mid <= 0.0 || self.rad > self.mid {
            return Self::WHOLE;
        }
        let low = (self.mid - self.rad) * DOWN;
        let root = self.mid.sqrt();
        Self::rounded(root, self.rad / ((low.sqrt() + root) * DOWN))
    }

    /// Sine and cosine. For `|d| <= r`, `|sin(m+d) - sin m| <= min(r, r |cos m| + r²/2)`, and the same with the two
    /// exchanged. Beyond `±4` the answer is `[-1, 1]`.
    #[inline]
    fn sin_cos(&self) -> (Self, Self) {
        let r = self.rad;
        if self.mid.abs() > double_sine::LARGEST || r >= 1.0 {
            let unit = Self { mid: 0.0, rad: 1.0 };
            return (unit, unit);
        }
        let (sin, cos) = sin_cos(DoubleDouble::exact(self.mid));
        let relative = if self.mid.abs() <= double_sine::RELATIVE { self.mid.abs() } else { 1.0 };
        let around = |value: DoubleDouble, slope: DoubleDouble, error: f64| {
            let bent = (slope.hi().abs() + double_sine::ERROR) * r + r * r / 2.0;
            Self::new(value.hi(), (r.min(bent) + value.lo().abs() + error) * UP)
        };
        (around(sin, cos, double_sine::ERROR * relative), around(cos, sin, double_sine::ERROR))
    }
}

impl Stumpff for DoubleBall {
    fn stumpff(&self, count: usize) -> Vec<Self> {
        let size = self.size();
        if size > 2.0 {
            return vec![Self::WHOLE; count];
        }
        // As for balls of MPFR: what follows the terms is within |u| of one.
        let tail = Self::exact(1.0).widened(size);
        from_series(self, count, terms(53, 1), &tail)
    }
}

impl Enclosure for DoubleBall {
    #[inline(always)]
    fn is_positive(&self) -> Ternary {
        if self.mid > self.rad {
            Ternary::True
        } else if -self.mid >= self.rad {
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
        Self { mid: 0.0, ..*self }
    }

    #[inline]
    fn lies_inside(&self, outer: &Self) -> bool {
        ((self.mid - outer.mid).abs() + self.rad) * UP < outer.rad
    }

    #[inline]
    fn overlaps(&self, other: &Self) -> bool {
        (self.mid - other.mid).abs() * DOWN <= (self.rad + other.rad) * UP
    }
}

impl Neg for DoubleBall {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { mid: -self.mid, ..self }
    }
}

impl Add<&DoubleBall> for DoubleBall {
    type Output = Self;
    #[inline]
    fn add(self, other: &Self) -> Self {
        Self::rounded(self.mid + other.mid, self.rad + other.rad)
    }
}

impl Sub<&DoubleBall> for DoubleBall {
    type Output = Self;
    #[inline]
    fn sub(self, other: &Self) -> Self {
        Self::rounded(self.mid - other.mid, self.rad + other.rad)
    }
}

impl Mul<&DoubleBall> for DoubleBall {
    type Output = Self;
    /// For `|x - a| <= r` and `|y - b| <= s`, `|xy - ab| <= |a| s + (|b| + s) r`.
    #[inline]
    fn mul(self, other: &Self) -> Self {
        let rad = self.mid.abs() * other.rad + (other.mid.abs() + other.rad) * self.rad;
        Self::rounded(self.mid * other.mid, rad)
    }
}

impl Div<&DoubleBall> for DoubleBall {
    type Output = Self;
    /// For `|x - a| <= r` and `|y - b| <= s`, `|x/y - a/b| <= (r + |a/b| s) / (|b| - s)`.
    #[inline]
    fn div(self, other: &Self) -> Self {
        let least = (other.mid.abs() - other.rad) * DOWN;
        if least <= 0.0 {
            return Self::WHOLE;
        }
        let quotient = self.mid / other.mid;
        Self::rounded(quotient, (self.rad + quotient.abs() * other.rad) / least)
    }
}

owned_operators!(DoubleBall);

#[cfg(test)]
mod tests {
    use super::*;
    use rug::{Float, float::Constant};

    #[test]
    fn what_is_out_of_range_is_widened_or_the_whole_line() {
        let tiny = DoubleBall::exact(1e-67);
        assert!(tiny.mid() == 0.0 && tiny.rad() >= 1e-67 && tiny.rad() < 1.1e-67);
        assert!(DoubleBall::new(1.0, f64::from_bits(1)).rad() == LEAST);
        assert!(DoubleBall::exact(0.0).rad() == 0.0 && DoubleBall::exact(-0.0).is_bounded());
        for (mid, rad) in [(1e67, 0.0), (1.0, 1e67), (f64::NAN, 0.0), (0.0, f64::NAN), (0.0, -1.0)]
        {
            assert!(!DoubleBall::new(mid, rad).is_bounded(), "{mid} {rad}");
        }
        let (huge, small) = (DoubleBall::exact(1e60), DoubleBall::exact(1e-60));
        assert!(!(huge * huge).is_bounded() && !(huge / small).is_bounded());
        assert!((small * small).rad() >= 1e-120);
        assert!(!(DoubleBall::WHOLE * DoubleBall::exact(0.0)).is_bounded());
        assert!(!(DoubleBall::exact(1.0) / DoubleBall::new(1.0, 1.0)).is_bounded());
    }

    #[test]
    fn signs_are_decided_only_when_they_are_known() {
        let sign = |mid, rad| DoubleBall::new(mid, rad).is_positive();
        assert_eq!([sign(1.0, 0.5), sign(-1.0, 1.0)], [Ternary::True, Ternary::False]);
        assert_eq!([sign(1.0, 1.0), sign(0.0, 0.0)], [Ternary::Undecided, Ternary::False]);
        assert_eq!(DoubleBall::WHOLE.is_positive(), Ternary::Undecided);
        let (inner, outer) = (DoubleBall::new(1.0, 0.25), DoubleBall::new(1.0, 0.5));
        assert!(
            inner.lies_inside(&outer) && !outer.lies_inside(&inner) && !inner.lies_inside(&inner)
        );
        assert!(
            inner.lies_inside(&DoubleBall::WHOLE)
                && !DoubleBall::WHOLE.lies_inside(&DoubleBall::WHOLE)
        );
        assert!(!inner.overlaps(&DoubleBall::new(2.0, 0.5)) && inner.overlaps(&DoubleBall::WHOLE));
    }

    #[test]
    fn roots_next_to_the_end_of_the_domain() {
        assert!(!DoubleBall::exact(-1.0).sqrt().is_bounded());
        assert!(!DoubleBall::new(1.0, 1.0f64.next_up()).sqrt().is_bounded());
        let half = DoubleBall::new(1.0, 1.0).sqrt();
        assert!(half.lower() <= 0.0 && half.upper() >= 2f64.sqrt());
        assert_eq!(DoubleBall::exact(0.0).sqrt().rad(), 0.0);
    }

    #[test]
    fn pi_lies_within_its_radius_and_not_within_less() {
        let pi = DoubleBall::exact(0.0).pi();
        let error = Float::with_val(300, Constant::Pi) - pi.mid();
        assert!(error <= pi.rad() && error > pi.rad().next_down());
    }
}
