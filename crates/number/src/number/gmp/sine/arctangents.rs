//! The arguments of the Gaussian primes, by arctangents of small numbers, kept from one use to the next.
//!
//! `x² + 1` has prime factors up to 109 only for each `x` of [`INVERSES`], so that `x + i` is a product of the
//! primes of [`PRIMES`](super::gaussian::PRIMES) and `atan(1/x)` a sum of multiples of their arguments. The
//! arguments are therefore combinations of these arctangents, whose series are fast; among
//! them is a formula for `pi/4` (after Machin; Størmer 1897; Johansson 2022, arXiv:2207.02501).

use super::Magnitude;
use super::gaussian::COUNT;
use super::product::{halving_powers, product, square};
use rug::Integer;
use std::collections::BTreeMap;
use std::sync::{Arc, PoisonError, RwLock};

/// Large independent `x` up to 4·10^8 with `x² + 1` free of prime factors beyond 109.
const INVERSES: [u32; COUNT] = [
    284_862_638,
    201_229_582,
    193_788_912,
    168_623_905,
    24_208_144,
    22_709_274,
    18_975_991,
    6_367_252,
    6_225_244,
    3_014_557,
    2_809_305,
    2_343_692,
    2_298_668,
    1_984_933,
];

/// Twice the argument of each prime in multiples of the arctangents of the inverses: twice the inverse of
/// the matrix of exponents, as the test below shows.
const MULTIPLES: [[i32; COUNT]; COUNT] = [
    [
        -893758, -127448, -721484, -461142, 863336, 664110, 1482900, 789210, 212214, 36462, 738156,
        805882, 432616, 938934,
    ],
    [
        -527616, -75237, -425917, -272228, 509657, 392047, 875407, 465898, 125277, 21525, 435759,
        475740, 255388, 554285,
    ],
    [
        -669128, -95416, -540152, -345242, 646352, 497198, 1110200, 590856, 158878, 27298, 552634,
        603338, 323886, 702950,
    ],
    [
        -278778, -39753, -225043, -143838, 269289, 207147, 462541, 246168, 66193, 11373, 230243,
        251368, 134940, 292869,
    ],
    [
        -433004, -61745, -349541, -223412, 418265, 321745, 718429, 382352, 102813, 17665, 357619,
        390430, 209592, 454891,
    ],
    [
        -187934, -26799, -151709, -96966, 181537, 139645, 311815, 165950, 44623, 7667, 155215,
        169456, 90968, 197433,
    ],
    [
        -767834, -109491, -619831, -396170, 741697, 570541, 1273969, 678014, 182315, 31325, 634155,
        692338, 371664, 806645,
    ],
    [
        -316696, -45160, -255652, -163402, 305916, 235322, 525454, 279650, 75196, 12920, 261560,
        285558, 153294, 332704,
    ],
    [
        -790590, -112737, -638203, -407912, 763681, 587451, 1311727, 698112, 187717, 32253, 652949,
        712858, 382678, 830551,
    ],
    [
        -408270, -58218, -329574, -210650, 394372, 303366, 677390, 360510, 96940, 16656, 337190,
        368128, 197620, 428906,
    ],
    [
        -635668, -90645, -513141, -327978, 614031, 472335, 1054683, 561310, 150933, 25933, 524999,
        573168, 307690, 667799,
    ],
    [
        -475926, -67866, -384190, -245558, 459726, 353638, 789644, 420254, 113004, 19416, 393068,
        429132, 230368, 499982,
    ],
    [
        -113420, -16173, -91557, -58520, 109559, 84277, 188183, 100152, 26931, 4627, 93673, 102268,
        54900, 119153,
    ],
    [
        -331668, -47295, -267739, -171128, 320379, 246447, 550295, 292872, 78751, 13531, 273925,
        299058, 160542, 348433,
    ],
];

/// Bits by which the arctangents are longer than the arguments: above the sum of the multiples of a row.
const GUARD: u32 = 40;

