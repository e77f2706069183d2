//! The asymmetric solutions of one half opening that begin at the friction of pure sliding, from end to end.
//!
//! The branch leaves the symmetric states where the least thickness is that of pure sliding, with an inner joint
//! that slides, and is followed over the vertical force `v` in the crown. Where the left side of another closing
//! equation becomes zero the kind changes, and from there on `v` falls; it ends in a symmetric state, `v = 0`. Ends
//! and changes are points that are proved, and lie in the tubes on both their sides, so that it is one curve.
//!
//! With Milankovitch's weight it is all, by the claim `asymmetric-number`. With Heyman's it is so at the
//! frictions that it passes; **that there are none at other frictions is not proved.**

use super::super::crossing::{BITS, Crossing};
use super::super::curve::Curve;
use super::super::law::Law;
use super::super::search;
use super::super::trace::Trace;
use super::super::variable::Variable;
use super::course::{CourseEnd, follow};
use super::kind::{closed_by, over_vertical_force, symmetric};
use super::meeting::Meeting;
use super::stretch::Stretch;
use crate::arch::SelfWeight;
use crate::arch::asymmetric::AsymmetricMode;
use crate::certify::Undecided;
use crate::number::{Ball, Enclosure, ExactNumber, Ternary, says};
use crate::problem::Line;
use rug::Float;

/// Reason why there is no branch.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum NoBranch {
    /// None begins at the friction of pure sliding.
    Nowhere(&'static str),
    /// A proof fails.
    Undecided(Undecided),
}

says!(NoBranch {
    Self::Nowhere(why) => "{why}";
} from {
    Undecided => Self::Undecided;
});

/// The branch of a half opening.
#[derive(Clone, Debug)]
pub struct Branch {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The half opening.
    pub half_opening: ExactNumber,
    /// Parts of the branch, each with the point where it begins.
    pub stretches: Vec<(Meeting, Stretch)>,
    /// The symmetric state in which it ends.
    pub end: Meeting,
}

/// Half-width of the tubes in which the line of pure sliding is followed, to find where the branch begins.
const FINE: f64 = 1e-4;
/// More parts than any branch has.
const MOST: usize = 6;

const NO_SUCH: &str =
    "no least thickness of this half opening is on the line between [s,r,r] and [s,s]";
const NO_MOTION: &str =
    "at the friction of pure sliding an inner joint would have to slide outwards";

impl Branch {
    /// Follows a branch, in tubes as [`Trace::new`] has them.
    pub fn new(
        weight: SelfWeight,
        half_opening: &ExactNumber,
        tolerance: f64,
    ) -> Result<Self, NoBranch> {
        let alpha: Ball = half_opening.enclosure(BITS);
        let first = beginning(weight, &alpha)?;
        let mut kind = AsymmetricMode::InnerSliding;
        let (mut stretches, mut from, mut falls) = (Vec::new(), first, false);
        while stretches.len() < MOST {
            let to = next(kind, &alpha, &from, falls)?;
            let stretch = Stretch::between(kind, &alpha, [&from, &to], falls, tolerance)?;
            stretches.push((from, stretch));
            let Some(other) = to.other else {
                return Ok(Self { weight, half_opening: half_opening.clone(), stretches, end: to });
            };
            (kind, from, falls) = (other, to, true);
        }
        Err(Undecided::new("the branch has no end").into())
    }

    /// The pieces that are not proved, and the parts that are not proved to be admissible.
    pub fn open(&self) -> Vec<String> {
        let of = |(_, stretch): &(Meeting, Stretch)| {
            let gaps = stretch.section.pieces().filter(|piece| !piece.is_proved()).map(|piece| {
                let [from, to] = piece.range();
                format!("{}: not proved between v = {from} and {to}", stretch.kind.name())
            });
            let doubt = stretch.is_admissible().err().map(|doubt| doubt.reason.to_string());
            gaps.chain(doubt).collect::<Vec<_>>()
        };
        self.stretches.iter().flat_map(of).collect()
    }

