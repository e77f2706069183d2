//! The arctangent, from sine and cosine at a point nearby.

use super::{Angle, Ball, Enclosure, Field, Magnitude, SineAnchor};
use std::cell::RefCell;

/// At this size MPFR's arctangent is taken for the first point.
const FLOOR: u32 = 512;
/// The bits of the result over those of the first point, and of the second.
const FIRST: u32 = 100;
const SECOND: u32 = 9;
/// Bits kept beyond those a term can contribute.
const GUARD: i64 = 16;

/// As many arguments as one question has.
const KEPT: usize = 2;

thread_local! {
    /// Arguments of many bits, with their arctangents: a question asks for the same one again and again.
    static LAST: RefCell<Vec<[Ball; 2]>> = const { RefCell::new(Vec::new()) };
}

/// The arctangent, to the precision of `x`.
///
/// A first point near it has a sine and a cosine that cost little; from there it is found to more bits, and
/// the point is moved: then the rest is a short series.
///
/// `x` must be positive and bounded; otherwise the answer is the whole line.
pub fn arctangent(x: &Ball) -> Ball {
    let prec = x.prec();
    if !x.is_positive().is_proved() || !x.is_bounded() {
        return Ball::whole(prec);
    }
    if prec <= FLOOR {
        return computed(x);
    }
    let same =
        |[of, _]: &&[Ball; 2]| of.prec() == prec && of.mid() == x.mid() && of.rad() == x.rad();
    let known = LAST.with_borrow(|last| last.iter().find(same).map(|[_, found]| found.clone()));
    known.unwrap_or_else(|| {
        let found = computed(x);
        LAST.with_borrow_mut(|last| {
            last.insert(0, [x.clone(), found.clone()]);
            last.truncate(KEPT);
        });
        found
    })
}

/// The arctangent of a positive number that is bounded.
fn computed(x: &Ball) -> Ball {
    let prec = x.prec();
    let near = |bits: u32| match bits <= FLOOR {
        true => rug::Float::with_val(bits, x.mid()).atan(),
        false => rug::Float::with_val(bits, computed(&x.with_precision(bits)).mid()),
    };
    let mut anchor = SineAnchor::new(&near((prec / FIRST).max(64)), prec);
    let middle = prec / SECOND + GUARD as u32;
    if prec > FLOOR {
        let short = x.with_precision(middle);
        let nearer = arctangent_from(&anchor.with_precision(middle).here(middle), &short);
        anchor = anchor.moved(&rug::Float::with_val(prec / SECOND, nearer.mid()));
    }
    arctangent_from(&anchor.here(prec), x)
}

