//! The reader of what is given of an arch.

use super::arc::arc;
use super::asked::{ArchAsked, Field, read};
use super::note::{notes, tilt_note};
use super::question::{ArchQuestion, Misfit, Spelling};
use super::stones::StonesAsked;
use crate::arch::SelfWeight;
use crate::number::{ExactNumber, TELL_OF_RANGES, shown};
use crate::problem::measures::{Circle, LengthUnit, Measures};
use crate::problem::stones::Stones;
use crate::problem::{Arch, Friction, Quantity, Slope, SlopeError, ThicknessError, thickness};
use num_bigint::Sign;

/// Arch as it is understood.
#[derive(Clone, Debug)]
pub struct ArchGiven {
    /// Half opening, where it is given or follows.
    pub half_opening: Option<ExactNumber>,
    /// Friction, where it is given.
    pub friction: Option<Friction>,
    /// Sizes, if any is given.
    pub measures: Option<Measures>,
    /// Thickness-to-radius ratio, where there is a thickness.
    pub thickness: Option<ExactNumber>,
    /// Stones, if the joints are between them alone.
    pub stones: Option<StonesAsked>,
    /// Horizontal acceleration over that of gravity, if there is one.
    pub tilt: Option<Slope>,
}

impl ArchGiven {
    /// Arch that a question is about, after the check of what is given.
    pub fn read(
        question: &ArchQuestion,
        asked: &ArchAsked,
        spelling: Spelling,
    ) -> Result<Self, Misfit> {
        question.fits(asked, spelling)?;
        question.is_whole(asked, spelling)?;
        let given = Self::new(asked, spelling)?;
        let any = || question.unlimited.then_some(Friction::Infinite);
        Ok(Self { friction: given.friction.clone().or_else(any), ..given })
    }

    /// Reads what is given, whatever of it is missing.
    pub fn new(asked: &ArchAsked, spelling: Spelling) -> Result<Self, Misfit> {
        if let Some(field) = asked.ranges().next() {
            let text = shown(asked.get(field).unwrap_or_default());
            let name = spelling.of(field);
            let message = format!(
                "{name} {text} is a range: ranges are for {TELL_OF_RANGES}, which tell of every arch inside; give one \
                 value here"
            );
            return Err(Misfit::new(field, message));
        }
        let stones = StonesAsked::of(asked)?;
        let alpha = match &stones {
            Some(StonesAsked::Joints(stones)) => Some(stones.half_opening().clone()),
            _ => read(asked, Field::HalfOpening)?,
        };
        let (half_opening, radius) = arc(asked, alpha, spelling)?;
        let circle = circle(asked)?;
        let loaded = read(asked, Field::Density)?.zip(read(asked, Field::Depth)?);
        let lengths = [&asked.span, &asked.rise, &asked.radius].into_iter().flatten();
        let unit = lengths.filter_map(|text| LengthUnit::of(text)).next().unwrap_or_default();
        let measures = radius.map(|radius| Measures::new(circle, radius, loaded).told_in(unit));
        let friction = friction(asked)?;
        let thickness = asked.thickness.as_deref();
        let thickness = thickness.map(|text| given_thickness(text, measures.as_ref(), spelling));
        let (thickness, tilt) = (thickness.transpose()?, tilt(asked, friction.as_ref(), spelling)?);
        Ok(Self { half_opening, friction, measures, thickness, stones, tilt })
    }

    /// Part of an arch of which more follows: its texts by themselves, each in the range that an arch allows.
    pub fn part(asked: &ArchAsked) -> Result<Self, Misfit> {
        let given = Self::new(asked, Spelling::Key)?;
        let alpha = given.half_opening.clone().unwrap_or_else(|| ExactNumber::from(1));
        let friction = given.friction.clone().unwrap_or(Friction::Infinite);
        Arch::new(SelfWeight::Heyman, alpha, friction).map_err(|error| error.to_string())?;
        Ok(given)
    }

    /// The arch with a self-weight: half opening and friction are there once a question was [read](Self::read).
    pub fn arch(&self, weight: SelfWeight) -> Result<Arch, Misfit> {
        let missing = |field| Misfit::new(field, format!("{} is missing", field.name()));
        let alpha = self.half_opening.clone().ok_or_else(|| missing(Field::HalfOpening))?;
        let friction = self.friction.clone().ok_or_else(|| missing(Field::Friction))?;
        Ok(Arch::new(weight, alpha, friction).map_err(|error| error.to_string())?)
    }

