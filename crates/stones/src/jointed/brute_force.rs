//! All solutions on a grid of thicknesses in doubles, by looking at all sets of four conditions: what the
//! enumeration is compared with.

use super::{Extent, enumerate};
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::whole::{motion_row, static_row};
use crate::arch::{Ring, SelfWeight};
use crate::number::{Angle, DoubleBall};
use crate::problem::Arch;

/// An arch in doubles, by joints of the whole arch.
struct ArchInDoubles {
    weight: SelfWeight,
    alpha: f64,
    mu: f64,
    stones: i32,
}

type ConditionRows = Vec<([f64; 4], [f64; 3])>;

impl ArchInDoubles {
    /// The rows of all conditions with their motions.
    fn rows(&self, eta: f64) -> ConditionRows {
        let (ring, grip) = (Ring::new(self.weight, &eta), Grip { shear: 1.0, normal: self.mu });
        let joints = (-self.stones..=self.stones).step_by(2);
        let at = |k: i32| Angle::new(self.alpha * f64::from(k) / f64::from(self.stones));
        let of = |joint: Angle<f64>| {
            Contact::ALL.map(|contact| {
                let [h, p, v] = static_row(contact, &joint, &ring, &grip);
                let load = contact.row(&joint, &ring, &grip).load;
                ([h, p, v, load], motion_row(contact, &joint, &eta, &0.0))
            })
        };
        joints.map(at).flat_map(of).collect()
    }
}

fn determinant<const N: usize>(mut rows: [[f64; N]; N]) -> f64 {
    let mut product = 1.0;
    for k in 0..N {
        let larger = |a: usize, b: usize| if rows[b][k].abs() > rows[a][k].abs() { b } else { a };
        let pivot = (k..N).reduce(larger).unwrap();
        if rows[pivot][k] == 0.0 {
            return 0.0;
        }
        if pivot != k {
            rows.swap(pivot, k);
            product = -product;
        }
        product *= rows[k][k];
        for i in k + 1..N {
            let part = rows[i][k] / rows[k][k];
            (k..N).for_each(|j| rows[i][j] -= part * rows[k][j]);
        }
    }
    product
}

/// Tells whether conditions are zero together at an admissible state and have rates that fit.
fn is_solution(rows: &ConditionRows, of: &[usize; 4]) -> bool {
    let triples = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]].map(|t| t.map(|k| of[k]));
    let whole = |t: &[usize; 3]| determinant(t.map(|k| [rows[k].0[0], rows[k].0[1], rows[k].0[2]]));
    let largest =
        |a: [usize; 3], b: [usize; 3]| if whole(&b).abs() > whole(&a).abs() { b } else { a };
    let best = triples.into_iter().reduce(largest).unwrap();
    let det = whole(&best);
    let state = [0, 1, 2].map(|place| {
        let replaced = best.map(|k| {
            let mut row = [rows[k].0[0], rows[k].0[1], rows[k].0[2]];
            row[place] = -rows[k].0[3];
            row
        });
        determinant(replaced) / det
    });
    let value = |row: &[f64; 4]| row[0] * state[0] + row[1] * state[1] + row[2] * state[2] + row[3];
    if det.abs() < 1e-9 || rows.iter().any(|(row, _)| value(row) > 1e-8) {
        return false;
    }
    let rate = |k: usize| {
        let rest: Vec<usize> = (0..4).filter(|i| *i != k).map(|i| of[i]).collect();
        let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * determinant([rows[rest[0]].1, rows[rest[1]].1, rows[rest[2]].1])
    };
    let rates = [0, 1, 2, 3].map(rate);
    let sum: f64 = rates.iter().sum();
    sum.abs() > 1e-9 && rates.iter().all(|rate| rate / sum > -1e-9)
}

/// All thicknesses with a solution whose four conditions are zero together, by looking at all sets of four: where
/// their determinant changes its sign on a grid.
fn by_brute_force(of: &ArchInDoubles) -> Vec<f64> {
    let grid: Vec<f64> = (1..=80).map(|k| f64::from(k) / 40.0 + 1e-4).collect();
    let rows: Vec<ConditionRows> = grid.iter().map(|eta| of.rows(*eta)).collect();
    let count = rows[0].len();
    let mut all: Vec<f64> = Vec::new();
    // Opposite slips of a joint are no motion.
    let is_idle = |four: &[usize; 4]| four.windows(2).any(|w| w[0] % 4 == 2 && w[1] == w[0] + 1);
    let mut look = |four: [usize; 4]| {
        if is_idle(&four) {
            return;
        }
        let values: Vec<f64> =
            rows.iter().map(|rows| determinant(four.map(|k| rows[k].0))).collect();
        for k in 1..grid.len() {
            let (mut low, mut high) = (grid[k - 1], grid[k]);
            if values[k - 1] * values[k] >= 0.0 || values[k].abs() < 1e-13 {
                continue;
            }
            for _ in 0..50 {
                let middle = 0.5 * (low + high);
                let rows = of.rows(middle);
                let same = determinant(four.map(|k| rows[k].0)) * values[k - 1] > 0.0;
                if same { low = middle } else { high = middle }
            }
            if is_solution(&of.rows(low), &four) && !all.iter().any(|eta| (eta - low).abs() < 1e-7)
            {
                all.push(low);
            }
        }
    };
    for i in 0..count {
        for j in i + 1..count {
            for k in j + 1..count {
                (k + 1..count).for_each(|l| look([i, j, k, l]));
            }
        }
    }
    all.sort_by(f64::total_cmp);
    all
}

/// Both ways find the same thicknesses, so many.
fn compare((weight, alpha, mu, stones, count): (&str, &str, &str, i32, usize)) {
    let arch = Arch::parse(weight, alpha, mu).unwrap();
    let of = ArchInDoubles {
        weight: arch.weight(),
        alpha: arch.half_opening().enclosure::<DoubleBall>(53).mid(),
        mu: mu.parse().unwrap(),
        stones,
    };
    let brute = by_brute_force(&of);
    let all = enumerate(&arch, stones as u64, Extent::Whole, 12).unwrap();
    assert!(all.first_open().is_none(), "{alpha} {mu}: {:?}", all.open);
    let found: Vec<f64> =
        all.solutions.into_iter().map(|solution| solution.unwrap().thickness.double).collect();
    assert_eq!([brute.len(), found.len()], [count; 2], "{alpha} {mu}: {brute:?} {found:?}");
    assert!(brute.iter().zip(&found).all(|(a, b)| (a - b).abs() < 1e-7), "{brute:?} {found:?}");
}

/// Another way, which knows neither vertices nor pieces, finds the same thicknesses: of arches with asymmetric
/// solutions; of three stones that stand at every thickness; and where the crown bears nothing.
#[test]
fn brute_force_finds_the_same() {
    for of in [
        ("milankovitch", "2.3", "1.05", 4, 2),
        ("heyman", "2.35", "1.15", 4, 2),
        ("milankovitch", "0.5", "0.7", 3, 0),
        ("heyman", "2.7", "5", 4, 1),
    ] {
        compare(of);
    }
}

/// So it does of a flat arch of an odd number of stones, whose hinges come to lie on one line.
#[test]
fn brute_force_finds_the_same_of_a_flat_arch() {
    compare(("heyman", "1.3", "3", 5, 1));
}

/// So it does at exact ties: a slip that is parallel to a joint, as the friction angle is the angle of one, and
/// conditions that are dependent at one thickness.
#[test]
fn brute_force_finds_the_same_at_exact_ties() {
    compare(("milankovitch", "pi/2", "1", 4, 1));
    compare(("heyman", "2pi/3", "1", 4, 1));
}
