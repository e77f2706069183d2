//! Ranges over the arches of a survey: each end belongs to one of two corners.

use super::answer::{EndValue, QuantityRange, RangeEnd, SurveyedArch};
use crate::certify::state::{Answer, AssessmentDigits, Balls, Figure, Limit, measured_state};
use crate::number::ExactNumber;
use crate::problem::measures::Measures;
use crate::problem::survey::{Side, SurveyVerdict, is_one_friction, is_one_number};
use crate::problem::{Arch, Quantity};
use crate::prover::{Answered, Error, Refused, Undecided};

/// Corner of a survey with what is proved of it.
pub(super) struct Corner {
    pub(super) side: Side,
    pub(super) at: SurveyedArch,
    found: Found,
    /// Least thickness in metres, where the arch is measured and some thickness is enough.
    metres: Answered<Figure>,
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
        Ok(Self { side, at, found, metres: Ok(None) })
    }

    /// The corner with its least thickness in metres.
    pub(super) fn in_metres(self, measures: &Measures, digits: usize) -> Result<Self, Refused> {
        let is_asked = |(of, _): &(Quantity, _)| *of == Quantity::ThicknessInMetres;
        let sizes = Error::apart(measured_state(&self.at.arch, measures, digits))?;
        let metres = sizes.map(|sizes| sizes.into_iter().find(is_asked)?.1);
        Ok(Self { metres, ..self })
    }

    /// Verdict on the arch, if it has a thickness.
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
                Quantity::ThicknessInMetres => match known(&found.least_thickness)? {
                    Some(Some(_)) => self.metres.clone()?.map(Some),
                    _ if self.at.measured.is_none() => None,
                    none => none,
                },
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

    /// Tells whether a quantity is the safety from sliding of an arch with a thickness that some friction is enough
    /// for, and friction without limit.
    fn slides_never(&self, of: Quantity) -> bool {
        let is_enough = matches!(&self.found, Found::Assessment(found)
            if !matches!(found.required_friction, Ok(None)));
        of == Quantity::FrictionSafety && !self.at.arch.is_limited() && is_enough
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
    Some(together(worst.stands()?, best.stands()?))
}

/// Verdict on all of what the worst does and what the best does.
pub(super) fn together(
    worst: Result<bool, Undecided>,
    best: Result<bool, Undecided>,
) -> Result<SurveyVerdict, Undecided> {
    match (worst, best) {
        (Ok(true), _) => Ok(SurveyVerdict::AllStand),
        (_, Ok(false)) => Ok(SurveyVerdict::NoneStands),
        (Ok(false), Ok(true)) => Ok(SurveyVerdict::BothOccur),
        (Err(open), _) => Err(open.about("the arch that stands least easily")),
        (_, Err(open)) => Err(open.about("the arch that stands most easily")),
    }
}

/// Ranges of least thicknesses, required friction and safety factors, and what of it stays open: least thickness and
/// required friction are largest at the worst arch, safety factors least (of measured arches the claims `survey-worst`
/// and `survey-safety`).
pub(super) fn ranges(worst: &Corner, best: &Corner) -> (Vec<QuantityRange>, Option<Undecided>) {
    let (mut ranges, mut open) = (Vec::new(), None);
    for (of, largest_is_worst) in [
        (Quantity::LeastThickness, true),
        (Quantity::GeometricSafety, false),
        (Quantity::RequiredFriction, true),
        (Quantity::FrictionSafety, false),
        (Quantity::ThicknessInMetres, true),
    ] {
        let [first, last] = if largest_is_worst { [best, worst] } else { [worst, best] };
        let (lower, upper) = match (first.told(of), last.told(of)) {
            (Ok(Some(lower)), Ok(Some(upper))) => (lower, upper),
            (Err(why), _) | (_, Err(why)) => {
                open.get_or_insert(why.about(of.name()));
                continue;
            }
            _ => continue,
        };
        let end = |corner: &Corner, value: Option<Figure>, up| {
            let value = match value {
                Some(figure) => outward(&figure, up),
                None if corner.slides_never(of) => EndValue::Unbounded,
                None => EndValue::NotEnough,
            };
            RangeEnd::attained(value, &corner.at)
        };
        let (lower, upper) = (end(first, lower, false), end(last, upper, true));
        ranges.push(QuantityRange { of, lower, upper });
    }
    (ranges, open)
}

/// Ranges of the thrusts, where half opening and thickness are free of each other. Each state of an arch is admissible
/// in every narrower, rougher and thicker one (the claim `survey-corners`): so the range of thrusts is within that of
/// the best arch, and holds that of the worst.
pub(super) fn thrusts(worst: &Corner, best: &Corner) -> Vec<QuantityRange> {
    let mut ranges = Vec::new();
    let thrusts = [(Quantity::LeastThrust, true), (Quantity::LargestThrust, false)];
    for (of, largest_is_worst) in thrusts.into_iter().filter(|_| worst.stands() == Some(Ok(true))) {
        let [first, last] = if largest_is_worst { [best, worst] } else { [worst, best] };
        let (Some(lower), Some(upper)) = (first.thrust(of), last.thrust(of)) else { continue };
        let (lower, upper) =
            (RangeEnd::attained(lower, &first.at), RangeEnd::attained(upper, &last.at));
        ranges.push(QuantityRange { of, lower, upper });
    }
    ranges.extend(thrust_at_least_thickness(worst, best));
    ranges
}

/// Range of the thrust at the least thickness, where that is asked for: an enclosure. A state is admissible in the best
/// arch too, and there as well when that has the thickness that the worst one needs.
fn thrust_at_least_thickness(worst: &Corner, best: &Corner) -> Option<QuantityRange> {
    let (Found::State(Ok(Answer::Stands(thin))), Found::State(Ok(Answer::Stands(thick)))) =
        (&best.found, &worst.found)
    else {
        return None;
    };
    let of = Quantity::Thrust;
    if is_one_arch(&worst.at, &best.at) {
        let end = |up| RangeEnd::attained(outward(&thin.thrust, up), &best.at);
        return Some(QuantityRange { of, lower: end(false), upper: end(true) });
    }
    let needed = ExactNumber::from(&thick.thickness.decimal.upper.to_rational());
    let digits = thin.thrust.decimal.value.significant_digits().min(ENCLOSED_DIGITS);
    let [lower, upper] = enclosed_thrusts(&best.at.arch, &needed, digits)?;
    let enclosed = |value| RangeEnd { value, at: None };
    Some(QuantityRange { of, lower: enclosed(lower.0), upper: enclosed(upper.1) })
}

/// Digits of an end that only encloses: more would say nothing.
pub(super) const ENCLOSED_DIGITS: usize = 5;

/// Bounds of the least and of the largest thrust of an arch that stands.
pub(super) fn enclosed_thrusts(
    arch: &Arch,
    eta: &ExactNumber,
    digits: usize,
) -> Option<[(EndValue, EndValue); 2]> {
    let found = Balls::DoubleDoubles.assess(arch, eta, digits).ok()?;
    let [least, largest] = found.limits();
    let both = |limit: &Limit<Figure>| match &limit.thrust {
        None => (EndValue::Unbounded, EndValue::Unbounded),
        Some(figure) => (outward(figure, false), outward(figure, true)),
    };
    Some([both(least?), both(largest?)])
}

/// Tells whether two corners are one arch.
fn is_one_arch(SurveyedArch { arch: a, .. }: &SurveyedArch, b: &SurveyedArch) -> bool {
    is_one_number(a.half_opening(), b.arch.half_opening())
        && is_one_friction(a.friction(), b.arch.friction())
}
