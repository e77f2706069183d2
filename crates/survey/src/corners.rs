//! Ranges over the arches of a survey: each end belongs to one of two corners.

use super::answer::{
    ENCLOSED_DIGITS, EndValue, ModesFound, QuantityRange, RangeEnd, SurveyAnswer, SurveyedArch,
};
use crate::certify::state::{
    Answer, AssessmentDigits, Balls, Certify, Figure, Limit, least_in_metres,
};
use crate::number::ExactNumber;
use crate::problem::measures::Measures;
use crate::problem::stones::Stones;
use crate::problem::survey::{SurveyVerdict, is_one_friction, is_one_number};
use crate::problem::{Arch, Quantity};
use crate::prover::{Answered, Error, Refused, Undecided};
use couplet_stones::{
    VoussoirAssessment, VoussoirStanding, Voussoirs, assess_voussoirs, voussoirs,
};

/// Corner of a survey with what is proved of it.
pub(super) struct Corner {
    pub(super) at: SurveyedArch,
    found: CornerAnswer,
    /// Least thickness in metres, where the arch is measured and some thickness is enough.
    metres: Answered<Figure>,
}

enum CornerAnswer {
    State(Result<Answer, Undecided>),
    Assessment(Box<AssessmentDigits>),
    Stones(Result<Voussoirs, Undecided>, Option<Box<VoussoirAssessment>>),
}

/// Value of a quantity at a corner.
enum Told {
    Value(Figure),
    /// Statement in place of a number.
    Without(EndValue),
}

impl Corner {
    pub(super) fn new(at: SurveyedArch, digits: usize) -> Result<Self, Refused> {
        Refused::digits(digits)?;
        let state = || Error::apart(Balls::DoubleDoubles.state(&at.arch, digits, false));
        let found = match &at.thickness {
            None => CornerAnswer::State(state()?),
            Some(eta) => {
                CornerAnswer::Assessment(Box::new(at.arch.certify_thickness(eta, digits)?))
            }
        };
        Ok(Self { at, found, metres: Ok(None) })
    }

    /// The corner with its least thickness in metres.
    pub(super) fn in_metres(self, measures: &Measures, digits: usize) -> Result<Self, Refused> {
        let metres = Error::apart(least_in_metres(&self.at.arch, measures, digits))?;
        Ok(Self { metres, ..self })
    }

    /// Corner of arches of stones.
    pub(super) fn of_stones(
        at: SurveyedArch,
        stones: &Stones,
        digits: usize,
    ) -> Result<Self, Refused> {
        let (weight, friction) = (at.arch.weight(), at.arch.friction());
        let least = Error::apart(voussoirs(stones, weight, friction, digits))?;
        let assess = |eta| assess_voussoirs(stones, weight, friction, eta, digits).map(Box::new);
        let given = at.thickness.as_ref().map(assess).transpose()?;
        Ok(Self { at, found: CornerAnswer::Stones(least, given), metres: Ok(None) })
    }

    /// Verdict on the arch, if it has a thickness.
    fn stands(&self) -> Option<Result<bool, Undecided>> {
        match &self.found {
            CornerAnswer::State(_) | CornerAnswer::Stones(_, None) => None,
            CornerAnswer::Assessment(found) => Some(found.stands.clone()),
            CornerAnswer::Stones(_, Some(found)) => {
                let stands = |of: &VoussoirStanding| matches!(of, VoussoirStanding::Stands(_));
                Some(found.standing.as_ref().map(stands).map_err(Clone::clone))
            }
        }
    }

