//! Sine and cosine near a point where they are known, and the arctangent that follows.
//!
//! Sine and cosine of a full-length argument are the most expensive part of a landmark. An [`Anchor`]
//! holds them at one **short** argument, which is cheaper, and reaches every argument nearby by a
//! few multiplications: with `d = x - anchor`,
//!
//! ```text
//! sin x = s - (s vers d - c sin d)      cos x = c - (c vers d + s sin d)      vers d = 1 - cos d
//! ```
//!
//! `sin d` and `vers d` are alternating series, summed from the innermost term outwards. The
//! innermost factor is replaced by the interval `[0, 1]`, in which the rest of an alternating series
//! with falling terms lies: that is the whole truncation error. A term of relative size `2^-k` is
//! computed with `k` bits fewer.

use super::burst::{sine_and_cosine, turn};
use super::{Angle, Ball, Enclosure, Field, Magnitude, Real};
use rug::Float;

/// Sine and cosine at one point, to the precision given, ready to be moved to points nearby.
#[derive(Clone, Debug)]
pub struct Anchor {
    at: Ball,
    sin: Ball,
    cos: Ball,
}

/// Series are used up to this distance, `2^-8`; beyond it sine and cosine are computed afresh.
const REACH: i64 = -8;
/// Bits kept beyond those a term can contribute.
const GUARD: i64 = 16;

impl Anchor {
    /// Computes sine and cosine next to `near` to `prec` bits. The fewer bits `near` has, the cheaper.
    ///
    /// A short number is only cheap where no multiple of pi/2 has to be taken off first, which would
    /// make it long. So the anchor is `k pi/2 + y` with `y` short and at most pi/4 in size: not quite
    /// `near`, but as close to it as its own last bit.
    pub fn new(near: &Float, prec: u32) -> Self {
        let short = near.prec();
        let right_angle = Ball::integer(1, prec).pi() / Ball::integer(2, prec);
        let quarters = Float::with_val(short, near / right_angle.mid()).round();
        let rest = Float::with_val(short, near - right_angle.mid() * quarters.clone());
        let quarters = quarters.to_i32_saturating().unwrap_or_default();
        let (sin, cos) = sine_and_cosine(&rest, prec);
        let rest = Ball::exact(rest, prec);
        let (sin, cos) = match quarters.rem_euclid(4) {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        };
        let at = rest + right_angle * Ball::integer(quarters, prec);
        Self { at, sin, cos }
    }

    /// The anchor moved to the exact number `at` nearby, at its full precision.
    pub fn moved(&self, at: &Float) -> Self {
        let Angle { rad, sin, cos } = self.angle(&Ball::exact(at.clone(), self.sin.prec()));
        Self { at: rad, sin, cos }
    }

    /// The anchor rounded to a lower precision.
    pub fn with_precision(&self, prec: u32) -> Self {
        let [at, sin, cos] = [&self.at, &self.sin, &self.cos].map(|x| x.with_precision(prec));
        Self { at, sin, cos }
    }

    /// The angle `rad` with its sine and cosine, to the precision of `rad`.
    pub fn angle(&self, rad: &Ball) -> Angle<Ball> {
        let distance = (rad.clone() - &self.at).with_precision(rad.prec());
        let Some(exponent) = size_exponent(&distance).filter(|&e| e <= REACH) else {
            return Angle::new(rad.clone());
        };
        // A small angle has a small sine, which deserves the same relative accuracy.
        let smallness = size_exponent(&self.at).unwrap_or(0).min(0);
        let prec = i64::from(rad.prec()) - smallness;
        let (sine, versine) = small_sine_and_versine(&distance, exponent, prec);
        let (sin, cos) = turn((&self.sin, &self.cos), &sine, &versine, bits(prec - GUARD));
        let [sin, cos] = [sin, cos].map(|x| x.with_precision(rad.prec()));
        Angle { rad: rad.clone(), sin, cos }
    }
}

/// `sin d` and `1 - cos d`, to `2^-prec`, for a ball `d` within `2^exponent < 1` of zero.
fn small_sine_and_versine(d: &Ball, exponent: i64, prec: i64) -> (Ball, Ball) {
    let d = d.clone().trimmed().with_precision(bits(prec + exponent));
    let square = d.with_precision(bits(prec + 2 * exponent)).square();
    // vers d = d²/2 (1 - d²/12 (1 - d²/30 (…))): factors d²/((2k+1)(2k+2))
    let versine =
        alternating(&square, prec + 2 * exponent, exponent, |k| (2 * k + 1) * (2 * k + 2));
    let versine = square.clone() * &versine / square.int(2);
    // sin d = d (1 - d²/6 (1 - d²/20 (…))): factors d²/(2k (2k+1))
    let sine = alternating(&square, prec + exponent, exponent, |k| 2 * k * (2 * k + 1));
    (d * &sine, versine)
}

/// `1 - x/q(1) (1 - x/q(2) (1 - …))` to `prec` bits, for `x` in `[0, 1)` below `2^(2 exponent)`.
fn alternating(x: &Ball, prec: i64, exponent: i64, divisor: impl Fn(i32) -> i32) -> Ball {
    let terms = (prec + GUARD).max(0) / (-2 * exponent) + 1;
    let half = Ball::new(Float::with_val(32, 0.5), Magnitude::power_of_two(-1), 32);
    (1..=terms).rev().fold(half, |rest, k| {
        let bits = bits(prec + 2 * exponent * (k - 1));
        let x = x.with_precision(bits);
        let term = x * rest.with_precision(bits) / Ball::integer(divisor(k as i32), bits);
        term.int(1) - term
    })
}

