//! Balls: an MPFR midpoint with a rigorous radius.
//!
//! One full-precision operation per step, half the price of two endpoints. Each operation rounds
//! its midpoint to nearest and adds half a unit of the last place to a radius that is itself
//! rounded up; an exact midpoint operation adds nothing. Where a result cannot be bounded (a
//! divisor that may be zero, the root of a negative number, an MPFR overflow) the ball is the whole
//! line, never NaN.
//!
//! Not guaranteed: that a radius is the smallest possible. Division and square root are within a
//! factor of two of it for narrow balls, and sums and products see no correlation between
//! operands (`x - x` has twice the radius of `x`).

use super::{Decimal, Enclosure, Field, Magnitude, Ternary};
use crate::number::shown_as_text;
use rug::float::{Constant, Round};
use rug::ops::{
    AddAssignRound, AssignRound, DivAssignRound, MulAssignRound, NegAssign, SubAssignRound,
};
use rug::{Float, Integer, Rational};
use std::cmp::Ordering;
use std::fmt;

/// All real numbers within `radius` of `midpoint`. A precision is a number of bits, at least one: MPFR
/// knows no fewer.
#[derive(Clone)]
pub struct Ball {
    mid: Float,
    rad: Magnitude,
    /// Bits to which results are rounded; an exact midpoint may have fewer.
    prec: u32,
}

/// Beyond this many bits above the precision an argument of sine and cosine is not reduced: the
/// reduction would need as many digits of pi as the argument has, for a result worth nothing.
const REDUCTION_LIMIT: i64 = 64;

impl Ball {
    /// The exact value `mid`, with results to be rounded to `prec` bits. An infinity or NaN
    /// becomes the whole line.
    pub fn exact(mid: Float, prec: u32) -> Self {
        if mid.is_finite() { Self { mid, rad: Magnitude::ZERO, prec } } else { Self::whole(prec) }
    }

    /// `mid ± rad`, with results to be rounded to `prec` bits.
    pub fn new(mid: Float, rad: Magnitude, prec: u32) -> Self {
        Self::exact(mid, prec).widened(rad)
    }

    /// The integer `n`.
    pub fn integer(n: i32, prec: u32) -> Self {
        Self::exact(Float::with_val(32, n), prec)
    }

    /// A ball of `prec` bits that holds the integer `value`.
    pub fn from_integer(value: &Integer, prec: u32) -> Self {
        Self::rounded(Float::with_val_round(prec, value, Round::Nearest), Magnitude::ZERO, prec)
    }

    /// A ball of `prec` bits that holds `value 2^-places`.
    pub(super) fn fixed(value: &Integer, places: u32, prec: u32) -> Self {
        let (mut mid, direction) = Float::with_val_round(prec, value, Round::Nearest);
        // Exact: exponents reach far beyond any number of places.
        mid >>= places;
        Self::rounded((mid, direction), Magnitude::ZERO, prec)
    }

    /// The ball times `2^power`.
    pub fn scaled(&self, power: i64) -> Self {
        let Ok(shift) = i32::try_from(power) else { return Self::whole(self.prec) };
        let mid = Float::with_val_round(self.mid.prec(), &self.mid << shift, Round::Nearest);
        Self::rounded(mid, self.rad.shifted(power), self.prec)
    }

    /// A ball of `prec` bits that holds the rational number `value`.
    pub fn enclosing(value: &Rational, prec: u32) -> Self {
        Self::rounded(Float::with_val_round(prec, value, Round::Nearest), Magnitude::ZERO, prec)
    }

    /// The whole line: nothing is known.
    pub fn whole(prec: u32) -> Self {
        Self { mid: Float::new(prec.min(32)), rad: Magnitude::INFINITE, prec }
    }

    /// A ball that holds this one and another; tight where they differ by little.
    pub fn hull(&self, other: &Self) -> Self {
        let gap = self.clone() - other;
        self.clone().widened(gap.size()).widened(other.rad())
    }

    /// The midpoint; zero for the whole line.
    pub fn mid(&self) -> &Float {
        &self.mid
    }

    /// The radius.
    pub fn rad(&self) -> Magnitude {
        self.rad
    }

    /// The precision in bits to which results are rounded.
    pub fn prec(&self) -> u32 {
        self.prec
    }