/// The arctangent from an angle near it, whose sine and cosine are known to the precision of `x`: the nearer, the
/// cheaper. The whole line where it is not told to be near.
///
/// `atan x = a + atan t`, `t = (x cos a - sin a)/(cos a + x sin a)`, for a point `a` in `(-1, 3)` near it. For a
/// positive `x` the divisor is positive exactly if `x` is less than a right angle from `a`.
///
/// `atan t = t (1 - t²/3 + t⁴/5 - …)` is summed from the innermost term outwards, as `1 - q(1) t² (1 - q(2) t²
/// (…))` with `q(k) = (2k-1)/(2k+1)`. The innermost factor is replaced by the interval `[0, 1]`, in which the rest
/// of an alternating series with falling terms lies. A term of relative size `2^-k` is computed with `k` bits
/// fewer.
fn arctangent_from(a: &Angle<Ball>, x: &Ball) -> Ball {
    let prec = x.prec();
    let rise = (x.clone() * &a.cos - &a.sin).trimmed();
    let Some(exponent) = rise.size_exponent() else { return Ball::whole(prec) };
    let bits = |lost: i64| (i64::from(prec) - lost + GUARD).max(32) as u32;
    let width = bits(-exponent.min(0));
    let run = a.cos.with_precision(width) + x.with_precision(width) * a.sin.with_precision(width);
    // Only so is it this arctangent and not another: then x and a are less than a right angle apart.
    let branch = [run.clone(), a.rad.int(1) + &a.rad, a.rad.int(3) - &a.rad];
    if !branch.iter().all(|sign| sign.is_positive().is_proved()) {
        return Ball::whole(prec);
    }
    let t = (rise.with_precision(width) / run).with_precision(width);
    let Some(exponent) = t.size_exponent().filter(|&e| e <= -4) else { return Ball::whole(prec) };
    let square = t.with_precision(bits(-2 * exponent)).square();
    let terms = (i64::from(prec) + GUARD).max(0) / (-2 * exponent) + 1;
    let half = Ball::new(rug::Float::with_val(32, 0.5), Magnitude::power_of_two(-1), 32);
    let series = (1..=terms).rev().fold(half, |rest, k| {
        let bits = bits(-(2 * k - 1) * exponent);
        let term = square.with_precision(bits) * rest.with_precision(bits);
        let term =
            term * Ball::integer(2 * k as i32 - 1, bits) / Ball::integer(2 * k as i32 + 1, bits);
        term.int(1) - term
    });
    (t * series).with_precision(prec) + &a.rad
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Real;
    use proptest::prelude::*;
    use rug::Float;

    proptest! {
        #![proptest_config(crate::number::test_config::config(64))]
        #[test]
        fn the_arctangent_holds_the_true_one(
            x in prop_oneof![1e-6f64..10.0, 10.0f64..1e12, 1e12f64..1e60], prec in prop_oneof![64u32..3000, 3000u32..40_000],
        ) {
            let x = Float::with_val(53, x);
            let ours = arctangent(&Ball::exact(x.clone(), prec));
            let truth = Float::with_val(prec + 3000, &x).atan();
            prop_assert!(ours.lower() <= truth && truth <= ours.upper());
            prop_assert!(ours.rad() < Magnitude::power_of_two(-i64::from(prec) + 16), "wide: {ours:?}");
        }

        #[test]
        fn a_wide_argument_keeps_its_image(x in 0.01f64..10.0, width in 20i64..400, inside in -1.0f64..1.0) {
            let x = Float::with_val(53, x);
            let ours = arctangent(&Ball::new(x.clone(), Magnitude::power_of_two(-width), 500));
            let offset = Float::with_val(60, inside) >> i32::try_from(width).unwrap();
            let truth = Float::with_val(1000, &x + &offset).atan();
            prop_assert!(ours.lower() <= truth && truth <= ours.upper());
            prop_assert!(ours.rad() < Magnitude::power_of_two(4 - width));
        }
    }

    /// The numerator of `t` is not small there, but `t` is.
    #[test]
    fn large_and_wide_arguments_keep_a_narrow_image() {
        for (x, rad, bits) in [(100, 1, 12), (1000, 5, 17), (10, 0, 60)] {
            let x = Ball::integer(x, 64).widened(Magnitude::from_integer(rad));
            assert!(arctangent(&x).rad() < Magnitude::power_of_two(-bits));
        }
        let power = |exponent: u32| Ball::exact(Float::with_val(64, 1) << exponent, 64);
        for exponent in [60, 70, 1000, 1 << 28] {
            let found = arctangent(&power(exponent));
            assert!(found.rad() < Magnitude::power_of_two(-60), "{found:?}");
            let truth = found.pi() / found.int(2) - found.int(1) / power(exponent);
            assert!(found.overlaps(&truth), "{found:?}");
        }
    }

    /// A point on another branch of the tangent, or no point at all.
    #[test]
    fn another_branch_is_not_taken() {
        let x = Ball::integer(1, 64);
        let (right, wrong) = (0.8f64, 0.8 - std::f64::consts::PI);
        for (point, is_right) in [(right, true), (wrong, false), (2.5, true), (-0.9, false)] {
            let angle = Angle::new(Ball::exact(Float::with_val(64, point), 64));
            let found = arctangent_from(&angle, &x);
            let truth = found.pi() / found.int(4);
            assert!(found.overlaps(&truth), "{point}");
            assert!(is_right && point < 1.0 || !found.is_bounded(), "{point}");
        }
    }

    #[test]
    fn the_arctangent_refuses_what_it_cannot_do() {
        assert!(!arctangent(&Ball::integer(-1, 64)).is_bounded());
        assert!(!arctangent(&Ball::whole(64)).is_bounded());
    }
}
