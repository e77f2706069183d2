//! `rug::Rational`: exact arithmetic, for identities at rational points.

use super::{ExactField, Field};
use rug::integer::Order;
use rug::{Integer, Rational};

impl Field for Rational {
    fn int(&self, n: i32) -> Self {
        Rational::from(n)
    }

    fn square(&self) -> Self {
        Rational::from(self.square_ref())
    }
}

impl ExactField for Rational {
    fn is_zero(&self) -> bool {
        *self == 0
    }
}

/// A rational number in the type and precision of `like`: exact where the type is exact, an enclosure
/// where it encloses.
pub fn rational_like<T: Field>(like: &T, value: &Rational) -> T {
    // From the most significant digit in base 2^24, each of which fits an `i32`.
    let integer = |n: &Integer| {
        let digits: Vec<u32> = n
            .clone()
            .abs()
            .to_digits::<u8>(Order::Lsf)
            .chunks(3)
            .map(|chunk| chunk.iter().rev().fold(0u32, |sum, byte| sum << 8 | u32::from(*byte)))
            .collect();
        let size = digits
            .iter()
            .rev()
            .fold(like.int(0), |sum, digit| sum * like.int(1 << 24) + like.int(*digit as i32));
        if *n < 0 { -size } else { size }
    };
    match value.is_integer() {
        true => integer(value.numer()),
        false => integer(value.numer()) / integer(value.denom()),
    }
}