    /// Upper bound of the size of every number of the ball.
    pub fn size(&self) -> Magnitude {
        Magnitude::upper(&self.mid).plus(self.rad)
    }

    /// Exponent `e` with every number of the ball below `2^e` in size; that of the last bit for zero.
    pub(super) fn size_exponent(&self) -> Option<i64> {
        let size = self.size();
        if size.is_zero() { Some(-i64::from(self.prec)) } else { size.exponent() }
    }

    /// A number not above any of the ball, rounded down; `-inf` for the whole line.
    pub fn lower(&self) -> Float {
        self.end(-self.rad.to_float(), Round::Down)
    }

    /// A number not below any of the ball, rounded up; `+inf` for the whole line.
    pub fn upper(&self) -> Float {
        self.end(self.rad.to_float(), Round::Up)
    }

    fn end(&self, step: Float, round: Round) -> Float {
        Float::with_val_round(self.mid.prec().max(self.prec) + 32, &self.mid + &step, round).0
    }

    /// Tells whether `x` is one of the numbers of the ball, decided exactly.
    pub fn contains(&self, x: &Rational) -> bool {
        if !self.is_bounded() {
            return true;
        }
        let (Some(mid), Some(rad)) = (self.mid.to_rational(), self.rad.to_float().to_rational())
        else {
            return true;
        };
        (mid - x).abs() <= rad
    }

    /// The double nearest to every number of the ball, ties to even; `None` if they differ.
    pub fn nearest_double(&self) -> Option<f64> {
        let (low, high) = (self.lower().to_f64(), self.upper().to_f64());
        // Adding zero makes a negative zero positive.
        (low == high).then_some(low + 0.0)
    }

    /// Ball with the midpoint of this one and `more` added to the radius.
    pub fn widened(mut self, more: Magnitude) -> Self {
        self.rad = self.rad.plus(more);
        if self.rad.is_finite() { self } else { Self::whole(self.prec) }
    }

    /// The ball with its midpoint rounded to `prec` bits and results rounded to `prec` bits from
    /// here on; the rounding is added to the radius.
    pub fn with_precision(&self, prec: u32) -> Self {
        if self.mid.prec() <= prec {
            return Self { prec, ..self.clone() };
        }
        Self::rounded(Float::with_val_round(prec, &self.mid, Round::Nearest), self.rad, prec)
    }

    /// The ball with the midpoint bits dropped that its radius makes worthless (a few are kept, so
    /// that the radius grows by less than one part in 2^16). The precision stays.
    pub fn trimmed(self) -> Self {
        let (Some(noise), Some(size)) = (self.rad.exponent(), self.mid.get_exp()) else {
            return self;
        };
        let useful = (i64::from(size) - noise + 18).clamp(32, i64::from(u32::MAX)) as u32;
        if useful >= self.mid.prec() {
            return self;
        }
        Self { prec: self.prec, ..self.with_precision(useful) }
    }

    /// A midpoint with the direction in which it was rounded; the error of that is added to `rad`.
    fn rounded((mid, direction): (Float, Ordering), rad: Magnitude, prec: u32) -> Self {
        if !mid.is_finite() {
            return Self::whole(prec);
        }
        let error = rounding_error(&mid, direction);
        Self { mid, rad, prec }.widened(error)
    }

    fn common(&self, other: &Self) -> u32 {
        self.prec.max(other.prec)
    }
}

/// A finite `x` in units of `2^-places`, rounded down.
pub(super) fn fixed(x: &Float, places: u32) -> Integer {
    let Some((mantissa, exponent)) = x.to_integer_exp() else { return Integer::new() };
    match i64::from(exponent) + i64::from(places) {
        up if up >= 0 => mantissa << up as u32,
        down => mantissa >> down.unsigned_abs().min(u64::from(u32::MAX)) as u32,
    }
}

/// A bound of the error of a midpoint that was rounded to nearest in some direction.
fn rounding_error(x: &Float, direction: Ordering) -> Magnitude {
    if direction == Ordering::Equal { Magnitude::ZERO } else { half_ulp(x) }
}

