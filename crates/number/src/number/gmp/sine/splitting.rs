//! The sine of a short number by binary splitting.
//!
//! For `r = u/2^p` the series `sin r = r (1 + s)`,
//!
//! ```text
//! s = - r²/(2·3) + r⁴/(2·3·4·5) - …
//! ```
//!
//! is summed as one fraction of integers, by halves (Brent 1976; Brent & Zimmermann, *Modern Computer
//! Arithmetic*, 4.9). The powers of `u²` that join two halves depend on the number of terms only, so that
//! all of one level share one. What stands behind a small power of `r` is cut to the bits that reach the
//! result.

use super::product::{halving_powers, product, square};
use super::rectangular::{count, of_sine};
use rug::Integer;
use std::collections::BTreeMap;

/// Bits kept beyond those that reach the result.
const GUARD: u32 = 40;

/// `sin(u/2^p)` in units of `2^-places`, for `0 < u/2^p < 2^-small <= 1/4` and `p <= places`; less than three
/// units off.
///
/// Error: the first term left out is less than a unit, for the terms alternate and fall. A part that
/// starts behind the factor `r^(2a)` is cut to `w = places - 2 a small + GUARD` bits, less than `2^(1-w)`
/// of itself; it is at most `r²/6` in size, since its terms alternate and fall too, so that this
/// changes the sum by less than `2^(-places - GUARD)`, and so does a power cut to as many bits. There are
/// at most four cuts a term, and fewer than `2^30` terms: less than `2^-8` units in all. The quotient is rounded
/// down, from a numerator and a denominator cut to [`GUARD`] bits more than it has, and so is the product with `r`.
pub(super) fn sine(u: &Integer, p: u32, places: u32) -> Integer {
    let small = p.saturating_sub(u.significant_bits());
    let series = SineSeries::new(u, p, small, places);
    let PartialSum { sum, denominator, shift, .. } = series.part(0, series.terms);
    // |s| < 2^(-2 small): this many bits of it count.
    let width = places.saturating_sub(2 * small) + GUARD;
    let (sum, shift) = cut(sum, shift, width + GUARD);
    let (denominator, lost) = cut(denominator, 0, width + GUARD);
    // s = sum / (denominator 2^shift), in units of 2^-(places + GUARD)
    let power = i64::from(places + GUARD) - shift + lost;
    let quotient = match power >= 0 {
        true => (sum << power as u32) / denominator,
        false => sum / (denominator << power.unsigned_abs() as u32),
    };
    let excess = product(&quotient, u) >> (p + GUARD);
    Integer::from(u << (places - p)) + excess
}

struct SineSeries {
    square: Integer,
    p: u32,
    small: u32,
    places: u32,
    terms: u32,
    /// `u^(2 n)` for the numbers of terms `n` of left halves.
    powers: BTreeMap<u32, Integer>,
}

/// Part of a series: some terms relative to the one before them: their sum is `sum / (denominator 2^shift)`,
/// and their factors multiply to a power of `u²` over `denominator 2^twos`. Both shifts are equal while
/// nothing is cut.
struct PartialSum {
    sum: Integer,
    denominator: Integer,
    shift: i64,
    twos: i64,
}

impl SineSeries {
    fn new(u: &Integer, p: u32, small: u32, places: u32) -> Self {
        let square = square(u);
        // The terms after the first are `r^(2k)/(2k+1)!`, times `r`, which is below `2^-small`.
        let terms = rounded(count(small, places.saturating_sub(small), of_sine));
        let powers = halving_powers(&square, terms);
        Self { square, p, small, places, terms, powers }
    }

    /// The terms number `a` to `b - 1`; the first is number 0.
    fn part(&self, a: u32, b: u32) -> PartialSum {
        if b - a == 1 {
            let even = 2 * u64::from(a) + 2;
            let zeros = even.trailing_zeros();
            let denominator = -(Integer::from(even >> zeros) * (2 * u64::from(a) + 3));
            let twos = 2 * i64::from(self.p) + i64::from(zeros);
            return PartialSum { sum: self.square.clone(), denominator, shift: twos, twos };
        }
        let middle = a + (b - a) / 2;
        let left = self.part(a, middle);
        let right = self.part(middle, b);
        let power = &self.powers[&(middle - a)];
        let lost = power.significant_bits().saturating_sub(self.width(middle));
        let rest = match lost > 0 {
            true => product(&Integer::from(power >> lost), &right.sum),
            false => product(power, &right.sum),
        };
        let head = product(&left.sum, &right.denominator);
        let after = left.twos + right.shift - i64::from(lost);
        let (sum, shift) = match after - left.shift {
            gap if gap >= 0 => ((head << gap as u32) + rest, after),
            gap => (head + (rest << gap.unsigned_abs() as u32), left.shift),
        };
        let (sum, shift) = cut(sum, shift, self.width(a));
        let denominator = product(&left.denominator, &right.denominator);
        PartialSum { sum, denominator, shift, twos: left.twos + right.twos }
    }

    /// The bits worth keeping of a part that starts with term `a`.
    fn width(&self, a: u32) -> u32 {
        self.places.saturating_sub((2 * a).saturating_mul(self.small)) + GUARD
    }
}

/// `x 2^-shift` with `x` cut to `bits` bits.
fn cut(x: Integer, shift: i64, bits: u32) -> (Integer, i64) {
    match x.significant_bits().checked_sub(bits) {
        Some(excess) if excess > 0 => (x >> excess, shift - i64::from(excess)),
        _ => (x, shift),
    }
}

/// A few more terms, so that halves of halves have few different lengths.
fn rounded(terms: u32) -> u32 {
    let step = match terms {
        0..100 => 1,
        100..1000 => 2,
        1000..10_000 => 16,
        _ => 128,
    };
    terms.next_multiple_of(step)
}

#[cfg(test)]
mod tests {
    use super::super::product::scrambled;
    use super::*;
    use proptest::prelude::*;
    use rug::Float;

    proptest! {
        #![proptest_config(crate::number::test_config::config(100))]
        /// Short and long, dense and sparse arguments.
        #[test]
        fn the_error_is_as_stated(
            places in 200u32..20_000, small in 2u32..400, length in 1u32..600, seed in any::<u64>(), sparse in any::<bool>(),
        ) {
            let small = small.min(places / 4);
            let length = length.min(places - small);
            let u = if sparse { (Integer::from(1) << (length - 1)) + 1 } else { scrambled(seed, length) };
            let p = small + u.significant_bits();
            let ours = sine(&u, p, places);
            let r = Float::with_val(length + 64, &u) >> p;
            let truth = Float::with_val(places + 64, r.sin_ref());
            let off = Float::with_val(64, (truth << places) - ours);
            prop_assert!(off.clone().abs() < 3, "{off}");
        }
    }

    #[test]
    fn the_sum_of_few_terms_is_exact() {
        // u/2^p = 3/16: -9/(256·6) + 81/(65536·120)
        let series = SineSeries::new(&Integer::from(3), 4, 2, 200);
        let PartialSum { sum, denominator, shift, .. } = series.part(0, 2);
        let value = rug::Rational::from((sum, denominator << shift as u32));
        let term = |n: i32, d: i32| rug::Rational::from((n, d));
        assert_eq!(value, term(-9, 1536) + term(81, 7_864_320));
    }
}
