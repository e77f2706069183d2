//! Conversions between intervals and GMP, MPFR: exactly, in both directions.

use crate::number::{Astro, AstroInterval};
use rug::integer::Order;
use rug::{Float, Integer};

impl AstroInterval {
    /// The interval from one MPFR number to another, both exact; the whole line if they are not finite and in order.
    pub fn between(low: &Float, high: &Float, prec: usize) -> Self {
        let number = |x: &Float| {
            let (mantissa, exponent) = x.to_integer_exp()?;
            let words: Vec<u64> = mantissa.to_digits(Order::Lsf);
            Astro::dyadic(mantissa < 0, &words, exponent)
        };
        match (number(low), number(high)) {
            (Some(low), Some(high)) => Self::new(low, high, prec),
            _ => Self::whole(prec),
        }
    }

    /// Ends as exact MPFR numbers; `None` for an unbounded interval.
    pub fn ends(&self) -> Option<(Float, Float)> {
        let number = |end: &Astro| {
            let (negative, words, exponent) = end.parts()?;
            let mantissa = Integer::from_digits(&words, Order::Lsf);
            let size = Float::with_val(mantissa.significant_bits().max(64), mantissa) << exponent;
            Some(if negative { -size } else { size })
        };
        Some((number(&self.low)?, number(&self.high)?))
    }
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
        let between = |low: &Float, high: &Float| AstroInterval::between(low, high, 64);
        assert!(!between(&two, &one).is_bounded(), "inverted");
        assert!(!between(&Float::with_val(64, f64::NAN), &one).is_bounded());
        let straddles = between(&-one.clone(), &one);
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
