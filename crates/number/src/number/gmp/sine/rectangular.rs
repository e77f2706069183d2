//! Sine and versine of a small fixed-point number by Taylor's series with rectangular splitting.
//!
//! Both are a factor times an alternating series in `y = t²`,
//!
//! ```text
//! sin t = t (1 - y/(2·3) (1 - y/(4·5) (…)))      1 - cos t = y/2 (1 - y/(3·4) (1 - y/(5·6) (…)))
//! ```
//!
//! of which the powers `y, …, y^m` are computed once: then `K` terms cost `m + K/m` long products
//! (Paterson and Stockmeyer 1973). The powers of a short number are short, and a block of `m` terms that
//! `2^-k` stands before is computed with `k` bits fewer.

use super::product::{product, square};
use rug::Integer;

/// Bits kept beyond those asked for: the errors of all terms together stay below one unit.
const GUARD: u32 = 32;

/// A number with the powers that the series of its sine and of its versine share.
pub(super) struct SineArgument {
    /// Integer of the number `root 2^-short`, without zeros at its end, and below `2^-small`.
    root: Integer,
    short: u32,
    small: u32,
    places: u32,
    /// `y, …, y^m` for its square `y`, each with its binary places.
    powers: Vec<(Integer, u32)>,
}

impl SineArgument {
    /// `t` units of `2^-places`, `0 < t < 1/4`; `None` for zero.
    pub(super) fn new(t: &Integer, places: u32) -> Option<Self> {
        let zeros = t.find_one(0)?.min(places);
        let root = Integer::from(t >> zeros);
        let short = places - zeros;
        let small = short - root.significant_bits();
        let mut argument = Self { root, short, small, places, powers: Vec::new() };
        // The versine has its square to all places.
        let width = (places - small + GUARD).max(places);
        argument.powers = argument.powers(width, argument.terms());
        Some(argument)
    }

    /// The number is below two to minus this.
    pub(super) fn small(&self) -> u32 {
        self.small
    }

    /// The terms of the sine.
    pub(super) fn terms(&self) -> u32 {
        count(self.small, self.places - self.small + GUARD, of_sine)
    }

    /// `sin t` in units of `2^-places`; less than three units off.
    ///
    /// Error: the series is less than two units of `2^-(places - small)` off, `t` is below `2^-small`, and the
    /// product is rounded down.
    pub(super) fn sine(&self) -> Integer {
        let series = self.series(self.places - self.small + GUARD, of_sine) >> GUARD;
        // t = root 2^-short, the series has places - small binary places.
        product(&series, &self.root) >> (self.short - self.small)
    }

    /// `1 - cos t` in units of `2^-places`; less than three units off.
    ///
    /// Error: as for the sine, with `t²/2 < 2^-(2 small)` in place of `t`, which is rounded down as well.
    pub(super) fn versine(&self) -> Integer {
        let Some(width) = self.places.checked_sub(2 * self.small).filter(|&width| width > 0) else {
            return Integer::new();
        };
        let series = self.series(width + GUARD, of_versine) >> GUARD;
        let (square, at) = &self.powers[0];
        product(&series, &cut(square, *at, self.places)) >> (width + 1)
    }

    /// `1 - y/d(1) (1 - y/d(2) (…))` for `y = t²`, in units of `2^-width`.
    ///
    /// Error: less than `8 K + 1` units for `K` terms, so less than `2^GUARD`. With `P_i` the power
    /// `y^i` cut to at most `width` places, `e_i` units of `2^-width` off, `e_(i+j) <= e_i y^j + e_j y^i +
    /// e_i e_j 2^-width + 1`; as `y < 1/16`, every `e_i` is below 2. In block `b` numbers are in units of
    /// `2^-(width - 2 b m small)`, and what is there stands behind the factor `y^(b m) < 2^-(2 b m
    /// small)`: an error of a unit there is at most one of `2^-width` in the result. A term is off by
    /// less than 3 such units (its power, its rounding), a division by 1, a step to the block below by 4 (its rounding,
    /// that of the power, the power). The terms alternate and fall, so that the first term left out, which
    /// is below one unit, bounds the rest.
    fn series(&self, width: u32, divisor: fn(u64) -> u64) -> Integer {
        let terms = count(self.small, width, divisor);
        let powers = &self.powers;
        let columns = powers.len() as u32;
        let scale = |block: u32| width.saturating_sub(2 * block * columns * self.small);
        let mut block = (terms - 1) / columns;
        let mut places = scale(block);
        let one = (Integer::from(1), 0);
        // The sum over the divisors so far is sum / factor.
        let (mut sum, mut factor) = (Integer::new(), 1u64);
        for k in (0..terms).rev() {
            let (power, at) = match k % columns {
                0 => &one,
                column => &powers[column as usize - 1],
            };
            let term = cut(power, *at, places);
            if k.is_multiple_of(2) {
                sum += term * factor
            } else {
                sum -= term * factor
            }
            if k == 0 {
                break;
            }
            let next = divisor(u64::from(k));
            factor = factor.checked_mul(next).unwrap_or_else(|| {
                sum /= factor;
                next
            });
            if k.is_multiple_of(columns) {
                block -= 1;
                let (power, at) = &powers[columns as usize - 1];
                let to = scale(block);
                let power = if *at > to { &cut(power, *at, to) } else { power };
                let above = i64::from(to) - i64::from(places) - i64::from((*at).min(to));
                sum = shifted(product(&sum, power), above);
                places = to;
            }
        }
        sum / factor
    }