    /// The points where it begins, where its kind changes, and where it ends.
    pub fn meetings(&self) -> impl Iterator<Item = &Meeting> {
        self.stretches.iter().map(|(from, _)| from).chain([&self.end])
    }
}

/// The symmetric state with the friction of pure sliding, if a mechanism of the first kind moves there.
fn beginning(weight: SelfWeight, alpha: &Ball) -> Result<Meeting, NoBranch> {
    let kind = AsymmetricMode::InnerSliding;
    let line = Trace::new(Curve::Line(Line::ShoulderEnd), weight, FINE)?;
    let at = Crossing::find(&line, Variable::HalfOpening, alpha)?;
    let at = at.ok_or(NoBranch::Nowhere(NO_SUCH))?;
    let thrust = at.value(Variable::Inclination).mid().to_f64().cos().powi(2);
    let eta = at.value(Variable::Thickness).mid().to_f64();
    let start = |variable: &Variable| match variable {
        Variable::CrownMoment => Float::with_val(BITS, thrust * (1.0 + eta / 2.0)),
        known => at.value(*known).mid().clone(),
    };
    let form = symmetric(kind, weight, alpha);
    let starts = form.variables().map(start).collect();
    let crossing = Crossing::proved(&form, None, starts)?;
    match crossing.residual(Law::HingesFit).is_positive() {
        Ternary::True => Ok(Meeting { crossing, other: None }),
        Ternary::False => Err(NoBranch::Nowhere(NO_MOTION)),
        Ternary::Undecided => {
            Err(Undecided::new("whether a mechanism moves at the friction of pure sliding").into())
        }
    }
}

