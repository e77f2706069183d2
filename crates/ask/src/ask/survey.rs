//! The reader of what is given of all arches between two ends.

use super::arch::{ArchAsked, Field};
use super::given::{circle, friction, given_thickness, read};
use super::question::{ArchQuestion, Misfit, Spelling};
use super::range::decimal;
use super::stones::StonesAsked;
use crate::arch::SelfWeight;
use crate::number::{ExactNumber, shown};
use crate::problem::measures::{Circle, Length, Measures, of_span_and_rise};
use crate::problem::stones::Stones;
use crate::problem::survey::{Shape, Survey, SurveyError, frictions_in_order, in_order};
use crate::problem::{Arch, ArchError, Friction, Sought};
use num_bigint::BigInt;

/// All arches of a question with ranges, as they are understood.
#[derive(Clone, Debug)]
pub struct SurveyGiven {
    /// Least and largest friction.
    pub friction: [Friction; 2],
    /// Half openings and thicknesses, or the measures that make both.
    pub shape: Shape,
    /// Circle at which the arches are measured, where they are.
    pub circle: Option<Circle>,
    /// Stones of every one of them, if the joints are between them alone.
    pub stones: Option<Stones>,
    /// Texts of the lower ends and of the upper ends.
    ends: [ArchAsked; 2],
}

/// Fields that go with no range, each with the reason.
const REFUSED: [(Field, &str); 3] = [
    (Field::Tilt, "a range of arches is told of on level ground"),
    (Field::Density, "of a range of arches no forces are told"),
    (Field::Depth, "of a range of arches no forces are told"),
];
/// Measures of an arch.
const MEASURES: [Field; 3] = [Field::Span, Field::Rise, Field::Radius];

impl SurveyGiven {
    /// Arches that a question is about, after the check of what is given. A field without a range is one value.
    pub fn read(
        question: &ArchQuestion,
        asked: &ArchAsked,
        spelling: Spelling,
    ) -> Result<Self, Misfit> {
        question.fits(asked, spelling)?;
        question.is_whole(asked, spelling)?;
        Self::of(question.unlimited, asked, spelling)
    }

    /// Arches of which something is sought that is not given: they have any friction, or any half opening, for which
    /// one radian stands where a text has none.
    pub fn seeking(sought: Sought, asked: &ArchAsked, spelling: Spelling) -> Result<Self, Misfit> {
        Self::of(sought == Sought::Friction, asked, spelling)
    }

    fn of(is_unlimited: bool, asked: &ArchAsked, spelling: Spelling) -> Result<Self, Misfit> {
        let refused = REFUSED.iter().find(|(field, _)| asked.get(*field).is_some());
        if let Some((field, why)) = refused {
            let (name, range) = (spelling.of(*field), asked.ranges().next());
            let range = range
                .map_or("a range".to_owned(), |of| format!("the range of {}", spelling.of(of)));
            let message = format!("{name} does not go with {range}: {why}");
            return Err(Misfit::new(*field, message));
        }
        let stones = stones(asked, spelling)?;
        let ends = asked.ends()?;
        let circle = circle(asked)?;
        let [low, high] = ends.each_ref().map(|end| {
            let any = || is_unlimited.then_some(Friction::Infinite);
            let missing = || Misfit::new(Field::Friction, "the friction is missing");
            friction(end)?.or_else(any).ok_or_else(missing)
        });
        let joints = stones.as_ref().and_then(|stones| match stones {
            StonesAsked::Joints(stones) => Some(stones.half_opening().clone()),
            StonesAsked::Numbers { .. } => None,
        });
        let usual = joints.unwrap_or_else(|| ExactNumber::rational(BigInt::from(1).into()));
        let (friction, shape) = ([low?, high?], shape(&ends, usual, circle, spelling)?);
        let is_measured = MEASURES.into_iter().any(|of| asked.get(of).is_some());
        let circle = is_measured.then_some(circle);
        let mut given = Self { friction, shape, circle, stones: None, ends };
        // What is no range of arches is told with its field.
        given.survey(SelfWeight::Heyman).map_err(|error| given.misfit(&error, asked))?;
        if let Some(stones) = stones {
            let [alpha, _] = given.half_opening();
            let all = stones.all(&alpha).map_err(|error| Misfit::new(Field::Stones, error))?;
            given.stones = all.into_iter().next();
        }
        Ok(given)
    }