/// A bound of the error of a midpoint rounded to nearest. Next to the underflow threshold the
/// spacing of MPFR numbers is the threshold itself, so that is the least this can be.
fn half_ulp(x: &Float) -> Magnitude {
    let least = i64::from(rug::float::exp_min());
    let exponent = x.get_exp().map_or(least, |e| i64::from(e) - i64::from(x.prec()) - 1);
    Magnitude::power_of_two(exponent.max(least))
}

impl Field for Ball {
    fn int(&self, n: i32) -> Self {
        Self::integer(n, self.prec)
    }

    fn square(&self) -> Self {
        let mid = Float::with_val_round(self.prec, self.mid.square_ref(), Round::Nearest);
        let size = Magnitude::upper(&self.mid);
        let rad = size.times(self.rad).shifted(1).plus(self.rad.times(self.rad));
        Self::rounded(mid, rad, self.prec)
    }
}

/// Real functions, by MPFR.
impl Ball {
    /// Pi.
    pub(super) fn pi_by_mpfr(&self) -> Self {
        let pi = Float::with_val_round(self.prec, Constant::Pi, Round::Nearest);
        Self::rounded(pi, Magnitude::ZERO, self.prec)
    }

    /// The square root; the whole line unless every number of the ball is at least zero.
    ///
    /// Radius: for `x` in `m ± r`, `|√x - √m| = |x - m| / (√x + √m)` is at most
    /// `r / (√(m-r) + √m)`; the root of the lower end is bounded by `√m (1 - r/m)`.
    ///
    /// GMP 6.2 and 6.3 take some numbers of more than eight words for squares that are none, and MPFR
    /// rounds by that: so the distance of the new midpoint `n` from `√m` is computed too,
    /// `|n² - m| / (n + √m)`.
    pub(super) fn sqrt_by_mpfr(&self) -> Self {
        if self.mid.is_zero() && self.rad.is_zero() {
            return self.clone();
        }
        let low = Magnitude::lower(&self.mid);
        if self.mid.is_sign_negative() || self.rad > low {
            return Self::whole(self.prec);
        }
        let (mid, direction) =
            Float::with_val_round(self.prec, self.mid.sqrt_ref(), Round::Nearest);
        let root = Magnitude::lower(&Float::with_val_round(64, self.mid.sqrt_ref(), Round::Down).0);
        let one = Magnitude::from_integer(1);
        let low_root = root.times_down(one.minus_down(self.rad.over(low)));
        // A sum rounded down: each part once more below itself by the rounding of `plus`.
        let sum =
            |a: Magnitude, b| a.plus(b).times_down(one.minus_down(Magnitude::power_of_two(-29)));
        let rad = self.rad.over(sum(low_root, root).max(root));
        let square = Float::with_val(2 * mid.prec(), mid.square_ref());
        let rest = Float::with_val_round(64, &square - &self.mid, Round::AwayZero).0;
        let distance = Magnitude::upper(&rest).over(sum(Magnitude::lower(&mid), root));
        let error = rounding_error(&mid, direction).max(distance);
        Self { mid, rad, prec: self.prec }.widened(error)
    }

    /// Sine and cosine. For `|d| <= r`, `|sin(m+d) - sin m| <= min(r, r |cos m| + r²/2)`, and the
    /// same with the two exchanged. An argument too large to reduce gives `[-1, 1]`.
    pub(super) fn sin_cos_by_mpfr(&self) -> (Self, Self) {
        let unit = Self { mid: Float::new(32), rad: Magnitude::from_integer(1), prec: self.prec };
        let limit = i64::from(self.prec) + REDUCTION_LIMIT;
        let reducible = self.mid.get_exp().is_none_or(|e| i64::from(e) <= limit);
        if !self.is_bounded() || !reducible || self.rad >= Magnitude::from_integer(1) {
            return (unit.clone(), unit);
        }
        let (mut sin, mut cos) = (Float::new(self.prec), Float::new(self.prec));
        let directions = (&mut sin, &mut cos).assign_round(self.mid.sin_cos_ref(), Round::Nearest);
        let spread = |slope: &Float, direction| {
            let slope = Magnitude::upper(slope).plus(rounding_error(slope, direction));
            let bent = slope.times(self.rad).plus(self.rad.times(self.rad).shifted(-1));
            self.rad.min(bent)
        };
        let (sin_rad, cos_rad) = (spread(&cos, directions.1), spread(&sin, directions.0));
        (
            Self::rounded((sin, directions.0), sin_rad, self.prec),
            Self::rounded((cos, directions.1), cos_rad, self.prec),
        )
    }
}

