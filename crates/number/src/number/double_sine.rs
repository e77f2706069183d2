//! Sine and cosine of a double-double in `[-4, 4]`, with a proved bound of the error.
//!
//! **Bound.** Both are within [`ERROR`] `= 2^-103` of the truth; for `|x| <= 1/64` the sine is even within
//! `2^-103 |x|`.
//!
//! *Proof*, with `u = 2^-53`, so that `ERROR = 8 u²`. The operations of [`DoubleDouble`] err by `3u²` (sum) and
//! `7u²` (product) relative to their results, each constant by `u²`, plus terms of third order, all of which together
//! are below `2^-40` of what is added up here.
//!
//! *Reduction.* `k` is the integer nearest to `32 hi` (adding and taking away `1.5 2^52` rounds to it). For `k >= 1`,
//! `hi` is between `k/64` and `k/16`, so that `s = hi - k/32` is exact (Sterbenz); `s` is zero or at least a unit
//! in the last place of `hi`, of which `lo` is at most a half, so that `r = s + lo = x - k/32` is exact too, and
//! `|r| <= 1/64 + 2^-52`. Any other `k` will do with `|s| <= 1/63` and `hi >= k/64`: then `k = 0`, or `hi` is again
//! between `k/64` and `k/16`. `y = r²` errs by `7u²`, relative to it, and is below `2^-11.9`.
//!
//! *Series.* What is left out of `sin r` after `r^13` is below `|r| 2^-83/15! < 2^-123 |r|`, of `cos r` after
//! `r^12` below `2^-83/14! < 2^-119`. The innermost terms, `1/9! - y/11! + y²/13!` and `1/8! - y/10! + y²/12!`, are
//! doubles with an error of less than `2^-70` and `2^-67`; with `y^4 < 2^-47` before them they add less than
//! `2^-117 |r|` and `2^-114`. Each further coefficient `h <- h y ± 1/n!` is a sum whose second term exceeds the
//! first more than `2^12` times, so that it errs by less than `3 + 1 + 1 = 5 u²`, relative to it. Hence, relative
//! to themselves, `h y` errs by `19u²` and `h y r` by `26u²`; with `|h y| < 2^-14` and `|c| < 2^-12`, where
//!
//! ```text
//! sin r = r + h y r         errs by less than (3 + 26/2^14 + 0.01) u² |r| < 3.1 u² |r|
//! c = cos r - 1 = h y       errs by less than (19/2^12 + 0.01) u²        < 0.02 u²
//! ```
//!
//! *Result.* With `S, C` from the table, `|sin r| < 1/63`,
//!
//! ```text
//! sin x = S + (S c + C sin r):   table 1, S c 0.03, C sin r (3.1 + 7 + 1)/63, inner sum 3/62, outer sum 3:  < 4.4 u²
//! cos x = C + (C c - S sin r):   the same
//! ```
//!
//! For `k = 0`, where `S = 0` and `C = 1`, the products are exact and `sin x = sin r`: `3.1 u² |x|`.
//!
//! *Underflow.* Below `2^-60` the answer is `x` and 1: the errors are `|x|³/6` and `x²/2`. From there on, for `k =
//! 0`, all leading terms are above `2^-300`; for `k >= 1`, where `r` may be anything, and in the low parts, an
//! underflow adds less than `2^-1000`. ∎
//!
//! The tests compare with MPFR: the largest error seen in 10^7 hard arguments is in the test that is ignored.

use super::double_sine_table::{RECIPROCAL_FACTORIALS, SINES_COSINES};
use super::{DoubleDouble, DoubleDoubleBy, Product};

/// The bound of the error: `2^-103`.
pub(super) const ERROR: f64 = DoubleDouble::UNIT / 2.0;

/// Argument up to which the error of the sine is relative to its argument.
pub(super) const RELATIVE: f64 = 1.0 / 64.0;

/// The largest argument.
pub(super) const LARGEST: f64 = 4.0;

