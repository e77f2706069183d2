//! The states of all arches of a patch at once: the half openings and frictions of a rectangle, with one mode.
//!
//! Let `p` be half opening and friction, `p0` a point of the patch, `x0` a point, `S` any slopes, `Z` a box about zero
//! and `C` any matrix. With the plane `X(p) = x0 + S (p - p0)`, if
//!
//! ```text
//! K = -C F(X(p), p) + (I - C F_x(X(p) + Z, p)) Z
//! ```
//!
//! lies in the interior of `Z` for all `p` of the patch, there is for **each** of them exactly one root of the mode's
//! system in `X(p) + Z`, and it lies in `X(p) + K`: Krawczyk's test about the centre `X(p)`. The slopes are those of
//! the root at `p0`, so that `F(X(p), p)`, by the mean value about `p0`, and `K` with it are small of second order.
//!
//! Where the conditions of the mode hold on all of `X(p) + K` each root is the state of its arch: a state that is
//! admissible and the thinnest is a proof by itself.

use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::certify::state::{Certify, Outcome, State};
use crate::check::krawczyk;
use crate::number::{DoubleBall, Dual, Enclosure, Field};
use crate::problem::{Arch, Condition, Examined, Mode, System};
use crate::solve::inverse;

/// Enclosure of a variable on a patch: a plane, and how far from it the variable is at most.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    /// Half opening and friction at which the plane has its value.
    pub at: [f64; 2],
    pub value: f64,
    /// Slopes to the half opening and to the friction.
    pub slopes: [f64; 2],
    /// Difference of the variable from the plane.
    pub rest: DoubleBall,
}

/// States of the arches of a patch.
pub(super) struct Patch {
    pub mode: Mode,
    unknowns: &'static [Unknown],
    planes: Vec<Plane>,
}

/// All numbers between two, about the middle.
pub(super) fn between([first, last]: [DoubleBall; 2]) -> DoubleBall {
    let middle = DoubleBall::exact((first.mid() + last.mid()) / 2.0);
    let far = (first - middle).size().max((last - middle).size());
    DoubleBall::new(middle.mid(), far)
}

/// Number of times that a box that is not mapped into itself is widened.
const TRIALS: usize = 3;
/// Least half-width of a box: the rounding of doubles, many times.
const LEAST: f64 = 1e-13;

/// A system with ranges of half opening and friction as variables behind its unknowns.
struct Ranges {
    system: System,
    given: Configuration<DoubleBall>,
}

impl Ranges {
    fn new(weight: SelfWeight, mode: Mode, [alpha, mu]: [DoubleBall; 2]) -> Self {
        let given = Configuration::zero(&alpha)
            .with(Unknown::HalfOpening, alpha)
            .with(Unknown::Friction, mu);
        Self { system: mode.system(weight), given }
    }

    fn at(&self, x: &[DoubleBall]) -> Configuration<DoubleBall> {
        self.system.place(self.given.clone(), x)
    }

    /// The residuals on a set, with slopes to the unknowns and behind them to half opening and friction.
    fn residuals(&self, x: &[DoubleBall]) -> Vec<Dual<DoubleBall>> {
        let at = self.at(x);
        let mut variables = self.system.variables(&at);
        variables.half_opening = at.half_opening.variable(x.len());
        variables.friction = Dual::variable(at.friction, x.len() + 1);
        self.system.residuals(&variables)
    }
}

impl Patch {
    /// Proves the states of the half openings (rad) and frictions of two ranges; unlimited friction is `None`. No patch
    /// if they are not seen to have one mode.
    pub(super) fn prove(
        weight: SelfWeight,
        alpha: DoubleBall,
        mu: Option<DoubleBall>,
    ) -> Option<Self> {
        let at = [alpha.mid(), mu.map_or(0.0, |mu| mu.mid())];
        let friction = mu.map_or(f64::INFINITY, |_| at[1]);
        let arch = Arch::from_doubles(weight, at[0], friction).ok()?;
        let Ok(Outcome::Stands(state)) = arch.state_in_doubles() else { return None };
        let ranges = [alpha, mu.unwrap_or(DoubleBall::exact(0.0))];
        let (unknowns, planes) = planes(weight, &state, at, ranges)?;
        let patch = Self { mode: state.mode, unknowns, planes };
        patch.is_state(weight, ranges, mu.is_some()).then_some(patch)
    }

    /// Plane about which a variable lies, if it is one that is solved for.
    pub(super) fn plane(&self, of: Unknown) -> Option<&Plane> {
        self.planes.get(self.unknowns.iter().position(|unknown| *unknown == of)?)
    }

