//! A real number in the binary formats of hardware: what a double leaves open of it.

use super::{Ball, TripleWord, TripleWordBall};
use crate::number::{DoubleDouble, DoubleDoubleBall, power_of_two};
use rug::Float;
use rug::float::Round;

/// Knowledge of a real number beside the double nearest to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Binary {
    /// A double that is not above the number.
    pub lower: f64,
    /// A double that is not below the number.
    pub upper: f64,
    /// A bound of the distance from the nearest double, rounded up.
    pub error: f64,
    /// The nearest IEEE quadruple (113 bits), where the enclosure decides it and it is a normal number
    /// or zero.
    pub quad: Option<Float>,
}

/// Bits of an IEEE quadruple.
const QUAD: u32 = 113;
/// The exponents of normal quadruples, for a mantissa in `[1/2, 1)`.
const QUAD_EXPONENTS: std::ops::RangeInclusive<i32> = -16381..=16384;

impl Binary {
    /// Of the number enclosed by `ball`, with its nearest double; `None` where the ball does not decide that.
    ///
    /// ```
    /// use couplet_number::number::{Ball, Binary, Field};
    /// let tenth = Ball::integer(1, 200) / Ball::integer(10, 200);
    /// let (double, binary) = Binary::nearest(&tenth).unwrap();
    /// assert_eq!((binary.lower, double, binary.upper), (0.1f64.next_down(), 0.1, 0.1));
    /// assert!(5.5e-18 < binary.error && binary.error < 5.6e-18);
    /// ```
    pub fn nearest(ball: &Ball) -> Option<(f64, Self)> {
        let ends = [ball.lower(), ball.upper()];
        let [low, high] = ends.each_ref().map(Float::to_f64);
        // Adding zero makes a negative zero positive.
        let double = (low == high).then_some(low + 0.0)?;
        Some((double, Self::between(&ends, double)))
    }

    /// Of the number enclosed by `ball`, whose nearest double is `double`.
    pub fn new(ball: &Ball, double: f64) -> Self {
        Self::between(&[ball.lower(), ball.upper()], double)
    }

    fn between([low, high]: &[Float; 2], double: f64) -> Self {
        let distance = |from: &Float, to: &Float| Float::with_val_round(64, to - from, Round::Up).0;
        let nearest = Float::with_val(53, double);
        let error = match double.is_finite() && low.is_finite() && high.is_finite() {
            true => distance(low, &nearest).max(&distance(&nearest, high)),
            false => Float::with_val(53, f64::INFINITY),
        };
        Self {
            // Adding zero makes a negative zero positive.
            lower: low.to_f64_round(Round::Down) + 0.0,
            upper: high.to_f64_round(Round::Up) + 0.0,
            error: error.to_f64_round(Round::Up),
            quad: nearest_quad(low, high),
        }
    }

    /// Bounds of the number enclosed by a ball of double-doubles, with its nearest double: the same bounds as
    /// of a ball of MPFR, an error that holds the radius, and no quadruple. `None` if the ball is too wide,
    /// and for zero and sizes far from one.
    #[inline]
    pub fn of_double_double(ball: &DoubleDoubleBall) -> Option<(f64, Self)> {
        let (double, rest, rad) = (ball.nearest_double()?, ball.mid().lo(), ball.rad());
        // On which side of the double the number lies.
        if rad >= rest.abs() {
            return None;
        }
        let error = (rest.abs() + rad).next_up();
        // The double next to it on that side, without a branch: which side it is nobody can guess.
        let bits = double.to_bits();
        let next = if (rest > 0.0) == (double > 0.0) { bits + 1 } else { bits - 1 };
        let (lower, upper) = (double.min(f64::from_bits(next)), double.max(f64::from_bits(next)));
        Some((double, Self { lower, upper, error, quad: None }))
    }

    /// Bounds of the number enclosed by a ball of three words, with its nearest double: the same bounds and error as of
    /// a ball of MPFR, and no quadruple. `None` if the ball is too wide or a number alone, and for sizes far from one.
    pub fn of_words(ball: &TripleWordBall) -> Option<(f64, Self)> {
        let (mid, double) = (ball.mid(), ball.mid().hi());
        let rest = mid - TripleWord::from(DoubleDouble::exact(double));
        let (size, is_below) = rest.size();
        let error = size.shortened().next_up();
        // The number lies on one side of the double, nearer to it than to the next, and within the error.
        let room =
            [size.shortened(), (TripleWord::from(DoubleDouble::exact(error)) - size).shortened()];
        let farthest = 0.5 * (double.abs() - double.abs().next_down());
        let is_near = error < farthest && room.iter().all(|room| *room > ball.rad());
        let in_range = (power_of_two(-200)..power_of_two(200)).contains(&double.abs());
        let (lower, upper) = match is_below {
            true => (double.next_down(), double),
            false => (double, double.next_up()),
        };
        (is_near && in_range && ball.rad() > 0.0)
            .then_some((double, Self { lower, upper, error, quad: None }))
    }

    /// Doubles between which the number lies.
    pub fn bounds(&self) -> [f64; 2] {
        [self.lower, self.upper]
    }

