//! Floating point of three machine words: 192 bits without a heap.
//!
//! **Every operation errs by less than [`UNIT`](TripleWord::UNIT) `= 2^-150` relative to its result**, for numbers
//! within `2^±220` and zero:
//!
//! | operation | how | relative error |
//! |---|---|---|
//! | sum, difference | cut off behind a fourth word | `2^-190` |
//! | product | cut off | `2^-191` |
//! | quotient, square root | by double-doubles, and a correction by doubles | `2^-151` |
//!
//! *Sum.* With one word more than the numbers have, the smaller one is shifted without a loss by up to 64 bits; if
//! by more, less than a unit of the fourth word is cut off, and the sum or the difference has its first bit among the
//! first two. To three words less than a unit of the third is cut off.
//!
//! *Quotient, root.* That of double-doubles, `q`, is within `2^-102` of the true one, its operands cut off included.
//! What it leaves, `a - q b` or `a - q²`, errs by less than `2^-189 a`; as a part of `a` it is below `2^-101`, so that
//! its quotient by `b` or `2 q` in doubles, which has five roundings of at most `2^-52`, adds less than `2^-152`. The
//! square of the correction of a root is below `2^-202`.

use crate::number::{DoubleDouble, Field};
use rug::Float;
use rug::integer::Order;

/// A number of 192 bits, `± words 2^exponent`: zero, or the topmost bit is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TripleWord {
    negative: bool,
    /// The least significant first.
    words: [u64; 3],
    exponent: i32,
}

/// The bits of a mantissa.
const BITS: i32 = 192;
/// The topmost bit of a word.
const TOP: u64 = 1 << 63;

/// `2^exponent`; beyond the range of normal doubles the nearest one.
#[inline]
fn power(exponent: i32) -> f64 {
    f64::from_bits(((exponent.clamp(-1022, 1023) + 1023) as u64) << 52)
}

/// `a b`.
#[inline]
fn product(a: &[u64; 3], b: &[u64; 3]) -> [u64; 6] {
    let mut all = [0u64; 6];
    for (i, x) in a.iter().enumerate() {
        let mut carry = 0;
        for (j, y) in b.iter().enumerate() {
            let term = u128::from(*x) * u128::from(*y) + u128::from(all[i + j]) + u128::from(carry);
            (all[i + j], carry) = (term as u64, (term >> 64) as u64);
        }
        all[i + 3] = carry;
    }
    all
}

/// `a b 2^-192`, cut off.
#[inline]
pub(super) fn upper_product(a: &[u64; 3], b: &[u64; 3]) -> [u64; 3] {
    let [.., low, middle, high] = product(a, b);
    [low, middle, high]
}

/// `words 2^-shift`, cut off.
#[inline]
fn shifted<const N: usize>(words: &[u64; N], shift: u32) -> [u64; N] {
    let (skip, bits) = ((shift / 64) as usize, shift % 64);
    let word = |i: usize| words.get(i).copied().unwrap_or(0);
    // In two steps: no shift is by 64 bits.
    std::array::from_fn(|i| word(i + skip) >> bits | word(i + skip + 1) << (63 - bits) << 1)
}

impl TripleWord {
    /// Zero.
    pub const ZERO: Self = Self { negative: false, words: [0; 3], exponent: 0 };

    /// Above the relative error of every operation: `2^-150`.
    pub const UNIT: f64 = 1.0 / (1u128 << 75) as f64 / (1u128 << 75) as f64;

    /// Part of a number that 192 bits leave of it, rounded up.
    pub const CUT: f64 = Self::UNIT / (1u64 << 40) as f64;

    /// Pi, cut off.
    pub const PI: Self = Self {
        negative: false,
        words: [0x2902_4e08_8a67_cc74, 0xc4c6_628b_80dc_1cd1, 0xc90f_daa2_2168_c234],
        exponent: -190,
    };

