//! States and assessments of arches that are proved many at a time: [`lanes`](crate::lanes) has the proofs.
//!
//! What they leave open is proved as any arch is. The digits are the same either way.

use super::assess::{Assessment, AssessmentDigits, line_fits, standing, with_thrusts};
use super::digits::{Answer, Digits, SomeDigits};
use super::enough::Enough;
use super::query::{DOUBLE_DOUBLE, Query};
use super::state::{Fall, Frictions, Outcome};
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

/// Rows of a weight that go into lanes together, each with its place.
#[derive(Debug, Default)]
pub struct LaneColumns {
    rows: Vec<usize>,
    arches: Vec<LaneArch>,
    /// Up to the last row that has one.
    thicknesses: Vec<Option<DoubleDoubleBall>>,
}

impl LaneColumns {
    /// Rows by their weights, in the order of [`SelfWeight::ALL`]: without those of which nothing is known, or whose
    /// thickness is not proved to be one.
    pub fn by_weight(all: impl Iterator<Item = Option<(SelfWeight, InLanes)>>) -> [Self; 2] {
        let mut columns = <[Self; 2]>::default();
        for (row, given) in all.enumerate() {
            let Some((weight, (arch, eta))) = given else { continue };
            if eta.as_ref().is_some_and(|eta| !is_thickness(eta)) {
                continue;
            }
            let of = &mut columns[weight as usize];
            of.rows.push(row);
            if eta.is_some() {
                of.thicknesses.resize(of.arches.len(), None);
                of.thicknesses.push(eta);
            }
            of.arches.push(arch);
        }
        columns
    }

    /// The thickness of a row, if it has one.
    fn thickness(&self, place: usize) -> Option<&DoubleDoubleBall> {
        self.thicknesses.get(place)?.as_ref()
    }
}

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
    rows: impl ExactSizeIterator<Item = Option<(SelfWeight, InLanes)>>,
    digits: usize,
    quantities: &[Quantity],
    remedies: bool,
) -> Vec<Option<RowAnswer>> {
    let wants = LaneWants::new(quantities);
    let [asks_frictions, _] = wants.frictions;
    // The friction below which an arch slides tells why it falls.
    let wants = LaneWants { frictions: [asks_frictions, !remedies], why: true, ..wants };
    let mut all = vec![None; rows.len()];
    let rows = LaneColumns::by_weight(rows);
    each_in_lanes(&rows, wants, |row, found| {
        all[row] = found.rounded(digits, quantities, remedies);
    });
    all
}

/// Outcome of an arch, with the friction of the purely sliding state if it falls.
pub type LaneOutcome = (Outcome<DoubleDoubleBall>, Option<DoubleDoubleBall>);