impl Enclosure for Ball {
    fn is_positive(&self) -> Ternary {
        match (self.lower() > 0, self.upper() <= 0) {
            (true, _) => Ternary::True,
            (_, true) => Ternary::False,
            _ => Ternary::Undecided,
        }
    }

    fn is_bounded(&self) -> bool {
        self.rad.is_finite()
    }

    fn midpoint(&self) -> Self {
        Self { rad: Magnitude::ZERO, ..self.clone() }
    }

    fn centred(&self) -> Self {
        Self { mid: Float::new(32), ..self.clone() }
    }

    fn lies_inside(&self, outer: &Self) -> bool {
        if !self.is_bounded() {
            return false;
        }
        if !outer.is_bounded() {
            return true;
        }
        // |mid - outer.mid| + rad < outer.rad, with the left side rounded up.
        let distance = Float::with_val_round(64, &self.mid - &outer.mid, Round::AwayZero).0;
        Magnitude::upper(&distance).plus(self.rad) < outer.rad
    }

    fn overlaps(&self, other: &Self) -> bool {
        !(self.upper() < other.lower() || other.upper() < self.lower())
    }
}

/// `x op y` rounded to `prec` bits and the direction of the rounding; in the place of `x` where that has as many, as
/// memory costs as much as the arithmetic of a few words.
macro_rules! rounded {
    ($x:expr, $op:tt, $assign:ident, $y:expr, $prec:expr) => {{
        let mut x = $x;
        if x.prec() == $prec {
            let direction = x.$assign($y, Round::Nearest);
            (x, direction)
        } else {
            Float::with_val_round($prec, &x $op $y, Round::Nearest)
        }
    }};
}

impl Ball {
    fn negated(mut self) -> Self {
        self.mid.neg_assign();
        self
    }

    fn plus(self, other: &Self) -> Self {
        let prec = self.common(other);
        let mid = rounded!(self.mid, +, add_assign_round, &other.mid, prec);
        Self::rounded(mid, self.rad.plus(other.rad), prec)
    }

    fn minus(self, other: &Self) -> Self {
        let prec = self.common(other);
        let mid = rounded!(self.mid, -, sub_assign_round, &other.mid, prec);
        Self::rounded(mid, self.rad.plus(other.rad), prec)
    }

    fn times(self, other: &Self) -> Self {
        let prec = self.common(other);
        let rad = if self.rad.is_zero() && other.rad.is_zero() {
            Magnitude::ZERO
        } else {
            Magnitude::upper(&self.mid)
                .times(other.rad)
                .plus(Magnitude::upper(&other.mid).plus(other.rad).times(self.rad))
        };
        let mid = rounded!(self.mid, *, mul_assign_round, &other.mid, prec);
        Self::rounded(mid, rad, prec)
    }

    /// Quotient of balls: for `x` in `a ± r` and `y` in `b ± s`, `|x/y - a/b| <= (r + |a/b| s) / (|b| - s)`.
    fn over(self, other: &Self) -> Self {
        let prec = self.common(other);
        let least = Magnitude::lower(&other.mid).minus_down(other.rad);
        if least.is_zero() {
            return Self::whole(prec);
        }
        if self.mid.is_zero() && self.rad.is_zero() {
            return Self { prec, ..self };
        }
        let (mid, direction) = rounded!(self.mid, /, div_assign_round, &other.mid, prec);
        let rad = if self.rad.is_zero() && other.rad.is_zero() {
            Magnitude::ZERO
        } else {
            let quotient = Float::with_val_round(64, &mid, Round::AwayZero).0;
            let size = Magnitude::upper(&quotient).plus(half_ulp(&mid));
            self.rad.plus(size.times(other.rad)).over(least)
        };
        Self::rounded((mid, direction), rad, prec)
    }
}

operators!(Ball);

