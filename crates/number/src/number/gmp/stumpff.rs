//! Stumpff's functions of MPFR numbers and of balls.

use super::super::stumpff::{Stumpff, from_angle, from_series, terms};
use super::{Angle, Ball, Enclosure, Field, Real};
use rug::Float;

impl Stumpff for Float {
    fn stumpff(&self, count: usize) -> Vec<Self> {
        let exponent = self.get_exp().map_or(i64::MIN / 2, i64::from);
        from_series(self, count, terms(self.prec(), exponent), &self.int(1))
    }
}

/// With more terms than this the functions follow from sine and cosine.
const MANY_TERMS: i32 = 64;
/// Bits beyond those that the recurrence loses.
const GUARD: u32 = 32;

/// Stumpff's functions of a ball, with sine and cosine where they are asked for as `angle` makes them.
///
/// They are those at the midpoint `m`, and change by `2r` at most on `m ± r`: for `|u| <= 2` each function is
/// below `3/n!`, so that `|c_n'| <= (n c_(n+2) + c_(n+1))/2 <= 2`.
pub fn stumpff_with(u: &Ball, count: usize, angle: impl FnOnce(Ball) -> Angle<Ball>) -> Vec<Ball> {
    let size = u.size().exponent().unwrap_or(i64::MIN / 2);
    let has_many = size <= 1 && terms(u.prec(), size) > MANY_TERMS;
    let Some(exponent) = u.mid().get_exp().filter(|_| has_many && *u.mid() > 0) else {
        return by_series(u, count);
    };
    let lost = exponent.min(0).unsigned_abs() * (count as u32).div_ceil(2);
    let middle = Ball::exact(u.mid().clone(), u.prec() + lost + GUARD);
    let twice = u.rad().shifted(1);
    let functions = from_angle(&middle, &angle(middle.sqrt()), count).into_iter();
    functions.map(|c| c.with_precision(u.prec()).widened(twice)).collect()
}

fn by_series(u: &Ball, count: usize) -> Vec<Ball> {
    let size = u.size();
    let exponent = size.exponent().unwrap_or(i64::MIN / 2);
    if !u.is_bounded() || exponent > 1 {
        return vec![Ball::whole(u.prec()); count];
    }
    // For |u| <= 2 what follows the terms, 1 - u/((m+1)(m+2)) (1 - ...), is within |u| of one: each
    // bracket is at most 2 in size, and the divisors are at least 12.
    let tail = u.int(1).widened(size);
    from_series(u, count, terms(u.prec(), exponent), &tail)
}