/// Sine and cosine of `x` with `|hi| <= 4`; beyond, what comes out means nothing.
pub(super) fn sin_cos<P: Product>(x: DoubleDoubleBy<P>) -> (DoubleDoubleBy<P>, DoubleDoubleBy<P>) {
    const NEGLIGIBLE: f64 = 1.0 / (1u64 << 60) as f64;
    if x.hi().abs() < NEGLIGIBLE {
        return (x, DoubleDoubleBy::exact(1.0));
    }
    if x.hi() < 0.0 {
        let (sin, cos) = SinePoint::nearest(-x.hi()).sin_cos(-x);
        return (-sin, cos);
    }
    SinePoint::nearest(x.hi()).sin_cos(x)
}

/// A point of the table, from which sine and cosine next to it are found.
#[derive(Clone, Copy, Debug)]
pub struct SinePoint {
    /// A multiple of 1/32.
    rad: f64,
    /// Sine of it and the rest of that, cosine and the rest.
    row: [f64; 4],
}

impl SinePoint {
    /// The distance up to which a point is used for a double.
    const REACH: f64 = 1.0 / 63.0;

    /// The point next to `x` in `[0, 4]`; some point for anything else.
    #[inline(always)]
    pub fn nearest(x: f64) -> Self {
        const ROUNDING: f64 = (3u64 << 51) as f64;
        let rounded = 32.0 * x + ROUNDING;
        // The last bits of the sum are the integer.
        let place = (rounded.to_bits() & 0xff) as usize;
        let row = SINES_COSINES[place.min(SINES_COSINES.len() - 1)];
        Self { rad: (rounded - ROUNDING) / 32.0, row }
    }

    /// Tells whether sine and cosine of a double-double led by `x`, found from this point, are within
    /// [`ERROR`](Self::ERROR) of the truth.
    #[inline(always)]
    #[allow(clippy::manual_range_contains, reason = "a range decides in two steps")]
    pub fn reaches(&self, x: f64) -> bool {
        let is_exact = (self.rad == 0.0) | (x >= self.rad / 2.0);
        (x >= 0.0) & (x <= LARGEST) & ((x - self.rad).abs() <= Self::REACH) & is_exact
    }

    /// The bound of the error of sine and cosine: `2^-103`.
    pub const ERROR: f64 = ERROR;

    /// Sine and cosine of a number next to it, without a branch, so that many go through at a time.
    #[inline(always)]
    pub fn sin_cos<P: Product>(
        &self,
        x: DoubleDoubleBy<P>,
    ) -> (DoubleDoubleBy<P>, DoubleDoubleBy<P>) {
        let [sin, sin_rest, cos, cos_rest] = self.row;
        let sin_k = DoubleDoubleBy::constant(sin, sin_rest);
        let cos_k = DoubleDoubleBy::constant(cos, cos_rest);
        let r = DoubleDoubleBy::<P>::sum(x.hi() - self.rad, x.lo());
        let y = r * r;
        let of = |n: usize| RECIPROCAL_FACTORIALS[n - 3];
        let over = |n: usize| DoubleDoubleBy::constant(of(n)[0], of(n)[1]);
        let tail = |n: usize| of(n)[0] + y.hi() * (y.hi() * of(n + 4)[0] - of(n + 2)[0]);

        let h = DoubleDoubleBy::exact(tail(9)) * y - over(7);
        let h = (h * y + over(5)) * y - over(3);
        let sin_r = h * y * r + r;

        let h = DoubleDoubleBy::exact(tail(8)) * y - over(6);
        let h = (h * y + over(4)) * y - DoubleDoubleBy::exact(0.5);
        let less = h * y;

        let sin = (sin_k * less + cos_k * sin_r) + sin_k;
        let cos = (cos_k * less - sin_k * sin_r) + cos_k;
        (sin, cos)
    }

    /// The bound of the error of sine and cosine in doubles: `2^-51`.
    ///
    /// With `u = 2^-53`, the rest of `sin r` after `r^7` is below `2^-72`, of `cos r` after `r^6` below `2^-62`. The
    /// entry of the table errs by `u`. No term that is added to it is above `1/62`, and none errs by more than `7 u`
    /// relative to it, so that all of it errs by less than `u/4`; the last sum errs by `u`.
    pub const ERROR_IN_DOUBLES: f64 = 4.0 * (f64::EPSILON / 2.0);

