//! States and assessments of arches that are proved many at a time: [`lanes`](crate::lanes) has the proofs.
//!
//! What they leave open is proved as any arch is. The digits are the same either way.

use super::assess::{Assessment, AssessmentDigits, line_fits, standing, with_thrusts};
use super::digits::{Answer, Digits};
use super::enough::Enough;
use super::query::{DOUBLE_DOUBLE, Query};
use super::state::{Fall, Frictions};
use super::thrust_range::Roots;
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::lanes::{
    FromFriction, LaneAnswer, LaneArch, LaneFrictions, LaneRoots, LaneState, Lanes,
};
use crate::number::{Angle, DoubleDoubleBall, Enclosure, Field, Ternary};
use crate::problem::Mode;
use crate::prover::figure::{Figure, Figured, optional};
use crate::prover::{Answered, Undecided};

/// Frictions that are asked for with the states of arches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WithFrictions {
    /// No friction.
    None,
    /// Frictions at which the mode changes; of an arch that falls the one below which nothing stands.
    OfModes,
    /// Frictions at which the mode changes, and what would be enough for an arch that falls, which lanes do not
    /// know.
    AndRemedies,
}

/// The answers to arches of a weight, in their order, to `digits` digits, at most 17; `None` where lanes leave anything
/// open.
pub fn states_in_lanes(
    (weight, arches): (SelfWeight, &[LaneArch]),
    digits: usize,
    with: WithFrictions,
) -> Vec<Option<Answer>> {
    let lanes = Lanes::of(weight);
    let answers = lanes.states(arches);
    let needs = |answer: &Option<LaneAnswer>| match answer {
        Some(LaneAnswer::Stands(_)) => with != WithFrictions::None,
        Some(LaneAnswer::Falls) => with != WithFrictions::AndRemedies,
        None => false,
    };
    let asking = answers.iter().zip(arches).filter(|(answer, _)| needs(answer));
    let half_openings: Vec<_> = asking.map(|(_, (half_opening, _))| *half_opening).collect();
    let mut frictions = lanes.frictions(&half_openings).into_iter();
    let answer = |(answer, (_, friction)): (&Option<LaneAnswer>, &LaneArch)| {
        let frictions = if needs(answer) { frictions.next() } else { None };
        match answer.as_ref()? {
            LaneAnswer::Stands(state) => stands(state, frictions.as_ref(), digits),
            LaneAnswer::Falls => falls(friction.as_ref(), &frictions?, (digits, with)),
        }
    };
    answers.iter().zip(arches).map(answer).collect()
}

/// A state in digits, with the frictions at which its mode changes if they are given, if all of it is decided.
fn stands(state: &LaneState, frictions: Option<&LaneFrictions>, digits: usize) -> Option<Answer> {
    let rounded = |x: &DoubleDoubleBall| x.figure(digits);
    let frictions = optional(frictions, |both| {
        let rotational = match both.rotational.as_ref()? {
            FromFriction::From(friction) => Some(rounded(friction)?),
            FromFriction::Never => None,
        };
        Some(Frictions { sliding: rounded(both.sliding.as_ref()?)?, rotational })
    })?;
    Some(Answer::Stands(Box::new(Digits {
        mode: state.mode,
        thickness: rounded(&state.thickness)?,
        thrust: rounded(&state.thrust)?,
        intrinsic_thrust: rounded(&state.intrinsic_thrust)?,
        rotation_joint: rounded(&state.rotation_joint)?,
        sliding_joint: optional(state.sliding_joint.as_ref(), rounded)?,
        frictions,
    })))
}

/// An arch that falls, with what would be enough.
fn falls(
    friction: Option<&DoubleDoubleBall>,
    of_opening: &LaneFrictions,
    (digits, with): (usize, WithFrictions),
) -> Option<Answer> {
    let sliding = of_opening.sliding.as_ref();
    let fall = why(friction, sliding)?;
    let enough = |sliding: Figure| Enough {
        sliding_friction: Some(sliding),
        friction: None,
        half_opening: None,
    };
    let enough = match with {
        WithFrictions::None => None,
        _ => Some(Box::new(enough(sliding?.figure(digits)?))),
    };
    Some(Answer::Falls { fall, enough })
}

