//! A line through the arch as a chain of points.

use crate::number::{Angle, Ball, Field};

/// A line from the crown to the shoulder.
#[derive(Clone, Debug)]
pub struct Line {
    /// Angle from the crown and radius of each point, in rad and in units of `r`.
    pub points: Vec<[f64; 2]>,
}

/// Angles between two points at first.
const STEP: f64 = 0.05;
/// The largest distance of the true line from a chord, looked at in its middle, and that as a part of the thickness.
const CHORD: f64 = 5e-5;
const PART: f64 = 2e-3;
/// A chord is halved so often at most.
const HALVINGS: u32 = 12;

/// The nearest double of a ball as narrow as those here.
pub(super) fn double(x: &Ball) -> f64 {
    x.nearest_double().unwrap_or_else(|| x.mid().to_f64())
}

/// To the right and up.
pub(super) fn place([angle, radius]: [f64; 2]) -> [f64; 2] {
    [radius * angle.sin(), radius * angle.cos()]
}

impl Line {
    /// The line of a radius at each joint, down to the shoulder at `half_opening`.
    pub(super) fn new(
        [half_opening, thickness]: [&Ball; 2],
        radius: impl Fn(&Angle<Ball>) -> Ball,
    ) -> Self {
        let alpha = double(half_opening);
        let chord = CHORD.min(PART * double(thickness));
        let at = |beta: f64| {
            // The shoulder itself, not its nearest double.
            let joint = match beta == alpha {
                true => half_opening.clone(),
                false => Ball::exact(rug::Float::with_val(53, beta), half_opening.prec()),
            };
            [beta, double(&radius(&Angle::new(joint)))]
        };
        let steps = (alpha / STEP).ceil().max(8.0) as u32;
        let mut points = vec![at(0.0)];
        for k in 1..=steps {
            let end = match k == steps {
                true => alpha,
                false => alpha * f64::from(k) / f64::from(steps),
            };
            refine(&mut points, at(end), &at, (chord, HALVINGS));
        }
        Self { points }
    }

    /// Its points to the right and up.
    pub fn places(&self) -> impl DoubleEndedIterator<Item = [f64; 2]> + ExactSizeIterator + '_ {
        self.points.iter().copied().map(place)
    }
}

/// Adds the points from the last one to `end`.
fn refine(
    points: &mut Vec<[f64; 2]>,
    end: [f64; 2],
    at: &impl Fn(f64) -> [f64; 2],
    (chord, halvings): (f64, u32),
) {
    let Some(&start) = points.last() else { return };
    let middle = at((start[0] + end[0]) / 2.0);
    let [a, b, m] = [start, end, middle].map(place);
    let off = [0, 1].map(|k| m[k] - (a[k] + b[k]) / 2.0);
    if halvings > 0 && off[0].hypot(off[1]) > chord {
        refine(points, middle, at, (chord, halvings - 1));
        refine(points, end, at, (chord, halvings - 1));
    } else {
        points.push(end);
    }
}

/// The centreline.
pub(super) fn centreline(half_opening: &Ball, thickness: &Ball) -> Line {
    Line::new([half_opening, thickness], |joint| joint.rad.int(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chords_are_near_the_line() {
        let line = centreline(&Ball::integer(2, 64), &Ball::integer(1, 64));
        assert!((70..200).contains(&line.points.len()), "{}", line.points.len());
        for pair in line.points.windows(2) {
            assert!(1.0 - ((pair[1][0] - pair[0][0]) / 2.0).cos() < 1e-4);
        }
        let [x, y] = line.places().last().unwrap();
        assert_eq!([x, y], [2f64.sin(), 2f64.cos()]);
    }
}
