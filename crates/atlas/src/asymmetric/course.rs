//! Probable course of the curve of one half opening, in doubles. Nothing here proves anything.

use super::super::form::CurveForm;
use super::super::law::Law;
use super::super::search;
use crate::number::Ball;

/// Steps from no vertical force up to one as large as half the weight of half the arch.
const STEPS: f64 = 512.0;

/// End of a walk along the vertical force.
pub(super) enum CourseEnd {
    /// The walk ends without a vertical force.
    Symmetric(Vec<f64>),
    /// The walk ends where an equation holds besides: with the vertical force and the unknowns next to it.
    Holds(Law, f64, Vec<f64>),
}

/// Walks from a vertical force on, up or down, until one of some equations holds; each of their left sides is
/// positive at first. `None` where no course is found.
pub(super) fn follow(
    form: &CurveForm,
    half_opening: f64,
    (from, mut x): (f64, Vec<f64>),
    rises: bool,
    until: [Law; 2],
) -> Option<CourseEnd> {
    let step = half_opening / STEPS * if rises { 1.0 } else { -1.0 };
    let number = |given: &Ball| given.mid().to_f64();
    let sides = |v: f64, x: &[f64]| until.map(|law| form.residual(law, &number, &v, x));
    let mut last: Option<(f64, [f64; 2])> = None;
    let mut v = from;
    loop {
        // The first step is short: what held at the start holds no longer.
        let next = v + if last.is_none() { step / 16.0 } else { step };
        if next <= 0.0 {
            return Some(CourseEnd::Symmetric(x));
        }
        let reached = search::point(form, next, x)?.x;
        let values = sides(next, &reached);
        if let Some((before, old)) = last {
            let part = |k: usize| old[k] / (old[k] - values[k]);
            let crossed = (0..2).filter(|k| values[*k] < 0.0);
            if let Some(k) = crossed.min_by(|a, b| part(*a).total_cmp(&part(*b))) {
                let v = before + part(k) * (next - before);
                let x = search::point(form, v, reached)?.x;
                return Some(CourseEnd::Holds(until[k], v, x));
            }
        } else if values.iter().any(|value| *value < 0.0) {
            return None;
        }
        if next > half_opening / 2.0 {
            return None;
        }
        last = Some((next, values));
        (v, x) = (next, reached);
    }
}
