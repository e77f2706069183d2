//! Extremes along a course of spans and rises, by halving.
//!
//! Each step of the course has a bounding arch, at least as unsafe (on the other side: as safe) as all arches of the
//! step. The step with the most extreme bound is halved until no bound is beyond the value at one place of the course,
//! rounded outwards to a few digits: then that place attains the end.

use super::answer::{EndValue, RangeEnd, SurveyedArch};
use super::largest::Largest;
use crate::certify::state::{Outcome, assessment_enclosed, state_enclosed};
use crate::number::{Ball, Decimal, Enclosure, ExactNumber, Field, Rounded, Ternary};
use crate::problem::Quantity;
use crate::problem::survey::{Bounding, Place, Side, Survey};
use crate::prover::{Answered, Undecided};
use num_bigint::BigInt;
use rug::Float;
use rug::float::Round;
use std::collections::BinaryHeap;

/// Most digits of an end that belongs to measured spans and rises.
pub const MEASURED_DIGITS: usize = 5;
/// Most steps that are halved for one end.
const MOST_HALVINGS: usize = 4_000;
/// Bits of the values.
const BITS: u32 = 100;

/// Extreme of a quantity on one side.
pub(super) struct Extreme {
    /// Place of the most extreme value that is found.
    pub(super) place: Place,
    /// Value there; `None` if nothing is enough.
    pub(super) value: Option<Ball>,
    /// Bound of all values, rounded outwards; `None` if there is no bound.
    bound: Option<Decimal>,
    /// True if the bound is that value, rounded outwards.
    attained: bool,
    /// Verdict on the course, of a safety: whether some arch stands; on the unsafe side whether all do.
    pub(super) stands: Option<bool>,
}

/// Step of a course by the bound of its values or their negatives, not below the true one.
type Step = Largest<[Place; 2]>;

/// Most extreme value that is found: its bound, its place, and itself.
type Best = (f64, Place, Option<Ball>);

/// Search for an extreme.
struct Search<'a> {
    survey: &'a Survey,
    side: Side,
    of: Quantity,
    digits: usize,
}

impl Search<'_> {
    /// Value of an arch; `None` if nothing is enough.
    fn value(&self, of: &Bounding) -> Answered<Ball> {
        let thickness = of.thickness.as_ref().ok_or_else(Undecided::no_solution)?;
        let eta: Ball = thickness.enclosure(BITS);
        if matches!(self.of, Quantity::RequiredFriction | Quantity::FrictionSafety) {
            let Some(required) = assessment_enclosed(&of.arch, thickness, BITS).required_friction?
            else {
                return Ok(None);
            };
            return Ok(Some(match self.of {
                Quantity::RequiredFriction => required,
                _ => of.arch.given::<Ball>(BITS).friction / required,
            }));
        }
        let Outcome::Stands(state) = state_enclosed(&of.arch, BITS, false)? else {
            return Ok(None);
        };
        Ok(match self.of {
            Quantity::GeometricSafety => Some(eta / state.thickness),
            _ => self.metres(&state.thickness, eta),
        })
    }

    /// Least thickness in metres, with the circle that an arch of ratio `eta` has.
    fn metres(&self, least: &Ball, eta: Ball) -> Option<Ball> {
        let (circle, t) = self.survey.thickness_at(self.side)?;
        let t: Ball = ExactNumber::rational(t.metres().clone()).enclosure(BITS);
        // r = R + c t/2 and r = t/eta give R, and the least thickness is l R/(1 - c l/2).
        let half = eta.ratio(circle.to_centreline(), 2);
        let radius = t.clone() / eta - half.clone() * t;
        Some(least.clone() * radius / (least.int(1) - half * least))
    }

    /// True if the most extreme value is the largest: of a safety it is on the safe side, of the others on the unsafe.
    fn is_largest(&self) -> bool {
        let is_safety = matches!(self.of, Quantity::GeometricSafety | Quantity::FrictionSafety);
        is_safety == (self.side == Side::Safe)
    }

    /// Bound of a value, or of its negative: the larger, the more extreme.
    fn bound(&self, value: Option<&Ball>) -> f64 {
        match (value, self.side) {
            (None, Side::Unsafe) => f64::INFINITY,
            (None, Side::Safe) => f64::NEG_INFINITY,
            (Some(x), _) if self.is_largest() => x.upper().to_f64_round(Round::Up),
            (Some(x), _) => (-x.lower()).to_f64_round(Round::Up),
        }
    }

    /// Bound of a step; of an arch that is not proved it is none.
    fn step(&self, ends: [Place; 2]) -> Step {
        let bounding = self.survey.bounding(self.side, [&ends[0], &ends[1]]);
        let bound = match bounding.map(|bounding| self.value(&bounding)) {
            Some(Ok(value)) => self.bound(value.as_ref()),
            _ => f64::INFINITY,
        };
        Largest { size: bound, of: ends }
    }

    /// Tries the arch at a place.
    fn place(&self, place: Place, best: &mut Option<Best>) -> Result<(), Undecided> {
        let arch = self.survey.bounding(self.side, [&place, &place]);
        let value = self.value(&arch.ok_or_else(Undecided::no_solution)?)?;
        let bound = self.bound(value.as_ref());
        if best.as_ref().is_none_or(|(most, ..)| bound > *most) {
            *best = Some((bound, place, value));
        }
        Ok(())
    }

    /// A bound rounded outwards; `None` if it is no number.
    fn rounded(&self, bound: f64) -> Option<Decimal> {
        let sign = if self.is_largest() { 1.0 } else { -1.0 };
        let exact = Float::with_val(53, bound * sign).to_rational()?;
        let rounded = Rounded::from_rational(&exact, self.digits)?;
        Some(if self.is_largest() { rounded.upper } else { rounded.lower })
    }

    /// Extreme as it is known when no value is beyond `bound`.
    fn known(&self, (most, place, value): &Best, bound: f64) -> Extreme {
        let bound = bound.max(*most);
        let (own, all) = (self.rounded(*most), self.rounded(bound));
        let attained = bound == *most || own.is_some() && own == all;
        let stands = value.as_ref().map_or(Some(false), |x| match (x.int(1) - x).is_positive() {
            Ternary::True => Some(false),
            Ternary::False => Some(true),
            Ternary::Undecided => None,
        });
        let stands = match self.side {
            Side::Unsafe if stands == Some(true) => (bound <= -1.0).then_some(true),
            Side::Safe if stands == Some(false) => (bound < 1.0).then_some(false),
            _ => stands,
        };
        Extreme { place: place.clone(), value: value.clone(), bound: all, attained, stands }
    }
}

