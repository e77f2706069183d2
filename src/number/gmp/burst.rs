//! Sine and cosine of a short argument, by bit-burst and binary splitting.
//!
//! The argument is cut into pieces of growing length, `y = r_1 + r_2 + …`, each a short number that is
//! smaller the longer it is. The sine of a piece is a series of rational terms,
//!
//! ```text
//! sin r = r (1 - r²/(2·3) (1 - r²/(4·5) (…)))
//! ```
//!
//! summed exactly, as one fraction of integers, by splitting it in halves; its versine `1 - cos r`
//! follows by a square root; and the pieces are put together by [`turn`]. From some thousand bits on
//! this is faster than MPFR's sine of a full-length argument, and the more so the shorter the argument
//! (Brent 1976; Brent & Zimmermann, *Modern Computer Arithmetic*, 4.9).
//!
//! What is rounded is rounded in balls, so that only the tail of the series needs a bound of its own:
//! the terms alternate and fall, so the tail is at most the first term left out.

use super::{Ball, Field, Magnitude, Real};
use rug::{Float, Integer};

/// Below this many bits MPFR's own sine is faster.
const THRESHOLD: u32 = 9_000;
/// Bits of the first piece.
const FIRST: u32 = 24;
/// Each piece ends at this many times the bits at which the one before ended.
const GROWTH: u32 = 4;
/// Bits kept beyond those that reach the result.
const GUARD: u32 = 16;

/// Sine and cosine of `y` to `prec` bits. Below one in size, the fewer bits `y` has, the faster.
pub(super) fn sine_and_cosine(y: &Float, prec: u32) -> (Ball, Ball) {
    let exact = Ball::exact(y.clone(), prec);
    let is_fraction = y.get_exp().is_none_or(|exponent| exponent <= 0);
    if prec < THRESHOLD || y.prec() > prec / 2 || !is_fraction {
        return exact.sin_cos();
    }
    let Some((mantissa, exponent)) = y.to_integer_exp().filter(|(_, e)| *e < 0) else {
        return exact.sin_cos();
    };
    let (negative, mantissa) = (mantissa < 0, mantissa.abs());
    let places = exponent.unsigned_abs();
    let (mut sin, mut cos) = (exact.int(0), exact.int(1));
    let (mut start, mut end) = (0, FIRST);
    while start < places {
        end = end.min(places);
        let piece = Integer::from(&mantissa >> (places - end)).keep_bits(end - start);
        if !piece.is_zero() {
            let (sine, versine) = sine_and_versine(&piece, end, prec);
            (sin, cos) = turn((&sin, &cos), &sine, &versine, prec);
        }
        (start, end) = (end, end.saturating_mul(GROWTH));
    }
    (if negative { -sin } else { sin }, cos)
}

/// Sine and cosine of `a + d` from those of `a` and from the sine and the versine of `d`, to `prec`
/// bits: `sin a + (cos a sin d - sin a vers d)`, `cos a - (sin a sin d + cos a vers d)`. Products of
/// a small factor are computed to the bits that reach the sum, and three of them do for four.
pub(super) fn turn(
    (sin, cos): (&Ball, &Ball),
    sine: &Ball,
    versine: &Ball,
    prec: u32,
) -> (Ball, Ball) {
    let width = |small: &Ball| {
        let size = Magnitude::upper(small.mid()).plus(small.rad()).exponent();
        let bits = i64::from(prec) + size.unwrap_or(0).min(0) + i64::from(GUARD);
        bits.clamp(32, i64::from(prec + GUARD)) as u32
    };
    let (first, second) = (width(sine), width(versine));
    let (sine, versine) = (sine.with_precision(first), versine.with_precision(second));
    let turned = cos.with_precision(first) * &sine;
    let lost = sin.with_precision(second) * &versine;
    let both = (sin.with_precision(first) + cos.with_precision(first)) * (sine + versine);
    (
        (sin.with_precision(prec) + &turned) - &lost,
        cos.with_precision(prec) - (both - turned - lost),
    )
}

