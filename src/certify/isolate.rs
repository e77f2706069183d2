//! Exactly one root in a box as large as the proof carries.

use super::Undecided;
use crate::check::krawczyk;
use crate::number::{Ball, Enclosure, Magnitude};
use crate::problem::{Point, System};
use crate::solve::{Candidate, inverse};
use rug::Float;
use rug::float::Round;

/// A root of a system, proved to exist and to be the only one in a box.
///
/// Guaranteed: the box holds exactly one root of the residuals, none of the denominators that they
/// have cleared vanishes in it, so it is the only solution of the printed equations there; and the
/// residuals are smooth on it.
#[derive(Clone, Debug)]
pub struct Isolated {
    system: System,
    domain: Vec<Ball>,
    image: Vec<Ball>,
}

impl Isolated {
    /// The system that was solved.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The box in which the root is unique, in the order of the unknowns.
    pub fn domain(&self) -> &[Ball] {
        &self.domain
    }

    /// A smaller box that holds the root.
    pub fn image(&self) -> &[Ball] {
        &self.image
    }

    /// The radii of the box relative to its centre, rounded down: the proof covers as much.
    pub fn relative_radii(&self) -> Vec<f64> {
        let ratio = |x: &Ball| {
            let (radius, centre) = (x.rad().to_float(), x.mid());
            Float::with_val_round(53, &radius / centre, Round::Zero).0.to_f64()
        };
        self.domain.iter().map(ratio).collect()
    }

    /// The geometric mean of the relative radii: the size of the box in one number.
    fn size(&self) -> f64 {
        let radii = self.relative_radii();
        (radii.iter().map(|r| r.ln()).sum::<f64>() / radii.len() as f64).exp()
    }
}

/// Precision of the isolation in bits: ample for boxes as wide as these.
const BITS: u32 = 64;
/// A box shape is tried with the scales `0.85^k`, from the whole value down to about `1e-7` of it.
const TRIALS: i32 = 100;
/// After so many changes of shape the size of the box has stopped growing.
const SHAPES: usize = 4;

/// Proves that `candidate` lies next to a root of `system` that is unique in a box around it, and
/// looks for a large such box.
///
/// The shape is first in proportion to the values. Then the radii of the image `K(X)` of the largest
/// box become the next shape: they tell how much room each unknown needs.
pub fn isolate(system: &System, candidate: &Candidate) -> Result<Isolated, Undecided> {
    let centre: Vec<Ball> =
        candidate.0.iter().map(|x| Ball::exact(Float::with_val(BITS, x), BITS)).collect();
    let preconditioner = preconditioner(system, &centre)
        .ok_or_else(|| Undecided("the Jacobian at the candidate is singular".into()))?;
    let values: Vec<Magnitude> = centre.iter().map(|x| Magnitude::lower(x.mid())).collect();
    let mut best: Option<Isolated> = None;
    let mut shape = values.clone();
    for _ in 0..SHAPES {
        let Some(found) = largest_box(system, &centre, &preconditioner, &shape, &values) else {
            break;
        };
        shape = found.image.iter().map(Ball::rad).collect();
        if best.as_ref().is_none_or(|best| best.size() < found.size()) {
            best = Some(found);
        }
    }
    best.ok_or_else(|| Undecided("no box around the candidate is mapped into itself".into()))
}

/// The largest box of the given shape, none of whose radii exceeds its value, that is mapped into
/// its interior.
fn largest_box(
    system: &System,
    centre: &[Ball],
    preconditioner: &[Vec<Ball>],
    shape: &[Magnitude],
    values: &[Magnitude],
) -> Option<Isolated> {
    let widest = shape.iter().zip(values).map(|(s, v)| s.over(*v)).max()?;
    (0..TRIALS).find_map(|trial| {
        let scale = Magnitude::upper(&Float::with_val(53, 0.85f64.powi(trial))).over(widest);
        let domain: Vec<Ball> =
            centre.iter().zip(shape).map(|(x, s)| x.clone().widened(s.times(scale))).collect();
        let point = Point::new(system, &domain);
        if !system.denominators(&point).iter().all(Enclosure::excludes_zero) {
            return None;
        }
        let image = krawczyk::unique_root(system, centre, preconditioner, &domain)?;
        Some(Isolated { system: *system, domain, image })
    })
}

/// An approximate inverse of the Jacobian at the midpoints.
fn preconditioner(system: &System, centre: &[Ball]) -> Option<Vec<Vec<Ball>>> {
    let slopes = system.residuals(&Point::new(system, centre).variables());
    let jacobian = slopes
        .iter()
        .map(|r| (0..centre.len()).map(|k| Float::with_val(BITS, r.derivative(k).mid())).collect())
        .collect();
    let exact = |row: Vec<Float>| row.into_iter().map(|y| Ball::exact(y, BITS)).collect();
    Some(inverse(jacobian)?.into_iter().map(exact).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::problem::Landmark;
    use crate::solve::{newton, start};

    #[test]
    fn every_landmark_is_isolated_in_a_macroscopic_box() {
        for landmark in Landmark::ALL {
            for weight in SelfWeight::ALL {
                let system = landmark.system(weight);
                let candidate = newton(&system, start::landmark(landmark, weight), BITS).unwrap();
                let isolated = isolate(&system, &candidate).unwrap();
                for (radius, unknown) in isolated.relative_radii().iter().zip(system.unknowns) {
                    assert!(*radius > 5e-3, "{landmark:?} {weight:?} {unknown:?} {radius}");
                }
            }
        }
    }

    #[test]
    fn a_point_that_is_no_root_is_not_isolated() {
        let system = Landmark::Triple.system(SelfWeight::Heyman);
        let candidate =
            newton(&system, start::landmark(Landmark::Triple, SelfWeight::Heyman), BITS).unwrap();
        let moved = candidate.0.into_iter().map(|x| x * Float::with_val(BITS, 1.2)).collect();
        assert!(isolate(&system, &Candidate(moved)).is_err());
    }
}