    /// The arches of a self-weight.
    pub fn survey(&self, weight: SelfWeight) -> Result<Survey, SurveyError> {
        Survey::new(weight, self.friction.clone(), self.shape.clone())
    }

    /// Reason why these are no arches, with its field.
    fn misfit(&self, error: &SurveyError, asked: &ArchAsked) -> Misfit {
        let is_friction = frictions_in_order(&self.friction).is_err();
        let field = match error {
            SurveyError::Arch(ArchError::HalfOpening(_)) => Field::HalfOpening,
            SurveyError::Arch(_) => asked.friction_field(),
            SurveyError::Reversed(..) | SurveyError::Open(..) if is_friction => {
                asked.friction_field()
            }
            SurveyError::Reversed(..) | SurveyError::Open(..)
                if in_order(&self.half_opening()).is_err() =>
            {
                Field::HalfOpening
            }
            _ => Field::Thickness,
        };
        Misfit::new(field, error)
    }

    /// Least and largest half opening, rad.
    pub fn half_opening(&self) -> [ExactNumber; 2] {
        match &self.shape {
            Shape::Free { half_opening, .. } => half_opening.clone(),
            Shape::Spanned { span, rise, .. } => {
                made(span, rise).map(|(half_opening, _)| half_opening)
            }
        }
    }

    /// Question about one of the arches: in the texts of the ends that it has, else in exact numbers. `measured` are
    /// its span, rise and thickness, where these are measured.
    pub fn one(
        &self,
        arch: &Arch,
        thickness: Option<&ExactNumber>,
        measured: Option<&[Length; 3]>,
    ) -> ArchAsked {
        let [low, high] = &self.ends;
        let mut one = low.clone();
        let end =
            |ends: &[Friction; 2]| ends.iter().position(|friction| friction == arch.friction());
        match end(&self.friction) {
            Some(end) => {
                one.friction.clone_from(&self.ends[end].friction);
                one.friction_angle.clone_from(&self.ends[end].friction_angle);
            }
            None => {
                (one.friction, one.friction_angle) = (Some(arch.friction().to_string()), None);
            }
        }
        if let Some(measured) = measured {
            for (field, length) in
                [Field::Span, Field::Rise, Field::Thickness].into_iter().zip(measured)
            {
                let said = |end: &&ArchAsked| {
                    let length = Some(length);
                    end.get(field).and_then(|text| text.parse().ok()).as_ref() == length
                };
                let said = [low, high].into_iter().find(said).and_then(|end| end.get(field));
                let text = || format!("{}m", decimal(length.metres()));
                *one.at(field) = Some(said.map_or_else(text, str::to_owned));
            }
            return one;
        }
        let Shape::Free { half_opening, thickness: range } = &self.shape else {
            // An arch of no named measures is told of by its ratios.
            (one.span, one.rise, one.measured_at) = (None, None, None);
            one.half_opening = Some(arch.half_opening().to_string());
            one.thickness = thickness.map(ToString::to_string);
            return one;
        };
        match half_opening.iter().position(|alpha| alpha == arch.half_opening()) {
            Some(end) => {
                one.half_opening.clone_from(&self.ends[end].half_opening);
                // The narrow arch has the longer span.
                one.span.clone_from(&self.ends[1 - end].span);
                one.rise.clone_from(&self.ends[end].rise);
            }
            None => {
                (one.span, one.rise) = (None, None);
                one.half_opening = Some(arch.half_opening().to_string());
            }
        }
        let (Some(range), Some(eta)) = (range, thickness) else {
            one.thickness = None;
            return one;
        };
        match range.iter().position(|end| end == eta) {
            Some(end) => {
                one.thickness.clone_from(&self.ends[end].thickness);
                // The thin arch has the larger radius.
                if of_lengths(&self.ends).is_some() {
                    one.radius.clone_from(&self.ends[1 - end].radius);
                }
            }
            None => {
                let is_sized = one.span.is_some() || one.radius.is_some();
                one.thickness = Some(format!("{eta}{}", if is_sized { "r" } else { "" }));
            }
        }
        one
    }
}

