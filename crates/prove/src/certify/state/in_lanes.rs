//! States and assessments of arches that are proved many at a time: [`lanes`](crate::lanes) has the proofs.
//!
//! What they leave open is proved as any arch is. The digits are the same either way.

use super::assess::{Assessment, AssessmentDigits, line_fits, standing, with_thrusts};
use super::digits::{Answer, Digits, SomeDigits};
use super::enough::Enough;
use super::query::{DOUBLE_DOUBLE, Query};
use super::state::{Fall, Frictions};
use super::thrust_range::Roots;
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::lanes::{
    FromFriction, LaneAnswer, LaneArch, LaneFrictions, LaneRoots, LaneState, Lanes,
};
use crate::number::{Angle, DoubleDoubleBall, Enclosure, Field, Ternary};
use crate::problem::{Mode, Quantity};
use crate::prover::Undecided;
use crate::prover::figure::{Figured, optional};

/// Half opening and friction of an arch, and its thickness if it has one, in enclosures.
pub type InLanes = (LaneArch, Option<DoubleDoubleBall>);

/// Answer to a row in digits: about the least thickness of an arch, or about the one that it has.
#[derive(Clone, Debug)]
pub enum RowAnswer {
    /// An arch without a thickness, with the values that are asked for.
    State(Answer<SomeDigits>),
    /// An arch with one.
    Assessment(Box<AssessmentDigits>),
}

/// The answers to arches with their weights, in their order, with these quantities to `digits` digits, at most 17;
/// `None` where lanes leave any of them open, as they do what would be enough for an arch that falls, if these remedies
/// are asked for.
pub fn answers_in_lanes(
    rows: &[Option<(SelfWeight, InLanes)>],
    digits: usize,
    quantities: &[Quantity],
    remedies: bool,
) -> Vec<Option<RowAnswer>> {
    let wants = LaneWants::new(quantities);
    let [asks_frictions, _] = wants.frictions;
    // The friction below which an arch slides tells why it falls.
    let wants = LaneWants { frictions: [asks_frictions, !remedies], why: true, ..wants };
    let mut all = vec![None; rows.len()];
    each_in_lanes(rows, wants, |row, found| all[row] = found.rounded(digits, quantities, remedies));
    all
}

/// Values of rows that are wanted beside the least thickness and what goes with it.
#[derive(Clone, Copy, Debug)]
pub(in crate::certify) struct LaneWants {
    /// True if the frictions at which the mode changes are wanted of arches that stand; and of those that fall.
    pub frictions: [bool; 2],
    /// True if it is wanted why an arch with a thickness falls whatever its thickness.
    pub why: bool,
    /// True if the required friction of a thickness is wanted.
    pub required: bool,
    /// True if the thrusts of a thickness are wanted.
    pub thrusts: bool,
}

impl LaneWants {
    /// Values that these quantities need.
    pub(in crate::certify) fn new(quantities: &[Quantity]) -> Self {
        use Quantity as Q;
        let asks = |of: &[Quantity]| quantities.iter().any(|quantity| of.contains(quantity));
        Self {
            frictions: [asks(&[Q::SlidingFriction, Q::RotationalFriction]); 2],
            why: false,
            required: asks(&[Q::RequiredFriction, Q::FrictionSafety]),
            thrusts: asks(&[Q::LeastThrust, Q::LargestThrust]),
        }
    }
}

/// A row that lanes have proved.
pub(in crate::certify) enum LaneFound<'a> {
    /// The state of an arch, with the frictions at which its mode changes if they are wanted.
    Stands(Digits<&'a DoubleDoubleBall>),
    /// No thickness is enough.
    Falls(Falling<'a>),
    /// An arch with a thickness, as far as it is wanted; and what it says where no thickness is enough.
    Assessment(Box<Assessment<DoubleDoubleBall>>, Option<Falling<'a>>),
}

/// An arch that falls whatever its thickness: its friction, and the one below which it slides, where that is known.
pub(in crate::certify) struct Falling<'a> {
    friction: Option<&'a DoubleDoubleBall>,
    pub sliding: Option<&'a DoubleDoubleBall>,
}

impl Falling<'_> {
    /// Why it falls: too little friction comes before any other reason.
    fn why(&self) -> Option<Fall> {
        let Some(mu) = self.friction else { return Some(Fall::Thickness) };
        let sliding = self.sliding?;
        match [mu.is_less_than(sliding), sliding.is_less_than(mu)].map(Ternary::is_proved) {
            [true, _] => Some(Fall::Sliding),
            [_, true] => Some(Fall::Thickness),
            _ => None,
        }
    }
}