/// Extreme of a quantity along a side's course, to `digits` digits (at most [`MEASURED_DIGITS`]): a safety, a least
/// thickness in metres, or a required friction. Of a geometric safety it is also told whether all arches of the survey
/// stand, on the unsafe side, or any, on the safe side.
fn extreme(survey: &Survey, side: Side, of: Quantity, digits: usize) -> Result<Extreme, Undecided> {
    let search = Search { survey, side, of, digits: digits.min(MEASURED_DIGITS) };
    let Some(course) = survey.course(side) else { return Err(Undecided::no_solution()) };
    let mut best = None;
    for place in &course {
        search.place(place.clone(), &mut best)?;
    }
    let legs = course.windows(2).filter(|leg| leg[0] != leg[1]);
    let mut steps: BinaryHeap<Step> =
        legs.map(|leg| search.step([leg[0].clone(), leg[1].clone()])).collect();
    for _ in 0..MOST_HALVINGS {
        let (Some(top), Some(most)) = (steps.peek(), &best) else { break };
        let known = search.known(most, top.size);
        let is_decided = of != Quantity::GeometricSafety || known.stands.is_some();
        if known.attained && is_decided || most.0 == f64::INFINITY {
            break;
        }
        let Some(Largest { of: [first, last], .. }) = steps.pop() else { break };
        let middle = [0, 1].map(|k| (&first[k] + &last[k]) / BigInt::from(2));
        search.place(middle.clone(), &mut best)?;
        steps.push(search.step([first, middle.clone()]));
        steps.push(search.step([middle, last]));
    }
    let best = best.ok_or_else(Undecided::no_solution)?;
    Ok(search.known(&best, steps.peek().map_or(best.0, |top| top.size)))
}

/// Extreme of a quantity along a side's course, with the arch at its place.
pub(super) fn placed(
    survey: &Survey,
    side: Side,
    of: Quantity,
    digits: usize,
) -> Result<(Extreme, SurveyedArch), Undecided> {
    let found = extreme(survey, side, of, digits)?;
    let bounding = survey.bounding(side, [&found.place, &found.place]);
    let arch = bounding.ok_or_else(Undecided::no_solution)?;
    let arch = SurveyedArch::new(arch, survey.measured(side, &found.place));
    Ok((found, arch))
}

impl Extreme {
    /// End of a range: the value of the place, or a bound of all; undecided if there is neither.
    pub(super) fn end(&self, at: &SurveyedArch) -> Result<RangeEnd, Undecided> {
        let value = match (&self.value, &self.bound) {
            (None, _) if self.attained => EndValue::NotEnough,
            (_, Some(bound)) => EndValue::Number(bound.clone()),
            (_, None) => return Err(Undecided::new("a bound of all arches")),
        };
        Ok(RangeEnd { value, at: self.attained.then(|| at.clone()) })
    }
}
