//! Between astro-float and GMP, MPFR: exactly, in both directions.

use super::AstroInterval;
use astro_float::{BigFloat, Sign, WORD_BIT_SIZE};
use rug::integer::Order;
use rug::{Float, Integer, Rational};

impl AstroInterval {
    /// An interval of `prec` bits that holds the rational number `value`.
    pub fn enclosing(value: &Rational, prec: usize) -> Self {
        let point = |n: &Integer| Self::point(&from_integer(n, 0), prec);
        point(value.numer()) / point(value.denom())
    }

    /// The interval from one MPFR number to another, both exact.
    pub fn between(low: &Float, high: &Float, prec: usize) -> Self {
        Self { low: from_float(low), high: from_float(high), prec }.checked()
    }

    /// Both ends as exact MPFR numbers; `None` for an unbounded interval.
    pub fn ends(&self) -> Option<(Float, Float)> {
        Some((to_float(&self.low)?, to_float(&self.high)?))
    }
}

/// `± n * 2^exponent`.
fn from_integer(n: &Integer, exponent: i32) -> BigFloat {
    let words: Vec<u64> = n.to_digits(Order::Lsf);
    AstroInterval::dyadic(*n < 0, &words, exponent, WORD_BIT_SIZE).low
}

fn from_float(x: &Float) -> BigFloat {
    let Some((mantissa, exponent)) = x.to_integer_exp() else { return BigFloat::nan(None) };
    from_integer(&mantissa, exponent)
}

fn to_float(x: &BigFloat) -> Option<Float> {
    if x.is_zero() {
        return Some(Float::with_val(64, 0));
    }
    let (words, _, sign, exponent, _) = x.as_raw_parts()?;
    let integer = Integer::from_digits(words, Order::Lsf);
    let bits = (words.len() * WORD_BIT_SIZE) as u32;
    let value = Float::with_val(bits.max(64), &integer) << (exponent - bits as i32);
    Some(if sign == Sign::Neg { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Enclosure, Real};

    #[test]
    fn conversions_are_exact() {
        for text in ["0", "1", "-3", "1e-300", "123456789123456789.125", "-7e99"] {
            let x = Float::with_val(300, Float::parse(text).unwrap());
            let interval = AstroInterval::between(&x, &x, 320);
            assert_eq!(interval.ends().unwrap(), (x.clone(), x), "{text}");
        }
    }

    #[test]
    fn bad_ends_become_the_whole_line() {
        let (one, two) = (Float::with_val(64, 1), Float::with_val(64, 2));
        assert!(!AstroInterval::between(&two, &one, 64).is_bounded(), "inverted");
        assert!(!AstroInterval::between(&Float::with_val(64, f64::NAN), &one, 64).is_bounded());
        let straddles = AstroInterval::between(&-one.clone(), &one, 64);
        assert!(!(AstroInterval::integer(1, 64) / &straddles).is_bounded());
        assert!(!straddles.sqrt().is_bounded());
    }

    /// Where sine or cosine is tiny, next to one, or zero, by all lengths of the argument.
    #[test]
    fn sine_and_cosine_hold_the_true_ones() {
        let pi = Float::with_val(400, rug::float::Constant::Pi);
        let near = |prec: u32, part: f64| Float::with_val(prec, pi.clone() * part);
        let mut arguments: Vec<Float> = (1..7).map(|k| near(40 * k, 0.25 * f64::from(k))).collect();
        arguments.extend([near(300, 0.5), near(53, 1.0), near(130, -1.0), near(64, 1e-40)]);
        arguments.extend(
            [0.0, 1.0, -0.7, 3.0, 1e-300, 0.126, 2.999, -2.0].map(|x| Float::with_val(53, x)),
        );
        for (x, prec) in
            arguments.iter().flat_map(|x| [64, 100, 128, 320, 600, 900].map(|prec| (x, prec)))
        {
            let (sin, cos) = AstroInterval::between(x, x, prec).sin_cos();
            let truth = (Float::with_val(2000, x).sin(), Float::with_val(2000, x).cos());
            for (ours, truth) in [(sin, truth.0), (cos, truth.1)] {
                let (low, high) = ours.ends().unwrap();
                assert!(low <= truth && truth <= high, "{x} {prec}");
                let width = Float::with_val(64, &high - &low);
                assert!(width <= truth.abs() >> (prec as u32 - 2), "{x} {prec}");
            }
        }
    }
}