    /// Value of a quantity, where there is any to tell.
    fn told(&self, of: Quantity) -> Result<Option<Told>, Undecided> {
        match (&self.found, of) {
            (_, Quantity::LeastThrust | Quantity::LargestThrust) => Ok(self.thrust(of)),
            (CornerAnswer::State(found), Quantity::LeastThickness) => match found {
                Ok(Answer::Stands(state)) => Ok(Some(Told::Value(state.thickness.clone()))),
                Ok(Answer::Falls { .. }) => Ok(Some(Told::Without(EndValue::NotEnough))),
                Err(open) => Err(open.clone()),
            },
            (CornerAnswer::State(_), _) => Ok(None),
            (CornerAnswer::Assessment(found), of) => {
                let slides_never =
                    !self.at.arch.is_limited() && !matches!(found.required_friction, Ok(None));
                match of {
                    Quantity::LeastThickness => answered(&found.least_thickness, false),
                    Quantity::ThicknessInMetres if self.at.measured.is_some() => {
                        match found.least_thickness.clone()? {
                            Some(_) => Ok(self.metres.clone()?.map(Told::Value)),
                            None => Ok(Some(Told::Without(EndValue::NotEnough))),
                        }
                    }
                    Quantity::GeometricSafety => answered(&found.geometric_safety, false),
                    Quantity::RequiredFriction => answered(&found.required_friction, false),
                    Quantity::FrictionSafety => answered(&found.friction_safety, slides_never),
                    _ => Ok(None),
                }
            }
            (CornerAnswer::Stones(least, _), Quantity::LeastThickness) => {
                Ok(Some(match least.clone()? {
                    Voussoirs::Stands(state) => Told::Value(state.thickness),
                    Voussoirs::AnyThickness => Told::Without(EndValue::AnyIsEnough),
                    Voussoirs::Slides | Voussoirs::TooThick => Told::Without(EndValue::NotEnough),
                }))
            }
            (CornerAnswer::Stones(_, None), _) => Ok(None),
            (CornerAnswer::Stones(least, Some(found)), of) => {
                let any = matches!(least, Ok(Voussoirs::AnyThickness));
                let slides_never = matches!(found.required_friction, Ok(Some(_)));
                match of {
                    Quantity::GeometricSafety => answered(&found.geometric_safety, any),
                    Quantity::RequiredFriction => answered(&found.required_friction, false),
                    Quantity::FrictionSafety => answered(&found.friction_safety, slides_never),
                    _ => Ok(None),
                }
            }
        }
    }

    /// The least or the largest admissible thrust.
    fn thrust(&self, of: Quantity) -> Option<Told> {
        let thrusts = match &self.found {
            CornerAnswer::Assessment(found) => {
                found.limits().map(|limit| limit.map(|limit| limit.thrust.as_ref()))
            }
            CornerAnswer::Stones(_, Some(found)) => match &found.standing {
                Ok(VoussoirStanding::Stands(ends)) => {
                    ends.each_ref().map(|end| Some(end.thrust.as_ref()))
                }
                _ => return None,
            },
            _ => return None,
        };
        let thrust = if of == Quantity::LeastThrust { thrusts[0] } else { thrusts[1] }?;
        match thrust {
            // Where all joints are beyond a right angle no thrust is too small: that is no number to tell.
            None if of == Quantity::LeastThrust => None,
            None => Some(Told::Without(EndValue::Unbounded)),
            Some(figure) => Some(Told::Value(figure.clone())),
        }
    }
}

/// Value of a quantity: where it has none it is `unbounded`, or nothing is enough.
fn answered(found: &Answered<Figure>, unbounded: bool) -> Result<Option<Told>, Undecided> {
    let none = if unbounded { EndValue::Unbounded } else { EndValue::NotEnough };
    Ok(Some(found.clone()?.map_or(Told::Without(none), Told::Value)))
}

/// A figure rounded up or down to its digits.
pub(super) fn outward(figure: &Figure, up: bool) -> EndValue {
    let decimal = &figure.decimal;
    EndValue::Number(if up { decimal.upper.clone() } else { decimal.lower.clone() })
}

/// Answer of two corners.
pub(super) fn answer(worst: Corner, best: Corner, modes: Option<ModesFound>) -> SurveyAnswer {
    let (verdict, (mut ranges, open)) = (verdict(&worst, &best), ranges(&worst, &best));
    ranges.extend(thrust_at_least_thickness(&worst, &best, modes.as_ref()));
    SurveyAnswer { verdict, worst: worst.at, best: best.at, ranges, open, modes }
}