    /// Bounds of infinity.
    pub fn infinite() -> Self {
        Self { lower: f64::INFINITY, upper: f64::INFINITY, error: 0.0, quad: None }
    }
}

/// The quadruple to which both ends round.
fn nearest_quad(low: &Float, high: &Float) -> Option<Float> {
    let [low, high] = [low, high].map(|end| Float::with_val(QUAD, end));
    let is_normal = low.is_zero() || low.get_exp().is_some_and(|e| QUAD_EXPONENTS.contains(&e));
    // Rounding downward leaves a zero negative.
    (low == high && is_normal).then_some(if low.is_zero() { low.abs() } else { low })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::Rational;

    proptest! {
        #![proptest_config(config(4000))]

        /// Powers of two, both signs, low parts next to a tie and to zero: the bounds are those of a ball of MPFR.
        #[test]
        fn a_ball_of_double_doubles_has_the_bounds_of_one_of_mpfr(
            mantissa in prop_oneof![Just(1u64), 1u64..1 << 53], low in -1.0f64..=1.0, gap in 53i32..110,
            shift in -60i32..60, radius in 60i32..140, negative in any::<bool>(),
        ) {
            let hi = mantissa as f64 * 2f64.powi(shift);
            let hi = if negative { -hi } else { hi };
            let mid = DoubleDouble::sum(hi, low * hi * 2f64.powi(-gap));
            let ball = DoubleDoubleBall::new(mid, hi.abs() * 2f64.powi(-radius));
            let found = Binary::of_double_double(&ball);
            let is_easy = radius > gap + 12 && (1e-3..0.49).contains(&low.abs());
            prop_assert!(found.is_some() || !is_easy, "{ball:?}");
            let words = TripleWordBall::from(&ball.to_ball(192));
            let of_words = Binary::of_words(&words);
            prop_assert!(of_words.is_some() || !(is_easy && radius > gap + 70), "{words:?}");
            if let Some((double, found)) = of_words {
                let by_mpfr = Binary::new(&words.to_ball(300), double);
                prop_assert_eq!(words.to_ball(300).nearest_double(), Some(double));
                prop_assert_eq!(Binary { quad: by_mpfr.quad.clone(), ..found }, by_mpfr);
            }
            if let Some((double, found)) = found {
                let by_mpfr = Binary::new(&ball.to_ball(300), double);
                prop_assert_eq!(ball.to_ball(300).nearest_double(), Some(double));
                prop_assert_eq!((found.lower, found.upper), (by_mpfr.lower, by_mpfr.upper));
                let exact = |x: f64| Rational::from_f64(x).unwrap();
                let farthest = exact(ball.mid().lo().abs()) + exact(ball.rad());
                prop_assert!(exact(found.error) >= farthest, "{ball:?}");
                prop_assert!(found.error <= farthest.to_f64() * 1.001, "{ball:?}");
            }
        }
    }

    fn of(ball: &Ball) -> (f64, Binary) {
        let (double, binary) = Binary::nearest(ball).unwrap();
        assert_eq!((ball.nearest_double(), &Binary::new(ball, double)), (Some(double), &binary));
        (double, binary)
    }

    #[test]
    fn an_exact_double_is_its_own_bounds() {
        for n in [0, 2, -7] {
            let (double, binary) = of(&Ball::integer(n, 100));
            assert_eq!((binary.lower, binary.upper, binary.error), (double, double, 0.0));
            let quad = binary.quad.unwrap();
            assert!(quad == n && (n < 0 || !quad.is_sign_negative()));
        }
    }

    #[test]
    fn a_fraction_lies_between_neighbours_on_either_side_of_zero() {
        for n in [1, -1] {
            let third = Rational::from((n, 3));
            let (double, binary) = of(&Ball::enclosing(&third, 200));
            assert_eq!(binary.lower.next_up(), binary.upper);
            assert!(Rational::from_f64(binary.lower).unwrap() < third);
            assert!(Rational::from_f64(binary.upper).unwrap() > third);
            let distance = (Rational::from_f64(double).unwrap() - &third).abs();
            let error = Rational::from_f64(binary.error).unwrap();
            assert!(error >= distance && error.to_f64() < 1.001 * distance.to_f64());
        }
    }

    #[test]
    fn what_no_double_can_hold_has_bounds_too() {
        let power = |exponent| Ball::integer(1, 100).scaled(exponent);
        let (tiny, least) = (of(&power(-2000)), f64::from_bits(1));
        assert_eq!((tiny.0, tiny.1.lower, tiny.1.upper, tiny.1.error), (0.0, 0.0, least, least));
        let huge = of(&power(2000));
        assert_eq!((huge.0, huge.1.lower, huge.1.upper), (f64::INFINITY, f64::MAX, f64::INFINITY));
        assert_eq!(huge.1.error, f64::INFINITY);
        assert!(tiny.1.quad.is_some() && of(&power(-20000)).1.quad.is_none());
    }

    #[test]
    fn a_wide_ball_has_no_quadruple() {
        let third = |bits| Ball::enclosing(&Rational::from((1, 3)), bits);
        assert!(of(&third(80)).1.quad.is_none() && of(&third(130)).1.quad.is_some());
    }
}
