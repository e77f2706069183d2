//! A few sparse linear equations over balls, by Gaussian elimination.
//!
//! The steps are the same for each matrix in the balls, so that their results are enclosed. If no pivot can be zero,
//! each of these matrices is regular, and what comes out holds its solution (Neumaier 1990, section 4.5).

use crate::number::{Ball, Derivatives, Drawable, Enclosure, Field, Magnitude};

/// A pivot is at most so many bits below the largest entry of its column.
const THRESHOLD: i64 = 6;

/// A square matrix of balls after elimination.
#[derive(Clone, Debug)]
pub struct Eliminated {
    pivots: Vec<Pivot>,
}

#[derive(Clone, Debug)]
struct Pivot {
    row: usize,
    column: usize,
    reciprocal: Ball,
    /// Number of times that the row is subtracted from others.
    multiples: Vec<(usize, Ball)>,
    /// The other entries of the row, by columns whose pivots come later.
    others: Vec<(usize, Ball)>,
}

impl Eliminated {
    /// The matrix of the derivatives of as many numbers as there are unknowns. `None` if a pivot may be zero.
    pub fn new(slopes: &[impl Derivatives<Ball>]) -> Option<Self> {
        let places = 0..slopes.len();
        let entry =
            |row: &_, k| Derivatives::slope(row, k).filter(|x: &&Ball| !x.is_zero()).cloned();
        let row = |row| places.clone().map(|k| entry(row, k)).collect();
        // Rows become empty once they are used.
        let mut rows: Vec<Vec<Option<Ball>>> = slopes.iter().map(row).collect();
        let pivots = places.clone().map(|_| Pivot::eliminate(&mut rows)).collect::<Option<_>>()?;
        Some(Self { pivots })
    }

    /// The solutions for one right-hand side.
    pub fn solve(&self, mut right: Vec<Ball>) -> Vec<Ball> {
        for pivot in &self.pivots {
            let head = right[pivot.row].clone();
            for (row, factor) in &pivot.multiples {
                right[*row] = right[*row].clone() - head.clone() * factor;
            }
        }
        let mut solution: Vec<Ball> = right.iter().map(|x| x.int(0)).collect();
        for pivot in self.pivots.iter().rev() {
            let terms = pivot.others.iter().map(|(k, x)| x.clone() * &solution[*k]);
            let rest = terms.fold(right[pivot.row].clone(), |rest, term| rest - term);
            solution[pivot.column] = rest * &pivot.reciprocal;
        }
        solution
    }
}

impl Pivot {
    /// Takes one row and eliminates its pivot from those that remain.
    fn eliminate(rows: &mut [Vec<Option<Ball>>]) -> Option<Self> {
        let (row, column) = choose(rows)?;
        let mut entries = std::mem::take(&mut rows[row]);
        let head = entries[column].take().filter(Enclosure::excludes_zero)?;
        let reciprocal = head.int(1) / &head;
        let others = entries.into_iter().enumerate().filter_map(|(k, x)| Some((k, x?)));
        let others: Vec<(usize, Ball)> = others.collect();
        let mut multiples = Vec::new();
        for (index, entries) in rows.iter_mut().enumerate() {
            let Some(entry) = entries.get_mut(column).and_then(Option::take) else { continue };
            let factor = entry * &reciprocal;
            for (k, other) in &others {
                let product = other.clone() * &factor;
                entries[*k] = Some(match entries[*k].take() {
                    Some(entry) => entry - product,
                    None => -product,
                });
            }
            multiples.push((index, factor));
        }
        Some(Self { row, column, reciprocal, multiples, others })
    }
}

