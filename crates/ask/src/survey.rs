//! The reader of what is given of all arches between two ends.

use super::arc::{arc, of_chord};
use super::asked::{ArchAsked, Field, read};
use super::given::{circle, friction, given_thickness};
use super::question::{ArchQuestion, Misfit, Spelling};
use super::stones::StonesAsked;
use crate::arch::SelfWeight;
use crate::number::{ExactNumber, decimal, shown};
use crate::problem::measures::{Circle, Length, Measures, UnitWeight, of_span_and_rise, radii};
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
    /// Measures with the least radius and load, and with the largest, where the arches are measured.
    pub sizes: Option<[Measures; 2]>,
    /// Stones of every one of them, if the joints are between them alone.
    pub stones: Option<Stones>,
    /// Texts of the lower ends and of the upper ends.
    ends: [ArchAsked; 2],
}

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
        if asked.tilt.is_some() {
            let (name, range) =
                (spelling.of(Field::Tilt), asked.ranges().find(|of| *of != Field::Tilt));
            let range = range
                .map_or("a range".to_owned(), |of| format!("the range of {}", spelling.of(of)));
            let message = format!(
                "{name} does not go with {range}: a range of arches is told of on level ground"
            );
            return Err(Misfit::new(Field::Tilt, message));
        }
        let stones = StonesAsked::of_ranges(asked, spelling)?;
        let ends = asked.ends()?;
        let circle = circle(asked)?;
        let [low, high] = ends.each_ref().map(|end| {
            let any = || is_unlimited.then_some(Friction::Infinite);
            let missing = || Misfit::new(Field::Friction, "the friction is missing");
            friction(end)?.or_else(any).ok_or_else(missing)
        });
        let usual = match &stones {
            Some(StonesAsked::Joints(stones)) => stones.half_opening().clone(),
            _ => ExactNumber::rational(BigInt::from(1).into()),
        };
        let friction = [low?, high?];
        let (shape, radii) = shape(&ends, usual, circle, spelling)?;
        let [light, heavy] = loads(&ends)?;
        let sizes = radii.map(|[small, large]| {
            [(small, light), (large, heavy)].map(|(of, load)| Measures::new(circle, of, load))
        });
        let mut given = Self { friction, shape, sizes, stones: None, ends };
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

    /// Least and largest `w r` in kN over the arches, if forces are told: it grows with radius and thickness, which is
    /// the one given, else between two ratios to the radius.
    pub fn forces(&self, ratios: Option<[ExactNumber; 2]>) -> Option<[ExactNumber; 2]> {
        let [small, large] = self.sizes.as_ref()?;
        let [thin, thick] = match (of_lengths(&self.ends), &self.shape) {
            (Some([thin, thick]), _) => {
                [small.thickness(&thin).ok()?, large.thickness(&thick).ok()?]
            }
            (None, Shape::Free { thickness: Some(ratios), .. }) => ratios.clone(),
            (None, _) => ratios?,
        };
        Some([small.exact_force(&thin)?, large.exact_force(&thick)?])
    }

    /// Question about one of the arches: in the texts of the ends that it has, else in exact numbers. `measured` are
    /// its span, rise and thickness, where these are measured.
    pub fn one(
        &self,
        arch: &Arch,
        thickness: Option<&ExactNumber>,
        measured: Option<&[Length; 3]>,
    ) -> ArchAsked {
        let low = &self.ends[0];
        let mut one = low.clone();
        match self.friction.iter().position(|friction| friction == arch.friction()) {
            Some(end) => {
                one.friction.clone_from(&self.ends[end].friction);
                one.friction_angle.clone_from(&self.ends[end].friction_angle);
            }
            None => {
                (one.friction, one.friction_angle) = (Some(arch.friction().to_string()), None);
            }
        }
        if let Some(measured) = measured {
            let fields = [Field::Span, Field::Rise, Field::Thickness];
            for (field, length) in fields.into_iter().zip(measured) {
                let is_it = |text: &&str| text.parse().ok().as_ref() == Some(length);
                let said = self.ends.iter().filter_map(|end| end.get(field)).find(is_it);
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
                one.rise.clone_from(&self.ends[end].rise);
                // Of one rise the narrow arch has the longer span, of one radius the shorter.
                let of_chord = is_chord(low);
                one.span.clone_from(&self.ends[if of_chord { end } else { 1 - end }].span);
                if of_chord {
                    one.radius.clone_from(&self.ends[1 - end].radius);
                }
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

/// Geometry that the arches have in common, with the least and the largest radius where they are measured; of no half
/// opening that is given, or made, they have the `usual` one.
fn shape(
    ends: &[ArchAsked; 2],
    usual: ExactNumber,
    circle: Circle,
    spelling: Spelling,
) -> Result<(Shape, Option<[Length; 2]>), Misfit> {
    let [span, rise, radius] = MEASURES.map(|field| lengths(ends, field));
    let (span, rise, radius) = (span?, rise?, radius?);
    let is_one =
        |ends: &Option<[Length; 2]>| ends.as_ref().is_none_or(|[low, high]| !high.exceeds(low));
    let [low, high] = ends;
    let is_one_arc =
        [&span, &rise, &radius].into_iter().all(is_one) && low.half_opening == high.half_opening;
    let (half_opening, radius) = match (&span, &rise, radius) {
        _ if is_one_arc => {
            let joints = low.joints.is_some().then(|| usual.clone());
            let alpha = joints.map_or_else(|| read(low, Field::HalfOpening), |x| Ok(Some(x)))?;
            let (alpha, radius) = arc(low, alpha, spelling)?;
            let alpha = alpha.unwrap_or(usual);
            ([alpha.clone(), alpha], radius.map(|radius| [radius.clone(), radius]))
        }
        (None, None, radius) => {
            let alpha = |end| {
                let given = read::<ExactNumber>(end, Field::HalfOpening)?;
                Ok::<_, Misfit>(given.unwrap_or_else(|| usual.clone()))
            };
            ([alpha(low)?, alpha(high)?], radius)
        }
        (Some(span), Some(rise), None) if low.half_opening.is_none() => {
            let (made, radii) = (made(span, rise), Some(radii(span, rise)));
            if let Some(thickness) = of_lengths(ends) {
                let thickness = ordered(ends, thickness, Field::Thickness)?;
                short(ends)?;
                let (span, rise) = (span.clone(), rise.clone());
                return Ok((Shape::Spanned { circle, span, rise, thickness }, radii));
            }
            let of = made.clone().map(|(_, radius)| Measures::new(circle, radius, None));
            let thickness = thickness(ends, Some(&of), spelling)?;
            let half_opening = made.map(|(alpha, _)| alpha);
            return Ok((Shape::Free { half_opening, thickness }, radii));
        }
        // The narrow arch has the larger radius.
        (span, rise, Some([small, large])) if is_chord(low) => {
            if large.exceeds(&small) && of_lengths(ends).is_some() {
                let [span, rise] = [Field::Span, Field::Rise].map(|field| spelling.of(field));
                let message = format!(
                    "beside a range of radii the thickness is a ratio (0.1r..0.12r), or the arch has {span} and {rise}"
                );
                return Err(Misfit::new(Field::Thickness, message));
            }
            let end = |k: usize, radius: &Length| {
                let chord = [span, rise].map(|ends| ends.as_ref().map(|ends| &ends[k]));
                Ok::<_, Misfit>(of_chord(chord, radius)?.unwrap_or_else(|| usual.clone()))
            };
            ([end(0, &large)?, end(1, &small)?], Some([small, large]))
        }
        _ => {
            let [alpha, span, rise, radius] =
                [Field::HalfOpening, Field::Span, Field::Rise, Field::Radius]
                    .map(|field| spelling.of(field));
            let message = format!(
                "of a range an arch has {span} and {rise}, or {radius} and one of {span}, {rise} and {alpha}: the rest \
                 follows"
            );
            return Err(Misfit::new(Field::Radius, message));
        }
    };
    let of = radius.clone().map(|ends| ends.map(|radius| Measures::new(circle, radius, None)));
    let thickness = match (of_lengths(ends), &radius) {
        (Some(lengths), Some(radius)) => {
            let lengths = ordered(ends, lengths, Field::Thickness)?;
            Some(ratios(lengths, radius.clone(), circle)?)
        }
        _ => thickness(ends, of.as_ref(), spelling)?,
    };
    Ok((Shape::Free { half_opening, thickness }, radius))
}

/// Tells whether the half opening of an arch is that of a radius and a span or a rise.
fn is_chord(asked: &ArchAsked) -> bool {
    asked.half_opening.is_none()
        && asked.radius.is_some()
        && asked.span.is_some() != asked.rise.is_some()
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

/// Thickness ratios of both ends, beside the measures of two arches where there are any.
fn thickness(
    ends: &[ArchAsked; 2],
    measures: Option<&[Measures; 2]>,
    spelling: Spelling,
) -> Result<Option<[ExactNumber; 2]>, Misfit> {
    let read = |end: usize| {
        let measures = measures.map(|of| &of[end]);
        let text = ends[end].thickness.as_deref();
        text.map(|text| given_thickness(text, measures, spelling)).transpose()
    };
    let (Some(low), Some(high)) = (read(0)?, read(1)?) else { return Ok(None) };
    let [first, last] = ends.each_ref().map(|end| length(end, Field::Thickness).is_some());
    match first == last {
        true => Ok(Some([low, high])),
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

/// Weight of a volume and depth at both ends, the least first; none if they are not given.
fn loads(ends: &[ArchAsked; 2]) -> Result<[Option<(UnitWeight, Length)>; 2], Misfit> {
    let [light, heavy] = ends.each_ref().map(|end| read::<UnitWeight>(end, Field::Density));
    let ((light, heavy), depths) = ((light?, heavy?), lengths(ends, Field::Depth)?);
    if let Some((light, heavy)) = light.as_ref().zip(heavy.as_ref())
        && light.exceeds(heavy)
    {
        return Err(empty(ends, Field::Density));
    }
    let [shallow, deep] = depths.map_or([None, None], |depths| depths.map(Some));
    Ok([light.zip(shallow), heavy.zip(deep)])
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
    if low.exceeds(&high) { Err(empty(ends, field)) } else { Ok([low, high]) }
}

/// Reason why a range whose first end is above its last is refused.
fn empty(ends: &[ArchAsked; 2], field: Field) -> Misfit {
    let [low, high] = ends.each_ref().map(|end| shown(end.get(field).unwrap_or_default()));
    Misfit::new(field, SurveyError::Reversed(low, high))
}

#[cfg(test)]
mod tests;