impl LaneFound<'_> {
    /// The digits, if all of them are decided; what would be enough for an arch that falls lanes do not know.
    fn rounded(self, digits: usize, quantities: &[Quantity], remedies: bool) -> Option<RowAnswer> {
        let asks = |of: Quantity| quantities.iter().any(|asked| asked.tells(of));
        match self {
            Self::Stands(state) => {
                let some = state.some_rounded(digits, asks)?;
                Some(RowAnswer::State(Answer::Stands(some)))
            }
            Self::Falls(_) if remedies => None,
            Self::Falls(falling) => {
                let enough = |sliding: &DoubleDoubleBall| {
                    let sliding_friction = Some(sliding.figure(digits)?);
                    Some(Box::new(Enough { sliding_friction, friction: None, half_opening: None }))
                };
                let sliding = falling.sliding.filter(|_| asks(Quantity::SlidingFriction));
                let (fall, enough) = (falling.why()?, optional(sliding, enough)?);
                Some(RowAnswer::State(Answer::Falls { fall, enough }))
            }
            Self::Assessment(found, falling) => {
                let fall = optional(falling, |falling| falling.why())?;
                let found = Assessment { fall, ..*found }.rounded(digits, DOUBLE_DOUBLE);
                let is_open = |of: &Quantity| found.why_open(*of).is_some();
                let is_decided = found.stands.is_ok() && !quantities.iter().any(is_open);
                is_decided.then(|| RowAnswer::Assessment(Box::new(found)))
            }
        }
    }
}

/// Proves rows many at a time, those of a weight together, and tells what is proved of each; nothing of a row that is
/// left open.
pub(in crate::certify) fn each_in_lanes(
    rows: &[Option<(SelfWeight, InLanes)>],
    wants: LaneWants,
    mut tell: impl FnMut(usize, LaneFound),
) {
    for weight in SelfWeight::ALL {
        let is_asked = |(of, given): &(SelfWeight, InLanes)| {
            *of == weight && given.1.as_ref().is_none_or(is_thickness)
        };
        let asked = |row: &usize| rows[*row].as_ref().is_some_and(is_asked);
        let places: Vec<usize> = (0..rows.len()).filter(asked).collect();
        if places.is_empty() {
            continue;
        }
        let given: Vec<InLanes> = places.iter().filter_map(|row| Some(rows[*row]?.1)).collect();
        let all = LaneRows::new(weight, &given, wants);
        for (place, row) in places.into_iter().enumerate() {
            if let Some(found) = all.of(place) {
                tell(row, found);
            }
        }
    }
}

/// Tells whether a number is proved to be in `(0, 2)`.
fn is_thickness(eta: &DoubleDoubleBall) -> bool {
    eta.is_positive().is_proved() && eta.is_less_than(&eta.int(2)).is_proved()
}

/// Arches of a weight, some with thicknesses, and what is proved of them.
struct LaneRows<'a> {
    weight: SelfWeight,
    given: &'a [InLanes],
    wants: LaneWants,
    answers: Vec<Option<LaneAnswer>>,
    /// The frictions at which the mode changes, where they are wanted.
    frictions: OfSome<LaneFrictions>,
    /// Roots that bound what is wanted of a thickness.
    roots: OfSome<LaneRoots>,
    /// The answers at unlimited friction, where they are others and wanted.
    unlimited: OfSome<Option<LaneAnswer>>,
}

/// Answers to those rows of which something is asked: these alone take room.
struct OfSome<B> {
    places: Vec<Option<usize>>,
    found: Vec<B>,
}

impl<B> OfSome<B> {
    fn new<A>(rows: impl Iterator<Item = Option<A>>, ask: impl FnOnce(&[A]) -> Vec<B>) -> Self {
        let mut asked = Vec::new();
        let place = |row: Option<A>| {
            asked.push(row?);
            Some(asked.len() - 1)
        };
        let places = rows.map(place).collect();
        Self { places, found: if asked.is_empty() { Vec::new() } else { ask(&asked) } }
    }

    fn of(&self, row: usize) -> Option<&B> {
        self.found.get(self.places[row]?)
    }
}