    /// Tells whether the conditions of the mode hold on all of the patch.
    fn is_state(&self, weight: SelfWeight, ranges: [DoubleBall; 2], is_limited: bool) -> bool {
        let x: Vec<DoubleBall> = self.planes.iter().map(|plane| plane.over(ranges)).collect();
        let at = Ranges::new(weight, self.mode, ranges).at(&x);
        let state = Examined::new(weight, self.mode, &at);
        let opening = [Condition::Above, Condition::Below].map(|side| side(Unknown::HalfOpening));
        opening
            .into_iter()
            .chain(Condition::of(self.mode, is_limited))
            .all(|condition| state.margin(condition).is_positive().is_proved())
    }
}

impl Plane {
    /// The variable over ranges of half opening and friction.
    fn over(&self, ranges: [DoubleBall; 2]) -> DoubleBall {
        self.on(ranges, DoubleBall::exact) + self.rest
    }

    /// The plane itself, in numbers that are made of doubles by `number`.
    pub(super) fn on<T: Field>(&self, at: [T; 2], number: impl Fn(f64) -> T) -> T {
        let [alpha, mu] = at;
        let first = number(self.slopes[0]) * (alpha - &number(self.at[0]));
        let second = number(self.slopes[1]) * (mu - &number(self.at[1]));
        number(self.value) + first + second
    }
}

/// Planes of the unknowns of a state's system, if Krawczyk's test proves them.
fn planes(
    weight: SelfWeight,
    state: &State<DoubleBall>,
    at: [f64; 2],
    ranges: [DoubleBall; 2],
) -> Option<(&'static [Unknown], Vec<Plane>)> {
    let point = Ranges::new(weight, state.mode, at.map(DoubleBall::exact));
    let patch = Ranges::new(weight, state.mode, ranges);
    let unknowns = point.system.unknowns;
    let value = |unknown: &Unknown| Some(DoubleBall::exact(state.value(*unknown)?.mid()));
    let centre: Vec<DoubleBall> = unknowns.iter().map(value).collect::<Option<_>>()?;
    let n = centre.len();
    let here = point.residuals(&centre);
    let jacobian = here.iter().map(|r| (0..n).map(|k| r.derivative(k).mid()).collect()).collect();
    let matrix: Vec<Vec<f64>> = inverse(jacobian)?;
    let slope = |i: usize, k: usize| -> f64 {
        -matrix[i].iter().zip(&here).map(|(y, r)| y * r.derivative(n + k).mid()).sum::<f64>()
    };
    let slopes: Vec<[f64; 2]> = (0..n).map(|i| [slope(i, 0), slope(i, 1)]).collect();
    let matrix: Vec<Vec<DoubleBall>> =
        matrix.iter().map(|row| row.iter().map(|y| DoubleBall::exact(*y)).collect()).collect();
    let offsets = [0, 1].map(|k| ranges[k] - DoubleBall::exact(at[k]));
    let plane = |i: usize| {
        let along = |k: usize| DoubleBall::exact(slopes[i][k]) * offsets[k];
        centre[i] + along(0) + along(1)
    };
    let on_plane: Vec<DoubleBall> = (0..n).map(plane).collect();
    // The mean value of F(X(p), p) about p0.
    let residuals = patch.residuals(&on_plane);
    let defect = |(r, here): (&Dual<DoubleBall>, &Dual<DoubleBall>)| {
        let along = |k: usize| {
            let by_unknowns = (0..n).map(|i| r.derivative(i) * DoubleBall::exact(slopes[i][k]));
            by_unknowns.fold(r.derivative(n + k), |sum, term| sum + term) * offsets[k]
        };
        *here.value() + along(0) + along(1)
    };
    let defects: Vec<DoubleBall> = residuals.iter().zip(&here).map(defect).collect();
    let start: Vec<DoubleBall> = matrix
        .iter()
        .map(|row| {
            let zero = DoubleBall::exact(0.0);
            -row.iter().zip(&defects).fold(zero, |sum, (y, defect)| sum + *y * *defect)
        })
        .collect();
    let rest = contracted(&patch, &on_plane, &matrix, &start)?;
    let plane = |i: usize| Plane { at, value: centre[i].mid(), slopes: slopes[i], rest: rest[i] };
    Some((unknowns, (0..n).map(plane).collect()))
}