/// `sin r` and `1 - cos r`, to an absolute `2^-prec`, for `r = numerator / 2^places` in `(0, 1)`.
fn sine_and_versine(numerator: &Integer, places: u32, prec: u32) -> (Ball, Ball) {
    let zeros = numerator.find_one(0).unwrap_or(0);
    let (numerator, places) = (Integer::from(numerator >> zeros), places - zeros);
    let bits = numerator.significant_bits();
    let r = Ball::exact(Float::with_val(bits.max(2), &numerator) >> places, prec);
    // r < 2^-small: each factor of r makes that many bits superfluous.
    let series = Series {
        square: Integer::from(numerator.square_ref()),
        shift: 2 * places,
        small: places - bits,
        prec,
    };
    let (terms, tail) = terms(Magnitude::upper(r.mid()), prec);
    let sum = if terms == 0 { r.int(0) } else { series.value(terms) };
    let sine = r.with_precision(series.width(1)) * (r.int(1) - sum).widened(tail);
    let square = sine.with_precision(series.width(2)).square().with_precision(prec + GUARD);
    let versine = square.int(1) - (square.int(1) - square).sqrt();
    (sine, versine)
}

/// How many terms after the first the series of `sin r / r` needs for `prec` bits, and a bound of the
/// tail: the first term left out.
fn terms(r: Magnitude, prec: u32) -> (u32, Magnitude) {
    let square = r.times(r);
    let enough = Magnitude::power_of_two(-i64::from(prec) - i64::from(GUARD));
    let mut term = Magnitude::from_integer(1);
    let mut count = 0;
    loop {
        let k = u64::from(count) + 1;
        term = term.times(square).over(Magnitude::from_integer_down(2 * k * (2 * k + 1)));
        if term < enough {
            return (count, term);
        }
        count += 1;
    }
}

/// The alternating series with the factors `-r²/(2k (2k + 1))`, `r² = square / 2^shift`.
struct Series {
    square: Integer,
    shift: u32,
    /// `r < 2^-small`.
    small: u32,
    /// Bits of the result.
    prec: u32,
}

/// A part of the series as a fraction: the terms from `low` to `high - 1`, relative to the term before
/// `low`, with alternating signs, the first positive.
struct Sum<T> {
    /// The product of all factors' numerators, `square^(high - low)`; zero if not wanted.
    product: T,
    /// The product of `2k (2k + 1)`; the powers of two, `shift` bits a term, are left out.
    denominator: Integer,
    /// The sum times the denominator and its powers of two.
    numerator: T,
}

impl Series {
    /// Bits worth keeping of a number that `powers` factors of `r` stand before.
    fn width(&self, powers: u32) -> u32 {
        self.prec.saturating_sub(self.small.saturating_mul(powers)).max(32) + GUARD
    }

    /// The sum of the terms from 1 to `terms`.
    fn value(&self, terms: u32) -> Ball {
        let Sum { denominator, numerator, .. } = self.rounded(1, terms + 1, false);
        let bits = denominator.significant_bits().min(numerator.prec());
        let quotient = numerator / Ball::from_integer(&denominator, bits);
        quotient.scaled(-i64::from(self.shift) * i64::from(terms))
    }