impl<'a> LaneRows<'a> {
    fn new(weight: SelfWeight, given: &'a [InLanes], wants: LaneWants) -> Self {
        let lanes = Lanes::of(weight);
        let arches: Vec<LaneArch> = given.iter().map(|(arch, _)| *arch).collect();
        let answers = lanes.states(&arches);
        let rows = || given.iter().zip(&answers);
        let opening = |(((alpha, _), eta), answer): (&InLanes, &Option<LaneAnswer>)| {
            let [stand, fall] = wants.frictions;
            let is_wanted = match answer.as_ref()? {
                LaneAnswer::Stands(_) => stand,
                LaneAnswer::Falls => fall,
            };
            let is_wanted = match eta {
                Some(_) => wants.why && matches!(answer, Some(LaneAnswer::Falls)),
                None => is_wanted,
            };
            is_wanted.then_some(*alpha)
        };
        let frictions = OfSome::new(rows().map(opening), |openings| lanes.frictions(openings));
        let wants_of = [wants.required, wants.thrusts];
        let thick =
            |(arch, eta): &InLanes| Some((*arch, (*eta)?)).filter(|_| wants_of.contains(&true));
        let roots = OfSome::new(given.iter().map(thick), |rows| lanes.roots(rows, wants_of));
        // A thickness that is enough with friction is so without its limit: then the least with friction says so.
        let other = |(given, answer): (&InLanes, &Option<LaneAnswer>)| {
            let ((alpha, _), eta) = thick(given)?;
            let is_same = match answer {
                Some(LaneAnswer::Stands(state)) => {
                    state.mode == Mode::Rotational || state.thickness.is_less_than(&eta).is_proved()
                }
                _ => false,
            };
            (!is_same).then_some((alpha, None))
        };
        let unlimited = OfSome::new(rows().map(other), |arches| lanes.states(arches));
        Self { weight, given, wants, answers, frictions, roots, unlimited }
    }

    /// Row that is proved; none if anything that is wanted of a state is open.
    fn of(&self, place: usize) -> Option<LaneFound<'_>> {
        let (answer, ((_, friction), eta)) = (self.answers[place].as_ref()?, &self.given[place]);
        let frictions = self.frictions.of(place);
        let falling = |sliding| Falling { friction: friction.as_ref(), sliding };
        match (eta, answer) {
            (Some(eta), _) => {
                let falls = matches!(answer, LaneAnswer::Falls);
                let sliding = frictions.and_then(|both| both.sliding.as_ref());
                let falling = falls.then(|| falling(sliding));
                Some(LaneFound::Assessment(Box::new(self.assessment(place, answer, eta)), falling))
            }
            (None, LaneAnswer::Stands(state)) => Some(LaneFound::Stands(stands(state, frictions)?)),
            (None, LaneAnswer::Falls) => {
                let sliding = optional(frictions, |both| both.sliding.as_ref())?;
                Some(LaneFound::Falls(falling(sliding)))
            }
        }
    }

    /// The assessment of an arch with a thickness, as far as it is wanted. Exact ties stay open.
    fn assessment(
        &self,
        place: usize,
        own: &LaneAnswer,
        eta: &DoubleDoubleBall,
    ) -> Assessment<DoubleDoubleBall> {
        let found = standing(eta, Ok(least(own)));
        let Some(roots) = self.roots.of(place) else { return found };
        let unlimited = self.unlimited.of(place).unwrap_or(&self.answers[place]);
        let unlimited = unlimited.as_ref().map(least);
        let unlimited = unlimited.ok_or_else(|| Undecided::new("whether a line of thrust fits"));
        let ((alpha, friction), _) = self.given[place];
        let given = Configuration::zero(&alpha)
            .with(Unknown::HalfOpening, alpha)
            .with(Unknown::Friction, friction.unwrap_or(alpha.int(0)))
            .with(Unknown::Thickness, *eta);
        let (weight, bits, is_limited) = (self.weight, DOUBLE_DOUBLE, friction.is_some());
        let query = Query { weight, bits, given, is_limited };
        let roots = Proved { given: &query.given, roots };
        let wants = [self.wants.required, self.wants.thrusts];
        with_thrusts((found, wants), &query, &roots, [false; 2], line_fits(eta, &unlimited))
    }
}

/// A state, with the frictions at which its mode changes if they are given, if these are known.
fn stands<'a>(
    state: &'a LaneState,
    frictions: Option<&'a LaneFrictions>,
) -> Option<Digits<&'a DoubleDoubleBall>> {
    let frictions = optional(frictions, |both| {
        let rotational = match both.rotational.as_ref()? {
            FromFriction::From(friction) => Some(friction),
            FromFriction::Never => None,
        };
        Some(Frictions { sliding: both.sliding.as_ref()?, rotational })
    })?;
    Some(Digits {
        mode: state.mode,
        thickness: &state.thickness,
        thrust: &state.thrust,
        intrinsic_thrust: &state.intrinsic_thrust,
        rotation_joint: &state.rotation_joint,
        sliding_joint: state.sliding_joint.as_ref(),
        frictions,
    })
}

/// The least thickness of an arch, if there is one.
fn least(answer: &LaneAnswer) -> Option<DoubleDoubleBall> {
    match answer {
        LaneAnswer::Stands(state) => Some(state.thickness),
        LaneAnswer::Falls => None,
    }
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