/// `K`, if it lies in the interior of some `Z`.
fn contracted(
    patch: &Ranges,
    on_plane: &[DoubleBall],
    matrix: &[Vec<DoubleBall>],
    start: &[DoubleBall],
) -> Option<Vec<DoubleBall>> {
    let wider = |k: &DoubleBall| DoubleBall::new(0.0, 1.5 * k.size() + LEAST);
    let mut domain: Vec<DoubleBall> = start.iter().map(wider).collect();
    for _ in 0..TRIALS {
        let x: Vec<DoubleBall> = on_plane.iter().zip(&domain).map(|(x, z)| *x + *z).collect();
        let is_regular =
            patch.system.denominators(&patch.at(&x)).iter().all(Enclosure::excludes_zero);
        if !is_regular {
            return None;
        }
        let spread = krawczyk::spread(&patch.residuals(&x), matrix, &domain);
        let image: Vec<DoubleBall> = start.iter().zip(spread).map(|(k, z)| *k + z).collect();
        if krawczyk::is_contracted(&image, &domain) {
            return Some(image);
        }
        domain = image.iter().map(wider).collect();
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of `[r,s,r]`, whose domain is a sliver, none is wide enough to be of use.
    type Case = (SelfWeight, [f64; 2], Option<[f64; 2]>, &'static str);

    const ALL: [Case; 7] = [
        (SelfWeight::Heyman, [1.4, 1.41], Some([0.6, 0.7]), "[r,r,r]"),
        (SelfWeight::Milankovitch, [1.5, 1.52], Some([0.6, 0.8]), "[r,r,r]"),
        (SelfWeight::Heyman, [1.7, 1.704], Some([0.43, 0.434]), "[s,r,r]"),
        (SelfWeight::Milankovitch, [1.7, 1.704], Some([0.43, 0.434]), "[s,r,r]"),
        (SelfWeight::Heyman, [2.586, 2.5865], Some([1.776, 1.777]), "[r,r,s]"),
        (SelfWeight::Milankovitch, [2.6, 2.605], Some([4.1, 4.2]), "[r,s]"),
        (SelfWeight::Heyman, [2.7, 2.72], None, "[r]"),
    ];

    fn proved(weight: SelfWeight, alphas: [f64; 2], mu: Option<[f64; 2]>) -> Option<Patch> {
        let ball = |ends: [f64; 2]| between(ends.map(DoubleBall::exact));
        Patch::prove(weight, ball(alphas), mu.map(ball))
    }

    #[test]
    fn each_arch_of_a_patch_has_the_state_that_it_says() {
        for (weight, alphas, mus, mode) in ALL {
            let patch = proved(weight, alphas, mus).unwrap_or_else(|| panic!("{weight} {mode}"));
            let within = |[a, b]: [f64; 2], k: i32| a + (b - a) * f64::from(k) / 4.0;
            for k in 0..25 {
                let (alpha, mu) = (within(alphas, k % 5), mus.map(|mus| within(mus, k / 5)));
                let arch = Arch::from_doubles(weight, alpha, mu.unwrap_or(f64::INFINITY)).unwrap();
                let Ok(Outcome::Stands(state)) = arch.state_in_doubles() else { panic!("{arch}") };
                assert_eq!([state.mode, patch.mode].map(|of| of.to_string()), [mode; 2], "{arch}");
                let at = [alpha, mu.unwrap_or(0.0)].map(DoubleBall::exact);
                for unknown in patch.unknowns {
                    let plane = patch.plane(*unknown).unwrap().over(at);
                    assert!(plane.overlaps(state.value(*unknown).unwrap()), "{arch} {unknown:?}");
                }
            }
        }
    }

    /// Half as wide a patch lies a quarter as far from its plane.
    #[test]
    fn what_a_plane_leaves_is_of_second_order() {
        for (weight, [a, _], mus, mode) in ALL {
            let rest = |h: f64| {
                let patch = proved(weight, [a, a + h], mus.map(|[c, _]| [c, c + h]));
                let patch = patch.unwrap_or_else(|| panic!("{weight} {mode} {h}"));
                patch.plane(Unknown::Thickness).unwrap().rest.size()
            };
            let [wide, narrow] = [2e-4, 1e-4].map(rest);
            assert!(narrow > 0.0 && narrow < 0.3 * wide, "{weight} {mode}: {wide} {narrow}");
        }
    }

    #[test]
    fn a_patch_with_two_modes_is_none() {
        for (alphas, mus) in [
            ([1.5, 1.53], [0.34, 0.42]),
            ([2.55, 2.58], [1.7, 1.9]),
            ([2.6, 2.64], [2.4, 2.5]),
            ([1.5, 1.52], [0.1, 0.2]),
        ] {
            assert!(proved(SelfWeight::Heyman, alphas, Some(mus)).is_none(), "{alphas:?}");
        }
    }
}