    /// `± words 2^exponent`, the least significant word first, cut off to 192 bits; and whether anything was cut
    /// off.
    pub fn of_words(negative: bool, words: &[u64], exponent: i64) -> (Self, bool) {
        let Some(top) = words.iter().rposition(|word| *word != 0) else {
            return (Self::ZERO, false);
        };
        let zeros = words[top].leading_zeros();
        let word = |k: usize| top.checked_sub(k).map_or(0, |i| words[i]);
        // The word that ends `k` words below the first bit.
        let at = |k: usize| word(k) << zeros | word(k + 1) >> 1 >> (63 - zeros);
        let is_cut = word(3) << zeros != 0
            || top.checked_sub(4).is_some_and(|i| words[..=i].iter().any(|w| *w != 0));
        let exponent = exponent + 64 * top as i64 - i64::from(zeros) - 128;
        // Far beyond all that is used.
        let exponent = exponent.clamp(-(1 << 24), 1 << 24) as i32;
        (Self { negative, words: [at(2), at(1), at(0)], exponent }, is_cut)
    }

    /// The number cut off to 192 bits, and whether anything was.
    pub(super) fn of_float(x: &Float) -> (Self, bool) {
        let (mantissa, exponent) = x.to_integer_exp().unwrap_or_default();
        let words: Vec<u64> = mantissa.to_digits(Order::Lsf);
        Self::of_words(mantissa < 0, &words, exponent.into())
    }

    /// The sign, the words of the mantissa, the least significant first, and the exponent.
    pub(super) fn parts(self) -> (bool, [u64; 3], i32) {
        (self.negative, self.words, self.exponent)
    }

    /// `floor(|x| 2^192)` of a number below one.
    #[inline]
    pub(super) fn fixed(self) -> [u64; 3] {
        shifted(&self.words, (-BITS - self.exponent).max(0) as u32)
    }

    /// `words 2^-192`.
    #[inline]
    pub(super) fn of_fixed([low, middle, high]: [u64; 3]) -> Self {
        Self::normal(false, [0, low, middle, high], -BITS - 64)
    }

    /// `± words 2^exponent`, cut off.
    fn normal(negative: bool, words: [u64; 4], exponent: i32) -> Self {
        let [_, low, middle, high] = words;
        if high & TOP != 0 {
            return Self { negative, words: [low, middle, high], exponent: exponent + 64 };
        }
        let Some(top) = words.iter().rposition(|word| *word != 0) else { return Self::ZERO };
        let zeros = words[top].leading_zeros();
        let word = |k: usize| if k <= top { words[top - k] } else { 0 };
        let at = |k: usize| word(k) << zeros | word(k + 1) >> 1 >> (63 - zeros);
        let exponent = exponent + 64 * top as i32 - zeros as i32 - 128;
        Self { negative, words: [at(2), at(1), at(0)], exponent }
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.words[2] == 0
    }

    /// The number with its sign taken away, and whether it was negative.
    #[inline]
    pub(super) fn size(self) -> (Self, bool) {
        (Self { negative: false, ..self }, self.negative)
    }

    #[inline]
    fn signed(&self, size: f64) -> f64 {
        if self.negative { -size } else { size }
    }

    /// A double `x` with `|number - x| <= (2^-53 + 2^-63) |x|`.
    #[inline]
    pub fn hi(self) -> f64 {
        let top = (self.words[2] >> 11) + (self.words[2] >> 10 & 1);
        self.signed(top as i64 as f64 * power(self.exponent + 139))
    }

    /// The number cut off to a double.
    #[inline]
    pub fn shortened(self) -> f64 {
        self.signed((self.words[2] >> 11) as i64 as f64 * power(self.exponent + 139))
    }

    /// Tells whether the number is a double.
    pub(super) fn is_double(self) -> bool {
        self.words[..2] == [0; 2] && self.words[2] << 53 == 0
    }

    /// The number cut off to at least 105 bits.
    #[inline]
    pub fn to_double_double(self) -> DoubleDouble {
        let [_, middle, top] = self.words;
        let low = (top & 0x7ff) << 42 | middle >> 22;
        let unit = power(self.exponent + 86);
        let [high, low] = [(top >> 11) as i64 as f64 * power(53), low as i64 as f64];
        DoubleDouble::sum(self.signed(high * unit), self.signed(low * unit))
    }

