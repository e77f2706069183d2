//! Numbers of a few words on the stack, the least significant first: what a fixed point is made of.

use std::cmp::Ordering;

/// The order of two sizes.
#[inline]
pub(super) fn compare<const N: usize>(a: &[u64; N], b: &[u64; N]) -> Ordering {
    for i in (0..N).rev() {
        if a[i] != b[i] {
            return a[i].cmp(&b[i]);
        }
    }
    Ordering::Equal
}

/// `a + b`, where the topmost words have room for it. A plain loop: what is built for size calls closures word by word.
#[inline]
pub(super) fn sum<const N: usize>(a: &[u64; N], b: &[u64; N]) -> [u64; N] {
    let (mut words, mut carry) = ([0; N], false);
    for i in 0..N {
        let (word, first) = a[i].overflowing_add(b[i]);
        let (word, second) = word.overflowing_add(u64::from(carry));
        (words[i], carry) = (word, first | second);
    }
    words
}

/// `a - b` for `a >= b`.
#[inline]
pub(super) fn difference<const N: usize>(a: &[u64; N], b: &[u64; N]) -> [u64; N] {
    let (mut words, mut borrow) = ([0; N], false);
    for i in 0..N {
        let (word, first) = a[i].overflowing_sub(b[i]);
        let (word, second) = word.overflowing_sub(u64::from(borrow));
        (words[i], borrow) = (word, first | second);
    }
    words
}

/// `a b 2^-64(N-1)`, cut off, less than `1 + 2^-58` too small, for at most 40 words; the topmost have room for it.
///
/// Left out are the columns from the third below the last word of the result on: a product of words in column `c`
/// is below `2^64(c+2)`, and the uppermost of these columns, `N - 4`, has at most 37, so that they are below `38
/// 2^64(N-2)` together.
#[inline]
pub(super) fn product<const N: usize>(a: &[u64; N], b: &[u64; N]) -> [u64; N] {
    let mut words = [0; N];
    product_of(a, b, &mut words);
    words
}

/// Products of words: compiled here, for speed, and not where they are used, for size.
fn product_of(a: &[u64], b: &[u64], to: &mut [u64]) {
    macro_rules! sizes {
        ($($n:literal)+) => { match a.len() {
            $($n => rows::<$n>(a, b, to),)+
            _ => {}
        } };
    }
    sizes!(2 3 4 5 6 7 8 9 10 12 14 16 18 20 24 28 32 36 40);
}

/// Product row by row, two rows at once: a word of the sum is read and written half as often.
fn rows<const N: usize>(a: &[u64], b: &[u64], to: &mut [u64]) {
    let (Ok(a), Ok(b)) = (<&[u64; N]>::try_from(a), <&[u64; N]>::try_from(b)) else { return };
    let mut all = [0u64; 80];
    let mut i = 0;
    while i < N {
        let (x, y) = (a[i], if i + 1 < N { a[i + 1] } else { 0 });
        let (mut of_x, mut of_y) = (0, 0);
        let mut j = N.saturating_sub(3 + i);
        let mut before = if j > 0 { b[j - 1] } else { 0 };
        while j < N {
            let first =
                u128::from(x) * u128::from(b[j]) + u128::from(all[i + j]) + u128::from(of_x);
            let second =
                u128::from(y) * u128::from(before) + u128::from(first as u64) + u128::from(of_y);
            (of_x, of_y) = ((first >> 64) as u64, (second >> 64) as u64);
            all[i + j] = second as u64;
            before = b[j];
            j += 1;
        }
        let last = u128::from(y) * u128::from(before) + u128::from(of_x) + u128::from(of_y);
        (all[i + N], all[i + N + 1]) = (last as u64, (last >> 64) as u64);
        i += 2;
    }
    to.copy_from_slice(&all[N - 1..2 * N - 1]);
}

/// `a n`, where the topmost word has room for it.
pub(super) fn multiple<const N: usize>(a: &[u64; N], n: u64) -> [u64; N] {
    let mut carry = 0;
    a.map(|word| {
        let term = u128::from(word) * u128::from(n) + u128::from(carry);
        carry = (term >> 64) as u64;
        term as u64
    })
}

/// `a / n`, cut off, and what it leaves; `0 < n < 2^32`, so that quotients of half words are those of machine words.
pub(super) fn quotient<const N: usize>(a: &[u64; N], n: u64) -> ([u64; N], u64) {
    let (mut words, mut rest) = ([0; N], 0);
    for (word, from) in words.iter_mut().zip(a).rev() {
        let upper = rest << 32 | from >> 32;
        let lower = (upper % n) << 32 | from & 0xffff_ffff;
        (*word, rest) = (((upper / n) << 32) + lower / n, lower % n);
    }
    (words, rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::Integer;
    use rug::integer::Order;

    fn integer(words: &[u64]) -> Integer {
        Integer::from_digits(words, Order::Lsf)
    }

    proptest! {
        #![proptest_config(config(1000))]

        /// Carries through words of ones, borrows through words of zeros.
        #[test]
        fn they_are_those_of_gmp(
            a in prop::array::uniform5(prop_oneof![Just(0u64), Just(u64::MAX), any::<u64>()]),
            b in prop::array::uniform5(prop_oneof![Just(0u64), Just(u64::MAX), any::<u64>()]),
            n in 1u64..1 << 31,
        ) {
            let small = |mut words: [u64; 5]| { words[4] %= 1 << 31; words };
            let (a, b) = (small(a), small(b));
            let (x, y) = (integer(&a), integer(&b));
            prop_assert_eq!(integer(&sum(&a, &b)), Integer::from(&x + &y));
            prop_assert_eq!(compare(&a, &b), x.cmp(&y));
            let (large, less) = if x >= y { (&a, &b) } else { (&b, &a) };
            prop_assert_eq!(integer(&difference(large, less)), Integer::from(&x - &y).abs());
            let lost = (Integer::from(&x * &y) >> 256) - integer(&product(&a, &b));
            prop_assert!(lost == 0 || lost == 1, "{}", lost);
            prop_assert_eq!(integer(&multiple(&a, n)), Integer::from(&x * n));
            let (words, rest) = quotient(&a, n);
            prop_assert_eq!((integer(&words), rest), (Integer::from(&x / n), Integer::from(&x % n).to_u64().unwrap()));
        }
    }
}
