//! The range of what is sought over all arches of a survey: the widest half opening that stands, or the least friction.
//!
//! An arch stands no less easily with a smaller half opening, with more friction, and with more thickness, up to
//! `eta = 2` (the claim `survey-corners`). So
//!
//! - the widest half opening grows with friction and thickness: its ends are those of the least rough and thinnest
//!   arches, and of the roughest and thickest;
//! - the least friction grows with the half opening and falls as the thickness grows: its ends are those of the
//!   narrowest and thickest arch, and of the widest and thinnest.
//!
//! Both are answers of [`find`], each the only one. Of arches whose span, rise and thickness are measured the friction
//! has its ends at the shortest span with the highest rise, and at the longest with the lowest (the claim
//! `survey-worst`).

use super::answer::{EndValue, QuantityRange, RangeEnd, SurveyAnswer, SurveyedArch};
use super::corners::outward;
use crate::certify::state::find::{Finding, Question, find};
use crate::problem::survey::{Side, Survey};
use crate::problem::{Quantity, Sought};
use crate::prover::{Error, Refused, Undecided};

/// Arch that decides on a side, with the end of each quantity there.
type DecidedSide = (SurveyedArch, Vec<(Quantity, RangeEnd)>);

/// Proves the range of what is sought over every arch of a survey, to `digits` digits. What is sought is not read in
/// the survey: its friction, or its half opening.
///
/// ```
/// use couplet_check::problem::Sought;
/// use couplet_check::problem::survey::{Shape, Survey};
/// use couplet_survey::{EndValue, sought};
/// use couplet_prove::prelude::*;
/// let shape = Shape::Free {
///     half_opening: ["78deg".parse()?, "82deg".parse()?],
///     thickness: Some(["0.08".parse()?, "0.1".parse()?]),
/// };
/// let arches = Survey::new(SelfWeight::Milankovitch, ["inf".parse()?, "inf".parse()?], shape)?;
/// let found = sought(&arches, Sought::Friction, 4)?;
/// let EndValue::Number(most) = &found.ranges[0].upper.value else { panic!("all can stand") };
/// let wide = Arch::parse("milankovitch", "82deg", "inf")?.certify_thickness(&"0.08".parse()?, 4)?;
/// let friction = wide.required_friction?.expect("some is enough");
/// assert_eq!(*most, friction.decimal.upper);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sought(survey: &Survey, of: Sought, digits: usize) -> Result<SurveyAnswer, Error> {
    Refused::digits(digits)?;
    // Without a half opening a span and a rise make no arch.
    if of == Sought::HalfOpening && survey.course(Side::Unsafe).is_some() {
        return Err(Undecided::no_solution().into());
    }
    let decided = |side, name: &str| {
        let at = SurveyedArch::decisive(survey, side).ok_or_else(Undecided::no_solution)?;
        at_corner(at, (of, side), digits).map_err(|error| match error {
            Error::Undecided(open) => open.about(name).into(),
            refused @ Error::Refused(_) => refused,
        })
    };
    let (worst, unsafest) = decided(Side::Unsafe, "the arch that stands least easily")?;
    let (best, safest) = decided(Side::Safe, "the arch that stands most easily")?;
    let range = |((of, one), (_, other)): ((Quantity, RangeEnd), (_, RangeEnd))| {
        let [lower, upper] = match of {
            Quantity::Friction => [other, one],
            _ => [one, other],
        };
        QuantityRange { of, lower, upper }
    };
    let ranges = unsafest.into_iter().zip(safest).map(range).collect();
    Ok(SurveyAnswer { verdict: None, worst, best, ranges, open: None, modes: None })
}

/// Ends at a corner: on the side where an arch stands most easily the widest half opening is largest, the friction
/// least.
fn at_corner(
    at: SurveyedArch,
    (of, side): (Sought, Side),
    digits: usize,
) -> Result<DecidedSide, Error> {
    let (arch, thickness) = (&at.arch, at.thickness.clone());
    let question = match of {
        Sought::HalfOpening => {
            Question::HalfOpening { friction: arch.friction().clone(), thickness }
        }
        Sought::Friction => {
            Question::Friction { half_opening: arch.half_opening().clone(), thickness }
        }
    };
    let finding = find(arch.weight(), &question, digits)?;
    let is_upper = (of == Sought::HalfOpening) == (side == Side::Safe);
    let end = |quantity: &Quantity| {
        let value = match &finding {
            Finding::Found(found) => {
                let figure = found.figures.iter().find(|(known, _)| known == quantity);
                let (_, figure) = figure.ok_or_else(Undecided::no_solution)?;
                outward(figure, is_upper)
            }
            Finding::Nothing(_) => EndValue::NotEnough,
            Finding::Beyond(..) => return Err(Undecided::no_solution()),
        };
        Ok((*quantity, RangeEnd::attained(value, &at)))
    };
    let ends = of.quantities().iter().map(end).collect::<Result<_, Undecided>>()?;
    Ok((at, ends))
}
