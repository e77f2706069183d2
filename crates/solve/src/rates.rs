//! The rates of least cost that fit, in doubles.

use super::programme::{HalfSpace, Optimum, largest_last};

/// The prices of the equations, and the columns whose rates are positive.
#[derive(Clone, Debug)]
pub struct PositiveRates {
    /// One price for each equation; the last one is the least cost.
    pub prices: [f64; 4],
    /// The columns that move.
    pub moving: Vec<usize>,
}

/// Solution where `costs . x` is least, for `x >= 0` and `sum x_j columns_j = (0, 0, 0, 1)`; the last entry
/// of each column is one. Sought by its dual, the largest price of the last equation for which no column is
/// sold below its cost.
///
/// Nothing is guaranteed; `None` where nothing is found.
pub fn least_cost(columns: &[[f64; 4]], costs: &[f64]) -> Option<PositiveRates> {
    let conditions = columns.iter().zip(costs).map(|(a, d)| HalfSpace { a: *a, d: *d });
    match largest_last(&conditions.collect::<Vec<_>>()) {
        Optimum::At { unknowns, active } => Some(PositiveRates {
            prices: unknowns,
            moving: active.into_iter().map(|(column, _)| column).collect(),
        }),
        Optimum::Unbounded | Optimum::Nothing => None,
    }
}

/// The entries of a direction are of this size at most.
const FAR: f64 = 16.0;

/// A direction `y` in which every column points, `y . column > 0`, as far as possible for entries of limited size,
/// with a given last entry; `None` if none is found.
pub fn parting(columns: &[[f64; 4]], last: f64) -> Option<[f64; 4]> {
    let toward = columns.iter().map(|[a, b, c, w]| HalfSpace { a: [-a, -b, -c, 1.0], d: w * last });
    let bounds = (0..6).map(|k| {
        let mut a = [0.0; 4];
        a[k / 2] = if k % 2 == 0 { 1.0 } else { -1.0 };
        HalfSpace { a, d: FAR }
    });
    match largest_last(&toward.chain(bounds).collect::<Vec<_>>()) {
        Optimum::At { unknowns: [x, y, z, least], .. } if least > 0.0 => Some([x, y, z, last]),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cheapest_mixture_is_found() {
        let columns = [
            [1.0, 0.0, 0.0, 1.0],
            [-1.0, 0.0, 0.0, 1.0],
            [0.0, 1.0, 0.0, 1.0],
            [0.0, -1.0, 0.0, 1.0],
            [0.0, 0.0, 1.0, 1.0],
            [0.0, 0.0, -1.0, 1.0],
        ];
        let mut found = least_cost(&columns, &[3.0, 3.0, 1.0, 2.0, 2.0, 2.0]).unwrap();
        approx::assert_relative_eq!(found.prices[3], 1.5, max_relative = 1e-12);
        found.moving.sort_unstable();
        assert_eq!(found.moving, [2, 3]);
        assert!(least_cost(&columns[..1], &[1.0]).is_none(), "nothing fits");
    }

    #[test]
    fn columns_are_parted_from_zero() {
        let columns = [[1.0, 0.1, 0.0, 0.0], [-0.9, 0.2, 0.1, 0.0], [0.0, 0.3, -1.0, 0.0]];
        let y = parting(&columns, 0.0).unwrap();
        let along = |column: &[f64; 4]| column.iter().zip(y).map(|(a, b)| a * b).sum::<f64>();
        assert!(columns.iter().all(|column| along(column) > 0.0));
        let mut about = [
            [1.0, 0.0, 0.0, 0.0],
            [-1.0, 1.0, 0.0, 0.0],
            [-1.0, -1.0, 1.0, 0.0],
            [0.0, 0.0, -1.0, 0.0],
        ];
        let signs = [0.0, -1.0, 1.0];
        assert!(signs.iter().all(|last| parting(&about, *last).is_none()), "zero is among them");
        // With a fourth entry it is no more; of either sign only the same last entry helps.
        about[3][3] = 0.5;
        assert_eq!(signs.map(|last| parting(&about, last).is_some()), [false, false, true]);
        about[3][3] = -0.5;
        assert_eq!(signs.map(|last| parting(&about, last).is_some()), [false, true, false]);
    }
}
