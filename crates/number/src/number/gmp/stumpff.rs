//! Stumpff's functions of MPFR numbers and of balls.

use super::super::stumpff::{Stumpff, from_series, terms};
use super::{Ball, Enclosure, Field, Magnitude};
use rug::Float;

impl Stumpff for Float {
    fn stumpff(&self, count: usize) -> Vec<Self> {
        let exponent = self.get_exp().map_or(i64::MIN / 2, i64::from);
        from_series(self, count, terms(self.prec(), exponent), &self.int(1))
    }
}

impl Stumpff for Ball {
    fn stumpff(&self, count: usize) -> Vec<Self> {
        let size = Magnitude::upper(self.mid()).plus(self.rad());
        let exponent = size.exponent().unwrap_or(i64::MIN / 2);
        if !self.is_bounded() || exponent > 1 {
            return vec![Self::whole(self.prec()); count];
        }
        // For |u| <= 2 what follows the terms, 1 - u/((m+1)(m+2)) (1 - ...), is within |u| of one: each
        // bracket is at most 2 in size, and the divisors are at least 12.
        let tail = self.int(1).widened(size);
        from_series(self, count, terms(self.prec(), exponent), &tail)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Real;
    use crate::number::test_config::config;
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
