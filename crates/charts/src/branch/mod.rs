//! Asymmetric solutions of Eq. (19) over friction, for one half opening, `couplet.branch/1`: their nodes are rows, and
//! a picture shows them beside the least thickness.

mod picture;
mod record;

use crate::arch::SelfWeight;
use crate::arch::asymmetric::AsymmetricMode;
use crate::atlas::{Branch, Level, Meeting, NoBranch, Place, Stretch};
use crate::number::{Ball, ExactNumber, Rounded};

/// The branch of a half opening, or why there is none.
#[derive(Debug)]
pub struct BranchArch {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The half opening.
    pub half_opening: ExactNumber,
    /// The branch and the line of the least thickness, or why there is none.
    pub found: Result<(Branch, Level), NoBranch>,
}

/// Branches, one for each weight asked for.
#[derive(Debug)]
pub struct BranchArches {
    /// The half-width of a tube that was asked for.
    pub tolerance: f64,
    /// Significant digits of the points, at most.
    pub digits: usize,
    /// The branches.
    pub arches: Vec<BranchArch>,
    /// The command that makes it, for a caption.
    pub command: String,
}

impl BranchArch {
    /// Parts that are not proved.
    pub fn open(&self) -> Vec<String> {
        match &self.found {
            Ok((branch, least)) => {
                let gap = least.has_gap().then(|| "the least thickness: a gap".to_owned());
                branch.open().into_iter().chain(gap).collect()
            }
            Err(NoBranch::Undecided(open)) => vec![open.to_string()],
            Err(_) => Vec::new(),
        }
    }

    fn verdict(&self) -> &'static str {
        match &self.found {
            Err(NoBranch::Nowhere(_)) => "none",
            _ if self.open().is_empty() => "proved",
            _ => "undecided",
        }
    }
}

/// Statements of what of a branch is proved, and what is not.
const PROOF: [&str; 9] = [
    "proved, for each vertical force between the ends of a part: its equations have exactly one solution in",
    "the tube, the states are one curve from end to end, each is admissible at every joint of the whole arch,",
    "and no rate is negative: it is a solution of (19), and so is its mirror image. The ends are symmetric",
    "states. On the branch the arch has an admissible state, and also a motion in which friction takes what",
    "the weight gives; this is said of the model. Between the branch and the least thickness states are",
    "admissible too (couplet prove unique-thicker).",
    "With Milankovitch's weight the branch is all. With Heyman's it is so at the frictions that it passes, and",
    "no friction has more than two asymmetric solutions (couplet prove asymmetric-number);",
    "not proved: that with Heyman's weight there are none at frictions beyond the branch.",
];

/// Event at a point, by the parts before and behind it.
fn event(before: Option<&Stretch>, behind: Option<&Stretch>) -> &'static str {
    match (before.map(|of| of.kind), behind.map(|of| of.kind)) {
        (None, _) => "leaves the least thickness, at the friction of pure sliding",
        (_, Some(AsymmetricMode::ShoulderOpening)) => "the shoulder that slides begins to open",
        (_, Some(_)) => "the inner joint stops",
        (Some(AsymmetricMode::ShoulderOpening), None) => {
            "ends on the least thickness, where [s,r,r] meets [r,r,r]"
        }
        (_, None) => "ends on the least thickness, in [s,r,r]",
    }
}

/// The points of a branch in their order, each with what happens there.
fn events(branch: &Branch) -> Vec<(&Meeting, &'static str)> {
    let parts: Vec<&Stretch> = branch.stretches.iter().map(|(_, stretch)| stretch).collect();
    let meetings = branch.meetings().enumerate();
    meetings
        .map(|(k, meeting)| {
            let before = k.checked_sub(1).and_then(|k| parts.get(k)).copied();
            (meeting, event(before, parts.get(k).copied()))
        })
        .collect()
}

/// A quantity of a point: its name, its symbol and its value.
type PlaceQuantity = (&'static str, &'static str, Ball);

/// The quantities of a point, with the least thickness at its friction.
fn quantities(place: &Place, least: &Level) -> Vec<PlaceQuantity> {
    let at_friction = || least.at_friction_angle(place.friction_angle.as_ref()?)?.thickness;
    let or_zero = |value: &Option<Ball>| value.clone().or_else(|| Some(Ball::integer(0, 64)));
    [
        ("friction", "mu", place.friction.clone()),
        ("friction_angle", "phi, rad", place.friction_angle.clone()),
        ("thickness", "eta", place.thickness.clone()),
        ("least_thickness", "at this mu", at_friction()),
        ("thrust", "h = H/(w r)", place.thrust.clone()),
        ("vertical_force", "v", or_zero(&place.vertical_force)),
        ("crown_hinge", "b0, rad", or_zero(&place.crown_hinge)),
        ("haunch", "b1, rad", place.rotation_joint.clone()),
    ]
    .into_iter()
    .filter_map(|(name, symbol, value)| Some((name, symbol, value?)))
    .collect()
}

/// A value in as many digits as are proved, up to some.
fn rounded(value: &Ball, digits: usize) -> Option<Rounded> {
    if value.mid().is_zero() && value.rad().is_zero() {
        return Rounded::from_rational(&rug::Rational::new(), 1);
    }
    Rounded::most(value, digits)
}