/// Verdict of two corners; `None` without a thickness.
fn verdict(worst: &Corner, best: &Corner) -> Option<Result<SurveyVerdict, Undecided>> {
    Some(match (worst.stands()?, best.stands()?) {
        (Ok(true), _) => Ok(SurveyVerdict::AllStand),
        (_, Ok(false)) => Ok(SurveyVerdict::NoneStands),
        (Ok(false), Ok(true)) => Ok(SurveyVerdict::BothOccur),
        (Err(open), _) => Err(open.about("the arch that stands least easily")),
        (_, Err(open)) => Err(open.about("the arch that stands most easily")),
    })
}

/// Ranges of least thicknesses, required friction and safety factors, and what of it stays open: least thickness and
/// required friction are largest at the worst arch, safety factors least (of measured arches the claims `survey-worst`
/// and `survey-safety`).
///
/// And of the thrusts, where all arches stand and span and rise are not measured. Each state of an arch is admissible
/// in every narrower, rougher and thicker one (the claim `survey-corners`): so the range of thrusts is within that of
/// the best arch, and holds that of the worst.
fn ranges(worst: &Corner, best: &Corner) -> (Vec<QuantityRange>, Option<Undecided>) {
    let (mut ranges, mut open) = (Vec::new(), None);
    let has_thrusts = worst.at.measured.is_none() && worst.stands() == Some(Ok(true));
    let thrusts = [(Quantity::LeastThrust, true), (Quantity::LargestThrust, false)];
    let others = [
        (Quantity::LeastThickness, true),
        (Quantity::GeometricSafety, false),
        (Quantity::RequiredFriction, true),
        (Quantity::FrictionSafety, false),
        (Quantity::ThicknessInMetres, true),
    ];
    let thrusts = thrusts.into_iter().filter(|_| has_thrusts);
    for (of, largest_is_worst) in others.into_iter().chain(thrusts) {
        let [first, last] = if largest_is_worst { [best, worst] } else { [worst, best] };
        let (lower, upper) = match (first.told(of), last.told(of)) {
            (Ok(Some(lower)), Ok(Some(upper))) => (lower, upper),
            (Err(why), _) | (_, Err(why)) => {
                open.get_or_insert(why.about(of.name()));
                continue;
            }
            _ => continue,
        };
        let end = |corner: &Corner, value: Told, up| {
            let value = match value {
                Told::Value(figure) => outward(&figure, up),
                Told::Without(words) => words,
            };
            RangeEnd::attained(value, &corner.at)
        };
        let (lower, upper) = (end(first, lower, false), end(last, upper, true));
        ranges.push(QuantityRange { of, lower, upper });
    }
    (ranges, open)
}

/// Range of the thrust at the least thickness, where that is asked for and span and rise are not measured. If all
/// arches rotate, it falls as the half opening grows, whatever the friction (the claim `curve-order`). Else an
/// enclosure: a state is admissible in the best arch too, and there as well when that has the thickness that the worst
/// one needs.
fn thrust_at_least_thickness(
    worst: &Corner,
    best: &Corner,
    modes: Option<&ModesFound>,
) -> Option<QuantityRange> {
    let (
        CornerAnswer::State(Ok(Answer::Stands(thin))),
        CornerAnswer::State(Ok(Answer::Stands(thick))),
        None,
    ) = (&best.found, &worst.found, &worst.at.measured)
    else {
        return None;
    };
    let of = Quantity::Thrust;
    if is_one_arch(&worst.at, &best.at) || modes.is_some_and(ModesFound::is_rotation_alone) {
        let lower = RangeEnd::attained(outward(&thick.thrust, false), &worst.at);
        let upper = RangeEnd::attained(outward(&thin.thrust, true), &best.at);
        return Some(QuantityRange { of, lower, upper });
    }
    let needed = ExactNumber::from(&thick.thickness.decimal.upper.to_rational());
    let digits = thin.thrust.decimal.value.significant_digits().min(ENCLOSED_DIGITS);
    let [lower, upper] = enclosed_thrusts(&best.at.arch, &needed, digits)?;
    Some(QuantityRange::enclosed(of, [lower.0, upper.1]))
}

/// Bounds of the least and of the largest thrust of an arch that stands.
pub(super) fn enclosed_thrusts(
    arch: &Arch,
    eta: &ExactNumber,
    digits: usize,
) -> Option<[(EndValue, EndValue); 2]> {
    let found = arch.certify_thickness(eta, digits).ok()?;
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