/// The arguments of the Gaussian primes in units of `2^-places`, less than two units off.
pub(super) struct PrimeArguments {
    pub places: u32,
    pub values: Vec<Integer>,
}

static KNOWN: RwLock<Option<Arc<PrimeArguments>>> = RwLock::new(None);

impl PrimeArguments {
    /// Arguments to at least `places` binary places; computed where they are not known to so many.
    pub(super) fn to(places: u32) -> Arc<Self> {
        let read = || KNOWN.read().unwrap_or_else(PoisonError::into_inner).clone();
        if let Some(known) = read().filter(|known| known.places >= places) {
            return known;
        }
        // A few more, so that a slightly longer one need not be computed again. No lock is held meanwhile.
        let fresh = Arc::new(Self::compute(places + places / 16 + 64));
        let mut known = KNOWN.write().unwrap_or_else(PoisonError::into_inner);
        if known.as_ref().is_none_or(|known| known.places < fresh.places) {
            *known = Some(fresh.clone());
        }
        fresh
    }

    /// Error of an argument: each arctangent is three units of `2^-(places + GUARD)` off and the multiples of a row
    /// add up to less than `2^25`, so that their sum is less than `2^-12` units off, and it is rounded down.
    fn compute(places: u32) -> Self {
        let arctangents = INVERSES.map(|x| arctangent_of_inverse(x, places + GUARD));
        let value = |multiples: &[i32; COUNT]| {
            let twice =
                multiples.iter().zip(&arctangents).fold(Integer::new(), |sum, (m, x)| sum + x * m);
            twice >> (GUARD + 1)
        };
        Self { places, values: MULTIPLES.iter().map(value).collect() }
    }

    /// `2 sum c_j theta_j` in units of `2^-places`, with a bound of the error, for `places` not above those known.
    pub(super) fn combination(&self, c: &[i32; COUNT], places: u32) -> (Integer, Magnitude) {
        let cut = self.places - places;
        let mut sum = Integer::new();
        for (value, c) in self.values.iter().zip(c).filter(|(_, c)| **c != 0) {
            sum += Integer::from(value >> cut) * c;
        }
        // Each is less than two units off, and one more once it is cut.
        let size: u64 = c.iter().map(|c| u64::from(c.unsigned_abs())).sum();
        (sum << 1, Magnitude::from_integer(6 * size).shifted(-i64::from(places)))
    }
}

/// `atan(1/x)` in units of `2^-places`, for `x > 1`; less than three units off.
///
/// Error: `sum (-1)^k/((2k+1) x^(2k+1))` alternates and falls; the first term left out is less than a unit. The
/// numerator and the denominator are cut so that the denominator has 64 bits more than the places: that
/// changes a value below one by less than `2^-62` units. The quotient loses less than a unit.
fn arctangent_of_inverse(x: u32, places: u32) -> Integer {
    let terms = places / (2 * x.ilog2()) + 1;
    let square = square(&Integer::from(x));
    let powers = halving_powers(&square, terms);
    let (numerator, denominator) = fraction(0, terms, &powers);
    // The sum is numerator / (denominator x^(2 terms - 1)).
    let (numerator, denominator) = (numerator * x, product(&denominator, &powers[&terms]));
    let excess = denominator.significant_bits().saturating_sub(places + 64);
    (numerator << places >> excess) / (denominator >> excess)
}

/// `sum (-1)^(k-a) x^(2(b-1-k)) / (2k+1)` for `k` from `a` to `b - 1`, as numerator and denominator.
fn fraction(a: u32, b: u32, powers: &BTreeMap<u32, Integer>) -> (Integer, Integer) {
    if b - a == 1 {
        return (Integer::from(1), Integer::from(2 * u64::from(a) + 1));
    }
    let half = (b - a) / 2;
    let (left, right) = (fraction(a, b - half, powers), fraction(b - half, b, powers));
    let head = product(&product(&left.0, &right.1), &powers[&half]);
    let rest = product(&right.0, &left.1);
    let is_even = (b - half - a).is_multiple_of(2);
    (if is_even { head + rest } else { head - rest }, product(&left.1, &right.1))
}