    /// The double `x`; what is not finite becomes larger than all that is used, and what is subnormal, zero.
    #[inline]
    fn of_double(x: f64) -> Self {
        let biased = (x.to_bits() >> 52 & 0x7ff) as i32;
        if biased == 0 {
            return Self::ZERO;
        }
        let mantissa = x.to_bits() & ((1 << 52) - 1) | 1 << 52;
        Self { negative: x < 0.0, words: [0, 0, mantissa << 11], exponent: biased - 1075 - 139 }
    }

    /// The square root of a number that is not negative.
    pub fn sqrt(self) -> Self {
        if self.is_zero() {
            return self;
        }
        let root = self.to_double_double().sqrt();
        let near = Self::from(root);
        let rest = self - near * near;
        near + Self::of_double(rest.hi() / (2.0 * root.hi()))
    }
}

/// The number itself; a part that is more than 190 bits below the first is lost.
impl From<DoubleDouble> for TripleWord {
    #[inline]
    fn from(x: DoubleDouble) -> Self {
        Self::of_double(x.hi()) + Self::of_double(x.lo())
    }
}

impl Field for TripleWord {
    #[inline]
    fn int(&self, n: i32) -> Self {
        if n == 0 {
            return Self::ZERO;
        }
        let size = u64::from(n.unsigned_abs());
        let zeros = size.leading_zeros();
        Self { negative: n < 0, words: [0, 0, size << zeros], exponent: -128 - zeros as i32 }
    }
}

impl TripleWord {
    #[inline]
    fn negated(self) -> Self {
        Self { negative: !self.negative && !self.is_zero(), ..self }
    }

    fn plus(self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { *other } else { self };
        }
        let is_larger = self.exponent >= other.exponent;
        let (large, small) = if is_larger { (self, *other) } else { (*other, self) };
        let gap = large.exponent.abs_diff(small.exponent);
        let longer = |x: &[u64; 3]| [0, x[0], x[1], x[2]];
        let (a, b) = (longer(&large.words), shifted(&longer(&small.words), gap.min(256)));
        let exponent = large.exponent - 64;
        if large.negative == small.negative {
            let mut carry = 0;
            let sum: [u64; 4] = std::array::from_fn(|i| {
                let term = u128::from(a[i]) + u128::from(b[i]) + carry;
                carry = term >> 64;
                term as u64
            });
            if carry == 0 {
                return Self { words: [sum[1], sum[2], sum[3]], ..large };
            }
            let half = shifted(&sum, 1);
            let words = [half[1], half[2], half[3] | TOP];
            return Self { words, exponent: large.exponent + 1, ..large };
        }
        let (difference, is_below) = difference(&a, &b);
        match is_below {
            true => Self::normal(small.negative, self::difference(&b, &a).0, exponent),
            false => Self::normal(large.negative, difference, exponent),
        }
    }

    #[inline]
    fn minus(self, other: &Self) -> Self {
        self + -*other
    }

    fn times(self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        let [.., next, low, middle, high] = product(&self.words, &other.words);
        let exponent = self.exponent + other.exponent + BITS - 64;
        Self::normal(self.negative != other.negative, [next, low, middle, high], exponent)
    }

    fn over(self, other: &Self) -> Self {
        if self.is_zero() {
            return Self::ZERO;
        }
        let quotient = Self::from(self.to_double_double() / other.to_double_double());
        let rest = self - quotient * other;
        quotient + Self::of_double(rest.hi() / other.hi())
    }
}

/// `a - b`, and whether it is below zero, where the difference means nothing.
#[inline]
pub(super) fn difference<const N: usize>(a: &[u64; N], b: &[u64; N]) -> ([u64; N], bool) {
    let mut borrow = false;
    let words = std::array::from_fn(|i| {
        let (word, first) = a[i].overflowing_sub(b[i]);
        let (word, second) = word.overflowing_sub(u64::from(borrow));
        borrow = first | second;
        word
    });
    (words, borrow)
}

