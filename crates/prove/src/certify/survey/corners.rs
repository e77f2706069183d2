//! Ranges over half openings, frictions and thicknesses that are free of each other: each end belongs to a corner.

use super::answer::{EndValue, QuantityRange, RangeEnd, SurveyVerdict, SurveyedArch};
use crate::arch::SelfWeight;
use crate::certify::state::{Answer, AssessmentDigits, Balls, Figure};
use crate::problem::Quantity;
use crate::problem::survey::Side;
use crate::prover::{Answered, Error, Refused, Undecided};

/// Corner of a survey with what is proved of it.
pub(super) struct Corner {
    pub(super) side: Side,
    pub(super) at: SurveyedArch,
    found: Found,
}

enum Found {
    State(Result<Answer, Error>),
    Assessment(Box<AssessmentDigits>),
}

/// Value of a quantity at a corner, where there is any to tell.
type Told = Option<Option<Figure>>;

impl Corner {
    pub(super) fn new(side: Side, at: SurveyedArch, digits: usize) -> Result<Self, Refused> {
        Refused::digits(digits)?;
        let balls = Balls::DoubleDoubles;
        let found = match &at.thickness {
            None => Found::State(balls.state(&at.arch, digits, false)),
            Some(eta) => Found::Assessment(Box::new(balls.assess(&at.arch, eta, digits)?)),
        };
        Ok(Self { side, at, found })
    }

    /// Whether the arch stands, if it has a thickness.
    fn stands(&self) -> Option<Result<bool, Undecided>> {
        match &self.found {
            Found::State(_) => None,
            Found::Assessment(found) => Some(found.stands.clone()),
        }
    }

    /// Value of a quantity: `None` inside if nothing is enough.
    fn told(&self, of: Quantity) -> Result<Told, Undecided> {
        let known = |x: &Answered<Figure>| x.clone().map(Some);
        Ok(match (&self.found, of) {
            (Found::State(found), Quantity::LeastThickness) => match found {
                Ok(Answer::Stands(state)) => Some(Some(state.thickness.clone())),
                Ok(Answer::Falls { .. }) => Some(None),
                Err(Error::Undecided(open)) => return Err(open.clone()),
                Err(Error::Refused(_)) => None,
            },
            (Found::State(_), _) => None,
            (Found::Assessment(found), of) => match of {
                Quantity::LeastThickness => known(&found.least_thickness)?,
                Quantity::GeometricSafety => known(&found.geometric_safety)?,
                Quantity::RequiredFriction => known(&found.required_friction)?,
                Quantity::FrictionSafety => known(&found.friction_safety)?,
                _ => None,
            },
        })
    }

    /// End of the thrust that this corner decides.
    fn thrust(&self, of: Quantity) -> Option<EndValue> {
        let Found::Assessment(found) = &self.found else { return None };
        let limits = found.limits();
        let limit = if of == Quantity::LeastThrust { limits[0] } else { limits[1] }?;
        Some(match &limit.thrust {
            None => EndValue::Unbounded,
            Some(figure) => outward(figure, (of == Quantity::LeastThrust) == self.is_unsafe()),
        })
    }

    fn is_unsafe(&self) -> bool {
        self.side == Side::Unsafe
    }
}

/// A figure rounded up or down to its digits.
fn outward(figure: &Figure, up: bool) -> EndValue {
    let decimal = &figure.decimal;
    EndValue::Number(if up { decimal.upper.clone() } else { decimal.lower.clone() })
}

/// Verdict of two corners; `None` without a thickness.
pub(super) fn verdict(worst: &Corner, best: &Corner) -> Option<Result<SurveyVerdict, Undecided>> {
    together(worst.stands()?, best.stands()?)
}

/// Verdict on all of what the worst does and what the best does.
pub(super) fn together(
    worst: Result<bool, Undecided>,
    best: Result<bool, Undecided>,
) -> Option<Result<SurveyVerdict, Undecided>> {
    Some(match (worst, best) {
        (Ok(true), _) => Ok(SurveyVerdict::AllStand),
        (_, Ok(false)) => Ok(SurveyVerdict::NoneStands),
        (Ok(false), Ok(true)) => Ok(SurveyVerdict::BothOccur),
        (Err(open), _) => Err(open.about("the arch that stands least easily")),
        (_, Err(open)) => Err(open.about("the arch that stands most easily")),
    })
}

/// Ranges of everything whose ends two corners decide, and what of it stays open.
///
/// Least thickness and required friction are largest at the worst arch, safety factors least. The range of thrusts
/// shrinks as the half opening grows and the friction falls; with the thickness it grows for Heyman's weight, in which
/// the load has no thickness.
pub(super) fn ranges(worst: &Corner, best: &Corner) -> Vec<QuantityRange> {
    let mut ranges = Vec::new();
    for (of, largest_is_worst) in [
        (Quantity::LeastThickness, true),
        (Quantity::GeometricSafety, false),
        (Quantity::RequiredFriction, true),
        (Quantity::FrictionSafety, false),
    ] {
        let [first, last] = if largest_is_worst { [best, worst] } else { [worst, best] };
        let (Ok(Some(lower)), Ok(Some(upper))) = (first.told(of), last.told(of)) else { continue };
        let end = |corner: &Corner, value: Option<Figure>, up| {
            let value = value.map_or(EndValue::NotEnough, |figure| outward(&figure, up));
            RangeEnd::attained(value, &corner.at)
        };
        let is_unlimited = |corner: &Corner| !corner.at.arch.is_limited();
        let safety = of == Quantity::FrictionSafety;
        let no_safety = |corner: &Corner, end: RangeEnd| match safety && is_unlimited(corner) {
            true => RangeEnd { value: EndValue::Unbounded, ..end },
            false => end,
        };
        let lower = no_safety(first, end(first, lower, false));
        let upper = no_safety(last, end(last, upper, true));
        ranges.push(QuantityRange { of, lower, upper });
    }
    let same_thickness = worst.at.thickness == best.at.thickness;
    let nested = worst.at.arch.weight() == SelfWeight::Heyman || same_thickness;
    if nested && worst.stands() == Some(Ok(true)) {
        for (of, largest_is_worst) in
            [(Quantity::LeastThrust, true), (Quantity::LargestThrust, false)]
        {
            let [first, last] = if largest_is_worst { [best, worst] } else { [worst, best] };
            let (Some(lower), Some(upper)) = (first.thrust(of), last.thrust(of)) else { continue };
            ranges.push(QuantityRange {
                of,
                lower: RangeEnd::attained(lower, &first.at),
                upper: RangeEnd::attained(upper, &last.at),
            });
        }
    }
    ranges
}
