//! The decimals of a fraction by products, where there are many.
//!
//! A fraction times `10^a` is the integer of its first `a` digits and the fraction of the others; so the digits
//! are found by splitting them in halves, each from as many bits as it has digits, down to [`LEAF`] of them. All
//! values of one number of digits are split alike and share the powers of five, and nothing is divided: 1.2 to 1.6
//! times as fast as a conversion of the integer, from five thousand to a million digits.
//!
//! **Error.** Let a part of `d` digits be computed from `x`, with `w >= d log2(10) + 64` bits behind the point, and
//! belong to the true fraction `X` in `[x, x + e 2^-w)`. Its first half is that of the same `X`, cut to fewer bits,
//! so that `e` grows by one. In the other half `X 10^a` has `w - a` bits behind the point and `e 5^a` units of
//! error; cut to `b log2(10) + 64` bits, rounded up, it has less than `2 e + 1`: for `w` has no fewer than `d
//! log2(10) + 64` bits, and `10^a 2^(b log2(10) + 65 - w) <= 2`. After at most [`LEVELS`] halvings `e` is below
//! `2^(LEVELS + 2)`, and what is left out below `2^(LEVELS + 2 - 64) < 2^-MARGIN` of the last digit of the part. No
//! digit is wrong unless a product that is cut off lies so near below an integer: then the answer is `None`.

use rug::Integer;
use rug::ops::Pow;
use std::sync::{Arc, Mutex, PoisonError};

/// Digits that are converted at once.
const LEAF: usize = 600;
/// Largest number of times that digits are halved: `LEAF 2^LEVELS` is more than a million.
const LEVELS: usize = 11;
/// Bits behind the last digit of a part that are told apart.
pub(super) const MARGIN: u32 = 48;
/// Bits of a part beyond its digits.
const GUARD: u32 = 64;

/// The digits of a fraction, and what follows them.
pub(super) struct Expansion {
    /// Digits as many as were asked for, with zeros in front.
    pub digits: String,
    /// The first [`MARGIN`] bits behind the last digit; what follows it is at least that and less than two units more.
    pub rest: u64,
}

/// The first `count` digits of the fractions in `[x, x + 1) / 2^bits`, if they are the same and can be told. There
/// have to be 64 bits beyond the digits, and at most a million and one of these.
pub(super) fn expansion(x: &Integer, bits: u32, count: usize) -> Option<Expansion> {
    if bits < width(count) || count > LEAF << LEVELS || x.significant_bits() > bits {
        return None;
    }
    let powers = powers(count);
    let mut found = Expansion { digits: String::with_capacity(count), rest: 0 };
    powers.write(cut(x, bits, width(count)), count, powers.squares.len(), &mut found)?;
    Some(found)
}

/// Bits behind the point of a part of so many digits. `log2(10) < 3.3219281`.
pub(super) fn width(digits: usize) -> u32 {
    (digits as u64 * 33_219_281).div_ceil(10_000_000) as u32 + GUARD
}

/// A fraction cut from `bits` to `width` bits behind the point.
fn cut(x: &Integer, bits: u32, width: u32) -> Integer {
    Integer::from(x >> bits.saturating_sub(width))
}

/// The powers of five by which fractions of one number of digits are split.
struct Powers {
    /// The digits of a leaf.
    leaf: usize,
    /// `5^(leaf 2^k)`.
    squares: Vec<Integer>,
}

/// The powers for numbers of `count` digits. Those used last are kept.
fn powers(count: usize) -> Arc<Powers> {
    static LAST: Mutex<Option<(usize, Arc<Powers>)>> = Mutex::new(None);
    let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
    match &*last {
        Some((known, powers)) if *known == count => powers.clone(),
        _ => {
            let powers = Arc::new(Powers::new(count));
            *last = Some((count, powers.clone()));
            powers
        }
    }
}

impl Powers {
    fn new(count: usize) -> Self {
        let levels = (0..LEVELS).find(|level| LEAF << level >= count).unwrap_or(LEVELS);
        let leaf = count.div_ceil(1 << levels);
        let mut squares = Vec::new();
        let mut power = Integer::from(5).pow(leaf as u32);
        for _ in 0..levels {
            let square = Integer::from(power.square_ref());
            squares.push(power);
            power = square;
        }
        Self { leaf, squares }
    }

