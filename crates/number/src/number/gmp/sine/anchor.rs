//! Sine and cosine near a point where they are known.
//!
//! Sine and cosine of a full-length argument are the most expensive part of a landmark. A [`SineAnchor`]
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

use super::arctangents::PrimeArguments;
use super::burst;
use super::gaussian::Gaussian;
use super::lattice;
use super::turn::Turn;
use super::{Angle, Ball, Magnitude, fixed};
use rug::{Float, Integer};

/// Sine and cosine at one point, to the precision given, ready to be moved to points nearby.
#[derive(Clone, Debug)]
pub struct SineAnchor {
    at: Ball,
    turn: Turn,
}

/// Series are used up to this distance, `2^-8`; beyond it sine and cosine are computed afresh.
const REACH: i64 = -8;
/// Bits kept beyond those of the result.
const GUARD: u32 = 24;
/// Below this many bits MPFR's own sine is faster; at 33,000 it takes four times as long, measured.
const THRESHOLD: u32 = 1_000;
/// The anchor of an angle of all bits has this part of them: what is left is one step.
const NEAR: u32 = 16;
/// Bits that a sine or cosine may lose as it is near zero.
const LOST: i32 = 16;

impl SineAnchor {
    /// Computes sine and cosine next to `near` to `prec` bits: not quite there, but as close as its own last bit.
    /// The fewer bits `near` has, the cheaper.
    pub fn new(near: &Float, prec: u32) -> Self {
        let places = places(near, prec);
        Self::reduced(near, prec, places, relations_to(places)).unwrap_or_else(|| {
            let at = Ball::exact(near.clone(), places);
            Self { turn: Turn::new(at.sin_cos_by_mpfr(), places), at: at.with_precision(prec) }
        })
    }

    /// Sine and cosine of an angle; `None` where MPFR is faster, or has more of what is nearly zero.
    pub(in crate::number::gmp) fn sin_cos(rad: &Ball) -> Option<(Ball, Ball)> {
        let prec = rad.prec();
        let near = Float::with_val((prec / NEAR).max(64), rad.mid());
        let places = places(&near, prec);
        let anchor = Self::reduced(&near, prec, places, relations_to(places))?;
        let Angle { sin, cos, .. } = anchor.reached(rad)?;
        let has_all = |x: &Ball, least: i32| x.mid().get_exp().is_some_and(|e| e >= least - LOST);
        (has_all(&sin, near.get_exp()?.min(0)) && has_all(&cos, 0)).then_some((sin, cos))
    }

    /// Computes what anchors of `prec` bits share, once for all threads.
    pub fn prepare(prec: u32) {
        PrimeArguments::to(prec + 2 * GUARD);
    }

    /// Anchor by Gaussian primes with relations up to `rho`; `None` where this is not worth it, or where no
    /// small rest or no small powers are found.
    fn reduced(near: &Float, prec: u32, places: u32, rho: u32) -> Option<Self> {
        let exponent = near.get_exp().filter(|exponent| (-64..=4).contains(exponent))?;
        let short = near.prec().checked_add_signed(-exponent)?;
        if prec < THRESHOLD || short > places / 2 {
            return None;
        }
        let c = lattice::close(&fixed(near, lattice::PLACES - 1), rho);
        // No prime has a norm of more than seven bits.
        let norm: u64 = c.iter().skip(1).map(|c| 7 * u64::from(c.unsigned_abs())).sum();
        if norm > u64::from(places) {
            return None;
        }
        let (sum, error) = PrimeArguments::to(places).combination(&c, places);
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
        let prec = prec.saturating_add(2 * GUARD);
        Self {
            at: self.at.with_precision(prec),
            turn: self.turn.cut(prec.saturating_add(self.depth())),
        }
    }

    /// Binary zeros before a small angle.
    fn depth(&self) -> u32 {
        let zeros = self.at.size_exponent().map_or(0, |e| e.min(0).unsigned_abs());
        u32::try_from(zeros).unwrap_or(u32::MAX)
    }

    /// The point itself, to `prec` bits: its sine and cosine are enclosed, not those of all numbers of `rad`.
    pub(super) fn here(&self, prec: u32) -> Angle<Ball> {
        let (sin, cos) = self.turn.balls(prec);
        Angle { rad: self.at.with_precision(prec), sin, cos }
    }

    /// The angle `rad` with its sine and cosine, to the precision of `rad`.
    pub fn angle(&self, rad: &Ball) -> Angle<Ball> {
        self.reached(rad).unwrap_or_else(|| Angle::new(rad.clone()))
    }

