//! Exactly one root in a box as large as the proof carries.

use super::Undecided;
use super::ladder::Unique;
use super::operator::{Equations, Operator, Scales, inverse_jacobian, largest_boxes};
use crate::arch::{Configuration, SelfWeight};
use crate::number::{Ball, DoubleBall, Magnitude};
use crate::problem::{Landmark, Problem, System};
use crate::solve::Candidate;
use rug::Float;
use rug::float::Round;
use std::sync::OnceLock;

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
    /// The root in few bits and in some more, each found when first asked for.
    pub(super) known: [OnceLock<Option<Beginning>>; 2],
}

/// A root in some bits, proved to be the isolated one: enough for few digits, and what the ladder begins with.
#[derive(Clone, Debug)]
pub(super) struct Beginning {
    pub at: Configuration<Ball>,
    pub unique: Unique,
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

    /// The middle of what is known.
    pub(super) fn middle(&self) -> Vec<Float> {
        self.image.iter().map(|x| x.mid().clone()).collect()
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
/// Scales from the whole value down to about `1e-14` of it.
const LADDER: Scales = Scales { step: 0.85, trials: 200 };

/// Proves that `candidate` lies next to the root of a landmark's system that is unique in a box around
/// it, and looks for a large such box.
pub fn isolate(
    landmark: Landmark,
    weight: SelfWeight,
    candidate: &Candidate,
) -> Result<Isolated, Undecided> {
    isolated(&Problem::Landmark { landmark, weight }, &candidate.0, BITS)
}

/// The largest box that the proof carries, in numbers of `bits` bits.
fn isolated(problem: &Problem, candidate: &[Float], bits: u32) -> Result<Isolated, Undecided> {
    isolated_where(problem, candidate, bits, |in_doubles, radii| in_doubles.image(radii).is_some())
}

/// Largest box that the proof carries, where the search begins at boxes that seem to be contracted.
fn isolated_where(
    problem: &Problem,
    candidate: &[Float],
    bits: u32,
    seems: impl Fn(&Operator<Problem, DoubleBall>, &[Magnitude]) -> bool,
) -> Result<Isolated, Undecided> {
    let centre: Vec<Float> = candidate.iter().map(|x| Float::with_val(bits, x)).collect();
    let points: Vec<Ball> = centre.iter().map(|x| Ball::exact(x.clone(), bits)).collect();
    let inverse =
        inverse_jacobian(&problem.slopes(bits, &points), bits).ok_or_else(Undecided::singular)?;
    let operator = Operator::<_, Ball>::new(problem, bits, &centre, &inverse);
    let in_doubles = Operator::<_, DoubleBall>::new(problem, bits, &centre, &inverse);
    let values: Vec<Magnitude> = centre.iter().map(Magnitude::lower).collect();
    let seems = |radii: &[Magnitude]| seems(&in_doubles, radii);
    largest_boxes(&values, LADDER, seems, |radii| operator.image(radii))
        .into_iter()
        .map(|(radii, image)| {
            let system = problem.system();
            Isolated { system, domain: operator.domain(&radii), image, known: Default::default() }
        })
        .max_by(|a, b| a.size().total_cmp(&b.size()))
        .ok_or_else(Undecided::not_alone)
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
                let isolated = isolate(landmark, weight, &candidate).unwrap();
                for (radius, unknown) in isolated.relative_radii().iter().zip(system.unknowns) {
                    assert!(*radius > 5e-3, "{landmark:?} {weight:?} {unknown:?} {radius}");
                }
            }
        }
    }

    /// The search in doubles begins next to the box that a walk down the whole ladder finds, so that both find
    /// the same.
    #[test]
    fn the_box_is_the_first_on_the_ladder() {
        for (landmark, weight) in
            Landmark::ALL.into_iter().flat_map(|l| SelfWeight::ALL.map(|w| (l, w)))
        {
            let system = landmark.system(weight);
            let candidate = newton(&system, start::landmark(landmark, weight), BITS).unwrap();
            let problem = Problem::Landmark { landmark, weight };
            let walked = isolated_where(&problem, &candidate.0, BITS, |_, _| true).unwrap();
            let found = isolate(landmark, weight, &candidate).unwrap();
            for (x, y) in walked.domain.iter().zip(&found.domain) {
                assert!(x.mid() == y.mid() && x.rad() == y.rad(), "{landmark:?} {weight:?}");
            }
            assert_eq!(walked.relative_radii(), found.relative_radii());
        }
    }

    #[test]
    fn a_point_that_is_no_root_is_not_isolated() {
        let system = Landmark::Triple.system(SelfWeight::Heyman);
        let candidate =
            newton(&system, start::landmark(Landmark::Triple, SelfWeight::Heyman), BITS).unwrap();
        let moved = candidate.0.into_iter().map(|x| x * Float::with_val(BITS, 1.2)).collect();
        assert!(isolate(Landmark::Triple, SelfWeight::Heyman, &Candidate(moved)).is_err());
    }
}
