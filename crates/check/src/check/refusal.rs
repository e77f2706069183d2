//! Why a certificate is refused: the place and the cause.

/// Why a certificate is refused. It says nothing about the truth of the claim.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Refusal {
    /// Not UTF-8.
    #[error("the file is not UTF-8 from byte {0} on")]
    Encoding(usize),
    /// Not JSON, or not of the schema: unknown, missing or repeated fields, wrong types, more behind
    /// the end.
    #[error("the file is not a certificate: {0}")]
    Format(String),
    /// Another schema.
    #[error("schema: '{0}' is not couplet.certificate/1")]
    Schema(String),
    /// No subject, or more than one.
    #[error(
        "claim: needs exactly one of 'landmark', 'state', 'slides', 'too_wide', 'too_thin', 'stands', 'asymmetric'"
    )]
    Subject,
    /// A name that does not exist.
    #[error("claim: there is no {place} '{text}'")]
    Name {
        /// What should be named.
        place: &'static str,
        /// What stands there.
        text: String,
    },
    /// The claim lists other equations, unknowns or contacts than its subject has.
    #[error("claim: the {place} are not those of the subject, {expected}")]
    Mismatch {
        /// `unknowns`, `equations` or `contacts`.
        place: &'static str,
        /// What they should be.
        expected: String,
    },
    /// A given number that is not exact and in its range.
    #[error("claim: {place} '{text}' is not possible")]
    Given {
        /// `half_opening`, `friction` or `thickness`.
        place: &'static str,
        /// What stands there.
        text: String,
    },
    /// The number of digits.
    #[error("digits: {0} is not from 1 to {1}")]
    Digits(usize, usize),
    /// More digits than this check was to read: nothing was looked at.
    #[error("{0} digits are more than the {1} of this check")]
    Limit(usize, usize),
    /// A vector or matrix of the wrong size.
    #[error("{place}: it has {found} entries and not {expected}")]
    Size {
        /// Which.
        place: &'static str,
        /// How many it has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// A number with more bits than its digits need.
    #[error("{place}: a number has more than {bits} bits")]
    Large {
        /// Where.
        place: &'static str,
        /// How many bits are allowed.
        bits: usize,
    },
    /// A radius that is not positive.
    #[error("{place}: the radius of {unknown} is not positive")]
    Radius {
        /// Which box.
        place: &'static str,
        /// Of which unknown.
        unknown: &'static str,
    },
    /// The equations are not regular on the box.
    #[error("{0}: a denominator of the equations may vanish in the box")]
    Denominator(&'static str),
    /// The box is not mapped into itself.
    #[error("{place}: the Krawczyk operator does not map the box into itself ({unknown})")]
    Contraction {
        /// Which box.
        place: &'static str,
        /// The first unknown for which it fails.
        unknown: &'static str,
    },
    /// The small box is not in the large one.
    #[error("root: the box is not inside the one of uniqueness ({0})")]
    Outside(&'static str),
    /// A physical condition that is not shown to hold on the small box.
    #[error("root: it does not show {0}")]
    Condition(&'static str),
    /// A quantity that does not exist for the subject, or twice, or none.
    #[error("values: '{0}' is not a quantity of this subject, or appears twice")]
    Quantity(String),
    /// No values.
    #[error("values: there are none")]
    NoValues,
    /// A value that is not a decimal number with at most the claimed digits.
    #[error("values: {0} is not a decimal number with at most the claimed digits")]
    Decimal(&'static str),
    /// A value that is not shown to be the correct rounding.
    #[error("values: {0} is not shown to be the correct rounding")]
    Rounding(&'static str),
}
