//! The certificate of a survey as a file: JSON, `couplet.survey-certificate/1`, described in `docs/certificate.md`.

use super::format::{Certificate, read_json};
use super::given::{friction_text, given_text, read_friction, read_given};
use super::record::{Entries, Entry, record};
use super::refusal::Refusal;
use super::survey_refusal::SurveyRefusal;
use super::visible::{beginning, shortened};
use crate::arch::SelfWeight;
use crate::number::ExactNumber;
use crate::problem::measures::{Circle, Length};
use crate::problem::survey::{Shape, Side, SpanAndRise, Survey, SurveyVerdict};
use num_bigint::BigInt;
use num_rational::BigRational;
use serde::{Deserializer, Serialize, Serializer};
use std::io;
use std::marker::PhantomData;

/// The schema of this version.
pub const SURVEY_SCHEMA: &str = "couplet.survey-certificate/1";
/// Schemas of surveys begin with this.
pub(super) const SURVEYS: &str = "couplet.survey-certificate/";
/// The most parts that are read.
pub const MAX_PARTS: usize = 4096;
/// Digits of an integer of a length: the arches of a course are computed from them.
pub const MAX_LENGTH_DIGITS: usize = 300;

record! {
    /// A certificate of a survey: a verdict on all of its arches, and certificates of those that decide it.
    pub struct SurveyCertificate {
        /// [`SURVEY_SCHEMA`].
        pub schema: String,
        /// Tool that made it, with the version; not checked.
        pub tool: String,
        /// All arches that are meant.
        pub survey: SurveyFile,
        /// `all_stand`, `none_stands` or `both_occur`.
        pub verdict: String,
        /// The arches that decide it.
        pub parts: Parts,
    }
}

record! {
    /// A survey: what its arches have in common, and exactly one of two shapes.
    pub struct SurveyFile {
        /// `heyman` or `milankovitch`.
        pub weight: String,
        /// Least and largest friction, each as in [`ArchFile`](super::ArchFile).
        pub friction: Vec<String>,
        /// Half opening and thickness, given each for itself.
        pub free: Option<FreeFile>,
        /// Span, rise and thickness in metres.
        pub spanned: Option<SpannedFile>,
    }
}

record! {
    /// Ranges of half opening and thickness.
    pub struct FreeFile {
        /// Least and largest half opening, each as in [`ArchFile`](super::ArchFile).
        pub half_opening: Vec<String>,
        /// Least and largest ratio of thickness to radius, fractions of integers.
        pub thickness: Vec<String>,
    }
}

record! {
    /// Ranges of lengths: fractions of integers, in metres.
    pub struct SpannedFile {
        /// `intrados`, `centreline` or `extrados`: where span and rise are measured.
        pub circle: String,
        /// Least and largest span.
        pub span: Vec<String>,
        /// Least and largest rise.
        pub rise: Vec<String>,
        /// Least and largest thickness.
        pub thickness: Vec<String>,
    }
}

record! {
    /// An arch that decides something, with its certificate.
    pub struct PartFile {
        /// `unsafe` or `safe`.
        pub side: String,
        /// Step of the course on that side that the arch is for, where spans and rises are measured.
        pub step: Option<StepFile>,
        /// Certificate of the arch.
        pub certificate: Certificate,
    }
}

record! {
    /// A step of a course: spans and rises at its first end and its last, fractions of integers, in metres.
    pub struct StepFile {
        /// Span at the first end and at the last.
        pub span: Vec<String>,
        /// Rise at the first end and at the last.
        pub rise: Vec<String>,
    }
}

/// Parts of a certificate, of which there may be many.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parts(pub Vec<PartFile>);

impl Entry for Parts {
    fn read<'de, D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_seq(Entries { most: MAX_PARTS, of: PhantomData }).map(Self)
    }
}

impl Serialize for Parts {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        self.0.serialize(to)
    }
}

impl SurveyCertificate {
    /// Reads a file, with or without a byte order mark. A file that is not such a certificate is refused with
    /// the place and the cause.
    pub fn read(bytes: &[u8]) -> Result<Self, Refusal> {
        let certificate: Self = read_json(bytes)?;
        match certificate.schema == SURVEY_SCHEMA {
            true => Ok(certificate),
            false => Err(Refusal::Schema(shortened(&certificate.schema))),
        }
    }

    /// Writes the file, whose bytes depend on the certificate only.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut *out, self)?;
        writeln!(out)
    }

    /// Verdict on the survey.
    pub(super) fn verdict(&self) -> Result<SurveyVerdict, SurveyRefusal> {
        named("verdict", &self.verdict, SurveyVerdict::ALL, SurveyVerdict::name)
    }
}