    /// The angle, where it is near.
    fn reached(&self, rad: &Ball) -> Option<Angle<Ball>> {
        let prec = rad.prec();
        let wanted = prec.saturating_add(self.depth()).saturating_add(GUARD);
        let places = self.turn.places.min(wanted);
        let distance = (rad.clone() - &self.at.with_precision(places + GUARD)).trimmed();
        let is_near = distance.size_exponent().is_some_and(|e| e <= REACH);
        let moved = || self.turn.cut(places).moved(&fixed(distance.mid(), places));
        let turn = is_near.then(moved).flatten()?;
        let unit = Magnitude::power_of_two(-i64::from(places));
        let (sin, cos) = turn.balls(prec);
        let spread = distance.rad().plus(unit);
        // For |d| <= r, sine and cosine change by at most r, and by r |slope| + r²/2.
        let change = |slope: &Ball| {
            spread.min(slope.size().times(spread).plus(spread.times(spread).shifted(-1)))
        };
        let (of_sin, of_cos) = (change(&cos), change(&sin));
        Some(Angle { rad: rad.clone(), sin: sin.widened(of_sin), cos: cos.widened(of_cos) })
    }
}

/// The binary places of sine and cosine next to an angle: a small angle has a small sine, which deserves the same
/// relative accuracy.
fn places(near: &Float, prec: u32) -> u32 {
    prec + near.get_exp().map_or(0, |e| e.min(0).unsigned_abs()).min(prec) + GUARD
}