    /// A part whose numbers are rounded to the bits worth keeping, from halves that are exact while
    /// they are shorter than that.
    fn rounded(&self, low: u32, high: u32, product: bool) -> Sum<Ball> {
        let width = self.width(2 * low);
        if high - low == 1 || self.shift.saturating_mul(high - low) < width / 2 {
            let Sum { product, denominator, numerator } = self.exact(low, high, product);
            let [product, numerator] = [product, numerator].map(|n| Ball::from_integer(&n, width));
            return Sum { product, denominator, numerator };
        }
        let middle = low.midpoint(high);
        let left = self.rounded(low, middle, true);
        let right = self.rounded(middle, high, product);
        let bits = right.denominator.significant_bits().min(width);
        let head = left.numerator * Ball::from_integer(&right.denominator, bits);
        let head = head.scaled(i64::from(self.shift) * i64::from(high - middle));
        let rest = left.product.with_precision(right.numerator.prec()) * &right.numerator;
        let rest = rest.with_precision(width);
        Sum {
            product: match product {
                true => left.product.with_precision(right.product.prec()) * right.product,
                false => left.product.int(0),
            },
            denominator: left.denominator * right.denominator,
            numerator: if (middle - low).is_multiple_of(2) { head + rest } else { head - rest },
        }
    }

    fn exact(&self, low: u32, high: u32, product: bool) -> Sum<Integer> {
        if high - low == 1 {
            let k = u64::from(low);
            return Sum {
                product: self.square.clone(),
                denominator: Integer::from(2 * k * (2 * k + 1)),
                numerator: self.square.clone(),
            };
        }
        let middle = low.midpoint(high);
        let left = self.exact(low, middle, true);
        let right = self.exact(middle, high, product);
        let head = (left.numerator * &right.denominator) << (self.shift * (high - middle));
        let rest = Integer::from(&left.product * &right.numerator);
        Sum {
            product: if product { left.product * right.product } else { Integer::new() },
            denominator: left.denominator * right.denominator,
            numerator: if (middle - low).is_multiple_of(2) { head + rest } else { head - rest },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(crate::number::test_config::config(48))]
        /// Against MPFR at a higher precision: arguments of all lengths, with long runs of zeros too.
        #[test]
        fn the_true_values_are_held_and_close(
            head in any::<u64>(), gap in 0u32..2000, tail in any::<u32>(), negative in any::<bool>(),
            prec in THRESHOLD..40_000, whole in prop_oneof![9 => Just(0u32), 1 => 1u32..4],
        ) {
            let mut y: Float = Float::with_val(64 + gap + 32, head) >> 64;
            y += (Float::with_val(32, tail) >> 96u32) >> gap;
            if negative { y = -y; }
            prop_assume!(!y.is_zero());
            let y = y << whole;
            let (sin, cos) = sine_and_cosine(&y, prec);
            let (mut true_sin, mut true_cos) = (Float::new(prec + 100), Float::new(prec + 100));
            rug::Assign::assign(&mut (&mut true_sin, &mut true_cos), y.sin_cos_ref());
            for (ours, truth) in [(sin, true_sin), (cos, true_cos)] {
                prop_assert!(ours.lower() <= truth && truth <= ours.upper(), "{ours:?} {truth:.20}");
                prop_assert!(ours.rad() < Magnitude::power_of_two(-i64::from(prec) + 8), "wide: {ours:?}");
            }
        }
    }

    #[test]
    fn a_part_of_the_series_is_its_sum() {
        // r² = 9/16, three terms: 9/(16·6) - 81/(256·120) + 729/(4096·5040)
        let series = Series { square: 9.into(), shift: 4, small: 0, prec: 64 };
        let Sum { numerator, denominator, .. } = series.exact(1, 4, false);
        let sum = rug::Rational::from((numerator, denominator << 12));
        let term = |n: i32, d: i32| rug::Rational::from((n, d));
        assert_eq!(sum, term(9, 96) - term(81, 30_720) + term(729, 20_643_840));
        assert!(series.value(3).contains(&sum), "and rounded");
    }

    #[test]
    fn the_tail_is_the_first_term_left_out() {
        let (count, tail) = terms(Magnitude::power_of_two(-1), 20);
        // (1/4)^5 / 11! is 2^-35.3, not below 2^-36; (1/4)^6 / 13! is 2^-44.5.
        assert_eq!(count, 5);
        assert!(tail < Magnitude::power_of_two(-44) && tail > Magnitude::power_of_two(-46));
    }
}