    /// `y, …, y^m`, each with its binary places.
    fn powers(&self, width: u32, terms: u32) -> Vec<(Integer, u32)> {
        let root = f64::from(terms).sqrt();
        // Powers of a short number cost less than the products of the blocks.
        let shorter = (f64::from(width) / (2.0 * f64::from(self.short))).min(f64::from(terms));
        let columns = match shorter > 2.0 {
            true => (root * (1.0 + shorter.sqrt() / 2.0)).min(shorter.max(root)),
            false => 1.2 * root,
        };
        let columns = (columns as u32).clamp(1, terms);
        let kept = |(power, at): (Integer, u64)| match at > u64::from(width) {
            true => (power >> (at - u64::from(width)) as u32, width),
            false => (power, at as u32),
        };
        let mut powers = vec![kept((square(&self.root), 2 * u64::from(self.short)))];
        for exponent in 2..=columns as usize {
            let (half, at) = &powers[exponent / 2 - 1];
            let even = (square(half), 2 * u64::from(*at));
            let next = if exponent.is_multiple_of(2) {
                even
            } else {
                let (last, at) = &powers[exponent - 2];
                (product(last, &powers[0].0), u64::from(*at) + u64::from(powers[0].1))
            };
            powers.push(kept(next));
        }
        powers
    }
}

/// The divisors of the series.
pub(super) fn of_sine(k: u64) -> u64 {
    2 * k * (2 * k + 1)
}

fn of_versine(k: u64) -> u64 {
    (2 * k + 1) * (2 * k + 2)
}

/// Number of terms that leave a rest below `2^-width`: the first with `t^(2k)/(d(1) … d(k))` below that.
pub(super) fn count(small: u32, width: u32, divisor: fn(u64) -> u64) -> u32 {
    let (mut terms, mut size) = (0, 0);
    while size < u64::from(width) {
        terms += 1;
        size += 2 * u64::from(small) + u64::from(divisor(u64::from(terms)).ilog2());
    }
    terms.max(1)
}

/// A number of `from` binary places, rounded down to `to` of them.
fn cut(x: &Integer, from: u32, to: u32) -> Integer {
    if to >= from { Integer::from(x << (to - from)) } else { Integer::from(x >> (from - to)) }
}

/// `x 2^power`, rounded down.
fn shifted(x: Integer, power: i64) -> Integer {
    if power >= 0 { x << power as u32 } else { x >> power.unsigned_abs() as u32 }
}

#[cfg(test)]
mod tests {
    use super::super::product::scrambled;
    use super::*;
    use proptest::prelude::*;
    use rug::Float;

    /// The distance of `ours` from `truth`, in units of `2^-places`.
    fn distance(ours: &Integer, truth: Float, places: u32) -> f64 {
        let scaled = Float::with_val(truth.prec(), truth << places);
        Float::with_val(64, scaled - ours).abs().to_f64()
    }

    proptest! {
        #![proptest_config(crate::number::test_config::config(200))]
        /// Arguments long and short, next to a quarter and next to nothing, of ones and of zeros.
        #[test]
        fn the_errors_are_as_stated(
            places in 40u32..4000, small in 2u32..2000, length in 1u32..3000, seed in any::<u64>(), ones in any::<bool>(),
        ) {
            let small = small.min(places - 1);
            let length = length.min(places - small);
            let t = if ones { (Integer::from(1) << length) - 1 } else { scrambled(seed, length) };
            let t = t << (places - small - length);
            let exact = Float::with_val(places + 8, &t) >> places;
            let argument = SineArgument::new(&t, places).unwrap();
            let high = 3 * places + 200;
            let (sin, cos) = (Float::with_val(high, exact.sin_ref()), Float::with_val(high, exact.cos_ref()));
            prop_assert!(distance(&argument.sine(), sin, places) < 3.0);
            prop_assert!(distance(&argument.versine(), 1 - cos, places) < 3.0);
        }
    }

    #[test]
    fn zero_and_one_unit() {
        assert!(SineArgument::new(&Integer::new(), 100).is_none());
        let unit = SineArgument::new(&Integer::from(1), 100).unwrap();
        assert!(unit.sine() <= 1 && unit.versine() == 0);
    }
}
