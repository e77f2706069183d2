//! A line through the arch as a chain of points.

use super::scale::polar;
use crate::number::{Angle, Drawable};

/// A line from the crown to the shoulder.
#[derive(Clone, Debug)]
pub struct SketchedLine {
    /// Angle from the crown and offset from the centreline of each point, in rad and in thicknesses, outwards: from
    /// -1/2 at the intrados to 1/2 at the extrados.
    pub points: Vec<[f64; 2]>,
    /// The thickness, in units of `r`.
    pub thickness: f64,
}

/// Angles between two points at first.
const STEP: f64 = 0.05;
/// The largest distance of the true line from a chord, looked at in its middle, in units of `r`, and of a half
/// opening below one in units of that.
const CHORD: f64 = 1e-4;
/// The largest error of an offset that is read off between two points, in thicknesses.
const PART: f64 = 2e-3;
/// The least offset beyond a face that is one, in thicknesses: at joints that give way lines are on a face.
const BEYOND: f64 = 1e-6;
/// A chord is halved so often at most.
const HALVINGS: u32 = 12;

/// Place to the right and up.
fn place([angle, offset]: [f64; 2], thickness: f64) -> [f64; 2] {
    polar(angle, 1.0 + offset * thickness)
}

impl SketchedLine {
    /// The line of a radius at each joint, in units of `r`, down to the shoulder at `half_opening`. Between stones it
    /// is said of `joints` alone: then it is the chain through its points at these, from the crown on or from that
    /// beside a keystone, and at the shoulder.
    pub fn new<T: Drawable>(
        [half_opening, thickness]: [&T; 2],
        joints: &[f64],
        radius: impl Fn(&Angle<T>) -> T,
    ) -> Self {
        let [alpha, eta] = [half_opening, thickness].map(T::double);
        let at = |beta: f64| {
            // The shoulder itself, not its nearest double.
            let is_shoulder = beta == alpha;
            let joint =
                if is_shoulder { half_opening.clone() } else { half_opening.of_double(beta) };
            let radius = radius(&Angle::new(joint));
            [beta, ((radius - thickness.int(1)) / thickness).double()]
        };
        if !joints.is_empty() {
            let points = joints.iter().copied().chain([alpha]).map(at).collect();
            return Self { points, thickness: eta };
        }
        let within = Within { chord: CHORD * alpha.min(1.0), offset: PART };
        let steps = (alpha / STEP).ceil().max(8.0) as u32;
        let mut points = vec![at(0.0)];
        for k in 1..=steps {
            let end = match k == steps {
                true => alpha,
                false => alpha * f64::from(k) / f64::from(steps),
            };
            refine(&mut points, at(end), (&at, eta), (within, HALVINGS));
        }
        Self { points, thickness: eta }
    }

    /// The line as far as it goes without being further beyond a face than so much, in units of `r`.
    pub(super) fn within(mut self, beyond: f64) -> Self {
        let most = 0.5 + beyond / self.thickness;
        let is_far = |[_, offset]: &[f64; 2]| offset.is_nan() || offset.abs() > most;
        let far = self.points.iter().position(is_far);
        self.points.truncate(far.unwrap_or(self.points.len()));
        self
    }

    /// The parts of the line that are beyond a face, as the line is.
    pub fn outside(&self) -> impl Iterator<Item = Self> + '_ {
        let is_out = |[_, offset]: &[f64; 2]| offset.abs() > 0.5 + BEYOND;
        let parts = self.points.chunk_by(move |a, b| is_out(a) == is_out(b));
        let starts =
            parts.clone().scan(0, |at, part| Some(std::mem::replace(at, *at + part.len())));
        let face = |out: &[f64; 2], within: &[f64; 2]| {
            let edge = out[1].signum() / 2.0;
            let share = (edge - within[1]) / (out[1] - within[1]);
            [within[0] + share * (out[0] - within[0]), edge]
        };
        parts.zip(starts).filter(move |(part, _)| part.iter().all(is_out)).map(
            move |(part, start)| {
                let before = start.checked_sub(1).map(|k| face(&part[0], &self.points[k]));
                let after = self.points.get(start + part.len());
                let after = after.map(|next| face(&part[part.len() - 1], next));
                let points = before.into_iter().chain(part.iter().copied()).chain(after).collect();
                Self { points, thickness: self.thickness }
            },
        )
    }

    /// The line of the whole arch, or of the right `half`.
    pub fn across(&self, half: bool) -> Self {
        Self { points: across(self.points.iter().copied(), half), ..*self }
    }

    /// Points of the line to the right and up.
    pub fn places(
        &self,
    ) -> impl DoubleEndedIterator<Item = [f64; 2]> + ExactSizeIterator + Clone + '_ {
        self.points.iter().map(|point| place(*point, self.thickness))
    }
}

/// A chain from the crown to the right, and before it the left half, which is its mirror image, unless only `half` is
/// shown. Over a keystone it is straight.
pub fn across(
    right: impl DoubleEndedIterator<Item = [f64; 2]> + ExactSizeIterator + Clone,
    half: bool,
) -> Vec<[f64; 2]> {
    let keystone = right.clone().next().filter(|[x, _]| *x > 0.0);
    let at_crown = usize::from(keystone.is_none());
    let left = right.clone().skip(at_crown).rev().filter(|_| !half).map(|[x, y]| [-x, y]);
    let middle = keystone.filter(|_| half).map(|[_, y]| [0.0, y]);
    left.chain(middle).chain(right).collect()
}

/// Distance that a line may have from what its points say, on its way and in its offset.
#[derive(Clone, Copy)]
struct Within {
    chord: f64,
    offset: f64,
}

/// Adds the points from the last one to `end`.
fn refine(
    points: &mut Vec<[f64; 2]>,
    end: [f64; 2],
    (at, thickness): (&impl Fn(f64) -> [f64; 2], f64),
    (within, halvings): (Within, u32),
) {
    let Some(&start) = points.last() else { return };
    let middle = at((start[0] + end[0]) / 2.0);
    let [a, b, m] = [start, end, middle].map(|point| place(point, thickness));
    let off = [0, 1].map(|k| m[k] - (a[k] + b[k]) / 2.0);
    let aside = (middle[1] - (start[1] + end[1]) / 2.0).abs();
    if halvings > 0 && (off[0].hypot(off[1]) > within.chord || aside > within.offset) {
        refine(points, middle, (at, thickness), (within, halvings - 1));
        refine(points, end, (at, thickness), (within, halvings - 1));
    } else {
        points.push(end);
    }
}

/// The centreline.
pub(super) fn centreline<T: Drawable>(half_opening: &T, thickness: &T) -> SketchedLine {
    SketchedLine::new([half_opening, thickness], &[], |joint| joint.rad.int(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Ball, Field};

    /// Of a thin arch too, whose lines bend within it as much as those of any other.
    #[test]
    fn lines_have_few_points_however_thin_the_arch_is() {
        for places in [1, 3, 9, 15] {
            let tenth = Ball::integer(1, 200) / Ball::integer(10, 200);
            let thin = (0..places).fold(Ball::integer(1, 200), |thin, _| thin * &tenth);
            let alpha = thin.clone();
            let line = SketchedLine::new([&alpha, &thin], &[], |joint| {
                let share = joint.rad.clone() / &alpha;
                joint.rad.int(1) + (share.int(1) - share.clone() * share) * &thin / joint.rad.int(2)
            });
            assert!((9..200).contains(&line.points.len()), "{places}: {}", line.points.len());
        }
    }

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