impl SurveyFile {
    /// The survey in the words of the file; `None` if its arches have no thickness, or its lengths have more than
    /// [`MAX_LENGTH_DIGITS`] digits, so that a certificate of it is none.
    pub fn new(survey: &Survey) -> Option<Self> {
        let texts = |range: &[ExactNumber; 2]| range.iter().map(given_text).collect();
        let lengths = |range: &[Length; 2]| -> Option<Vec<String>> {
            range.iter().map(|length| length_text(length.metres())).collect()
        };
        let (free, spanned) = match survey.shape() {
            Shape::Free { half_opening, thickness } => {
                let (half_opening, thickness) = (texts(half_opening), texts(thickness.as_ref()?));
                (Some(FreeFile { half_opening, thickness }), None)
            }
            Shape::Spanned { circle, span, rise, thickness } => {
                let [span, rise, thickness] = [span, rise, thickness].map(lengths);
                let circle = circle.name().to_owned();
                let file = SpannedFile { circle, span: span?, rise: rise?, thickness: thickness? };
                (None, Some(file))
            }
        };
        let friction = survey.friction().iter().map(friction_text).collect();
        Some(Self { weight: survey.weight().name().to_owned(), friction, free, spanned })
    }

    /// The survey, if every name is known and every range is one.
    pub fn resolve(&self) -> Result<Survey, SurveyRefusal> {
        let weight = named("weight", &self.weight, SelfWeight::ALL, SelfWeight::name)?;
        let friction = ends("friction", &self.friction, read_friction)?;
        let shape = match (&self.free, &self.spanned) {
            (Some(free), None) => Shape::Free {
                half_opening: ends("half_opening", &free.half_opening, read_given)?,
                thickness: Some(ends("thickness", &free.thickness, read_given)?),
            },
            (None, Some(spanned)) => Shape::Spanned {
                circle: named("circle", &spanned.circle, Circle::ALL, Circle::name)?,
                span: ends("span", &spanned.span, read_length)?.map(Length::new),
                rise: ends("rise", &spanned.rise, read_length)?.map(Length::new),
                thickness: ends("thickness", &spanned.thickness, read_length)?.map(Length::new),
            },
            _ => return Err(SurveyRefusal::Shape),
        };
        let refused = |why: String| SurveyRefusal::Survey(beginning(&why, 160));
        Survey::new(weight, friction, shape).map_err(|error| refused(error.to_string()))
    }
}

impl PartFile {
    /// Side that the part is on.
    pub(super) fn side(&self) -> Result<Side, SurveyRefusal> {
        named("side", &self.side, Side::ALL, Side::name)
    }
}

impl StepFile {
    /// The step between two places in the words of the file; `None` if a length has more than [`MAX_LENGTH_DIGITS`]
    /// digits.
    pub fn new(step: [&SpanAndRise; 2]) -> Option<Self> {
        let texts = |i: usize| step.iter().map(|place| length_text(&place[i])).collect();
        let [span, rise]: [Option<Vec<String>>; 2] = [0, 1].map(texts);
        Some(Self { span: span?, rise: rise? })
    }

    /// First end and last.
    pub(super) fn places(&self) -> Result<[SpanAndRise; 2], SurveyRefusal> {
        let [first_span, last_span] = ends("span", &self.span, read_length)?;
        let [first_rise, last_rise] = ends("rise", &self.rise, read_length)?;
        Ok([[first_span, first_rise], [last_span, last_rise]])
    }
}

/// Both ends of a range.
fn ends<T>(
    place: &'static str,
    texts: &[String],
    read: fn(&str) -> Option<T>,
) -> Result<[T; 2], SurveyRefusal> {
    let [first, last] = texts else { return Err(SurveyRefusal::Ends(place)) };
    let end = |text: &str| {
        read(text).ok_or_else(|| SurveyRefusal::Given { place, text: shortened(text) })
    };
    Ok([end(first)?, end(last)?])
}

fn named<T: Copy, const N: usize>(
    place: &'static str,
    text: &str,
    all: [T; N],
    name: fn(T) -> &'static str,
) -> Result<T, SurveyRefusal> {
    all.into_iter()
        .find(|x| name(*x) == text)
        .ok_or_else(|| SurveyRefusal::Name { place, text: shortened(text) })
}

/// A length in metres: `49/5`.
fn length_text(metres: &BigRational) -> Option<String> {
    let text = given_text(&ExactNumber::rational(metres.clone()));
    has_length_digits(&text).then_some(text)
}

/// Reads a length above zero, in lowest terms or not.
fn read_length(text: &str) -> Option<BigRational> {
    let length = read_given(Some(text).filter(|text| has_length_digits(text))?)?;
    let is_length = length.is_rational() && *length.factor().numer() > BigInt::ZERO;
    is_length.then(|| length.factor().reduced())
}

fn has_length_digits(text: &str) -> bool {
    text.split('/').all(|integer| integer.len() <= MAX_LENGTH_DIGITS)
}