#[cfg(test)]
mod tests {
    use super::super::gaussian::PRIMES;
    use super::*;
    use rug::Float;

    /// Exponent of each prime in `x + i`, conjugates counted as negative; the unit left over is a power of
    /// `i`, which is the square of `1 + i` but for a positive factor.
    fn exponents(x: u32) -> [i64; COUNT] {
        let (mut re, mut im) = (i64::from(x), 1i64);
        let mut exponents = [0; COUNT];
        for (j, &(a, b)) in PRIMES.iter().enumerate() {
            let (a, b) = (i64::from(a), i64::from(b));
            let norm = a * a + b * b;
            for (sign, b) in [(1, b), (-1, -b)] {
                // (re + i im) / (a + i b)
                while (re * a + im * b) % norm == 0 && (im * a - re * b) % norm == 0 {
                    (re, im) = ((re * a + im * b) / norm, (im * a - re * b) / norm);
                    exponents[j] += sign;
                }
            }
        }
        assert_eq!(re * re + im * im, 1, "{x}");
        // The argument of x + i is between 0 and pi/4, which tells how often i is a factor.
        let sum: f64 = PRIMES
            .iter()
            .zip(exponents)
            .map(|(&(a, b), e)| e as f64 * f64::from(b).atan2(f64::from(a)))
            .sum();
        let quarters = (sum / std::f64::consts::FRAC_PI_4).round() as i64;
        exponents[0] -= quarters;
        assert_eq!(quarters.rem_euclid(2), 0, "only powers of i are left");
        exponents
    }

    /// Exactly: the multiples of the exponents are twice the unit matrix.
    #[test]
    fn the_multiples_give_twice_each_argument() {
        let exponents = INVERSES.map(exponents);
        for (j, multiples) in MULTIPLES.iter().enumerate() {
            for i in 0..COUNT {
                let products = multiples.iter().zip(&exponents).map(|(m, e)| i64::from(*m) * e[i]);
                assert_eq!(products.sum::<i64>(), if i == j { 2 } else { 0 }, "row {j}, prime {i}");
            }
            let size: u64 = multiples.iter().map(|m| u64::from(m.unsigned_abs())).sum();
            assert!(size < 1 << 25);
        }
    }

    #[test]
    fn the_errors_are_as_stated() {
        for places in [64, 500, 3000, 10_007] {
            let arguments = PrimeArguments::compute(places);
            for (&(re, im), ours) in PRIMES.iter().zip(&arguments.values) {
                let truth = (Float::with_val(places + 50, im) / re).atan() << places;
                let off = Float::with_val(64, truth - ours);
                assert!(off.clone().abs() < 2, "{places} {re} {im} {off}");
            }
        }
        let places = 2000;
        let ours = arctangent_of_inverse(INVERSES[13], places);
        let truth = Float::with_val(places + 50, INVERSES[13]).recip().atan() << places;
        assert!(Float::with_val(64, truth - ours).abs() < 3);
    }

    #[test]
    fn a_combination_is_within_its_bound() {
        let arguments = PrimeArguments::to(900);
        let mut c = [0; COUNT];
        (c[0], c[3], c[13]) = (-7, 1234, -999);
        let (ours, error) = arguments.combination(&c, 800);
        let argument = |j: usize| (Float::with_val(1000, PRIMES[j].1) / PRIMES[j].0).atan();
        let truth = 2 * (argument(0) * c[0] + argument(3) * c[3] + argument(13) * c[13]);
        let off = Float::with_val(64, truth - (Float::with_val(900, ours) >> 800u32)).abs();
        assert!(off < error.to_float() && error < Magnitude::power_of_two(-785));
    }
}
