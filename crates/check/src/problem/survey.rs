//! All arches of a survey: each measure between two exact ends, both of which are in it.
//!
//! What an arch stands on asks for something at each of its joints, and a joint's demands know neither the springings
//! nor the other joints. So of two arches
//!
//! - the one with the wider half opening has the other's joints and more;
//! - the one with the lower friction has the narrower cone at each of them;
//! - the thinner one has its faces nearer together, up to the physical limit `eta = 2`.
//!
//! A state that is admissible in it is so in the other (the claim `survey-corners`). In a box of half openings,
//! frictions and thicknesses the widest, least rough and thinnest arch decides whether all stand, its opposite whether
//! any does.
//!
//! Where span, rise and thickness are measured half opening and ratio go against each other: with the span grows the
//! radius, which makes the ratio of the thickness less, and falls the half opening. Still a corner decides, the
//! shortest span with the highest rise, or the longest with the lowest (the claim `survey-worst`).
//!
//! A certificate does without that claim: an arch does not change with its scale. With `q = 2 rise/span` the half
//! opening is `2 atan(q)` and rises with `q` alone; and on a ray of one `q` the largest arch has the least `eta`. So
//! the arches to look at lie on one **course** from the least `q` to the largest, along the outer edges of the
//! rectangle of spans and rises; and those that stand most easily along its inner edges. On a step of the course the
//! half opening rises and the radius `(s²/4 + f²)/(2f)` is convex in the rise and rises with the span: so one arch is
//! at least as unsafe as all of the step.

use super::length::exceeds;
use super::measures::{Circle, Length, MeasureError, Measures, circle, of_span_and_rise, radii};
use super::{Arch, ArchError, Friction, is_thickness};
use crate::arch::SelfWeight;
use crate::number::{AstroInterval, Enclosure, ExactNumber, Ternary, says, worded};
use num_bigint::BigInt;
use num_rational::BigRational;

/// All arches of one self-weight between measured ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Survey {
    weight: SelfWeight,
    friction: [Friction; 2],
    shape: Shape,
}

/// Geometry that the arches of a survey have in common.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Half opening and thickness are given each for itself.
    Free {
        /// Least and largest half opening, rad.
        half_opening: [ExactNumber; 2],
        /// Least and largest ratio of thickness to radius; none if the thickness is what is asked for.
        thickness: Option<[ExactNumber; 2]>,
    },
    /// Span, rise and thickness are measured, and make half opening and ratio together.
    Spanned {
        /// Circle at which span and rise are measured.
        circle: Circle,
        /// Least and largest span.
        span: [Length; 2],
        /// Least and largest rise.
        rise: [Length; 2],
        /// Least and largest thickness.
        thickness: [Length; 2],
    },
}

worded! {
    /// Side of a survey.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Side {
        /// Where arches stand least easily: if they do there, all do.
        Unsafe = "unsafe",
        /// Where arches stand most easily: if they do not there, none does.
        Safe = "safe",
    }
    /// Both of them.
    pub const ALL;
    /// Name of the side in files.
    pub fn name -> &'static str;
}

worded! {
    /// Verdict on all arches of a survey. An arch stands if an admissible symmetric state exists.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum SurveyVerdict {
        /// Each of them stands.
        AllStand = "all_stand",
        /// No one of them stands.
        NoneStands = "none_stands",
        /// At least one stands, and at least one does not.
        BothOccur = "both_occur",
    }
    /// All verdicts.
    pub const ALL;
    /// Name of the verdict in files.
    pub fn name -> &'static str;
}

/// Span and rise, a corner of a course.
pub type SpanAndRise = [BigRational; 2];

/// Arch of a survey, or one that is at least as safe or as unsafe as some of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bounding {
    /// Weight, half opening and friction.
    pub arch: Arch,
    /// Ratio of thickness to radius; none if the thickness is what is asked for.
    pub thickness: Option<ExactNumber>,
}

