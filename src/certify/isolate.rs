//! Exactly one root in a box as large as the proof carries.

use super::{Undecided, krawczyk};
use crate::arch::{Point, System};
use crate::number::{Ball, Enclosure, Field, Magnitude};
use crate::solve::{Candidate, inverse};
use rug::Float;

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
    relative_radius: f64,
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

    /// The radius of the box, in units of each unknown: the box reaches from `x (1 - r)` to
    /// `x (1 + r)`. For display only.
    pub fn relative_radius(&self) -> f64 {
        self.relative_radius
    }
}

/// Precision of the isolation in bits: ample for boxes as wide as these.
const BITS: u32 = 128;
/// The box is tried with a relative radius of `(7/8)^k`, from `k = 0` down to about `1e-9`.
const TRIALS: i32 = 160;

/// Proves that `candidate` lies next to a root of `system` that is unique in a box around it, and
/// finds the largest box (all unknowns in proportion to their values) for which that succeeds.
pub fn isolate(system: &System, candidate: &Candidate) -> Result<Isolated, Undecided> {
    let centre: Vec<Ball> =
        candidate.0.iter().map(|x| Ball::exact(Float::with_val(BITS, x), BITS)).collect();
    let preconditioner = preconditioner(system, &centre)
        .ok_or_else(|| Undecided("the Jacobian at the candidate is singular".into()))?;
    for trial in 0..TRIALS {
        let relative_radius = 0.875f64.powi(trial);
        let scale = Magnitude::lower(&Float::with_val(53, relative_radius));
        let domain: Vec<Ball> = centre
            .iter()
            .map(|x| x.clone().widened(Magnitude::lower(x.mid()).times_down(scale)))
            .collect();
        if !denominators_exclude_zero(system, &domain) {
            continue;
        }
        if let Some(image) = krawczyk::unique_root(system, &centre, &preconditioner, &domain) {
            return Ok(Isolated { system: *system, domain, image, relative_radius });
        }
    }
    Err(Undecided("no box around the candidate is mapped into itself".into()))
}

/// An approximate inverse of the Jacobian at the midpoints.
fn preconditioner(system: &System, centre: &[Ball]) -> Option<Vec<Vec<Ball>>> {
    let slopes = system.residuals(&Point::new(system, centre).variables());
    let jacobian = slopes
        .iter()
        .map(|r| (0..centre.len()).map(|k| Float::with_val(BITS, r.derivative(k).mid())).collect())
        .collect();
    let inverse = inverse(jacobian)?;
    Some(inverse.into_iter().map(|row| row.into_iter().map(|y| Ball::exact(y, BITS)).collect()).collect())
}

fn denominators_exclude_zero(system: &System, domain: &[Ball]) -> bool {
    system.denominators(&Point::new(system, domain)).iter().all(Enclosure::excludes_zero)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::{Landmark, SelfWeight};
    use crate::solve::{newton, start};

    #[test]
    fn every_landmark_is_isolated_in_a_macroscopic_box() {
        for landmark in Landmark::ALL {
            for weight in SelfWeight::ALL {
                let system = landmark.system(weight);
                let candidate = newton(&system, start(landmark, weight), BITS).unwrap();
                let isolated = isolate(&system, &candidate).unwrap();
                println!("{landmark:?} {weight:?} {:.1e}", isolated.relative_radius());
                assert!(isolated.relative_radius() > 1e-3, "{landmark:?} {weight:?}");
            }
        }
    }

    #[test]
    fn a_point_that_is_no_root_is_not_isolated() {
        let system = Landmark::Triple.system(SelfWeight::Heyman);
        let candidate = newton(&system, start(Landmark::Triple, SelfWeight::Heyman), BITS).unwrap();
        let moved = candidate.0.into_iter().map(|x| x * Float::with_val(BITS, 1.01)).collect();
        assert!(isolate(&system, &Candidate(moved)).is_err());
    }
}