operators!(TripleWord);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::{Integer, Rational};

    /// Mantissas that carry and cancel, words of ones and of zeros, exponents near and far.
    fn hard() -> impl Strategy<Value = TripleWord> {
        let word = || prop_oneof![Just(0u64), Just(1), Just(u64::MAX), Just(TOP), any::<u64>()];
        let exponent = prop_oneof![-3i32..3, -70i32..70, -200i32..200];
        (word(), word(), word(), exponent, any::<bool>()).prop_map(
            |(low, middle, high, exponent, negative)| TripleWord {
                negative,
                words: [low, middle, high | TOP],
                exponent: exponent - BITS,
            },
        )
    }

    fn value(x: TripleWord) -> Rational {
        let (negative, words, exponent) = x.parts();
        let size = Rational::from(Integer::from_digits(&words, Order::Lsf)) << exponent;
        if negative { -size } else { size }
    }

    fn is_within(found: TripleWord, truth: &Rational, bits: u32) -> bool {
        let is_normal = found.is_zero() == (found == TripleWord::ZERO)
            && (found.is_zero() || found.words[2] & TOP != 0);
        let error = Rational::from(&value(found) - truth).abs();
        is_normal && error <= truth.clone().abs() >> bits
    }

    proptest! {
        #![proptest_config(config(20_000))]

        #[test]
        fn each_operation_keeps_its_bound(a in hard(), b in hard()) {
            let (x, y) = (value(a), value(b));
            prop_assert!(is_within(a + b, &Rational::from(&x + &y), 190), "{a:?} {b:?}");
            prop_assert!(is_within(a - b, &Rational::from(&x - &y), 190));
            prop_assert!(is_within(a * b, &Rational::from(&x * &y), 191));
            prop_assert!(is_within(a / b, &Rational::from(&x / &y), 151));
            let truth = Float::with_val(400, x.clone().abs()).sqrt().to_rational().unwrap();
            prop_assert!(is_within(a.size().0.sqrt(), &truth, 151));
            let beside = a * b + TripleWord::of_double((a * b).hi() * TripleWord::UNIT);
            prop_assert!(!is_within(beside, &Rational::from(&x * &y), 151), "false twin");
        }

        #[test]
        fn doubles_are_as_near_as_is_said(a in hard()) {
            let (x, exact) = (value(a), |x: f64| Rational::from_f64(x).unwrap());
            let error = (&x - exact(a.hi())).abs();
            prop_assert!(error <= exact(a.hi().abs() * 2f64.powi(-53)) + exact(a.hi().abs() * 2f64.powi(-63)));
            let shortened = exact(a.shortened().abs());
            prop_assert!(shortened <= x.clone().abs() && shortened >= exact(a.hi().abs() * (1.0 - 2f64.powi(-51))));
            let both = a.to_double_double();
            let both = exact(both.hi()) + exact(both.lo());
            prop_assert!(Rational::from(&x - &both).abs() <= x.clone().abs() >> 104u32);
            prop_assert_eq!(a.is_double(), exact(a.shortened()) == x);
            let float = Float::with_val(300, &x);
            prop_assert_eq!(TripleWord::of_float(&float), (a, false));
            prop_assert_eq!(value(TripleWord::of_double(a.hi())), exact(a.hi()));
        }

        /// Words of any number, with bits to be cut off or not.
        #[test]
        fn words_are_cut_off(
            words in prop::collection::vec(prop_oneof![Just(0u64), Just(1), Just(u64::MAX), any::<u64>()], 0..7),
            exponent in -300i64..100,
        ) {
            let (found, is_cut) = TripleWord::of_words(false, &words, exponent);
            let truth = Rational::from(Integer::from_digits(&words, Order::Lsf)) << exponent as i32;
            prop_assert!(is_within(found, &truth, 191));
            prop_assert_eq!(is_cut, value(found) != truth);
        }
    }

    #[test]
    fn small_integers_and_zero_are_exact() {
        for n in [0, 1, -1, 3, i32::MAX, i32::MIN] {
            assert_eq!(value(TripleWord::ZERO.int(n)), n);
        }
        let one = TripleWord::ZERO.int(1);
        assert_eq!(one - one, TripleWord::ZERO);
        assert_eq!(-TripleWord::ZERO, TripleWord::ZERO);
        assert_eq!(one + TripleWord::ZERO, one);
    }
}
