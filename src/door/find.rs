//! Questions asked the other way round: what is sought, and the reader of what is given for it.

use crate::ask::{ArchAsked, ArchGiven, ArchQuestion, Field, Spelling, SurveyGiven};
use crate::certify::Refused;
use crate::certify::state::find::{Given, Question};
use crate::problem::{Friction, Line, NoLine, Sought};
use crate::report::Understood;
use crate::report::words::list;
use crate::sweep::failure::Failure;
use crate::sweep::parse;

/// Target of a search: the widest half opening that stands, the least friction with which an arch stands, or with
/// `None` the place where one mode becomes another.
pub type FindTarget = Option<Sought>;

/// Target of a name.
pub fn what(text: &str) -> Result<FindTarget, String> {
    match &text.replace('_', "-").to_lowercase()[..] {
        "half-opening" | "alpha" => Ok(Some(Sought::HalfOpening)),
        "friction" | "mu" => Ok(Some(Sought::Friction)),
        "boundary" => Ok(None),
        "thickness" | "eta" => Err("the least thickness is what `couplet state` finds".into()),
        _ => Err(parse::unknown("what is found", text, &["half-opening", "friction", "boundary"])),
    }
}

/// Pair of modes.
pub fn line(text: &str) -> Result<Line, String> {
    text.parse().map_err(|error: NoLine| error.to_string())
}

/// Question about an arch of which one thing is sought.
pub const QUESTION: ArchQuestion = ArchQuestion {
    refuses: &[
        (Field::Stones, "what is found is of an arch with a joint at every angle"),
        (Field::Joints, "what is found is of an arch with a joint at every angle"),
        (Field::Tilt, "what is found is of an arch without acceleration"),
        (Field::Density, "no forces are found"),
    ],
    needs: &[],
    unlimited: false,
    example: "",
};

/// The question asked, if what is given fits it.
pub fn question(
    (what, modes): (FindTarget, Option<Line>),
    asked: &ArchAsked,
    spelling: Spelling,
) -> Result<Question, Failure> {
    QUESTION.fits(asked, spelling)?;
    let given = ArchGiven::new(asked, spelling)?;
    let ArchGiven { half_opening, friction, thickness: eta, .. } = given;
    let given = [half_opening.is_some(), friction.is_some(), eta.is_some()];
    let name = |field| spelling.of(field);
    let too_much = |wrong: &[(bool, String)]| {
        let wrong: Vec<&str> = wrong.iter().filter(|(given, _)| *given).map(|x| &x.1[..]).collect();
        match wrong.is_empty() {
            true => Ok(()),
            false => Err(Failure::Input(format!("{} does not belong here", list(wrong)))),
        }
    };
    let missing = |what: &str, example: &str| {
        let example = match spelling {
            Spelling::Option => format!("; for example: couplet find {example}"),
            Spelling::Key => String::new(),
        };
        Failure::Input(format!("{what} is missing{example}"))
    };
    let pair = (modes.is_some(), "a pair of modes".to_owned());
    let [alpha, mu, angle] = [Field::HalfOpening, Field::Friction, Field::FrictionAngle].map(name);
    let [has_alpha, has_mu, is_thick] = given;
    Ok(match what {
        Some(Sought::HalfOpening) => {
            too_much(&[pair, (has_alpha, alpha)])?;
            let example = "half-opening --thickness 0.15 --friction 0.6";
            let friction =
                friction.ok_or_else(|| missing(&format!("{mu} (or {angle})"), example))?;
            Question::HalfOpening { friction, thickness: eta }
        }
        Some(Sought::Friction) => {
            too_much(&[pair, (has_mu, mu)])?;
            let example = "friction --half-opening 80deg --thickness 0.1";
            let half_opening = half_opening.ok_or_else(|| missing(&alpha, example))?;
            Question::Friction { half_opening, thickness: eta }
        }
        None => {
            too_much(&[(is_thick, name(Field::Thickness))])?;
            let example = "boundary rrs/rsr --friction 1.6";
            let line = modes.ok_or_else(|| missing("the pair of modes", example))?;
            let given = match (half_opening, friction) {
                (Some(alpha), None) => Given::HalfOpening(alpha),
                (None, Some(Friction::Infinite)) => return Err(Refused::UnlimitedFriction.into()),
                (None, Some(mu)) => Given::Friction(mu),
                (None, None) => return Err(missing(&format!("{mu} or {alpha}"), example)),
                (Some(_), Some(_)) => {
                    let message = format!("give {mu} or {alpha}; the other one is found");
                    return Err(message.into());
                }
            };
            Question::Boundary { line, given }
        }
    })
}

/// The quantity sought of every arch of a question with ranges, and the arches, if what is given fits it.
pub fn of_ranges(
    target: (FindTarget, Option<Line>),
    asked: &ArchAsked,
    spelling: Spelling,
) -> Result<(Sought, SurveyGiven), Failure> {
    // Of a boundary, one of them refuses the range.
    let boundary = || Ok(question(target, asked, spelling)?.sought());
    let sought = target.0.map_or_else(boundary, Ok::<_, Failure>)?;
    for end in asked.ends()? {
        question(target, &end, spelling)?;
    }
    Ok((sought, SurveyGiven::seeking(sought, asked, spelling)?))
}

/// The question as it is understood, once it is read.
pub fn understood(asked: &ArchAsked, spelling: Spelling) -> Result<Understood, Failure> {
    Ok(Understood::new(asked, &ArchGiven::new(asked, spelling)?))
}