/// The arctangent, to the precision of `x`, by one sine and cosine at a short argument:
/// with `a` near it, `atan x = a + atan t`, `t = (x cos a - sin a) / (cos a + x sin a)`.
///
/// `x` must be positive and bounded; otherwise the answer is the whole line.
pub fn arctangent(x: &Ball) -> Ball {
    let prec = x.prec();
    if !x.is_positive().is_proved() || !x.is_bounded() {
        return Ball::whole(prec);
    }
    let short = (prec / 16).max(64);
    let near = Float::with_val(short, x.mid()).atan();
    let anchor = Anchor::new(&near, prec);
    let t =
        (x.clone() * &anchor.cos - &anchor.sin) / (anchor.cos.clone() + x.clone() * &anchor.sin);
    let Some(exponent) = size_exponent(&t).filter(|&e| e <= REACH) else {
        return Ball::whole(prec);
    };
    // atan t = t (1 - t²/3 + t⁴/5 - …): the same alternating form with the factors k-th over
    // (k-1)-th term, t² (2k-1)/(2k+1).
    let width = i64::from(prec);
    let t = t.trimmed().with_precision(bits(width + exponent));
    let square = t.with_precision(bits(width + 2 * exponent)).square();
    let terms = (width + exponent + GUARD).max(0) / (-2 * exponent) + 1;
    let half = Ball::new(Float::with_val(32, 0.5), Magnitude::power_of_two(-1), 32);
    let series = (1..=terms).rev().fold(half, |rest, k| {
        let bits = bits(width + exponent + 2 * exponent * (k - 1));
        let factor = Ball::integer(2 * k as i32 - 1, bits) / Ball::integer(2 * k as i32 + 1, bits);
        let term = square.with_precision(bits) * rest.with_precision(bits) * factor;
        term.int(1) - term
    });
    (t * series).with_precision(prec) + &anchor.at
}

/// Some `e` with every number of the ball below `2^e` in size.
fn size_exponent(x: &Ball) -> Option<i64> {
    let bound = Magnitude::upper(x.mid()).plus(x.rad());
    if bound.is_zero() { Some(-i64::from(x.prec()) - GUARD) } else { bound.exponent() }
}

fn bits(wanted: i64) -> u32 {
    (wanted + GUARD).clamp(32, i64::from(u32::MAX)) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn high(x: &Float) -> (Ball, Ball) {
        Ball::exact(x.clone(), 6000).sin_cos()
    }

    proptest! {
        #![proptest_config(crate::number::test_config::config(64))]
        #[test]
        fn moved_values_hold_the_true_ones(
            start in 0.01f64..3.1, short in 30u32..400, prec in 64u32..3000, far in 5i32..1500, sign in any::<bool>(),
        ) {
            let at = Float::with_val(short, start);
            let step = Float::with_val(40, if sign { 1.3 } else { -1.3 }) >> far;
            let x = Float::with_val(4000, &at + &step);
            let angle = Anchor::new(&at, prec).angle(&Ball::exact(x.clone(), prec));
            let (sin, cos) = high(&x);
            for (ours, truth) in [(&angle.sin, &sin), (&angle.cos, &cos)] {
                prop_assert!(ours.lower() <= truth.lower() && truth.upper() <= ours.upper(), "{ours:?} {truth:?}");
                prop_assert!(ours.rad() < Magnitude::power_of_two(-i64::from(prec) + 8), "wide: {ours:?}");
            }
        }

        #[test]
        fn a_wide_argument_keeps_its_image(start in 0.1f64..3.0, width in 12i64..200, inside in -1.0f64..1.0) {
            let at = Float::with_val(100, start);
            let argument = Ball::new(at.clone(), Magnitude::power_of_two(-width), 300);
            let angle = Anchor::new(&at, 300).angle(&argument);
            let offset = Float::with_val(60, inside) >> i32::try_from(width).unwrap();
            let (sin, cos) = high(&Float::with_val(1000, &at + &offset));
            prop_assert!(angle.sin.lower() <= sin.lower() && sin.upper() <= angle.sin.upper());
            prop_assert!(angle.cos.lower() <= cos.lower() && cos.upper() <= angle.cos.upper());
        }

        #[test]
        fn the_arctangent_holds_the_true_one(x in prop_oneof![1e-6f64..10.0, 10.0f64..1e12], prec in 64u32..3000) {
            let x = Float::with_val(53, x);
            let ours = arctangent(&Ball::exact(x.clone(), prec));
            let truth = Float::with_val(6000, &x).atan();
            prop_assert!(ours.lower() <= truth && truth <= ours.upper());
            prop_assert!(ours.rad() < Magnitude::power_of_two(-i64::from(prec) + 16), "wide: {ours:?}");
        }
    }

    #[test]
    fn the_arctangent_refuses_what_it_cannot_do() {
        assert!(!arctangent(&Ball::integer(-1, 64)).is_bounded());
        assert!(!arctangent(&Ball::whole(64)).is_bounded());
    }
}