/// Nearness to which the Gaussian primes bring an anchor of as many places, as a power of two; measured.
fn relations_to(places: u32) -> u32 {
    match places {
        0..4_000 => 36,
        4_000..12_000 => 48,
        12_000..60_000 => 80,
        60_000..600_000 => 120,
        _ => 160,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Enclosure;
    use proptest::prelude::*;
    use rug::float::Constant;

    /// By MPFR alone.
    fn by_mpfr(x: &Ball) -> (Ball, Ball) {
        let bits = x.prec() + 64;
        let ball = |value: Float| {
            Ball::new(value, Magnitude::power_of_two(-i64::from(bits)), bits).widened(x.rad())
        };
        let sin = Float::with_val(bits, x.mid().sin_ref());
        (ball(sin), ball(Float::with_val(bits, x.mid().cos_ref())))
    }

    fn high(x: &Float) -> (Ball, Ball) {
        by_mpfr(&Ball::exact(x.clone(), 6000))
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
            let angle = SineAnchor::new(&at, prec).angle(&Ball::exact(x.clone(), prec));
            let (sin, cos) = high(&x);
            for (ours, truth) in [(&angle.sin, &sin), (&angle.cos, &cos)] {
                prop_assert!(ours.lower() <= truth.lower() && truth.upper() <= ours.upper(), "{ours:?} {truth:?}");
                prop_assert!(ours.rad() < Magnitude::power_of_two(-i64::from(prec) + 8), "wide: {ours:?}");
            }
        }

        /// Angles of all bits, of both signs, next to right angles too; with a radius or without.
        #[test]
        fn sines_of_all_bits_are_those_of_mpfr(
            start in -11.0f64..11.0, right in prop::option::of((-10i32..10, 2u32..6000)), prec in 1000u32..9000,
            radius in prop::option::of(-9000i64..-12),
        ) {
            let x = match right {
                Some((n, bits)) => Float::with_val(bits, Float::with_val(bits + 64, Constant::Pi) * n / 2u32),
                None => Float::with_val(prec, 2).sqrt() * start,
            };
            let x = Ball::new(x, radius.map_or(Magnitude::ZERO, Magnitude::power_of_two), prec);
            if let Some((sin, cos)) = SineAnchor::sin_cos(&x) {
                let truth = by_mpfr(&x.midpoint().with_precision(prec + 100));
                let [low, high] = [x.lower(), x.upper()].map(|end| by_mpfr(&Ball::exact(end, prec + 100)));
                for (ours, truths) in [(sin, [truth.0, low.0, high.0]), (cos, [truth.1, low.1, high.1])] {
                    for truth in truths {
                        prop_assert!(ours.lower() <= truth.upper() && truth.lower() <= ours.upper(), "{x}");
                    }
                    let size = i64::from(ours.mid().get_exp().unwrap());
                    let narrow = Magnitude::power_of_two(size - i64::from(prec) + 2);
                    prop_assert!(ours.rad() <= narrow.plus(x.rad()), "{x} {ours:?}");
                }
            } else {
                prop_assert!(right.is_some(), "{x}");
            }
        }

        #[test]
        fn a_wide_argument_keeps_its_image(start in 0.1f64..3.0, width in 12i64..200, inside in -1.0f64..1.0) {
            let at = Float::with_val(100, start);
            let argument = Ball::new(at.clone(), Magnitude::power_of_two(-width), 300);
            let angle = SineAnchor::new(&at, 300).angle(&argument);
            let offset = Float::with_val(60, inside) >> i32::try_from(width).unwrap();
            let (sin, cos) = high(&Float::with_val(1000, &at + &offset));
            prop_assert!(angle.sin.lower() <= sin.lower() && sin.upper() <= angle.sin.upper());
            prop_assert!(angle.cos.lower() <= cos.lower() && cos.upper() <= angle.cos.upper());
        }

        /// Every list of relations, angles of both signs beyond a turn and of all sizes, and moved once more.
        #[test]
        fn anchors_by_gaussian_primes_hold_the_true_values(
            rho in prop::sample::select(vec![36u32, 48, 80, 120, 160]), start in -15.99f64..15.99,
            small in prop_oneof![3 => Just(0u32), 1 => 1u32..60], short in 30u32..250, extra in 0u32..3000,
        ) {
            let near = Float::with_val(short, start) >> small;
            prop_assume!(near.get_exp().is_some_and(|e| e >= -64));
            let prec = extra + match rho { 36..=80 => 1500, 120 => 25_000, _ => 150_000 };
            let depth = near.get_exp().map_or(0, |e| e.min(0).unsigned_abs());
            let places = prec + depth + GUARD;
            let anchor = SineAnchor::reduced(&near, prec, places, rho).unwrap();
            let nearer = Float::with_val(short + 200, &near + ((near.clone() / 1000u32) >> 20));
            for (anchor, prec) in [
                (anchor.moved(&nearer), prec),
                (anchor.with_precision(prec / 2), prec / 2),
                (anchor, prec),
            ] {
                let angle = anchor.here(prec);
                let (sin, cos) = by_mpfr(&angle.rad.with_precision(prec + 200));
                for (ours, truth) in [(&angle.sin, &sin), (&angle.cos, &cos)] {
                    prop_assert!(ours.overlaps(truth), "{near} {prec}");
                    let size = ours.mid().get_exp().map_or(0, |e| i64::from(e).min(0));
                    prop_assert!(ours.rad() < Magnitude::power_of_two(size - i64::from(prec) + 8), "{near} {prec}: {ours:?}");
                }
            }
        }
    }

    /// Where Gaussian primes are of no use MPFR is asked.
    #[test]
    fn what_is_short_of_bits_or_too_long_is_not_reduced() {
        let is_reduced = |near: &Float, prec: u32| {
            let anchor = SineAnchor::new(near, prec);
            let (sin, _) = by_mpfr(&anchor.here(prec).rad);
            assert!(anchor.here(prec).sin.overlaps(&sin));
            SineAnchor::reduced(near, prec, prec + GUARD, 36).is_some()
        };
        let float = |bits: u32, x: f64| Float::with_val(bits, x);
        assert!(is_reduced(&float(100, 0.7), 2000));
        assert!(!is_reduced(&float(100, 0.7), 900), "few bits");
        assert!(!is_reduced(&float(1100, 0.7), 2000), "a long argument");
        assert!(!is_reduced(&float(60, 17.0), 2000), "far away");
        assert!(!is_reduced(&(float(60, 0.7) >> 70), 2000), "tiny");
        assert!(!is_reduced(&Float::new(60), 2000), "zero");
        assert!(SineAnchor::reduced(&float(100, 0.7), 2000, 2024, 160).is_none(), "large powers");
    }

    #[test]
    fn a_point_out_of_reach_is_computed_afresh() {
        let (here, there) = (Float::with_val(60, 0.5), Float::with_val(60, 2.5));
        for prec in [300, 2000] {
            let anchor = SineAnchor::new(&here, prec);
            let angles = [
                anchor.moved(&there).here(prec),
                anchor.angle(&Ball::exact(there.clone(), prec)),
                anchor.with_precision(5 * prec).with_precision(prec / 2).moved(&there).here(60),
            ];
            for angle in angles {
                let (sin, cos) = by_mpfr(&angle.rad);
                assert!(angle.sin.overlaps(&sin) && angle.cos.overlaps(&cos));
            }
        }
    }
}
