//! Sine and cosine near a point where they are known.
//!
//! Sine and cosine of a full-length argument are the most expensive part of a landmark. An [`Anchor`]
//! holds them at a point where they are cheap, and reaches every argument nearby by a few
//! multiplications. The point is
//!
//! ```text
//! 2 sum c_j theta_j + y        e^(i point) = e^(iy) u²/|u|²,    u = prod z_j^(c_j)
//! ```
//!
//! with the arguments `theta_j` of Gaussian primes `z_j`, known once and for all, small integers `c_j` that
//! bring it near the point asked for, and a rest `y` that is small and **short** (Johansson 2022,
//! arXiv:2207.02501). A step `d` from there is a short series, the shorter the nearer.

use super::arctangents::Arguments;
use super::ball::fixed;
use super::burst;
use super::gaussian::Gaussian;
use super::lattice;
use super::turn::Turn;
use super::{Angle, Ball, Magnitude, Real};
use rug::{Float, Integer};

/// Sine and cosine at one point, to the precision given, ready to be moved to points nearby.
#[derive(Clone, Debug)]
pub struct Anchor {
    at: Ball,
    turn: Turn,
}

/// Series are used up to this distance, `2^-8`; beyond it sine and cosine are computed afresh.
const REACH: i64 = -8;
/// Bits kept beyond those of the result.
const GUARD: u32 = 24;
/// Below this many bits MPFR's own sine is faster.
const THRESHOLD: u32 = 1_000;

impl Anchor {
    /// Computes sine and cosine next to `near` to `prec` bits: not quite there, but as close as its own last bit.
    /// The fewer bits `near` has, the cheaper.
    pub fn new(near: &Float, prec: u32) -> Self {
        // A small angle has a small sine, which deserves the same relative accuracy.
        let depth = near.get_exp().map_or(0, |e| e.min(0).unsigned_abs()).min(prec);
        let places = prec + depth + GUARD;
        Self::reduced(near, prec, places).unwrap_or_else(|| {
            let at = Ball::exact(near.clone(), places);
            Self { turn: Turn::new(at.sin_cos(), places), at: at.with_precision(prec) }
        })
    }

    /// Computes what anchors of `prec` bits share, once for all threads.
    pub fn prepare(prec: u32) {
        Arguments::to(prec + 2 * GUARD);
    }

    /// By Gaussian primes; `None` where this is not worth it, or where no small rest is found.
    fn reduced(near: &Float, prec: u32, places: u32) -> Option<Self> {
        let exponent = near.get_exp().filter(|exponent| (-64..=4).contains(exponent))?;
        let short = near.prec().checked_add_signed(-exponent)?;
        if prec < THRESHOLD || short > places / 2 {
            return None;
        }
        let c = lattice::close(&fixed(near, lattice::PLACES - 1), relations_to(places));
        let (sum, error) = Arguments::to(places).combination(&c, places);
        let y = fixed(near, short) - Integer::from(&sum >> (places - short));
        if y.significant_bits() + 16 > short {
            return None;
        }
        let turn =
            burst::turn(&y, short, places).by_twice(&Gaussian::odd(&c)).by_right_angles(c[0]);
        let at = Ball::fixed(&(sum + (y << (places - short))), places, places).widened(error);
        Some(Self { at, turn })
    }

    /// The anchor moved next to `near`, as close as the last of the binary places of `near`, at its full precision.
    pub fn moved(&self, near: &Float) -> Self {
        let last = near.get_exp().map_or(0, |e| i64::from(near.prec()) - i64::from(e));
        let last = u32::try_from(last).unwrap_or(0).min(self.turn.places);
        let d = fixed(&Float::with_val(near.prec(), near - self.at.mid()), last);
        let step = d << (self.turn.places - last);
        let at = self.at.clone() + Ball::fixed(&step, self.turn.places, self.turn.places);
        match self.turn.moved(&step) {
            Some(turn) => Self { at, turn },
            None => Self::new(near, self.turn.places - GUARD),
        }
    }

    /// The anchor rounded to a lower precision.
    pub fn with_precision(&self, prec: u32) -> Self {
        let lost = self.at.prec().saturating_sub(prec + 2 * GUARD);
        Self {
            at: self.at.with_precision(prec + 2 * GUARD),
            turn: self.turn.cut(self.turn.places - lost),
        }
    }

    /// The point itself, to `prec` bits.
    pub(super) fn here(&self, prec: u32) -> Angle<Ball> {
        let (sin, cos) = self.turn.balls(prec);
        Angle { rad: self.at.with_precision(prec), sin, cos }
    }

    /// The angle `rad` with its sine and cosine, to the precision of `rad`.
    pub fn angle(&self, rad: &Ball) -> Angle<Ball> {
        let prec = rad.prec();
        let depth = size_exponent(&self.at).map_or(0, |e| -e.min(0)).unsigned_abs();
        let places = self.turn.places.min(prec.saturating_add(depth as u32).saturating_add(GUARD));
        let distance = (rad.clone() - &self.at.with_precision(places + GUARD)).trimmed();
        let is_near = size_exponent(&distance).is_some_and(|e| e <= REACH);
        let step = fixed(distance.mid(), places);
        let Some(turn) = self.turn.cut(places).moved(&step).filter(|_| is_near) else {
            return Angle::new(rad.clone());
        };
        let unit = Magnitude::power_of_two(-i64::from(places));
        let (sin, cos) = turn.balls(prec);
        let spread = distance.rad().plus(unit);
        // For |d| <= r, sine and cosine change by at most r, and by r |slope| + r²/2.
        let change = |slope: &Ball| {
            let slope = Magnitude::upper(slope.mid()).plus(slope.rad());
            spread.min(slope.times(spread).plus(spread.times(spread).shifted(-1)))
        };
        let (of_sin, of_cos) = (change(&cos), change(&sin));
        Angle { rad: rad.clone(), sin: sin.widened(of_sin), cos: cos.widened(of_cos) }
    }
}

/// How near the Gaussian primes bring an anchor of as many places, as a power of two; measured.
fn relations_to(places: u32) -> u32 {
    match places {
        0..4_000 => 36,
        4_000..12_000 => 48,
        12_000..60_000 => 80,
        60_000..600_000 => 120,
        _ => 160,
    }
}

/// Some `e` with every number of the ball below `2^e` in size.
fn size_exponent(x: &Ball) -> Option<i64> {
    let bound = Magnitude::upper(x.mid()).plus(x.rad());
    if bound.is_zero() { Some(-i64::from(x.prec())) } else { bound.exponent() }
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

    }
}
