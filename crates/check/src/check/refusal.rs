//! Reasons why a certificate is refused: the place and the cause.

use super::survey_refusal::SurveyRefusal;
use crate::number::says;

/// Reason why a certificate is refused. It says nothing about the truth of the claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The text is not UTF-8.
    Encoding(usize),
    /// The text is not JSON, or not of the schema: unknown, missing or repeated fields, wrong types, more
    /// behind the end.
    Format(String),
    /// Another schema.
    Schema(String),
    /// No subject, or more than one.
    Subject,
    /// A name that does not exist.
    Name {
        /// Entry that should be named.
        place: &'static str,
        /// Text that stands there.
        text: String,
    },
    /// The claim lists other equations, unknowns or contacts than its subject has.
    Mismatch {
        /// `unknowns`, `equations` or `contacts`.
        place: &'static str,
        /// Form that they should have.
        expected: String,
    },
    /// A given number that is not exact and in its range.
    Given {
        /// `half_opening`, `friction` or `thickness`.
        place: &'static str,
        /// Text that stands there.
        text: String,
    },
    /// The number of digits.
    Digits(usize, usize),
    /// More digits than this check was to read: nothing was looked at.
    Limit(usize, usize),
    /// A vector or matrix of the wrong size.
    Size {
        /// Entry that is meant.
        place: &'static str,
        /// Number of items it has.
        found: usize,
        /// Number of items it should have.
        expected: usize,
    },
    /// A number with more bits than its digits need.
    Large {
        /// Place of the number.
        place: &'static str,
        /// Number of bits that are allowed.
        bits: usize,
    },
    /// A radius that is not positive.
    Radius {
        /// Box that is meant.
        place: &'static str,
        /// Unknown that is meant.
        unknown: &'static str,
    },
    /// The equations are not regular on the box.
    Denominator(&'static str),
    /// The box is not mapped into itself.
    Contraction {
        /// Box that is meant.
        place: &'static str,
        /// The first unknown for which it fails.
        unknown: &'static str,
    },
    /// The small box is not in the large one.
    Outside(&'static str),
    /// A physical condition that is not shown to hold on the small box.
    Condition(&'static str),
    /// A quantity that does not exist for the subject, or twice, or none.
    Quantity(String),
    /// No values.
    NoValues,
    /// A value that is not a decimal number with at most the claimed digits.
    Decimal(&'static str),
    /// A value that is not shown to be the correct rounding.
    Rounding(&'static str),
    /// A survey, or a part of it that says nothing for its verdict.
    Survey(SurveyRefusal),
    /// The certificate of a part of a survey, counted from 1.
    Part(usize, Box<Self>),
}

says!(Refusal {
    Self::Encoding(byte) => "the file is not UTF-8 from byte {byte} on";
    Self::Format(reason) => "the file is not a certificate: {reason}";
    Self::Schema(schema) => "schema: '{schema}' is not couplet.certificate/1 or couplet.survey-certificate/1";
    Self::Subject =>
        "claim: needs exactly one of 'landmark', 'state', 'slides', 'too_wide', 'too_thin', 'stands', 'asymmetric'";
    Self::Name { place, text } => "claim: there is no {place} '{text}'";
    Self::Mismatch { place, expected } => "claim: the {place} are not those of the subject, {expected}";
    Self::Given { place, text } => "claim: {place} '{text}' is not possible";
    Self::Digits(found, most) => "digits: {found} is not from 1 to {most}";
    Self::Limit(found, most) => "{found} digits are more than the {most} of this check";
    Self::Size { place, found, expected } => "{place}: it has {found} entries and not {expected}";
    Self::Large { place, bits } => "{place}: a number has more than {bits} bits";
    Self::Radius { place, unknown } => "{place}: the radius of {unknown} is not positive";
    Self::Denominator(place) => "{place}: a denominator of the equations may vanish in the box";
    Self::Contraction { place, unknown } =>
        "{place}: the Krawczyk operator does not map the box into itself ({unknown})";
    Self::Outside(unknown) => "root: the box is not inside the one of uniqueness ({unknown})";
    Self::Condition(condition) => "root: it does not show {condition}";
    Self::Quantity(quantity) => "values: '{quantity}' is not a quantity of this subject, or appears twice";
    Self::NoValues => "values: there are none";
    Self::Decimal(quantity) => "values: {quantity} is not a decimal number with at most the claimed digits";
    Self::Rounding(quantity) => "values: {quantity} is not shown to be the correct rounding";
    Self::Part(part, refusal) => "part {part}: {refusal}";
} from {
    SurveyRefusal => Self::Survey;
});