/// Half opening and radius of the lowest arch of the longest span, and of the highest of the shortest.
fn made([short, long]: &[Length; 2], [low, high]: &[Length; 2]) -> [(ExactNumber, Length); 2] {
    [(long, low), (short, high)].map(|(span, rise)| of_span_and_rise(span, rise))
}

/// Stones of arches of which friction or thickness is a range: what else has one moves the joints.
fn stones(asked: &ArchAsked, spelling: Spelling) -> Result<Option<StonesAsked>, Misfit> {
    let Some(stones) = super::given::stones(asked)? else { return Ok(None) };
    let [of, alpha] = match stones {
        StonesAsked::Joints(_) => [Field::Joints; 2],
        StonesAsked::Numbers { .. } => [Field::Stones, Field::HalfOpening],
    };
    let name = |field| spelling.of(field);
    let moves = [alpha, Field::Span, Field::Rise];
    if let Some(field) = asked.ranges().find(|field| moves.contains(field)) {
        let message = format!(
            "{} does not go with the range of {}, which moves the joints: ranges of friction and thickness leave them",
            name(of),
            name(field)
        );
        return Err(Misfit::new(of, message));
    }
    match stones.is_range() {
        true => {
            let message =
                format!("a range of arches has one number of stones: give {} one", name(of));
            Err(Misfit::new(of, message))
        }
        false => Ok(Some(stones)),
    }
}

/// Geometry that the arches have in common; of no half opening that is given, or made, they have the `usual` one.
fn shape(
    ends: &[ArchAsked; 2],
    usual: ExactNumber,
    circle: Circle,
    spelling: Spelling,
) -> Result<Shape, Misfit> {
    let [span, rise, radius] = MEASURES.map(|field| lengths(ends, field));
    let (measured, radius) = (span?.zip(rise?), radius?);
    let Some((span, rise)) = measured else {
        let alpha = |end| {
            let given = read::<ExactNumber>(end, Field::HalfOpening)?;
            Ok::<_, Misfit>(given.unwrap_or_else(|| usual.clone()))
        };
        let half_opening = [alpha(&ends[0])?, alpha(&ends[1])?];
        let of = radius.clone().map(|ends| ends.map(|radius| Measures::new(circle, radius, None)));
        let thickness = match (thickness(ends, of.as_ref(), spelling)?, radius) {
            (Thickness::Lengths(lengths), Some(radius)) => Some(ratios(lengths, radius, circle)?),
            (thickness, _) => thickness.ratios(),
        };
        return Ok(Shape::Free { half_opening, thickness });
    };
    if radius.is_some() {
        let [span, radius] = [Field::Span, Field::Radius].map(|field| spelling.of(field));
        let message = format!("beside {span} leave {radius} out of a range: it follows");
        return Err(Misfit::new(Field::Radius, message));
    }
    let made = made(&span, &rise);
    let of = made.clone().map(|(_, radius)| Measures::new(circle, radius, None));
    let thickness = match thickness(ends, Some(&of), spelling)? {
        // One circle, as good as free of its thickness.
        Thickness::Lengths(lengths) if span[0] == span[1] && rise[0] == rise[1] => {
            let radius = made.clone().map(|(_, radius)| radius);
            Some(ratios(lengths, radius, circle)?)
        }
        Thickness::Lengths(thickness) => {
            short(ends)?;
            return Ok(Shape::Spanned { circle, span, rise, thickness });
        }
        ratio => ratio.ratios(),
    };
    Ok(Shape::Free { half_opening: made.map(|(half_opening, _)| half_opening), thickness })
}

/// Most characters of a length that is halved on the way to an answer: of 9,000 it takes minutes.
const MOST_CHARACTERS: usize = 300;