/// Reason why a survey is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SurveyError {
    /// A range whose first end is above its last.
    Reversed(String, String),
    /// A range whose ends could not be told apart.
    Open(String, String),
    /// An end that is not that of an arch.
    Arch(ArchError),
    /// A ratio of thickness to radius that is not above 0 and at most 2.
    Thickness(String),
    /// Measures that make no arch.
    Measures(MeasureError),
}

says!(SurveyError {
    Self::Reversed(first, last) => "the range {first}..{last} is empty: give the lower end first";
    Self::Open(first, last) => "which of {first} and {last} is larger stays open";
    Self::Thickness(text) => "the thickness {text} is not between 0 and 2";
} from {
    ArchError => Self::Arch;
    MeasureError => Self::Measures;
});

impl Side {
    /// The one of two that decides on this side.
    fn of<T>(self, [least_safe, safest]: [T; 2]) -> T {
        match self {
            Self::Unsafe => least_safe,
            Self::Safe => safest,
        }
    }
}

impl SurveyVerdict {
    /// The verdict in a sentence.
    pub const fn sentence(self) -> &'static str {
        match self {
            Self::AllStand => "every arch stands",
            Self::NoneStands => "no arch stands",
            Self::BothOccur => "some arches stand, others do not",
        }
    }
}

impl Survey {
    /// The arches between these ends, if each range has its lower end first and every arch of it is one.
    pub fn new(
        weight: SelfWeight,
        friction: [Friction; 2],
        shape: Shape,
    ) -> Result<Self, SurveyError> {
        let friction = friction.map(|friction| friction.checked(false));
        let [lower, upper] = friction;
        let friction = [lower?, upper?];
        frictions_in_order(&friction)?;
        match &shape {
            Shape::Free { half_opening, thickness } => {
                in_order(half_opening)?;
                for alpha in half_opening {
                    Arch::new_with(weight, alpha.clone(), Friction::Infinite, false)?;
                }
                if let Some(range) = thickness {
                    in_order(range)?;
                    if let Some(eta) = range.iter().find(|eta| !is_thickness(eta)) {
                        return Err(SurveyError::Thickness(eta.to_string()));
                    }
                }
            }
            Shape::Spanned { circle, span, rise, thickness } => {
                for [lower, upper] in [span, rise, thickness] {
                    if lower.exceeds(upper) {
                        let [lower, upper] = [lower, upper].map(ToString::to_string);
                        return Err(SurveyError::Reversed(lower, upper));
                    }
                }
                let [radius, _] = radii(span, rise);
                Measures::new(*circle, radius, None).thickness(&thickness[1])?;
            }
        }
        Ok(Self { weight, friction, shape })
    }

    /// The self-weight model.
    pub fn weight(&self) -> SelfWeight {
        self.weight
    }

    /// Least and largest friction.
    pub fn friction(&self) -> &[Friction; 2] {
        &self.friction
    }

    /// Geometry that the arches have in common.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Least and largest half opening, rad: that of the lowest arch of the longest span, and of the highest of the
    /// shortest.
    pub fn half_opening(&self) -> [ExactNumber; 2] {
        match &self.shape {
            Shape::Free { half_opening, .. } => half_opening.clone(),
            Shape::Spanned { span: [short, long], rise: [low, high], .. } => {
                [(long, low), (short, high)].map(|(span, rise)| of_span_and_rise(span, rise).0)
            }
        }
    }

    /// The arch that decides on a side, where half opening and thickness are free of each other.
    pub fn corner(&self, side: Side) -> Option<Bounding> {
        let Shape::Free { half_opening: [narrow, wide], thickness } = &self.shape else {
            return None;
        };
        let thickness = thickness.clone().map(|range| side.of(range));
        Some(Bounding { arch: self.arch(side.of([wide, narrow]).clone(), side)?, thickness })
    }

    /// Corners of the course on a side, from the least `q` to the largest, where span, rise and thickness are measured;
    /// two neighbours differ in one of span and rise.
    pub fn course(&self, side: Side) -> Option<[SpanAndRise; 3]> {
        let Shape::Spanned { span, rise, .. } = &self.shape else { return None };
        let [[short, long], [low, high]] =
            [span, rise].map(|range| range.each_ref().map(|x| x.metres().clone()));
        let middle = side.of([[&long, &high], [&short, &low]]).map(BigRational::clone);
        Some([[long, low], middle, [short, high]])
    }