/// Why an arch falls that no thickness is enough for: too little friction comes before any other reason.
fn why(friction: Option<&DoubleDoubleBall>, sliding: Option<&DoubleDoubleBall>) -> Option<Fall> {
    let Some(mu) = friction else { return Some(Fall::Thickness) };
    match [mu.is_less_than(sliding?), sliding?.is_less_than(mu)].map(Ternary::is_proved) {
        [true, _] => Some(Fall::Sliding),
        [_, true] => Some(Fall::Thickness),
        _ => None,
    }
}

/// Half opening and friction of an arch, and its thickness if it has one, in enclosures.
pub type InLanes = (LaneArch, Option<DoubleDoubleBall>);

/// Tells whether a number is proved to be in `(0, 2)`.
pub(in crate::certify) fn is_thickness(eta: &DoubleDoubleBall) -> bool {
    eta.is_positive().is_proved() && eta.is_less_than(&eta.int(2)).is_proved()
}

/// All that holds for arches of a weight with thicknesses, in their order, to `digits` digits, at most 17; `None` where
/// lanes leave anything open.
pub fn assessments_in_lanes(
    (weight, given): (SelfWeight, &[(LaneArch, DoubleDoubleBall)]),
    digits: usize,
) -> Vec<Option<AssessmentDigits>> {
    let lanes = Lanes::of(weight);
    // What is no thickness is not asked about.
    let given = given.iter().map(|(arch, eta)| (*arch, Some(*eta).filter(is_thickness)));
    let given: Vec<InLanes> = given.collect();
    let answers = lanes.states(&given.iter().map(|(arch, _)| *arch).collect::<Vec<_>>());
    let all = LaneAssessments::new(lanes, (&given, &answers), [true; 2]);
    let digits = |place: usize| {
        let found = all.of(place)?;
        let fall = match &answers[place] {
            Some(LaneAnswer::Falls) => {
                let sliding = all.roots[place].sliding.as_ref().map(|[friction, _]| friction);
                Some(why(given[place].0.1.as_ref(), sliding)?)
            }
            _ => None,
        };
        let found = Assessment { fall, ..found }.rounded(digits, DOUBLE_DOUBLE);
        found.first_open().is_none().then_some(found)
    };
    (0..given.len()).map(digits).collect()
}

/// Assessments of arches with thicknesses: what they are found from.
pub(in crate::certify) struct LaneAssessments<'a> {
    weight: SelfWeight,
    given: &'a [InLanes],
    answers: &'a [Option<LaneAnswer>],
    /// True if the required friction is asked for; and the thrusts.
    wants: [bool; 2],
    roots: Vec<LaneRoots>,
    /// The answers at unlimited friction, where they are others.
    unlimited: Vec<Option<LaneAnswer>>,
}

impl<'a> LaneAssessments<'a> {
    /// From the answers to the arches, some of which may have no thickness.
    pub(in crate::certify) fn new(
        lanes: Lanes,
        (given, answers): (&'a [InLanes], &'a [Option<LaneAnswer>]),
        wants: [bool; 2],
    ) -> Self {
        let (mut roots, mut unlimited) = (Vec::new(), Vec::new());
        if wants.contains(&true) {
            let with = |(arch, eta): &InLanes| (*arch, eta.unwrap_or(DoubleDoubleBall::WHOLE));
            roots = lanes.roots(&given.iter().map(with).collect::<Vec<_>>(), wants);
            unlimited = Self::at_unlimited(lanes, (given, answers));
        }
        Self { weight: lanes.weight, given, answers, wants, roots, unlimited }
    }

    /// A thickness that is enough with friction is so without its limit: then the least with friction says so.
    fn at_unlimited(
        lanes: Lanes,
        (given, answers): (&[InLanes], &[Option<LaneAnswer>]),
    ) -> Vec<Option<LaneAnswer>> {
        let mut unlimited = answers.to_vec();
        let is_other = |place: &usize| match (&answers[*place], &given[*place]) {
            (Some(LaneAnswer::Stands(state)), (_, Some(eta))) => {
                state.mode != Mode::Rotational && !state.thickness.is_less_than(eta).is_proved()
            }
            _ => true,
        };
        let places: Vec<usize> = (0..given.len()).filter(is_other).collect();
        let arches: Vec<LaneArch> = places.iter().map(|place| (given[*place].0.0, None)).collect();
        for (place, answer) in places.iter().zip(lanes.states(&arches)) {
            unlimited[*place] = answer;
        }
        unlimited
    }

