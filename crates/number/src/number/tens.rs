//! Powers of ten and the integers that digits stand for, as enclosures of the precision of a check.
//!
//! Digits are joined in halves, `top 10^k + rest`, so that long products do the work. Every number is held to the bits
//! that it has, which is exact, as long as these are fewer than those of the result. The powers are kept: all
//! values of a certificate need the same.

use super::{Dyadic, Engine};

/// The powers of ten that were needed so far.
#[derive(Clone, Debug)]
pub struct Tens<E> {
    /// The bits to which results are rounded.
    bits: usize,
    /// `10^(LEAF 2^k)`.
    squares: Vec<E>,
    /// Powers with their exponents.
    others: Vec<(i64, E)>,
}

/// Digits of a word.
const CHUNK: usize = 18;
/// Digits that are read in machine words.
const LEAF: usize = 16 * CHUNK;

impl<E: Engine> Tens<E> {
    /// None yet; results are to be rounded to at least `bits` bits.
    pub fn new(bits: usize) -> Self {
        Self { bits, squares: Vec::new(), others: Vec::new() }
    }

    /// The integer with the digits given, as they are written, the most significant first.
    pub fn integer(&mut self, digits: &[u8]) -> E {
        while LEAF << self.squares.len() < digits.len() {
            let next = match self.squares.last() {
                Some(power) => power.with_bits(self.enough(LEAF << self.squares.len())).square(),
                None => self.ten_to(LEAF as u64),
            };
            self.squares.push(next);
        }
        self.joined(digits, self.squares.len()).with_bits(self.bits)
    }

    /// `10^exponent`.
    pub fn power(&mut self, exponent: i64) -> E {
        if let Some((_, power)) = self.others.iter().find(|(known, _)| *known == exponent) {
            return power.clone();
        }
        let power = self.ten_to(exponent.unsigned_abs()).with_bits(self.bits);
        let power = if exponent < 0 { power.int(1) / power } else { power };
        self.others.push((exponent, power.clone()));
        power
    }

    /// `10^n`, by squaring.
    fn ten_to(&self, n: u64) -> E {
        let whole = |n, bits| E::exact(&Dyadic::new(false, vec![n], 0), bits);
        let mut power = whole(1, 64);
        for place in (0..64 - n.leading_zeros()).rev() {
            let reached = n >> place;
            let bits = self.enough(usize::try_from(reached).unwrap_or(usize::MAX));
            power = power.with_bits(bits).square();
            if reached & 1 == 1 {
                power = power * whole(10, 64);
            }
        }
        power
    }

    /// The integer of at most `LEAF 2^level` digits.
    fn joined(&self, digits: &[u8], level: usize) -> E {
        let Some(smaller) = level.checked_sub(1) else {
            return E::exact(&Dyadic::new(false, words(digits), 0), self.enough(digits.len()));
        };
        let below = LEAF << smaller;
        if digits.len() <= below {
            return self.joined(digits, smaller);
        }
        let (top, rest) = digits.split_at(digits.len() - below);
        let top = self.joined(top, smaller).with_bits(self.enough(digits.len()));
        top * &self.squares[smaller] + self.joined(rest, smaller)
    }

    /// Bits of an integer of so many digits, `log2(10) < 10/3`; no more than those of the result.
    fn enough(&self, digits: usize) -> usize {
        digits.saturating_mul(10).div_ceil(3).saturating_add(64).min(self.bits)
    }
}

/// The integer in words, the least significant first.
fn words(digits: &[u8]) -> Vec<u64> {
    let mut words: Vec<u64> = Vec::new();
    for chunk in digits.chunks(CHUNK) {
        let digit = |n: u64, digit: &u8| 10 * n + u64::from(*digit - b'0');
        let mut carry = u128::from(chunk.iter().fold(0, digit));
        let scale = u128::from(10u64.pow(chunk.len() as u32));
        for word in &mut words {
            let sum = u128::from(*word) * scale + carry;
            (*word, carry) = (sum as u64, sum >> 64);
        }
        if carry > 0 {
            words.push(carry as u64);
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{AstroInterval, Enclosure, Field};

    /// Digits of every length about the places where they are split, against Horner's rule.
    #[test]
    fn digits_are_split_and_joined() {
        let bits = 12_000;
        let mut tens = Tens::<AstroInterval>::new(bits);
        let all: Vec<u8> = (0..3 * LEAF).map(|i| b'0' + (i * i + i / 7) as u8 % 10).collect();
        let like = AstroInterval::integer(0, bits);
        let (mut value, mut next) = (like.clone(), 0);
        for length in [1, 17, 18, 19, LEAF - 1, LEAF, LEAF + 1, 2 * LEAF, 2 * LEAF + 1, 3 * LEAF] {
            for digit in &all[next..length] {
                value = value * like.int(10) + like.int(i32::from(*digit - b'0'));
            }
            next = length;
            let joined = tens.integer(&all[..length]);
            assert!(joined.overlaps(&value), "{length}");
            assert!(!joined.overlaps(&(value.clone() + like.int(1))), "exact: {length}");
        }
    }

    /// Where the result has fewer bits than the digits, it is an enclosure.
    #[test]
    fn more_digits_than_bits_are_enclosed() {
        let digits: Vec<u8> = (0..3 * LEAF).map(|i| b'0' + (7 * i + 1) as u8 % 10).collect();
        let exact = Tens::<AstroInterval>::new(12_000).integer(&digits);
        let rounded = Tens::<AstroInterval>::new(128).integer(&digits);
        let unit = exact.clone() * Tens::<AstroInterval>::new(12_000).power(-30);
        assert!(rounded.overlaps(&exact));
        assert!(!rounded.overlaps(&(exact.clone() + &unit)));
        assert!(!rounded.overlaps(&(exact - unit)));
    }

    #[test]
    fn powers_are_those_of_ten() {
        let mut tens = Tens::<AstroInterval>::new(256);
        let like = AstroInterval::integer(0, 256);
        assert!(tens.power(0).overlaps(&like.int(1)));
        assert!(tens.power(9).overlaps(&like.int(1_000_000_000)));
        assert!(!tens.power(9).overlaps(&like.int(1_000_000_001)));
        for n in [1, 5, 64, 1000, 3_000_000] {
            let one = tens.power(n) * tens.power(-n);
            assert!(one.overlaps(&like.int(1)), "{n}");
            let close = like.int(1) + like.ratio(1, 1_000_000_007);
            assert!(!one.overlaps(&close), "{n}");
        }
    }
}
