//! Verdicts on every arch of given stones whose friction and thickness have ranges.
//!
//! The joints are those of the stones, and the same for all arches. What each asks of thrust and crown moment is what
//! it asks in an arch with a joint at every angle (the claim `survey-corners`): no more where there is more friction
//! or, up to `eta = 2`, more thickness. So the least rough and thinnest arch decides whether all stand, the roughest
//! and thickest whether any does. A wider half opening, or another span of one rise, has other joints: nothing is said
//! of those.

use super::answer::{SurveyAnswer, SurveyedArch};
use super::corners::{Corner, answer};
use crate::problem::stones::Stones;
use crate::problem::survey::{Side, Survey};
use crate::prover::{Error, Undecided};

/// Proves what holds for every arch of these stones with a friction and, where it has one, a thickness of the survey,
/// to `digits` digits; the half opening is that of the stones. Modes are not told.
pub fn survey_of_stones(
    survey: &Survey,
    stones: &Stones,
    digits: usize,
) -> Result<SurveyAnswer, Error> {
    let corner = |side| {
        let at = SurveyedArch::decisive(survey, side).ok_or_else(Undecided::no_solution)?;
        Ok::<_, Error>(Corner::of_stones(at, stones, digits)?)
    };
    Ok(answer(corner(Side::Unsafe)?, corner(Side::Safe)?, None))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::problem::Quantity;
    use crate::problem::survey::Shape;
    use crate::{EndValue, SurveyVerdict};
    use couplet_stones::assess_voussoirs;
    use couplet_stones::{VoussoirStanding, Voussoirs, voussoirs};

    const DIGITS: usize = 8;

    fn survey(stones: &Stones, mu: [&str; 2], eta: Option<[&str; 2]>) -> Survey {
        let shape = Shape::Free {
            half_opening: [(); 2].map(|()| stones.half_opening().clone()),
            thickness: eta.map(|eta| eta.map(|x| x.parse().unwrap())),
        };
        Survey::new(SelfWeight::Heyman, mu.map(|x| x.parse().unwrap()), shape).unwrap()
    }

    /// Every arch of a grid has its values within the ranges, and stands or not as the verdict says.
    #[test]
    fn no_arch_of_stones_contradicts_its_survey() {
        for (count, alpha, mus, etas, verdict) in [
            (
                11,
                "pi/2",
                ["0.5", "0.55", "0.6"],
                ["0.1", "0.105", "0.11"],
                SurveyVerdict::BothOccur,
            ),
            (12, "80deg", ["0.4", "0.6", "inf"], ["0.1", "0.11", "0.2"], SurveyVerdict::AllStand),
            (5, "2.2", ["0.3", "0.35", "0.4"], ["0.1", "0.3", "0.4"], SurveyVerdict::NoneStands),
        ] {
            let stones = Stones::equal(count, alpha.parse().unwrap()).unwrap();
            let all = survey(&stones, [mus[0], mus[2]], Some([etas[0], etas[2]]));
            let found = survey_of_stones(&all, &stones, DIGITS).unwrap();
            assert_eq!(found.verdict, Some(Ok(verdict)), "{count} {alpha}");
            let bounds = |of: Quantity| {
                let range = found.ranges.iter().find(|range| range.of == of)?;
                let number = |end: &EndValue| match end {
                    EndValue::Number(number) => Some(number.to_rational()),
                    _ => None,
                };
                Some([&range.lower, &range.upper].map(|end| number(&end.value)))
            };
            for (mu, eta) in mus.iter().flat_map(|mu| etas.iter().map(move |eta| (mu, eta))) {
                let (mu, eta) = (mu.parse().unwrap(), eta.parse().unwrap());
                let own = assess_voussoirs(&stones, SelfWeight::Heyman, &mu, &eta, 12).unwrap();
                let least = voussoirs(&stones, SelfWeight::Heyman, &mu, 12).unwrap();
                let stands = matches!(own.standing, Ok(VoussoirStanding::Stands(_)));
                match verdict {
                    SurveyVerdict::AllStand => assert!(stands),
                    SurveyVerdict::NoneStands => assert!(!stands),
                    SurveyVerdict::BothOccur => {}
                }
                let least = match least {
                    Voussoirs::Stands(state) => Some(state.thickness),
                    _ => None,
                };
                let mut values = vec![
                    (Quantity::LeastThickness, least),
                    (Quantity::GeometricSafety, own.geometric_safety.unwrap()),
                    (Quantity::RequiredFriction, own.required_friction.unwrap()),
                    (Quantity::FrictionSafety, own.friction_safety.unwrap()),
                ];
                if let Ok(VoussoirStanding::Stands([least, largest])) = own.standing {
                    values.push((Quantity::LeastThrust, least.thrust));
                    values.push((Quantity::LargestThrust, largest.thrust));
                }
                for (of, value) in values {
                    let (Some([lower, upper]), Some(value)) = (bounds(of), value) else { continue };
                    let value = value.decimal.value.to_rational();
                    assert!(lower.is_none_or(|lower| lower <= value), "{of} of {mu} {eta}");
                    assert!(upper.is_none_or(|upper| value <= upper), "{of} of {mu} {eta}");
                }
            }
        }
    }

    /// Two stones have no joint inside their halves: every thickness is enough.
    #[test]
    fn two_stones_need_no_thickness() {
        let stones = Stones::equal(2, "1".parse().unwrap()).unwrap();
        let found = survey_of_stones(&survey(&stones, ["1", "2"], None), &stones, DIGITS).unwrap();
        let [range] = &found.ranges[..] else { panic!("{:?}", found.ranges) };
        assert_eq!(range.of, Quantity::LeastThickness);
        assert_eq!(
            [&range.lower.value, &range.upper.value],
            [&EndValue::AnyIsEnough, &EndValue::AnyIsEnough]
        );
        let least = voussoirs(&stones, SelfWeight::Heyman, &"1".parse().unwrap(), DIGITS).unwrap();
        assert!(matches!(least, Voussoirs::AnyThickness), "{least:?}");
    }
}
