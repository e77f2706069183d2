//! Gaussian primes: rotations that are exact.
//!
//! For a Gaussian integer `u` of argument `theta`, `e^(2 i theta) = u²/|u|²` is a fraction of integers.

use super::product::{product, square};
use rug::{Complete, Integer};

/// The number of primes.
pub(super) const COUNT: usize = 14;

/// `1 + i` and the Gaussian primes up to norm 109, one of each pair of conjugates, as real and imaginary
/// part; their arguments are between 0 and pi/4.
pub(super) const PRIMES: [(i32, i32); COUNT] = [
    (1, 1),
    (2, 1),
    (3, 2),
    (4, 1),
    (5, 2),
    (6, 1),
    (5, 4),
    (7, 2),
    (6, 5),
    (8, 3),
    (8, 5),
    (9, 4),
    (10, 1),
    (10, 3),
];

/// Products of so many primes are those of machine integers: each prime is shorter than `2^3.5`.
const SMALL: u64 = 35;

/// A Gaussian integer.
#[derive(Clone)]
pub(super) struct Gaussian {
    pub re: Integer,
    pub im: Integer,
}

impl Gaussian {
    fn new(re: i32, im: i32) -> Self {
        Self { re: re.into(), im: im.into() }
    }

    /// The product of the primes to the powers `exponents`, those with a negative exponent conjugated;
    /// without the first of them, `1 + i`.
    pub(super) fn odd(exponents: &[i32; COUNT]) -> Self {
        let powers = PRIMES.iter().zip(exponents).skip(1).filter(|(_, exponent)| **exponent != 0);
        let powers = powers.map(|(&(re, im), &exponent)| {
            ((re, if exponent < 0 { -im } else { im }), exponent.unsigned_abs())
        });
        let factors: u64 = powers.clone().map(|(_, exponent)| u64::from(exponent)).sum();
        if factors > SMALL {
            let powers = powers.map(|((re, im), exponent)| Self::new(re, im).power(exponent));
            return powers.fold(Self::new(1, 0), |product, power| product.times(&power));
        }
        let (mut x, mut y) = (1i128, 0i128);
        for ((re, im), exponent) in powers {
            let (re, im) = (i128::from(re), i128::from(im));
            for _ in 0..exponent {
                (x, y) = (x * re - y * im, x * im + y * re);
            }
        }
        Self { re: x.into(), im: y.into() }
    }

    fn times(&self, other: &Self) -> Self {
        let (a, b) = (product(&self.re, &other.re), product(&self.im, &other.im));
        let (c, d) = (product(&self.re, &other.im), product(&self.im, &other.re));
        Self { re: a - b, im: c + d }
    }

    pub(super) fn squared(&self) -> Self {
        let sum = (&self.re + &self.im).complete();
        let difference = (&self.re - &self.im).complete();
        Self { re: product(&sum, &difference), im: product(&self.re, &self.im) << 1 }
    }

    pub(super) fn norm(&self) -> Integer {
        square(&self.re) + square(&self.im)
    }

    fn power(&self, exponent: u32) -> Self {
        let bits = (0..u32::BITS - exponent.leading_zeros()).rev();
        bits.fold(Self::new(1, 0), |power, bit| {
            let power = power.squared();
            if exponent >> bit & 1 == 1 { power.times(self) } else { power }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_and_conjugates() {
        let mut exponents = [0; COUNT];
        (exponents[0], exponents[1], exponents[2]) = (5, 3, -1);
        // (2+i)³ (3-2i) = (2+11i)(3-2i) = 28+29i
        let u = Gaussian::odd(&exponents);
        assert_eq!((u.re.clone(), u.im.clone()), (28.into(), 29.into()));
        assert_eq!(u.norm(), 125 * 13);
        // As many primes as there is room for, and one more, in the same place.
        let most = |exponent| {
            let mut exponents = [0; COUNT];
            exponents[COUNT - 1] = exponent;
            Gaussian::odd(&exponents)
        };
        let (most, more) = (most(SMALL as i32), most(SMALL as i32 + 1));
        let next = most.times(&Gaussian::new(10, 3));
        assert_eq!((next.re, next.im), (more.re, more.im));
        let u2 = u.squared();
        assert_eq!((u2.re, u2.im), (Integer::from(28 * 28 - 29 * 29), Integer::from(2 * 28 * 29)));
    }

    #[test]
    fn the_primes_are_those_up_to_norm_109() {
        let norms: Vec<i32> = PRIMES.iter().map(|(a, b)| a * a + b * b).collect();
        let is_prime = |n: i32| (2..n).all(|d| n % d != 0);
        let wanted = (2..110).filter(|n| is_prime(*n) && n % 4 != 3);
        assert_eq!(norms, wanted.collect::<Vec<_>>());
        assert!(PRIMES.iter().all(|(re, im)| re >= im && *im > 0));
    }
}