    /// The assessment of an arch, as far as it is wanted; `None` where the arch has no thickness or its state is open.
    pub(in crate::certify) fn of(&self, place: usize) -> Option<Assessment<DoubleDoubleBall>> {
        let own = least(self.answers[place].as_ref()?);
        let (arch, Some(eta)) = self.given[place] else { return None };
        let Some(roots) = self.roots.get(place) else { return Some(standing(&eta, Ok(own))) };
        let unlimited = self.unlimited[place].as_ref().map(least);
        let unlimited = unlimited.ok_or_else(|| Undecided::new("whether a line of thrust fits"));
        Some(assessed(self.weight, (arch, &eta), [Ok(own), unlimited], (roots, self.wants)))
    }
}

/// The least thickness of an arch, if there is one.
fn least(answer: &LaneAnswer) -> Option<DoubleDoubleBall> {
    match answer {
        LaneAnswer::Stands(state) => Some(state.thickness),
        LaneAnswer::Falls => None,
    }
}

/// Assessment of an arch with a thickness from what lanes have proved: the least ones with its own and with unlimited
/// friction, and roots; with the required friction and the thrusts, as they are wanted. Exact ties stay open.
fn assessed(
    weight: SelfWeight,
    ((alpha, friction), eta): (LaneArch, &DoubleDoubleBall),
    [own, unlimited]: [Answered<DoubleDoubleBall>; 2],
    (roots, wants): (&LaneRoots, [bool; 2]),
) -> Assessment<DoubleDoubleBall> {
    let given = Configuration::zero(&alpha)
        .with(Unknown::HalfOpening, alpha)
        .with(Unknown::Friction, friction.unwrap_or(alpha.int(0)))
        .with(Unknown::Thickness, *eta);
    let is_limited = friction.is_some();
    let query = Query { weight, bits: DOUBLE_DOUBLE, given, is_limited };
    let roots = Proved { given: &query.given, roots };
    with_thrusts(
        (standing(eta, own), wants),
        &query,
        &roots,
        [false; 2],
        line_fits(eta, &unlimited),
    )
}

/// Roots that lanes have proved.
struct Proved<'a> {
    given: &'a Configuration<DoubleDoubleBall>,
    roots: &'a LaneRoots,
}

/// An angle whose sine and cosine nobody asks for: nothing is known of them.
fn without_sine(rad: DoubleDoubleBall) -> Angle<DoubleDoubleBall> {
    Angle { rad, sin: DoubleDoubleBall::WHOLE, cos: DoubleDoubleBall::WHOLE }
}

impl Proved<'_> {
    fn with(
        &self,
        values: Option<[DoubleDoubleBall; 2]>,
        put: impl FnOnce(&mut Configuration<DoubleDoubleBall>, [DoubleDoubleBall; 2]),
    ) -> Result<Configuration<DoubleDoubleBall>, Undecided> {
        let values = values.ok_or_else(|| Undecided::new("whether there is a root"))?;
        let mut at = self.given.clone();
        put(&mut at, values);
        Ok(at)
    }
}

impl Roots<DoubleDoubleBall> for Proved<'_> {
    fn least(&self) -> Result<Configuration<DoubleDoubleBall>, Undecided> {
        self.with(self.roots.least, |at, [joint, thrust]| {
            (at.rotation_joint, at.thrust) = (without_sine(joint), thrust);
        })
    }

    fn largest(&self) -> Result<Configuration<DoubleDoubleBall>, Undecided> {
        self.with(self.roots.largest, |at, [joint, thrust]| {
            (at.rotation_joint, at.thrust) = (Angle::new(joint), thrust);
        })
    }

    fn sliding(&self) -> Result<Configuration<DoubleDoubleBall>, Undecided> {
        self.with(self.roots.sliding, |at, both| [at.friction, at.thrust] = both)
    }

    fn steepest(&self) -> Result<Configuration<DoubleDoubleBall>, Undecided> {
        self.with(self.roots.steepest, |at, [thrust, joint]| {
            (at.thrust, at.sliding_joint) = (thrust, without_sine(joint));
        })
    }
}