/// Checks that no length is too long to be halved.
fn short(ends: &[ArchAsked; 2]) -> Result<(), Misfit> {
    for field in [Field::Span, Field::Rise, Field::Thickness] {
        let longest = ends.iter().filter_map(|end| end.get(field)).map(str::len).max();
        if longest > Some(MOST_CHARACTERS) {
            let message =
                format!("beside a range a length has at most {MOST_CHARACTERS} characters");
            return Err(Misfit::new(field, message));
        }
    }
    Ok(())
}

/// Ends of the ratio `t/(R + c t/2)`, which rises with the thickness and falls as the radius grows.
fn ratios(
    [thin, thick]: [Length; 2],
    [small, large]: [Length; 2],
    circle: Circle,
) -> Result<[ExactNumber; 2], Misfit> {
    let ratio = |radius: Length, t: Length| {
        let eta = Measures::new(circle, radius, None).thickness(&t);
        eta.map_err(|error| Misfit::new(Field::Thickness, error))
    };
    Ok([ratio(large, thin)?, ratio(small, thick)?])
}

/// Least and largest thickness as they are given.
enum Thickness {
    None,
    Ratios([ExactNumber; 2]),
    Lengths([Length; 2]),
}

impl Thickness {
    fn ratios(self) -> Option<[ExactNumber; 2]> {
        match self {
            Self::Ratios(ratios) => Some(ratios),
            Self::None | Self::Lengths(_) => None,
        }
    }
}

/// Thicknesses of both ends, beside the measures of two arches where there are any.
fn thickness(
    ends: &[ArchAsked; 2],
    measures: Option<&[Measures; 2]>,
    spelling: Spelling,
) -> Result<Thickness, Misfit> {
    if let (Some(lengths), Some(_)) = (of_lengths(ends), measures) {
        return ordered(ends, lengths, Field::Thickness).map(Thickness::Lengths);
    }
    let read = |end: usize| {
        let measures = measures.map(|of| &of[end]);
        let text = ends[end].thickness.as_deref();
        text.map(|text| given_thickness(text, measures, spelling)).transpose()
    };
    let (Some(low), Some(high)) = (read(0)?, read(1)?) else { return Ok(Thickness::None) };
    let [first, last] = ends.each_ref().map(|end| length(end, Field::Thickness).is_some());
    match first == last {
        true => Ok(Thickness::Ratios([low, high])),
        false => Err(Misfit::new(
            Field::Thickness,
            "one end of the thickness is a length and the other a ratio: give two of a kind (50cm..60cm, 0.1r..0.12r)",
        )),
    }
}

/// Length of a field, if it is one.
fn length(asked: &ArchAsked, field: Field) -> Option<Length> {
    asked.get(field)?.parse().ok()
}

/// Both thicknesses, if both are lengths.
fn of_lengths([low, high]: &[ArchAsked; 2]) -> Option<[Length; 2]> {
    Some([length(low, Field::Thickness)?, length(high, Field::Thickness)?])
}

/// Lengths of a field, the least first; none if it is not given.
fn lengths(ends: &[ArchAsked; 2], field: Field) -> Result<Option<[Length; 2]>, Misfit> {
    let [low, high] = ends.each_ref().map(|end| read::<Length>(end, field));
    let (Some(low), Some(high)) = (low?, high?) else { return Ok(None) };
    ordered(ends, [low, high], field).map(Some)
}

