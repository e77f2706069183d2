//! Between astro-float and GMP, MPFR: exactly, in both directions.

use super::AstroInterval;
use astro_float::{BigFloat, Sign, WORD_BIT_SIZE, Word};
use rug::integer::Order;
use rug::{Float, Integer, Rational};

impl AstroInterval {
    /// An interval of `prec` bits that holds the rational number `value`.
    pub fn enclosing(value: &Rational, prec: usize) -> Self {
        let point = |n: &Integer| Self::point(&from_integer(n), prec);
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

fn from_integer(n: &Integer) -> BigFloat {
    let words: Vec<Word> = n.to_digits(Order::Lsf);
    let Some(top) = words.last() else { return BigFloat::from_i32(0, WORD_BIT_SIZE) };
    // astro-float wants the mantissa's top bit set and reads it as a fraction below one.
    let shift = top.leading_zeros();
    let exponent = (words.len() * WORD_BIT_SIZE) as i32 - shift as i32;
    let mantissa: Vec<Word> = Integer::from(n << shift).to_digits(Order::Lsf);
    let sign = if *n < 0 { Sign::Neg } else { Sign::Pos };
    BigFloat::from_words(&mantissa, sign, exponent)
}

fn from_float(x: &Float) -> BigFloat {
    let Some((mantissa, exponent)) = x.to_integer_exp() else { return BigFloat::nan(None) };
    let mut value = from_integer(&mantissa);
    if let (false, Some(e)) = (mantissa.is_zero(), value.exponent()) {
        value.set_exponent(e + exponent);
    }
    value
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
}
