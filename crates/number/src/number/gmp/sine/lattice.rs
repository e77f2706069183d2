//! An angle as small multiples of the arguments of Gaussian primes: close vectors.
//!
//! Multiples `c_j` with `sum c_j theta_j` near `x` and small exponents are a vector of a lattice near
//! `(0, …, 0, x)`; Babai's method of nearest planes finds one from a reduced basis (Babai 1986). All in doubles: what
//! comes out decides how fast the sine of `x` is computed, never what it is.

use super::arctangents::PrimeArguments;
use super::gaussian::{COUNT, PRIMES};
use super::relations::{REDUCED_BASES, ReducedBasis};
use rug::{Float, Integer};
use std::sync::OnceLock;

/// Binary places of the angles here: more than the nearest relations need.
pub(super) const PLACES: u32 = 320;

/// A basis with what the method needs of it, in doubles.
struct Basis {
    relations: &'static ReducedBasis,
    /// Each vector as `(c_j log2 |z_j|², 16·2^rho sum c_j theta_j)`.
    vectors: Vec<LatticeVector>,
    /// The orthogonal vectors of Gram and Schmidt, each over the square of its length.
    duals: Vec<LatticeVector>,
}

type LatticeVector = [f64; COUNT + 1];

/// Multiples `c_j` with `sum c_j theta_j` near `x`, in units of `2^-PLACES`: with bases up to `rho`, about as near as
/// `2^-rho`.
pub(super) fn close(x: &Integer, rho: u32) -> [i32; COUNT] {
    static BASES: [OnceLock<Basis>; REDUCED_BASES.len()] =
        [const { OnceLock::new() }; REDUCED_BASES.len()];
    let arguments = PrimeArguments::to(PLACES);
    let bases = REDUCED_BASES.iter().zip(&BASES).filter(|(relations, _)| relations.rho <= rho);
    let mut c = [0; COUNT];
    for (relations, basis) in bases {
        let rest = x - (arguments.combination(&c, PLACES).0 >> 1);
        basis.get_or_init(|| Basis::new(relations)).approach(&rest, &mut c);
    }
    c
}

impl Basis {
    fn new(relations: &'static ReducedBasis) -> Self {
        let vectors: Vec<LatticeVector> =
            relations.rows.iter().map(|row| vector(row, relations.rho)).collect();
        let mut duals: Vec<LatticeVector> = Vec::new();
        for vector in &vectors {
            let mut rest = *vector;
            for dual in &duals {
                let along = dot(vector, dual) / dot(dual, dual);
                subtract(&mut rest, along, dual);
            }
            duals.push(rest.map(|x| x / dot(&rest, &rest)));
        }
        Self { relations, vectors, duals }
    }

    /// Adds to `c` what brings its sum nearer by `rest`, in units of `2^-PLACES`, and its exponents to small ones.
    fn approach(&self, rest: &Integer, c: &mut [i32; COUNT]) {
        let mut open = [0.0; COUNT + 1];
        for (open, (c, weight)) in open.iter_mut().zip(c.iter().zip(weights())) {
            *open = -f64::from(*c) * weight;
        }
        open[COUNT] = scaled(rest, self.relations.rho);
        // Many times a relation, but the sums are small again: right even where they wrap on the way.
        let mut sums = c.map(i64::from);
        let basis = self.vectors.iter().zip(&self.duals).zip(&self.relations.rows);
        for ((vector, dual), row) in basis.rev() {
            let times = dot(&open, dual).round();
            subtract(&mut open, times, vector);
            for (sum, r) in sums.iter_mut().zip(row) {
                *sum = sum.wrapping_add((times as i64).wrapping_mul(i64::from(*r)));
            }
        }
        *c = sums.map(|sum| i32::try_from(sum).unwrap_or(0));
    }
}

fn vector(c: &[i16; COUNT], rho: u32) -> LatticeVector {
    let (sum, _) = PrimeArguments::to(PLACES).combination(&c.map(i32::from), PLACES);
    let mut vector = [scaled(&(sum >> 1), rho); COUNT + 1];
    for (entry, (c, weight)) in vector.iter_mut().zip(c.iter().zip(weights())) {
        *entry = f64::from(*c) * weight;
    }
    vector
}

/// Cost of an exponent: the bits of the norm of its prime. `1 + i` costs next to nothing.
fn weights() -> [f64; COUNT] {
    let mut weights = PRIMES.map(|(re, im)| f64::from(re * re + im * im).log2());
    weights[0] = 0.01;
    weights
}

/// `16·2^rho` times a number of units of `2^-PLACES`.
fn scaled(x: &Integer, rho: u32) -> f64 {
    (Float::with_val(53, x) >> (PLACES - rho - 4)).to_f64()
}

fn dot(a: &LatticeVector, b: &LatticeVector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn subtract(from: &mut LatticeVector, times: f64, what: &LatticeVector) {
    for (x, y) in from.iter_mut().zip(what) {
        *x -= times * y;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each basis is one of all of `Z^14`: its determinant, by exact elimination, is one in size. And
    /// each relation is as short as the basis is said to have them.
    #[test]
    fn the_relations_are_bases_of_short_vectors() {
        for (relations, longest) in REDUCED_BASES.iter().zip([50, 88, 471, 3094, 22_792]) {
            let mut rows = relations.rows.map(|row| row.map(|x| rug::Rational::from(i32::from(x))));
            let mut determinant = rug::Rational::from(1);
            for k in 0..COUNT {
                let pivot = (k..COUNT).find(|&i| rows[i][k] != 0).unwrap();
                rows.swap(k, pivot);
                determinant *= &rows[k][k];
                let head = rows[k].clone();
                for row in rows.iter_mut().skip(k + 1) {
                    let factor = rug::Rational::from(&row[k] / &head[k]);
                    for (x, y) in row.iter_mut().zip(&head) {
                        *x -= rug::Rational::from(&factor * y);
                    }
                }
            }
            assert_eq!(determinant.abs(), 1);
            for row in &relations.rows {
                let vector = vector(row, relations.rho);
                assert!(dot(&vector, &vector).sqrt() <= f64::from(longest), "{}", relations.rho);
            }
        }
    }

    #[test]
    fn angles_are_reached_with_few_bits() {
        // Bits of |u|², and those of the distance, that each basis may take and has to give.
        for (rho, norm, distance) in [
            (36, 140.0, 30),
            (48, 400.0, 40),
            (80, 2000.0, 70),
            (120, 12_000.0, 108),
            (160, 90_000.0, 144),
        ] {
            for k in 1..40 {
                let x = (Integer::from(79 * k + 1) << PLACES) / 1009;
                let c = close(&x, rho);
                let bits: f64 = c.iter().zip(weights()).map(|(c, w)| f64::from(c.abs()) * w).sum();
                let rest: Integer = x - (PrimeArguments::to(PLACES).combination(&c, PLACES).0 >> 1);
                assert!(bits < norm, "{rho} {bits}");
                assert!(
                    rest.significant_bits() < PLACES - distance,
                    "{rho} {}",
                    PLACES - rest.significant_bits()
                );
            }
        }
    }
}