/// Lengths of a field, if the first is not above the last.
fn ordered(
    ends: &[ArchAsked; 2],
    [low, high]: [Length; 2],
    field: Field,
) -> Result<[Length; 2], Misfit> {
    if !low.exceeds(&high) {
        return Ok([low, high]);
    }
    let [low, high] = ends.each_ref().map(|end| shown(end.get(field).unwrap_or_default()));
    Err(Misfit::new(field, SurveyError::Reversed(low, high)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::survey::Side;

    const ASSESS: ArchQuestion =
        ArchQuestion { refuses: &[], needs: &[Field::Thickness], unlimited: false, example: "" };

    fn asked(words: &str) -> ArchAsked {
        let pairs = words.split_whitespace().map(|pair| pair.split_once('=').unwrap());
        ArchAsked::of(pairs.map(|(name, text)| (Field::named(name).unwrap(), text)))
    }

    fn read(words: &str) -> Result<SurveyGiven, Misfit> {
        SurveyGiven::read(&ASSESS, &asked(words), Spelling::Key)
    }

    #[test]
    fn a_length_that_would_take_minutes_is_refused() {
        let of = |zeros: usize| {
            let long = format!("1.{}1m", "0".repeat(zeros));
            read(&format!("span={long}..2m rise=1m mu=1 eta=10cm..20cm"))
        };
        assert!(of(200).is_ok());
        let misfit = of(400).unwrap_err();
        assert_eq!(misfit.field, Some(Field::Span));
        assert!(misfit.message.contains("at most 300 characters"), "{misfit}");
    }

    /// The questions about the arches that decide where half opening and thickness are free.
    fn corners(words: &str) -> [String; 2] {
        let given = read(words).unwrap();
        let survey = given.survey(SelfWeight::Heyman).unwrap();
        [Side::Unsafe, Side::Safe].map(|side| {
            let corner = survey.corner(side).unwrap();
            let one = given.one(&corner.arch, corner.thickness.as_ref(), None);
            // It is that arch.
            let read = super::super::ArchGiven::new(&one, Spelling::Option).unwrap();
            let arch = read.arch(SelfWeight::Heyman).unwrap();
            assert_eq!((&arch, &read.thickness), (&corner.arch, &corner.thickness));
            one.options()
        })
    }

    #[test]
    fn the_arches_that_decide_are_asked_for_in_the_words_of_the_question() {
        let of = |worst: &str, best: &str| [worst.to_owned(), best.to_owned()];
        assert_eq!(
            corners("alpha=80deg±1deg mu=0.6±10% eta=0.1..0.12"),
            of(
                " --half-opening 81deg --friction 0.54 --thickness 0.1",
                " --half-opening 79deg --friction 0.66 --thickness 0.12"
            )
        );
        assert_eq!(
            corners("span=10m±2cm rise=3m±1cm eta=0.1r phi=31deg..32deg measured_at=extrados"),
            of(
                " --friction-angle 31deg --thickness 0.1r --span 9.98m --rise 3.01m --measured-at extrados",
                " --friction-angle 32deg --thickness 0.1r --span 10.02m --rise 2.99m --measured-at extrados"
            )
        );
        assert_eq!(
            corners("radius=5m±1cm alpha=1 eta=50cm±1cm mu=0.5..inf"),
            of(
                " --half-opening 1 --friction 0.5 --thickness 49cm --radius 5.01m",
                " --half-opening 1 --friction inf --thickness 51cm --radius 4.99m"
            )
        );
        assert_eq!(
            corners("span=10m rise=3m eta=60cm mu=0.5±0.1"),
            of(
                " --friction 0.4 --thickness 60cm --span 10m --rise 3m",
                " --friction 0.6 --thickness 60cm --span 10m --rise 3m"
            )
        );
    }

    #[test]
    fn measured_spans_rises_and_thicknesses_are_lengths() {
        let given = read("span=33ft±1in rise=3m eta=60cm±2cm mu=0.6").unwrap();
        assert!(matches!(given.shape, Shape::Spanned { .. }));
        let arch = Arch::parse("heyman", "1", "0.6").unwrap();
        let [span, rise, t] = ["10.05m", "300cm", "0.58m"].map(|x| x.parse().unwrap());
        let one = given.one(&arch, None, Some(&[span, rise, t]));
        assert_eq!(one.options(), " --friction 0.6 --thickness 58cm --span 10.05m --rise 3m");
        let one = given.one(&arch, Some(&"1/10".parse().unwrap()), None);
        assert_eq!(one.options(), " --half-opening 1 --friction 0.6 --thickness 1/10");
        let [narrow, wide] = given.half_opening();
        assert!(in_order(&[narrow, wide]).is_ok());
    }

    #[test]
    fn what_makes_no_range_of_arches_is_refused_with_its_field() {
        use Field as F;
        for (words, field, why) in [
            ("alpha=1..2 eta=0.1", None, "friction (or friction_angle) is missing"),
            ("alpha=1..2 mu=1", None, "thickness is missing"),
            (
                "alpha=1..2 mu=1 eta=0.1 stones=3",
                Some(F::Stones),
                "stones does not go with the range of half_opening",
            ),
            ("alpha=1..2 mu=1 eta=0.1 tilt=0.1", Some(F::Tilt), "level ground"),
            ("alpha=1 mu=1 eta=0.1 tilt=0.1..0.2", Some(F::Tilt), "level ground"),
            ("joints=0,1..2 mu=1 eta=0.1", Some(F::Joints), "a joint at every angle"),
            (
                "alpha=1 radius=5m..6m mu=1 eta=1m density=24kN/m3 depth=1m",
                Some(F::Density),
                "no forces",
            ),
            ("alpha=80..82deg mu=1 eta=0.1", Some(F::HalfOpening), "write 80deg..82deg"),
            (
                "alpha=82deg..80deg mu=1 eta=0.1",
                Some(F::HalfOpening),
                "82deg..80deg is empty: give the lower end first",
            ),
            (
                "alpha=90deg..180deg mu=1 eta=0.1",
                Some(F::HalfOpening),
                "180deg is not between 0 and pi",
            ),
            ("alpha=1 mu=0.7..0.6 eta=0.1", Some(F::Friction), "0.7..0.6 is empty"),
            ("alpha=1 mu=0.1±0.2 eta=0.1", Some(F::Friction), "the friction -0.1 is negative"),
            (
                "alpha=1 phi=89deg±2deg eta=0.1",
                Some(F::FrictionAngle),
                "91deg is not between 0 and pi/2",
            ),
            ("alpha=1 phi=32deg..31deg eta=0.1", Some(F::FrictionAngle), "is empty"),
            ("alpha=1 mu=1 eta=0.2..0.1", Some(F::Thickness), "0.2..0.1 is empty"),
            ("alpha=1 mu=1 eta=1.9±10%", Some(F::Thickness), "2.09 is not between 0 and 2"),
            ("alpha=1 mu=1 eta=50cm..60cm", Some(F::Thickness), "50cm is a length"),
            (
                "span=10m±1cm rise=3m mu=1 eta=50..60",
                Some(F::Thickness),
                "the thickness 50 has no unit",
            ),
            ("span=10m±1cm rise=3m mu=1 eta=0.1r..60cm", Some(F::Thickness), "two of a kind"),
            ("span=10m±1cm rise=3m mu=1 eta=60cm..50cm", Some(F::Thickness), "60cm..50cm is empty"),
            (
                "span=10m±1cm rise=3m mu=1 eta=5.5m±1m measured_at=extrados",
                Some(F::Thickness),
                "too large for this extrados",
            ),
            ("span=11m..10m rise=3m mu=1 eta=60cm", Some(F::Span), "11m..10m is empty"),
            ("span=1m±2m rise=3m mu=1 eta=60cm", Some(F::Span), "-1m is not above 0"),
            ("span=10m±1cm rise=3 mu=1 eta=60cm", Some(F::Rise), "is not a length"),
            ("span=10m±1cm rise=3m radius=5m mu=1 eta=60cm", Some(F::Radius), "it follows"),
            ("radius=6m..5m alpha=1 mu=1 eta=60cm", Some(F::Radius), "is empty"),
            (
                "radius=5m..6m alpha=1 mu=1 eta=6m measured_at=extrados",
                Some(F::Thickness),
                "at most 5 m",
            ),
            (
                "span=10m±1cm rise=3m mu=1 eta=60cm measured_at=top",
                Some(F::MeasuredAt),
                "one of intrados",
            ),
        ] {
            let misfit = read(words).unwrap_err();
            assert_eq!(misfit.field, field, "{words}: {misfit}");
            assert!(misfit.message.contains(why), "{words}: {misfit}");
        }
    }

    /// The range of one arch is that arch.
    #[test]
    fn a_range_without_extent_is_one_arch() {
        let given = read("alpha=1..1 mu=0.6±0 eta=0.1±0%").unwrap();
        let survey = given.survey(SelfWeight::Milankovitch).unwrap();
        assert_eq!(survey.corner(Side::Unsafe), survey.corner(Side::Safe));
    }
}