/// Operators with a small integer on the right, with a reference on the left, and in place.
macro_rules! more_operators {
    ($($op:ident $method:ident $assign:ident $in_place:ident;)+) => {$(
        impl std::ops::$op<i32> for Ball {
            type Output = Self;
            fn $method(self, other: i32) -> Self {
                let other = self.int(other);
                std::ops::$op::$method(self, other)
            }
        }

        references! { Ball: $op $method: &Ball, Ball, i32; }
        more_operators!(@ $op $method $assign $in_place: &Ball, Ball, i32);
    )+};
    (@ $op:ident $method:ident $assign:ident $in_place:ident: $($right:ty),+) => {$(
        impl std::ops::$assign<$right> for Ball {
            fn $in_place(&mut self, other: $right) {
                *self = std::ops::$op::$method(self.clone(), other);
            }
        }
    )+};
}

more_operators! {
    Add add AddAssign add_assign;
    Sub sub SubAssign sub_assign;
    Mul mul MulAssign mul_assign;
    Div div DivAssign div_assign;
}

impl std::ops::Neg for &Ball {
    type Output = Ball;
    fn neg(self) -> Ball {
        self.clone().negated()
    }
}

/// The double itself, with results to be rounded to the bits of a double; beside a longer ball, to those of that. The
/// whole line for an infinity or NaN.
impl From<f64> for Ball {
    fn from(value: f64) -> Self {
        Self::exact(Float::with_val(f64::MANTISSA_DIGITS, value), f64::MANTISSA_DIGITS)
    }
}

/// Digits that are shown where no number of them is asked for.
const SHOWN: usize = 20;
/// Digits of a bound.
const BOUND: usize = 3;
/// Bits beyond those of a ball in which its digits are compared with it.
const GUARD: u32 = 64;

impl fmt::Display for Ball {
    /// The digits that the ball has, 20 of them at most, and a bound of how far from these any of its numbers is:
    /// `[0.33333333333 +/- 3.72e-12]`; `{:.40}` shows up to 40. A bound alone where no digit is known, no bound where
    /// the digits are the number.
    ///
    /// ```
    /// use couplet_number::number::{Ball, Field, Real};
    /// let tenth = Ball::from(1.0) / 10;
    /// assert_eq!(tenth.to_string(), "[0.100000000000000 +/- 1.25e-17]");
    /// assert_eq!(format!("{:.4}", tenth.pi()), "[3.142 +/- 4.08e-4]");
    /// assert_eq!((tenth.int(5) / 2).to_string(), "2.5");
    /// ```
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let most = f.precision().unwrap_or(SHOWN).max(1);
        // The radius is less than a unit of the last digit.
        let digits = match (self.mid.get_exp(), self.rad.exponent()) {
            (Some(size), Some(noise)) => {
                let bits = i64::from(size) - 1 - noise;
                (bits as f64 * std::f64::consts::LOG10_2).floor().clamp(0.0, most as f64) as usize
            }
            (None, Some(_)) => 0,
            _ => most,
        };
        let shown = decimal(&self.mid, digits.max(1), Round::Nearest);
        let bound = |x: &Self| {
            let bound = x.size();
            match bound.is_finite() {
                true => format!("{:e}", decimal(&bound.to_float(), BOUND, Round::Up)),
                false => "inf".to_owned(),
            }
        };
        if digits == 0 || !self.is_bounded() {
            return write!(f, "[+/- {}]", bound(self));
        }
        let text = Float::parse(shown.to_string()).map_err(|_| fmt::Error)?;
        let bits = self.mid.prec().max(4 * digits as u32) + GUARD;
        let read = Float::with_val_round(bits, text, Round::Nearest);
        let apart = self.clone() - Self::rounded(read, Magnitude::ZERO, bits);
        match apart.mid.is_zero() && apart.rad.is_zero() {
            true => fmt::Display::fmt(&shown.shortened(), f),
            // Without zeros that only show the size.
            false if shown.exponent() > 0 => write!(f, "[{shown:e} +/- {}]", bound(&apart)),
            false => write!(f, "[{shown} +/- {}]", bound(&apart)),
        }
    }
}

/// A finite number rounded to so many digits.
fn decimal(x: &Float, digits: usize, round: Round) -> Decimal {
    let (negative, text, exponent) = x.to_sign_string_exp_round(10, Some(digits), round);
    // The point stands in front of the digits.
    let exponent = exponent.map_or(0, |exponent| i64::from(exponent) - text.len() as i64);
    Decimal::new(negative, &text, exponent)
}

shown_as_text!(Ball);

#[cfg(test)]
mod tests;