    /// Sine and cosine of a double that it [reaches](Self::reaches), within
    /// [`ERROR_IN_DOUBLES`](Self::ERROR_IN_DOUBLES) of the truth; elsewhere they mean nothing.
    #[inline(always)]
    pub fn sin_cos_in_doubles(&self, x: f64) -> (f64, f64) {
        let [sin_k, _, cos_k, _] = self.row;
        let r = x - self.rad;
        let y = r * r;
        let of = |n: usize| RECIPROCAL_FACTORIALS[n - 3][0];
        let sin_r = r - r * y * (of(3) - y * (of(5) - y * of(7)));
        let less = -y * (0.5 - y * (of(4) - y * of(6)));
        (sin_k + (sin_k * less + cos_k * sin_r), cos_k + (cos_k * less - sin_k * sin_r))
    }
}

/// Points of the table for many numbers, apart by what they hold: so that many are read at a time.
#[derive(Clone, Debug)]
pub struct SinePoints<const N: usize> {
    rad: [f64; N],
    row: [[f64; N]; 4],
}

impl<const N: usize> SinePoints<N> {
    /// No point for any number yet: none reaches it.
    pub const NONE: Self = Self { rad: [f64::NAN; N], row: [[f64::NAN; N]; 4] };

    /// Sets the point in a place.
    #[inline(always)]
    pub fn set(&mut self, place: usize, point: SinePoint) {
        self.rad[place] = point.rad;
        for (column, x) in self.row.iter_mut().zip(point.row) {
            column[place] = x;
        }
    }