    /// Span and rise of the arch that decides on a side, where they are measured: the shortest span with the highest
    /// rise, or the longest with the lowest. If the unsafe arch stands, all do; if the safe one does not, none does
    /// (the claim `survey-worst`).
    pub fn decisive(&self, side: Side) -> Option<SpanAndRise> {
        let [lowest, _, highest] = self.course(side)?;
        Some(side.of([highest, lowest]))
    }

    /// Tells whether a step, given by its ends, lies on one leg of the course on a side and goes its way.
    pub fn has_step(&self, side: Side, [first, last]: [&SpanAndRise; 2]) -> bool {
        let is_on = |leg: &[SpanAndRise]| {
            (0..2).all(|i| are_in_turn([&leg[0][i], &first[i], &last[i], &leg[1][i]]))
        };
        self.course(side).is_some_and(|course| course.windows(2).any(is_on))
    }

    /// An arch at least as unsafe, or as safe, as all of a side's friction and thickness on the step from `first` to
    /// `last` of its course; if the two are one, the arch that is there.
    pub fn bounding(&self, side: Side, [first, last]: [&SpanAndRise; 2]) -> Option<Bounding> {
        let ends = [first, last].map(|[span, rise]| circle(span, rise));
        let radii = [&ends[0][1], &ends[1][1]];
        let radius = Length::new(Self::radius(side, [first, last], radii));
        let [[at_first, _], [at_last, _]] = ends;
        let tangent = side.of([at_last, at_first]);
        self.spanned(ExactNumber::twice_arctangent(tangent), radius, side)
    }

    /// Largest radius on a step of the unsafe course, least of one on the safe course, at the measured circle, by those
    /// at its ends.
    fn radius(
        side: Side,
        [first, last]: [&SpanAndRise; 2],
        [one, other]: [&BigRational; 2],
    ) -> BigRational {
        let [least, largest] = if exceeds(one, other) { [other, one] } else { [one, other] };
        match side {
            Side::Unsafe => largest.clone(),
            Side::Safe => {
                let half = &first[0] / BigInt::from(2);
                let has_least = is_same(&first[0], &last[0])
                    && exceeds(&half, &first[1])
                    && exceeds(&last[1], &half);
                if has_least { half } else { least.clone() }
            }
        }
    }

    /// Arch of the half opening and friction that are least safe, or safest, of all, with the largest, or least, radius
    /// at the measured circle: every arch of the survey is at least as safe, or as unsafe, and narrower, or wider,
    /// though this one need not be of them.
    pub fn beyond(&self, side: Side) -> Option<Bounding> {
        let Shape::Spanned { span, rise, .. } = &self.shape else { return None };
        let ([narrow, wide], [small, large]) = (self.half_opening(), radii(span, rise));
        let (alpha, radius) = side.of([(wide, large), (narrow, small)]);
        self.spanned(alpha, radius, side)
    }

    /// Thickness of the arches that decide on a side, where it is measured, and the circle.
    pub fn thickness_at(&self, side: Side) -> Option<(Circle, &Length)> {
        let Shape::Spanned { circle, thickness, .. } = &self.shape else { return None };
        Some((*circle, side.of(thickness.each_ref())))
    }

    /// Span, rise and thickness of the arch at a place of a side's course.
    pub fn measured(&self, side: Side, at: &SpanAndRise) -> Option<[Length; 3]> {
        let (_, thickness) = self.thickness_at(side)?;
        let [span, rise] = at.clone().map(Length::new);
        Some([span, rise, thickness.clone()])
    }

    fn arch(&self, half_opening: ExactNumber, side: Side) -> Option<Arch> {
        Arch::new_with(self.weight, half_opening, side.of(self.friction.clone()), false).ok()
    }

