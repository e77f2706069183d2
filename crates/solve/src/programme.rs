//! A linear programme in four unknowns, in doubles: the largest last unknown under many conditions.
//!
//! The dual simplex method: four conditions hold with equality, their multipliers being positive; the one that is
//! passed farthest comes in, and one goes out. It starts from bounds so large that they mean nothing.

use super::invert;

/// The unknowns with `a x <= d`.
#[derive(Clone, Copy, Debug)]
pub(super) struct HalfSpace {
    pub a: [f64; 4],
    pub d: f64,
}

/// Probable optimum of a programme.
#[derive(Clone, Debug)]
pub(super) enum Optimum {
    /// The unknowns, and the conditions that hold with equality, by index and multiplier.
    At { unknowns: [f64; 4], active: Vec<(usize, f64)> },
    /// There is no largest one.
    Unbounded,
    /// The conditions contradict each other.
    Nothing,
}

/// A bound that means nothing.
const FAR: f64 = 1e5;
const ROUNDS: usize = 2_000;
const SMALL: f64 = 1e-11;

fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The largest last unknown.
pub(super) fn largest_last(conditions: &[HalfSpace]) -> Optimum {
    let bound = |k: usize| {
        let mut a = [0.0; 4];
        a[k] = 1.0;
        (None, HalfSpace { a, d: FAR })
    };
    let mut basis: [(Option<usize>, HalfSpace); 4] = std::array::from_fn(bound);
    for _ in 0..ROUNDS {
        let Some(inverse) = invert(basis.each_ref().map(|(_, row)| row.a)) else { break };
        let d = basis.each_ref().map(|(_, row)| row.d);
        let unknowns = inverse.map(|row| dot(&row, &d));
        let multipliers = inverse[3];
        let size = 1.0 + unknowns.iter().map(|x| x.abs()).fold(0.0, f64::max);
        let passed =
            |row: &HalfSpace| (dot(&row.a, &unknowns) - row.d) / (1.0 + dot(&row.a, &row.a).sqrt());
        let worst = conditions
            .iter()
            .enumerate()
            .map(|(index, row)| (index, passed(row)))
            .fold((0, f64::MIN), |worst, next| if next.1 > worst.1 { next } else { worst });
        if worst.1 <= 1e-13 * size {
            let pairs = || basis.iter().zip(multipliers);
            if pairs().any(|((index, _), rate)| index.is_none() && rate > SMALL) {
                return Optimum::Unbounded;
            }
            let active = pairs().filter_map(|((index, _), rate)| Some(((*index)?, rate)));
            let active = active.filter(|(_, rate)| *rate > SMALL).collect();
            return Optimum::At { unknowns, active };
        }
        let row = conditions[worst.0];
        let parts: [f64; 4] =
            std::array::from_fn(|j| (0..4).map(|i| row.a[i] * inverse[i][j]).sum());
        // Bounds that nothing rests on go first, whichever side they are of.
        let idle = |j: &usize| basis[*j].0.is_none() && multipliers[*j].abs() < SMALL;
        let largest = |a: usize, b: usize| if parts[b].abs() > parts[a].abs() { b } else { a };
        let bare = (0..4).filter(idle).filter(|j| parts[*j].abs() > SMALL).reduce(largest);
        let ratio = |j: usize| multipliers[j].max(0.0) / parts[j];
        let least = |a: usize, b: usize| if ratio(b) < ratio(a) { b } else { a };
        let leaving = bare.or_else(|| (0..4).filter(|j| parts[*j] > SMALL).reduce(least));
        let Some(leaving) = leaving else { return Optimum::Nothing };
        basis[leaving] = (Some(worst.0), row);
    }
    Optimum::Nothing
}

#[cfg(test)]
mod tests {
    use super::*;

    fn condition(a: [f64; 4], d: f64) -> HalfSpace {
        HalfSpace { a, d }
    }

    #[test]
    fn a_corner_is_found() {
        // The last unknown under four planes through (1, 2, 3, 4), and some beyond.
        let mut rows = vec![
            condition([1.0, 0.0, 0.0, 1.0], 5.0),
            condition([-1.0, 1.0, 0.0, 1.0], 5.0),
            condition([0.0, -1.0, 1.0, 1.0], 5.0),
            condition([0.0, 0.0, -1.0, 1.0], 1.0),
            condition([1.0, 1.0, 1.0, 1.0], 50.0),
        ];
        let Optimum::At { unknowns, active } = largest_last(&rows) else { panic!() };
        assert!(unknowns.iter().zip([1.0, 2.0, 3.0, 4.0]).all(|(x, y)| (x - y).abs() < 1e-12));
        assert_eq!(active.len(), 4);
        rows.push(condition([0.0, 0.0, 0.0, -1.0], -5.0));
        assert!(matches!(largest_last(&rows), Optimum::Nothing));
        assert!(matches!(largest_last(&rows[..3]), Optimum::Unbounded));
    }
}