    /// Notes on what may have been meant otherwise.
    pub fn notes(&self) -> Vec<String> {
        let mut all = notes(&self.friction);
        all.extend(self.tilt.as_ref().and_then(tilt_note));
        all
    }

    /// Quantities that can be asked of the arch.
    pub fn quantities(&self) -> Vec<Quantity> {
        let forces = self.measures.as_ref().map(Measures::has_forces);
        Quantity::of_arch(self.thickness.is_some(), forces)
    }

    /// The divisions into stones; none if there is a joint at every angle.
    pub fn divisions(&self) -> Result<Vec<Stones>, Misfit> {
        let (Some(stones), Some(alpha)) = (&self.stones, &self.half_opening) else {
            return Ok(Vec::new());
        };
        stones.all(alpha).map_err(|error| Misfit::new(Field::Stones, error))
    }
}

/// Circle at which an arch is measured.
pub(super) fn circle(asked: &ArchAsked) -> Result<Circle, Misfit> {
    let circle = asked.measured_at.as_deref().map_or(Ok(Circle::default()), str::parse);
    circle
        .map_err(|names| Misfit::new(Field::MeasuredAt, format!("an arch is measured at {names}")))
}

/// Friction, by whichever field it is given.
pub(super) fn friction(asked: &ArchAsked) -> Result<Option<Friction>, Misfit> {
    let (friction, angle) = (read(asked, Field::Friction)?, read(asked, Field::FrictionAngle)?);
    Ok(friction.or(angle.map(Friction::Angle)))
}

/// Thickness over the radius, of a text that is a ratio or, of an arch with measures, a length.
pub(super) fn given_thickness(
    text: &str,
    measures: Option<&Measures>,
    spelling: Spelling,
) -> Result<ExactNumber, Misfit> {
    thickness(text, measures)
        .map_err(|error| Misfit::new(Field::Thickness, hinted(&error, spelling)))
}

/// Reason why a thickness is refused, with what would do.
fn hinted(error: &ThicknessError, spelling: Spelling) -> String {
    let [span, rise, radius] =
        [Field::Span, Field::Rise, Field::Radius].map(|field| spelling.of(field));
    match error {
        ThicknessError::Length(_) => {
            format!("{error}, or the arch in metres: {span} and {rise}, or {radius}")
        }
        ThicknessError::NoRatio(_) => {
            format!("{error}, or of an arch in metres a length in m, cm, mm, ft or in")
        }
        _ => error.to_string(),
    }
}