/// The row and column of an entry that is large enough and makes few others (Markowitz 1957).
fn choose(rows: &[Vec<Option<Ball>>]) -> Option<(usize, usize)> {
    let sizes = rows.iter().enumerate().flat_map(|(i, row)| {
        let size = move |(k, x): (usize, &Option<Ball>)| {
            x.as_ref().map(|x| (i, k, Magnitude::upper(x.mid())))
        };
        row.iter().enumerate().filter_map(size)
    });
    let sizes: Vec<(usize, usize, Magnitude)> = sizes.collect();
    let column = |k: usize| sizes.iter().filter(move |entry| entry.1 == k);
    let is_large = |&&(_, k, size): &&(usize, usize, Magnitude)| {
        column(k).all(|entry| entry.2 <= size.shifted(THRESHOLD))
    };
    let made = |&&(i, k, _): &&(usize, usize, Magnitude)| {
        let in_row = sizes.iter().filter(|entry| entry.0 == i).count();
        (in_row - 1) * (column(k).count() - 1)
    };
    sizes.iter().filter(is_large).min_by_key(made).map(|&(i, k, _)| (i, k))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Dual;
    use crate::number::test_config::config;
    use proptest::prelude::*;
    use rug::{Float, Rational};

    const N: usize = 5;

    fn ball(x: i32, rad: i64) -> Ball {
        let ball = Ball::integer(x, 128);
        if rad == 0 { ball } else { ball.widened(Magnitude::power_of_two(-rad)) }
    }

    fn matrix(entries: &[i32], rad: i64) -> Vec<Dual<Ball>> {
        let row = |row: &[i32]| Dual::new(ball(0, 0), row.iter().map(|x| ball(*x, rad)).collect());
        entries.chunks(N).map(row).collect()
    }

    proptest! {
        #![proptest_config(config(400))]
        /// A product with a known vector gives that vector, from sparse matrices and from any matrix next to them.
        #[test]
        fn solutions_are_held(
            entries in prop::collection::vec(prop_oneof![Just(0), -9i32..10], N * N),
            solution in prop::collection::vec(-99i32..100, N),
            rad in prop_oneof![Just(0i64), 20i64..90], sides in prop::collection::vec(-1i32..2, N * N),
        ) {
            let Some(eliminated) = Eliminated::new(&matrix(&entries, rad)) else { return Ok(()) };
            // Some matrix in the balls, exactly.
            let step = if rad == 0 { Rational::new() } else { Rational::from(1) >> rad as u32 };
            let truth = |k: usize| Rational::from(sides[k]) * &step + entries[k];
            let right = (0..N).map(|i| {
                let sum = (0..N).map(|k| truth(N * i + k) * solution[k]).fold(Rational::new(), |a, b| a + b);
                Ball::enclosing(&sum, 128)
            });
            let found = eliminated.solve(right.collect());
            for (found, truth) in found.iter().zip(&solution) {
                prop_assert!(found.contains(&Rational::from(*truth)), "{found:?} {truth}");
            }
        }
    }

    /// Without a pivot in its place, with a singular matrix, and with one that is singular within its balls.
    #[test]
    fn only_what_is_surely_regular_is_eliminated() {
        let unit = |k: usize| i32::from(k.is_multiple_of(N + 1));
        let turned: Vec<i32> = (0..N * N).map(|k| unit((k + N) % (N * N))).collect();
        let found = Eliminated::new(&matrix(&turned, 0)).unwrap();
        let right: Vec<Ball> = (0..N).map(|k| ball(k as i32, 0)).collect();
        let first = found.solve(right)[0].mid().clone();
        assert_eq!(first, Float::with_val(32, N - 1), "the last equation has the first unknown");
        let mut entries: Vec<i32> = (0..N * N).map(unit).collect();
        assert!(Eliminated::new(&matrix(&entries, 10)).is_some());
        assert!(Eliminated::new(&matrix(&entries, 0)).is_some());
        assert!(Eliminated::new(&matrix(&entries, -1)).is_none(), "wide");
        (entries[1], entries[N], entries[N + 1]) = (2, 3, 6);
        assert!(Eliminated::new(&matrix(&entries, 60)).is_none(), "singular");
        assert!(Eliminated::new(&matrix(&entries, 0)).is_none(), "exactly singular");
        entries[N + 1] = 7;
        let found = Eliminated::new(&matrix(&entries, 60)).unwrap();
        assert!(found.solve(vec![ball(1, 0); N])[1].contains(&Rational::from(-2)));
    }
}