/// The outcomes of arches with their weights, in their order; with the frictions at which the mode of one that stands
/// changes, if they are asked for. `None` where lanes leave anything of it open.
pub fn outcomes_in_lanes(
    arches: impl ExactSizeIterator<Item = Option<(SelfWeight, LaneArch)>>,
    frictions: bool,
) -> Vec<Option<LaneOutcome>> {
    let wants = LaneWants { frictions: [frictions, true], ..LaneWants::new(&[]) };
    let mut all = vec![None; arches.len()];
    let rows = arches.map(|arch| arch.map(|(weight, arch)| (weight, (arch, None))));
    each_in_lanes(&LaneColumns::by_weight(rows), wants, |row, found| {
        all[row] = match found {
            LaneFound::Stands(state) => Some((Outcome::Stands(Box::new(state.enclosed())), None)),
            LaneFound::Falls(falling) => {
                let fall = falling.why();
                fall.map(|fall| (Outcome::Falls(fall), falling.sliding.copied()))
            }
            LaneFound::Assessment(..) => None,
        };
    });
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
    Assessment(&'a Assessment<DoubleDoubleBall>, Option<Falling<'a>>),
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
                let found = Assessment { fall, ..found.clone() }.rounded(digits, DOUBLE_DOUBLE);
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
    columns: &[LaneColumns; 2],
    wants: LaneWants,
    mut tell: impl FnMut(usize, LaneFound),
) {
    for (weight, given) in SelfWeight::ALL.into_iter().zip(columns) {
        if given.rows.is_empty() {
            continue;
        }
        let all = LaneRows::new(weight, given, wants);
        for (place, row) in given.rows.iter().enumerate() {
            all.tell(place, |found| tell(*row, found));
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
    given: &'a LaneColumns,
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
#[derive(Default)]
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
        self.found.get((*self.places.get(row)?)?)
    }
}

impl<'a> LaneRows<'a> {
    fn new(weight: SelfWeight, given: &'a LaneColumns, wants: LaneWants) -> Self {
        let lanes = Lanes::of(weight);
        let answers = lanes.states(&given.arches);
        let mut all = Self {
            weight,
            given,
            wants,
            answers,
            frictions: OfSome::default(),
            roots: OfSome::default(),
            unlimited: OfSome::default(),
        };
        if wants.why || wants.frictions.contains(&true) {
            all.frictions = OfSome::new(all.rows(Self::opening), |of| lanes.frictions(of));
        }
        let wants_of = [wants.required, wants.thrusts];
        if wants_of.contains(&true) {
            all.roots = OfSome::new(all.rows(Self::thick), |rows| lanes.roots(rows, wants_of));
            all.unlimited = OfSome::new(all.rows(Self::unlimited), |rows| lanes.states(rows));
        }
        all
    }

    /// Question to each row, if it is asked any.
    fn rows<A>(&self, of: impl Fn(&Self, usize) -> Option<A>) -> impl Iterator<Item = Option<A>> {
        (0..self.answers.len()).map(move |place| of(self, place))
    }

    /// The half opening of a row whose frictions are wanted.
    fn opening(&self, place: usize) -> Option<DoubleDoubleBall> {
        let falls = matches!(self.answers[place].as_ref()?, LaneAnswer::Falls);
        let is_wanted = match self.given.thickness(place) {
            Some(_) => self.wants.why && falls,
            None => self.wants.frictions[usize::from(falls)],
        };
        is_wanted.then_some(self.given.arches[place].0)
    }

    /// The arch of a row with its thickness.
    fn thick(&self, place: usize) -> Option<(LaneArch, DoubleDoubleBall)> {
        Some((self.given.arches[place], *self.given.thickness(place)?))
    }

    /// The arch of a row with a thickness at unlimited friction, unless its own answer says whether the thickness is
    /// enough there: one that is enough with friction is so without its limit.
    fn unlimited(&self, place: usize) -> Option<LaneArch> {
        let ((alpha, _), eta) = self.thick(place)?;
        let is_same = match &self.answers[place] {
            Some(LaneAnswer::Stands(state)) => {
                state.mode == Mode::Rotational || state.thickness.is_less_than(&eta).is_proved()
            }
            _ => false,
        };
        (!is_same).then_some((alpha, None))
    }

    /// Tells what is proved of a row; nothing if anything that is wanted of a state is open.
    fn tell(&self, place: usize, tell: impl FnOnce(LaneFound)) -> Option<()> {
        let (answer, friction) = (self.answers[place].as_ref()?, self.given.arches[place].1);
        let frictions = self.frictions.of(place);
        let falling = |sliding| Falling { friction: friction.as_ref(), sliding };
        match (self.given.thickness(place), answer) {
            (Some(eta), _) => {
                let falls = matches!(answer, LaneAnswer::Falls);
                let sliding = frictions.and_then(|both| both.sliding.as_ref());
                let assessment = self.assessment(place, answer, eta);
                tell(LaneFound::Assessment(&assessment, falls.then(|| falling(sliding))));
            }
            (None, LaneAnswer::Stands(state)) => tell(LaneFound::Stands(stands(state, frictions)?)),
            (None, LaneAnswer::Falls) => {
                let sliding = optional(frictions, |both| both.sliding.as_ref())?;
                tell(LaneFound::Falls(falling(sliding)));
            }
        }
        Some(())
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
        let (alpha, friction) = self.given.arches[place];
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