fn tilt(
    asked: &ArchAsked,
    friction: Option<&Friction>,
    spelling: Spelling,
) -> Result<Option<Slope>, Misfit> {
    let Some(text) = &asked.tilt else { return Ok(None) };
    let why = |error: SlopeError| match error {
        SlopeError::Negative => {
            "is negative: give its size, for to the other side the arch is its mirror image"
        }
        SlopeError::Angle => "is not an angle from 0 to below 90deg",
        _ => "is no acceleration: give a number (0.1) or an angle (5deg)",
    };
    // The unit in which it is told.
    let number = text.trim().strip_suffix('g').map(str::trim_end);
    let number = number.filter(|number| number.ends_with(|c: char| c.is_ascii_digit() || c == '.'));
    let tilt = number.unwrap_or(text).parse().map_err(|error| {
        Misfit::new(Field::Tilt, format!("the tilt '{}' {}", shown(text), why(error)))
    })?;
    match friction {
        Some(Friction::Coefficient(x) | Friction::Angle(x))
            if x.factor().numer().sign() == Sign::NoSign =>
        {
            let name = spelling.of(Field::Tilt);
            Err(Misfit::new(
                Field::Tilt,
                format!("without friction nothing stands: {name} asks for a friction above 0"),
            ))
        }
        _ => Ok(Some(tilt)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STATE: ArchQuestion = ArchQuestion {
        refuses: &[(Field::Tilt, "why")],
        needs: &[],
        unlimited: false,
        example: "example",
    };

    fn asked(words: &str) -> ArchAsked {
        let pairs = words.split_whitespace().map(|pair| pair.split_once('=').unwrap());
        ArchAsked::of(pairs.map(|(name, text)| (Field::named(name).unwrap(), text)))
    }

    fn read(words: &str) -> Result<ArchGiven, Misfit> {
        ArchGiven::read(&STATE, &asked(words), Spelling::Key)
    }

    #[test]
    fn an_arch_is_the_same_however_it_is_given() {
        let of_span =
            read("span=10m rise=5m mu=0.6 thickness=60cm measured_at=centreline").unwrap();
        let of_radius =
            read("radius=5m alpha=90deg friction=0.6 eta=60cm measured_at=centreline").unwrap();
        let of_ratio = read("alpha=2atan(1) mu=0.6 eta=0.12").unwrap();
        for given in [&of_span, &of_radius, &of_ratio] {
            let eta: ExactNumber = "3/25".parse().unwrap();
            assert_eq!(given.thickness.as_ref().unwrap().factor(), eta.factor());
            let arch = given.arch(SelfWeight::Heyman).unwrap();
            assert_eq!(arch.friction(), &"0.6".parse().unwrap());
        }
        let stones = read("joints=0,0.5,1 mu=1").unwrap();
        assert_eq!(stones.half_opening.unwrap().to_string(), "1");
        assert_eq!(
            read("alpha=1 phi=31deg").unwrap().friction,
            Some("tan(31deg)".parse().unwrap())
        );
    }

    #[test]
    fn what_makes_no_sense_is_refused_with_its_field() {
        for (words, field, why) in [
            ("", None, "half_opening, friction (or friction_angle) are missing"),
            ("alpha=1", None, "friction (or friction_angle) is missing"),
            ("alpha=1 mu=1 span=1m", Some(Field::Span), "make a radius that is no exact number"),
            ("alpha=4 mu=1 span=1m", Some(Field::HalfOpening), "not between 0 and pi"),
            ("alpha=1 mu=1 phi=1", Some(Field::FrictionAngle), "friction and friction_angle"),
            ("mu=1 span=1m", Some(Field::Span), "span needs rise"),
            ("alpha=1 mu=1 density=1kN/m3 depth=1m", Some(Field::Density), "forces need a size"),
            ("alpha=1 mu=1 measured_at=intrados", Some(Field::MeasuredAt), "needs a size"),
            ("alpha=1 mu=1 tilt=1", Some(Field::Tilt), "tilt does not belong here: why"),
            ("alpha=1 mu=1 stones=3 joints=0,1", Some(Field::Joints), "say the same"),
            ("alpha=1 mu=1 stones=1", Some(Field::Stones), "from 2 to"),
            ("alpha=1 mu=1 stones=9..3", Some(Field::Stones), "from 2 to"),
            ("alpha=1 mu=1 eta=60cm", Some(Field::Thickness), "span and rise, or radius"),
            ("span=10m rise=3m mu=1 radius=1m", Some(Field::Radius), "contradicts"),
            ("span=10 rise=3m mu=1", Some(Field::Span), "is not a length"),
            ("radius=1m alpha=1 mu=1 measured_at=top", Some(Field::MeasuredAt), "one of intrados"),
            (
                "alpha=1..2 mu=1",
                Some(Field::HalfOpening),
                "half_opening 1..2 is a range: ranges are for",
            ),
            ("alpha=1 mu=1±1%", Some(Field::Friction), "give one value here"),
            ("alpha=x mu=1", Some(Field::HalfOpening), "x"),
            ("alpha=1 mu=x", Some(Field::Friction), "x"),
        ] {
            let misfit = read(words).unwrap_err();
            assert_eq!(misfit.field, field, "{words}: {misfit}");
            assert!(misfit.message.contains(why), "{words}: {misfit}");
        }
        let tilted = ArchQuestion { refuses: &[], ..STATE };
        let misfit = ArchGiven::read(&tilted, &asked("alpha=1 mu=0 tilt=0.1"), Spelling::Option)
            .unwrap_err();
        assert!(misfit.message.contains("--tilt asks for a friction above 0"));
        let misfit = ArchGiven::read(&STATE, &asked("alpha=1"), Spelling::Option).unwrap_err();
        assert!(misfit.message.ends_with("for example: example"));
    }
}
