//! The arguments of the Gaussian primes, by arctangents of small numbers, kept from one use to the next.
//!
//! `x² + 1` has prime factors up to 109 only for each `x` of [`INVERSES`], so that `x + i` is a product of the
//! primes of [`PRIMES`](super::gaussian::PRIMES) and `atan(1/x)` a sum of multiples of their arguments. The
//! arguments are therefore combinations of these arctangents, whose series are fast; among
//! them is a formula for `pi/4` (after Machin; Størmer 1897; Johansson 2022, arXiv:2207.02501).

use super::gaussian::COUNT;
use super::product::{halving_powers, product, square};
use super::{Ball, Magnitude};
use rug::Integer;
use std::collections::BTreeMap;
use std::sync::{Arc, PoisonError, RwLock};

/// The largest independent `x` with `x² + 1` free of prime factors beyond 109. With a product `d` of some of these
/// primes `x² + 1 = d y²` is an equation of Pell: for each `d` its solutions up to 10^22 were looked through.
const INVERSES: [u32; COUNT] = [
    2_189_376_182,
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
];

/// Twice the argument of each prime in multiples of the arctangents of the inverses: twice the inverse of
/// the matrix of exponents, as the test below shows.
const MULTIPLES: [[i32; COUNT]; COUNT] = [
    [
        -938934, -893758, -1066382, -3538286, -1400076, 2741204, 1603044, 3360768, 4544946,
        -1665654, 36462, 738156, 1744816, -506318,
    ],
    [
        -554285, -527616, -629522, -2088772, -826513, 1618227, 946332, 1983977, 2683038, -983293,
        21525, 435759, 1030025, -298897,
    ],
    [
        -702950, -669128, -798366, -2649002, -1048192, 2052252, 1200148, 2516100, 3402656,
        -1247022, 27298, 552634, 1306288, -379064,
    ],
    [
        -292869, -278778, -332622, -1103650, -436707, 855027, 500016, 1048279, 1417644, -519545,
        11373, 230243, 544237, -157929,
    ],
    [
        -454891, -433004, -516636, -1714214, -678303, 1328047, 776636, 1628211, 2201916, -806969,
        17665, 357619, 845321, -245299,
    ],
    [
        -197433, -187934, -224232, -744008, -294399, 576403, 337078, 706681, 955682, -350243, 7667,
        155215, 366889, -106465,
    ],
    [
        -806645, -767834, -916136, -3039766, -1202815, 2354987, 1377186, 2887259, 3904594,
        -1430975, 31325, 634155, 1498983, -434981,
    ],
    [
        -332704, -316696, -377864, -1253764, -496106, 971324, 568026, 1190862, 1610466, -590212,
        12920, 261560, 618262, -179410,
    ],
    [
        -830551, -790590, -943288, -3129856, -1238463, 2424783, 1418002, 2972829, 4020316,
        -1473385, 32253, 652949, 1543409, -447873,
    ],
    [
        -428906, -408270, -487124, -1616292, -639556, 1252184, 732272, 1535202, 2076134, -760872,
        16656, 337190, 797034, -231286,
    ],
    [
        -667799, -635668, -758444, -2516538, -995777, 1949629, 1140134, 2390281, 3232506, -1184665,
        25933, 524999, 1240967, -360109,
    ],
    [
        -499982, -475926, -567848, -1884136, -745540, 1459690, 853620, 1789608, 2420182, -886960,
        19416, 393068, 929114, -269614,
    ],
    [
        -119153, -113420, -135326, -449016, -177673, 347865, 203430, 426489, 576764, -211375, 4627,
        93673, 221421, -64253,
    ],
    [
        -348433, -331668, -395728, -1313038, -519561, 1017245, 594880, 1247161, 1686604, -618115,
        13531, 273925, 647491, -187891,
    ],
];

/// Bits by which the arctangents are longer than the arguments: above the sum of the multiples of a row.
const GUARD: u32 = 40;

/// Terms of a series that are not split.
const BLOCK: u32 = 24;

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
        let fresh = Arc::new(Self::compute(places + places / 128 + 64));
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

/// Pi, four times the argument of `1 + i`, if that is known to so many places.
pub(in crate::number) fn known_pi(places: u32) -> Option<Ball> {
    let known = KNOWN.read().unwrap_or_else(PoisonError::into_inner).clone()?;
    let quarter = Integer::from(&known.values[0] >> known.places.checked_sub(places)?);
    // Two units off, and one more once it is cut.
    let error = Magnitude::from_integer(3).shifted(-i64::from(places));
    Some(Ball::fixed(&quarter, places, places).widened(error).scaled(2))
}

/// `atan(1/x)` in units of `2^-places`, for `x > 1`; less than three units off.
///
/// Error: `sum (-1)^k/((2k+1) x^(2k+1))` alternates and falls; the first term left out is less than a unit. The
/// numerator and the denominator are cut so that the denominator has 64 bits more than the places: that
/// changes a value below one by less than `2^-62` units. The quotient loses less than a unit.
fn arctangent_of_inverse(x: u32, places: u32) -> Integer {
    // Two more, for what the quotient of doubles is off.
    let terms = (f64::from(places) / (2.0 * f64::from(x).log2())) as u32 + 2;
    let square = square(&Integer::from(x));
    let powers = halving_powers(&square, terms);
    let (numerator, denominator) = fraction(x, 0, terms, &powers);
    // The sum is numerator / (denominator x^(2 terms - 1)).
    let (numerator, denominator) = (numerator * x, product(&denominator, &powers[&terms]));
    let excess = denominator.significant_bits().saturating_sub(places + 64);
    (numerator << places >> excess) / (denominator >> excess)
}

/// `sum (-1)^(k-a) x^(2(b-1-k)) / (2k+1)` for `k` from `a` to `b - 1`, as numerator and denominator.
fn fraction(x: u32, a: u32, b: u32, powers: &BTreeMap<u32, Integer>) -> (Integer, Integer) {
    if b - a <= BLOCK {
        return block(x, a, b);
    }
    let half = (b - a) / 2;
    let (left, right) = (fraction(x, a, b - half, powers), fraction(x, b - half, b, powers));
    let head = product(&product(&left.0, &right.1), &powers[&half]);
    let rest = product(&right.0, &left.1);
    let is_even = (b - half - a).is_multiple_of(2);
    (if is_even { head + rest } else { head - rest }, product(&left.1, &right.1))
}

/// A few terms one after the other: products in place with machine words cost less than the halves of halves.
fn block(x: u32, a: u32, b: u32) -> (Integer, Integer) {
    let square = u64::from(x).pow(2);
    let (mut numerator, mut denominator) = (Integer::from(1), Integer::from(2 * u64::from(a) + 1));
    for k in a + 1..b {
        let odd = 2 * u64::from(k) + 1;
        numerator *= square;
        numerator *= odd;
        match (k - a).is_multiple_of(2) {
            true => numerator += &denominator,
            false => numerator -= &denominator,
        }
        denominator *= odd;
    }
    (numerator, denominator)
}

#[cfg(test)]
mod tests {
    use super::super::gaussian::PRIMES;
    use super::*;
    use crate::number::{Enclosure, Real};
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
    fn pi_is_four_times_the_first() {
        PrimeArguments::to(3000);
        for places in [100, 2999] {
            let pi = known_pi(places).unwrap();
            assert!(
                pi.lies_inside(&pi.pi().widened(Magnitude::power_of_two(5 - i64::from(places))))
            );
            assert!(pi.overlaps(&pi.with_precision(4000).pi()));
        }
        assert!(known_pi(1 << 30).is_none());
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
