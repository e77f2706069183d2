//! Sine and cosine of a number of three words in `[-4, 4]`, within [`ERROR`] `= 2^-150` of the truth; for `|x| <= 1/64`
//! the sine is within `2^-150 |x|`.
//!
//! *Proof.* With the integer `k` nearest to `32 x`, `r = x - k/32` is at most `1/64 + 2^-40` in size and has, as `k/32`
//! is a double next to `x`, an error of less than `2^-190`, none for `k = 0`; `y = r² < 2^-11.9` is cut off to a fixed
//! point of 192 bits. There
//!
//! ```text
//! sin r = r - r g,   g = y/3! - y²/5! + ... ± y^8/17!,   what is left out is below |r| y^9/19! < 2^-162 |r|
//! cos r = 1 - f,     f = y/2! - y²/4! + ... ± y^8/16!,   what is left out is below y^9/18!     < 2^-158
//! ```
//!
//! Each coefficient and each product is cut off by less than two units of `2^-192`, and these errors are multiplied by
//! `y` before they are added up: less than `2^-189` in all. With the sine `S` and the cosine `C` of `k/32`, rounded by
//! MPFR to 256 bits and cut off to 192,
//!
//! ```text
//! sin x = S + (C sin r - S f),   cos x = C - (C f + S sin r)
//! ```
//!
//! add at most twelve errors of `2^-189`. For `k = 0`, where `S = 0` and `C = 1`, `sin x = sin r`; for `|x| = 1/64` and
//! `k = 1` the error is below `2^-157`. ∎

use super::triple_word::{TripleWord, difference, upper_product};
use crate::number::Field;
use rug::Float;
use std::sync::OnceLock;

/// The bound of the error.
pub(crate) const ERROR: f64 = TripleWord::UNIT;

/// Terms of the series.
const TERMS: usize = 8;

/// `2^192/n!`, cut off, for `n` up to 17; that of the first two means nothing.
const RECIPROCAL_FACTORIALS: [[u64; 3]; 2 * TERMS + 2] = {
    let mut all = [[0; 3]; 2 * TERMS + 2];
    // Of 2!.
    let mut last = [0, 0, 1 << 63];
    let mut n = 2;
    while n < all.len() {
        all[n] = last;
        n += 1;
        let (mut rest, mut i) = (0u128, 3);
        while i > 0 {
            i -= 1;
            let above = rest << 64 | last[i] as u128;
            last[i] = (above / n as u128) as u64;
            rest = above % n as u128;
        }
    }
    all
};

/// Sine and cosine of `k/32`.
fn row(k: usize) -> [TripleWord; 2] {
    static ROWS: [OnceLock<[TripleWord; 2]>; 129] = [const { OnceLock::new() }; 129];
    let k = k.min(ROWS.len() - 1);
    *ROWS[k].get_or_init(|| {
        let (sin, cos) = (Float::with_val(256, k) / 32u32).sin_cos(Float::new(256));
        [sin, cos].map(|x| TripleWord::of_float(&x).0)
    })
}

/// `y/n! - y²/(n + 2)! + ...`, in units of `2^-192`.
#[inline]
fn series(first: usize, y: &[u64; 3]) -> TripleWord {
    let coefficient = |k: usize| RECIPROCAL_FACTORIALS[first + 2 * k];
    let sum = (0..TERMS - 1).rev().fold(coefficient(TERMS - 1), |sum, k| {
        difference(&coefficient(k), &upper_product(&sum, y)).0
    });
    TripleWord::of_fixed(upper_product(&sum, y))
}

/// Sine and cosine of `x` with `|x| <= 4`; beyond, what comes out means nothing.
pub(crate) fn sin_cos(x: TripleWord) -> (TripleWord, TripleWord) {
    let (x, is_negative) = x.size();
    let k = (32.0 * x.hi()).round();
    let [sin_k, cos_k] = row(k as usize);
    let r = x - x.int(k as i32) / x.int(32);
    let y = (r * r).fixed();
    let (g, f) = (series(3, &y), series(2, &y));
    let sin_r = r - r * g;
    let sin = sin_k + (cos_k * sin_r - sin_k * f);
    let cos = cos_k - (cos_k * f + sin_k * sin_r);
    (if is_negative { -sin } else { sin }, cos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::Integer;
    use rug::integer::Order;

    fn float(x: TripleWord) -> Float {
        let (negative, words, exponent) = x.parts();
        let size = Float::with_val(420, Integer::from_digits(&words, Order::Lsf)) << exponent;
        if negative { -size } else { size }
    }

    /// The larger error of sine and cosine, over the bound.
    fn error(x: TripleWord, (sin, cos): (TripleWord, TripleWord)) -> f64 {
        let truth = float(x).sin_cos(Float::new(420));
        let scale = if x.hi().abs() <= 1.0 / 64.0 { x.hi().abs() } else { 1.0 };
        let of =
            |truth: Float, found| Float::with_val(53, truth - float(found)).to_f64().abs() / ERROR;
        (of(truth.0, sin) / scale).max(of(truth.1, cos))
    }

    proptest! {
        #![proptest_config(config(20_000))]

        /// Anywhere, next to points of the table, to middles between them and to zeros of sine and cosine; tiny.
        #[test]
        fn hard_arguments_keep_the_bound(
            near in prop_oneof![(0u32..=256).prop_map(|k| f64::from(k) / 64.0), Just(std::f64::consts::PI), Just(0.0)],
            size in 0i32..180, words in any::<[u64; 3]>(), negative in any::<bool>(), below in any::<bool>(),
        ) {
            let offset = TripleWord::of_words(below, &words, i64::from(-192 - size)).0;
            let x = TripleWord::of_float(&Float::with_val(53, near)).0 + offset;
            let x = if negative { -x } else { x };
            if x.hi().abs() <= 4.0 {
                let (sin, cos) = sin_cos(x);
                prop_assert!(error(x, (sin, cos)) < 0.1, "{x:?} {}", error(x, (sin, cos)));
                let more = TripleWord::of_float(&Float::with_val(53, 2.0 * ERROR)).0;
                prop_assert!(error(x, (sin, cos + more)) > 1.0, "false twin");
            }
        }
    }

    #[test]
    fn reciprocal_factorials_are_cut_off() {
        for (n, words) in RECIPROCAL_FACTORIALS.iter().enumerate().skip(2) {
            let truth = (Integer::from(1) << 192) / Integer::from(Integer::factorial(n as u32));
            let lost = truth - Integer::from_digits(words, Order::Lsf);
            assert!(lost == 0 || lost == 1, "{n}! {lost}");
        }
    }
}
