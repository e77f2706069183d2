//! The rates of least cost that fit, in doubles.

use super::programme::{Condition, Optimum, largest_last};

/// The prices of the equations, and the columns whose rates are positive.
#[derive(Clone, Debug)]
pub struct Rates {
    /// One price for each equation; the last one is the least cost.
    pub prices: [f64; 4],
    /// The columns that move.
    pub moving: Vec<usize>,
}

/// Where `costs . x` is least, for `x >= 0` and `sum x_j columns_j = (0, 0, 0, 1)`; the last entry of each column is one. Sought by its dual,
/// the largest price of the last equation for which no column is sold below its cost.
///
/// Nothing is guaranteed; `None` where nothing is found.
pub fn least_cost(columns: &[[f64; 4]], costs: &[f64]) -> Option<Rates> {
    let conditions = columns.iter().zip(costs).map(|(a, d)| Condition { a: *a, d: *d });
    match largest_last(&conditions.collect::<Vec<_>>()) {
        Optimum::At { unknowns, active } => Some(Rates {
            prices: unknowns,
            moving: active.into_iter().map(|(column, _)| column).collect(),
        }),
        Optimum::Unbounded | Optimum::Nothing => None,
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
}