    /// Arch of a half opening and of a radius at the measured circle, with the friction and the thickness of a side.
    fn spanned(&self, half_opening: ExactNumber, radius: Length, side: Side) -> Option<Bounding> {
        let (circle, thickness) = self.thickness_at(side)?;
        let thickness = Measures::new(circle, radius, None).thickness(thickness).ok()?;
        Some(Bounding { arch: self.arch(half_opening, side)?, thickness: Some(thickness) })
    }
}

/// Tells whether two places are one.
pub(crate) fn is_one_place(a: &SpanAndRise, b: &SpanAndRise) -> bool {
    is_same(&a[0], &b[0]) && is_same(&a[1], &b[1])
}

/// Tells whether two numbers are one in the same form. Their own equality is that of their texts.
pub fn is_one_number(a: &ExactNumber, b: &ExactNumber) -> bool {
    a.form() == b.form() && is_same(a.factor(), b.factor())
}

/// Tells whether two frictions are one in the same form.
pub fn is_one_friction(a: &Friction, b: &Friction) -> bool {
    match (a, b) {
        (Friction::Coefficient(a), Friction::Coefficient(b))
        | (Friction::Angle(a), Friction::Angle(b)) => is_one_number(a, b),
        (Friction::Infinite, Friction::Infinite) => true,
        _ => false,
    }
}

/// Tells whether two rational numbers are one, in lowest terms or not.
pub(crate) fn is_same(a: &BigRational, b: &BigRational) -> bool {
    !exceeds(a, b) && !exceeds(b, a)
}

/// Tells whether numbers rise all the way or fall all the way; of neighbours some may be the same.
fn are_in_turn(numbers: [&BigRational; 4]) -> bool {
    let mut pairs = numbers.windows(2);
    pairs.clone().all(|pair| !exceeds(pair[0], pair[1]))
        || pairs.all(|pair| !exceeds(pair[1], pair[0]))
}

/// Checks that the first end is not above the last; open if they cannot be told apart.
pub fn in_order([first, last]: &[ExactNumber; 2]) -> Result<(), SurveyError> {
    let texts = || (first.to_string(), last.to_string());
    let is_in_order = if first.form() == last.form() {
        !exceeds(first.factor(), last.factor())
    } else {
        let at = |x: &ExactNumber, bits| x.enclosure::<AstroInterval>(bits);
        compared(|bits| at(last, bits) - at(first, bits), texts)?
    };
    match is_in_order {
        true => Ok(()),
        false => Err(SurveyError::Reversed(texts().0, texts().1)),
    }
}

/// Checks that the first friction is not above the last; open if they cannot be told apart.
pub fn frictions_in_order([first, last]: &[Friction; 2]) -> Result<(), SurveyError> {
    match (first, last) {
        (_, Friction::Infinite) => Ok(()),
        (Friction::Coefficient(first), Friction::Coefficient(last))
        | (Friction::Angle(first), Friction::Angle(last)) => {
            in_order(&[first.clone(), last.clone()])
        }
        _ => {
            let texts = || (first.to_string(), last.to_string());
            if *first == Friction::Infinite {
                return Err(SurveyError::Reversed(texts().0, texts().1));
            }
            let cone = |bits| {
                let [low, high] = [first, last].map(|x| x.grip::<AstroInterval>(bits));
                high.normal * low.shear - low.normal * high.shear
            };
            match compared(cone, texts)? {
                true => Ok(()),
                false => Err(SurveyError::Reversed(texts().0, texts().1)),
            }
        }
    }
}

/// Most bits in which two ends of a range are compared.
const MOST_BITS: u32 = 4096;

/// Sign of a difference, in as many bits as it takes.
fn compared(
    difference: impl Fn(u32) -> AstroInterval,
    texts: impl Fn() -> (String, String),
) -> Result<bool, SurveyError> {
    let bits = std::iter::successors(Some(128), |bits| Some(bits * 2));
    for bits in bits.take_while(|bits| *bits <= MOST_BITS) {
        match difference(bits).is_positive() {
            Ternary::True => return Ok(true),
            Ternary::False => return Ok(false),
            Ternary::Undecided => {}
        }
    }
    Err(SurveyError::Open(texts().0, texts().1))
}

#[cfg(test)]
mod tests;