impl Stumpff for Ball {
    fn stumpff(&self, count: usize) -> Vec<Self> {
        stumpff_with(self, count, Angle::new)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use crate::number::{
        DoubleBall, DoubleDoubleBall, FloatBall, Magnitude, Midpoint, Real, TripleWordBall,
    };
    use proptest::prelude::*;
    use rug::Rational;

    /// Enclosures of the functions from sine and cosine, with enough bits that no digit is lost.
    fn from_sine_and_cosine(x: &Rational, bits: u32) -> [Ball; 5] {
        let x = Ball::enclosing(x, 8 * bits + 4096);
        let (sin, cos) = x.sin_cos();
        let u = x.square();
        let one = x.int(1);
        [
            cos.clone(),
            sin.clone() / &x,
            (one.clone() - &cos) / &u,
            (x.clone() - sin) / (u.clone() * &x),
            (cos - one + u.clone() / u.int(2)) / u.square(),
        ]
    }

    proptest! {
        #![proptest_config(config(200))]

        #[test]
        fn the_true_values_are_enclosed(
            n in 1i64..1_000_000, shift in 0u32..600, bits in 24u32..500,
        ) {
            let x = Rational::from((n, 1_000_000)) >> shift;
            let u = Ball::enclosing(&Rational::from(x.square_ref()), bits);
            for (found, truth) in u.stumpff(5).iter().zip(from_sine_and_cosine(&x, bits)) {
                prop_assert!(found.overlaps(&truth), "{found:?} {truth:?}");
                let (lower, upper) = (found.lower(), found.upper());
                prop_assert!(lower <= truth.upper() && truth.lower() <= upper);
                let width = Magnitude::upper(found.mid()).shifted(12 - i64::from(bits));
                prop_assert!(found.rad() < width, "no digit is lost: {found:?}");
            }
        }
    }

    fn of_floats<M: Midpoint>(
        u: &FloatBall<M>,
        to_ball: impl Fn(&FloatBall<M>) -> Ball,
    ) -> Vec<Ball> {
        u.stumpff(6).iter().map(to_ball).collect()
    }

    proptest! {
        #![proptest_config(config(300))]

        /// In balls of two and of three words, of numbers of any size and of sets of them.
        #[test]
        fn floats_enclose_the_true_values(x in -1.0f64..=1.0, shift in 0i32..1100, wide in 0i32..60) {
            let x = x * 2f64.powi(1 - shift / 2) * 2f64.powi(-(shift - shift / 2));
            for radius in [0.0, x.abs() * 2f64.powi(-wide)] {
                let u = DoubleBall::new(x, radius);
                let found = [
                    (of_floats(&DoubleDoubleBall::from(u), |c| c.to_ball(300)), 96i64),
                    (of_floats(&TripleWordBall::from(u), |c| c.to_ball(300)), 140),
                ];
                let [x, radius] = [x, radius].map(|x| Rational::from_f64(x).unwrap());
                for end in [x.clone() - &radius, x.clone(), x + &radius] {
                    let truth = Ball::enclosing(&end, 400).stumpff(6);
                    // Of a set the true value at an end is an end of the enclosure, but for what is rounded up.
                    let truth: Vec<_> = truth.iter().filter_map(|c| c.mid().to_rational()).collect();
                    for (found, bits) in &found {
                        let is_true = found.iter().zip(&truth).all(|(all, one)| all.contains(one));
                        prop_assert!(is_true && truth.len() == 6, "{found:?} {truth:?}");
                        prop_assert!(!found[4].contains(&truth[3]), "false twin");
                        let width = |c: &Ball| Magnitude::upper(c.mid()).shifted(-bits);
                        prop_assert!(radius > 0 || found.iter().all(|c| c.rad() < width(c)));
                    }
                }
            }
        }
    }

    /// By sine and cosine they are those of the series, and what is wide holds them.
    #[test]
    fn many_bits_are_those_of_the_series() {
        for (n, d, bits) in [(1, 1, 1000), (3, 7, 4000), (19, 10, 2000), (1, 1_000_000, 9000)] {
            let u = Ball::enclosing(&Rational::from((n, d)), bits);
            let wide = u.clone().widened(Magnitude::power_of_two(-99));
            for ((one, series), wide) in
                u.stumpff(6).iter().zip(by_series(&u, 6)).zip(wide.stumpff(6))
            {
                assert!(one.overlaps(&series) && one.lies_inside(&wide), "{n}/{d} {bits}");
                let width = Magnitude::upper(one.mid()).shifted(12 - i64::from(bits));
                assert!(one.rad() < width && wide.rad() < Magnitude::power_of_two(-97));
            }
            assert!(!u.stumpff(6)[2].overlaps(&u.stumpff(6)[3]), "false twin");
        }
    }

    #[test]
    fn every_number_of_a_wide_ball_is_enclosed_and_beyond_the_range_nothing_is_claimed() {
        let wide = Ball::integer(0, 64).widened(Magnitude::power_of_two(0));
        for x in [0, 1, 2, 3] {
            let u = Ball::enclosing(&Rational::from((x, 3)), 200);
            for (all, one) in wide.stumpff(5).iter().zip(u.stumpff(5)) {
                assert!(one.lies_inside(all), "{all:?} {one:?}");
            }
        }
        assert!(Ball::integer(9, 64).stumpff(5).iter().all(|c| !c.is_bounded()));
        let centre = Ball::integer(0, 64).stumpff(5);
        assert!(!wide.stumpff(5)[1].lies_inside(&centre[1]), "false twin");
    }
}