    /// The point in a place.
    #[inline(always)]
    pub fn get(&self, place: usize) -> SinePoint {
        let row = &self.row;
        SinePoint {
            rad: self.rad[place],
            row: [row[0][place], row[1][place], row[2][place], row[3][place]],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Float;

    const BITS: u32 = 420;

    /// A stream of words (SplitMix64), the same in every run.
    struct Words(u64);

    impl Words {
        fn next(&mut self) -> u64 {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ z >> 31
        }

        fn below(&mut self, n: u64) -> u64 {
            self.next() % n
        }

        /// In `[1, 2)`, now and then with a mantissa of ones or of zeros.
        fn mantissa(&mut self) -> f64 {
            let bits = match self.below(8) {
                0 => 0,
                1 => u64::MAX,
                _ => self.next(),
            };
            f64::from_bits(1023 << 52 | bits >> 12)
        }
    }

    /// Anywhere; next to a point of the table, to the middle between two, to a zero of sine or cosine; tiny.
    /// The low part is of any size.
    fn argument(words: &mut Words) -> DoubleDouble {
        use std::f64::consts::{FRAC_PI_2, PI};
        let kind = words.below(8);
        let near = match kind {
            0 | 1 => words.below(129) as f64 / 32.0,
            2 | 3 => (words.below(128) as f64 + 0.5) / 32.0,
            4 => [FRAC_PI_2, PI][words.below(2) as usize],
            _ => 0.0,
        };
        let offset = match kind {
            0..=4 => words.mantissa() * 2f64.powi(-5 - words.below(110) as i32),
            5 => words.mantissa() * 2f64.powi(-2 - words.below(220) as i32),
            _ => words.mantissa() * 2f64.powi(1 - words.below(8) as i32),
        };
        let sign = [1.0, -1.0][words.below(2) as usize];
        let low = words.mantissa() * 2f64.powi(-53 - words.below(60) as i32);
        let x = DoubleDouble::sum(near, sign * offset);
        let x = x + DoubleDouble::exact(x.hi() * low * [0.0, 1.0, -1.0][words.below(3) as usize]);
        let x = if words.below(2) == 0 { x } else { -x };
        if x.hi().abs() <= LARGEST { x } else { x / DoubleDouble::exact(2.0) }
    }

    fn float(x: DoubleDouble) -> Float {
        Float::with_val(BITS, x.hi()) + x.lo()
    }

    /// The larger error of sine and cosine, over the bound.
    fn error(x: DoubleDouble, (sin, cos): (DoubleDouble, DoubleDouble)) -> f64 {
        let truth = float(x).sin_cos(Float::new(BITS));
        let scale = if x.hi().abs() <= RELATIVE { x.hi().abs() } else { 1.0 };
        let of =
            |truth: Float, found| Float::with_val(53, truth - float(found)).to_f64().abs() / ERROR;
        (of(truth.0, sin) / scale).max(of(truth.1, cos))
    }

    fn largest_error(count: u32) -> f64 {
        let mut words = Words(0);
        let arguments = (0..count).map(|_| argument(&mut words));
        arguments.map(|x| error(x, sin_cos(x))).fold(0.0, f64::max)
    }

    #[test]
    fn hard_arguments_keep_the_bound() {
        let largest = largest_error(100_000);
        assert!(largest < 1.0, "{largest} of the bound");
    }

    /// `cargo test --release --lib ten_million -- --ignored --nocapture`
    #[test]
    #[ignore = "half a minute with optimisation"]
    fn ten_million_hard_arguments_keep_the_bound() {
        let largest = largest_error(10_000_000);
        println!("largest error: {largest} of the bound");
        assert!(largest < 1.0, "{largest} of the bound");
    }

    /// False twins: what is off by a hair more than the bound is seen, at the ends of the range too.
    #[test]
    fn an_error_beyond_the_bound_is_seen() {
        for x in [1e-50, 0.01, 1.0, 3.9, -4.0].map(DoubleDouble::exact) {
            let (sin, cos) = sin_cos(x);
            assert!(error(x, (sin, cos)) < 1.0);
            let scale = if x.hi().abs() <= RELATIVE { x.hi().abs() } else { 1.0 };
            let more = DoubleDouble::exact(2.0 * ERROR);
            assert!(error(x, (sin + more * DoubleDouble::exact(scale), cos)) > 1.0, "{x:?}");
            assert!(error(x, (sin, cos - more)) > 1.0, "{x:?}");
        }
    }

    /// From the point next to a double and from its neighbours, as far as they reach.
    #[test]
    fn a_point_keeps_the_bound_as_far_as_it_reaches() {
        let (mut words, mut shared) = (Words(1), 0);
        for _ in 0..100_000 {
            let exact = argument(&mut words);
            let exact = if exact.hi() < 0.0 { -exact } else { exact };
            let x = exact.hi();
            let mut points = SinePoints::<3>::NONE;
            let shifts = [-1.0, 0.0, 1.0].map(|by| by * 6e-4);
            (0..3).for_each(|k| points.set(k, SinePoint::nearest((x + shifts[k]).max(0.0))));
            let reaching = (0..3).map(|k| points.get(k)).filter(|point| point.reaches(x));
            for point in reaching {
                shared += usize::from(point.rad != SinePoint::nearest(x).rad);
                for exact in [exact, DoubleDouble::exact(x)] {
                    assert!(error(exact, point.sin_cos(exact)) < 1.0, "{x} from {}", point.rad);
                }
                let (sin, cos) = point.sin_cos_in_doubles(x);
                let truth = Float::with_val(BITS, x).sin_cos(Float::new(BITS));
                let error = Float::with_val(53, truth.0 - sin)
                    .abs()
                    .max(&(Float::with_val(53, truth.1 - cos).abs()));
                assert!(error < SinePoint::ERROR_IN_DOUBLES, "{x} from {}", point.rad);
            }
        }
        assert!(shared > 1000, "{shared}");
        let far = SinePoint::nearest(1.0);
        assert!(far.reaches(1.0) && !far.reaches(1.02) && !far.reaches(f64::NAN));
        assert!(!SinePoints::<1>::NONE.get(0).reaches(1.0));
        assert!(
            SinePoint::nearest(0.01).reaches(0.01) && !SinePoint::nearest(0.02).reaches(0.0155)
        );
        assert!(!SinePoint::nearest(0.0).reaches(-0.0078125));
    }

    #[test]
    fn zero_and_signs_are_exact() {
        assert_eq!(sin_cos(DoubleDouble::ZERO), (DoubleDouble::ZERO, DoubleDouble::exact(1.0)));
        let x = DoubleDouble::sum(0.7, 1e-18);
        let ((sin, cos), (minus, same)) = (sin_cos(x), sin_cos(-x));
        assert_eq!((-sin, cos), (minus, same));
    }
}