/// The point up to which a kind goes.
fn next(
    kind: AsymmetricMode,
    alpha: &Ball,
    from: &Meeting,
    falls: bool,
) -> Result<Meeting, Undecided> {
    let weight = from.crossing.form.weight;
    let form = over_vertical_force(kind, weight, alpha);
    let double = |variable| from.crossing.value(variable).mid().to_f64();
    let start = form.unknowns.iter().map(|unknown| double(*unknown)).collect();
    let until = match kind {
        AsymmetricMode::InnerSliding => [Law::ShoulderOpens, Law::HingesFit],
        AsymmetricMode::ShoulderOpening => [Law::InnerSlides, Law::HingesFit],
        AsymmetricMode::ShoulderSliding => [Law::InnerSlides, Law::ShoulderOpens],
    };
    let start = (double(Variable::VerticalForce), start);
    let lost = || Undecided::new(format!("{}: the branch is not found any further", kind.name()));
    let number = |x: &f64| Float::with_val(BITS, *x);
    match follow(&form, alpha.mid().to_f64(), start, !falls, until).ok_or_else(lost)? {
        CourseEnd::Symmetric(x) => {
            let ends = search::point(&form, 0.0, x).ok_or_else(lost)?.x;
            let value = |variable: &Variable| form.value(*variable, &0.0, &ends).map(number);
            let form = symmetric(kind, weight, alpha);
            let starts: Option<Vec<Float>> = form.variables().map(value).collect();
            let crossing = Crossing::proved(&form, None, starts.ok_or_else(lost)?)?;
            Ok(Meeting { crossing, other: None })
        }
        CourseEnd::Holds(law, v, x) => {
            let starts = [v].iter().chain(&x).map(number).collect();
            let crossing = Crossing::proved(&form, Some(law), starts)?;
            Ok(Meeting { crossing, other: closed_by(law) })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::contour::Contour;
    use super::super::super::level::Level;
    use super::*;
    use crate::certify::CertifiedAsymmetric;
    use crate::problem::Arch;
    use AsymmetricMode::{InnerSliding as Inner, ShoulderOpening as Opening, ShoulderSliding};
    use SelfWeight::{Heyman, Milankovitch};
    use std::sync::OnceLock;

    fn branch(weight: SelfWeight, alpha: &str) -> Result<Branch, NoBranch> {
        Branch::new(weight, &alpha.parse().unwrap(), 1e-4)
    }

    /// One whose kinds are the first and the second.
    fn usual() -> &'static Branch {
        static USUAL: OnceLock<Branch> = OnceLock::new();
        USUAL.get_or_init(|| branch(Milankovitch, "2.3").unwrap())
    }

    #[test]
    fn branches_are_proved_from_end_to_end() {
        let short = branch(Milankovitch, "2.21").unwrap();
        let all = branch(Heyman, "2.25").unwrap();
        for (branch, kinds) in [
            (usual(), &[Inner, Opening][..]),
            (&short, &[Inner, ShoulderSliding]),
            (&all, &[Inner, ShoulderSliding, Opening]),
        ] {
            let found: Vec<_> = branch.stretches.iter().map(|(_, part)| part.kind).collect();
            assert_eq!(found, kinds, "{}", branch.half_opening);
            assert_eq!(branch.open(), [""; 0]);
            let pieces = branch.stretches.iter().flat_map(|(_, stretch)| stretch.section.pieces());
            assert!(pieces.filter_map(|piece| piece.width()).all(|width| width <= 1e-4));
            let symmetric: Vec<bool> = branch.meetings().map(Meeting::is_symmetric).collect();
            let inside = symmetric.len() - 1;
            assert!(symmetric[0] && symmetric[inside] && !symmetric[1..inside].contains(&true));
            assert!(branch.stretches.iter().skip(1).all(|(_, part)| part.falls()));
        }
    }

    /// At its ends the thickness is the least one, found another way, and between them it is larger.
    #[test]
    fn it_begins_and_ends_on_the_least_thickness() {
        let contour = Contour::HalfOpening(usual().half_opening.clone());
        let least = Level::new(Milankovitch, &contour, 1e-4).unwrap();
        for meeting in usual().meetings() {
            let place = meeting.place();
            let (phi, eta) = (place.friction_angle.unwrap(), place.thickness.unwrap());
            let below = least.at_friction_angle(&phi).unwrap().thickness.unwrap();
            assert!(below.rad().to_float() < 1e-30);
            assert_eq!(below.overlaps(&eta), meeting.is_symmetric());
            assert_eq!(below.is_less_than(&eta).is_proved(), !meeting.is_symmetric());
        }
    }

    /// Of one arch the solution that is proved alone is on the branch, and what is a millionth off is not.
    #[test]
    fn a_certified_solution_is_on_it() {
        for (mu, kind) in [("1.05", Inner), ("1.07", Opening)] {
            let arch = Arch::parse("milankovitch", "2.3", mu).unwrap();
            let witness = CertifiedAsymmetric::of(&arch, kind, 128).unwrap().at;
            let (_, part) = usual().stretches.iter().find(|(_, part)| part.kind == kind).unwrap();
            let v = witness.forces.vertical.mid().to_f64();
            let place = part.section.pieces().find_map(|piece| piece.place(v)).unwrap();
            let near = |x: &Option<Ball>, y: &Ball, off: f64| {
                let gap = (x.clone().unwrap() - y).mid().to_f64() - off;
                gap.abs() < 1e-7
            };
            let mu = witness.grip.normal.clone() / &witness.grip.shear;
            for (off, is_there) in [(0.0, true), (1e-6, false)] {
                assert_eq!(near(&place.thickness, &witness.thickness, off), is_there);
                assert_eq!(near(&place.friction, &mu, off), is_there);
                assert_eq!(near(&place.thrust, &witness.forces.thrust, off), is_there);
                assert_eq!(near(&place.rotation_joint, &witness.haunch.rad, off), is_there);
                assert_eq!(near(&place.crown_hinge, &witness.crown_hinge.rad, off), is_there);
            }
        }
    }

    #[test]
    fn elsewhere_there_is_none() {
        for (alpha, why) in
            [("2.1", NO_MOTION), ("pi/2", NO_MOTION), ("2.5", NO_SUCH), ("3.2", NO_SUCH)]
        {
            match branch(Milankovitch, alpha) {
                Err(NoBranch::Nowhere(reason)) => assert_eq!(reason, why, "{alpha}"),
                other => panic!("{alpha}: {other:?}"),
            }
        }
    }
}