    /// Writes `count <= leaf 2^level` digits of `x / 2^width(count)`.
    fn write(&self, x: Integer, count: usize, level: usize, found: &mut Expansion) -> Option<()> {
        let bits = width(count);
        let Some(level) = level.checked_sub(1) else {
            let power = if count == self.leaf { self.squares.first() } else { None };
            let product = match power {
                Some(power) => x * power,
                None => x * Integer::from(5).pow(count as u32),
            };
            let (whole, part) = split(product, bits - count as u32);
            found.rest = told(&part, bits - count as u32)?;
            let text = whole.to_string_radix(10);
            found.digits.extend(std::iter::repeat_n('0', count.checked_sub(text.len())?));
            found.digits.push_str(&text);
            return Some(());
        };
        let first = self.leaf << level;
        if count <= first {
            return self.write(x, count, level, found);
        }
        let (_, part) = split(Integer::from(&x * &self.squares[level]), bits - first as u32);
        told(&part, bits - first as u32)?;
        self.write(cut(&x, bits, width(first)), first, level, found)?;
        let others = count - first;
        self.write(cut(&part, bits - first as u32, width(others)), others, level, found)
    }
}

/// The integer part of `x / 2^bits`, and the other part in units of `2^-bits`.
fn split(x: Integer, bits: u32) -> (Integer, Integer) {
    let whole = Integer::from(&x >> bits);
    (whole, x.keep_bits(bits))
}

/// The first bits of a fraction, unless it is so near below one that it may be an integer.
fn told(part: &Integer, bits: u32) -> Option<u64> {
    let first = cut(part, bits, MARGIN).to_u64()?;
    (first < (1 << MARGIN) - 1).then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::integer::Order;

    /// The digits by one multiplication and GMP's conversion.
    fn slow(x: &Integer, bits: u32, count: usize) -> String {
        let product: Integer = (x * Integer::from(10).pow(count as u32)) >> bits;
        format!("{:0>count$}", product.to_string_radix(10))
    }

    /// A fraction with all bits drawn.
    fn drawn(bits: u32, seed: u64) -> Integer {
        let mut state = seed | 1;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state
        };
        let words: Vec<u64> = (0..bits.div_ceil(64)).map(|_| next()).collect();
        Integer::from_digits(&words, Order::Lsf).keep_bits(bits)
    }

    #[test]
    fn digits_are_those_of_one_product() {
        for count in [1, 17, LEAF - 1, LEAF, LEAF + 1, 2 * LEAF, 2 * LEAF + 1, 7777, 20_000] {
            for (seed, extra) in [(3, 0), (5, 1), (7, 63), (11, 5000)] {
                let bits = width(count) + extra;
                let x = drawn(bits, seed + count as u64);
                let found = expansion(&x, bits, count).expect("not next to an integer");
                assert_eq!(found.digits, slow(&x, bits, count), "{count} {extra}");
                let product = &x * Integer::from(10).pow(count as u32);
                let rest = cut(&product.keep_bits(bits), bits, MARGIN).to_u64().unwrap();
                assert!(found.rest.abs_diff(rest) <= 1, "{count} {extra}");
            }
        }
    }

    /// Zeros in front, before and behind the places where parts end.
    #[test]
    fn zeros_are_written() {
        let (count, run) = (3 * LEAF + 5, 12);
        let bits = width(count) + 70;
        for place in [0, LEAF - run, LEAF, 2 * LEAF - run / 2, count - run] {
            let mut text = "7".repeat(count);
            text.replace_range(place..place + run, &"0".repeat(run));
            // Half a unit behind the last digit.
            let scale = Integer::from(10).pow(count as u32 + 1);
            let x = (Integer::from_str_radix(&format!("{text}5"), 10).unwrap() << bits) / scale;
            let found = expansion(&x, bits, count).expect("not next to an integer");
            assert_eq!(found.digits, text);
            assert_eq!(found.rest >> (MARGIN - 8), 127, "just below a half");
        }
    }

    /// A decimal that ends, cut to bits, lies just below itself: at the end of a part, of a leaf, or behind the
    /// last digit.
    #[test]
    fn what_cannot_be_told_is_not() {
        let count = 4 * LEAF;
        let bits = width(count);
        for digits in [3, LEAF, 2 * LEAF, 3 * LEAF, count] {
            let scale = Integer::from(10).pow(digits as u32);
            let decimal = Integer::from(10).pow(digits as u32 - 1) * 3u32 + 1u32;
            let below = (decimal << bits) / scale;
            assert!(expansion(&below, bits, count).is_none(), "{digits}");
        }
        assert!(expansion(&Integer::from(1), width(9) - 1, 9).is_none(), "too few bits");
        assert!(expansion(&(Integer::from(1) << width(9)), width(9), 9).is_none(), "no fraction");
    }
}
