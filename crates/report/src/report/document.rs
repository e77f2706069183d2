//! The document that lists each value: JSON and TOML are two ways to write it. Fields may be added, none
//! changes its meaning.
//!
//! Where JSON has `null`, TOML has nothing; where a double is infinite, JSON has `null` and TOML `inf`.

use super::answer::Answer;
use super::answers::{Answers, TOOL};
use super::given::GivenDoubles;
use super::subject::Subject;
use super::value::Value;
use super::words::hexadecimal;
use crate::problem::Quantity;
use serde::Serialize;
use std::collections::BTreeMap;

/// The document.
#[derive(Serialize)]
pub(super) struct Document<'a> {
    schema: &'static str,
    tool: &'static str,
    digits: usize,
    constants: Vec<ValueEntry<'a>>,
    proofs: Vec<AnswerEntry<'a>>,
}

/// Whose value it is.
#[derive(Serialize)]
struct Owner {
    weight: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    landmark: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<u64>,
}

/// A proved value. `double` is the nearest to the true value, the doubles after it its bounds and a bound
/// of its error.
#[derive(Serialize)]
struct ValueEntry<'a> {
    #[serde(flatten)]
    owner: Owner,
    quantity: &'static str,
    value: String,
    lower: String,
    upper: String,
    exact: Option<&'a str>,
    double: f64,
    hex: Option<String>,
    double_lower: f64,
    double_upper: f64,
    double_error: f64,
}

#[derive(Serialize)]
struct AnswerEntry<'a> {
    #[serde(flatten)]
    owner: Owner,
    #[serde(flatten)]
    arch: Option<ArchEntry<'a>>,
    verdict: &'static str,
    reason: Option<&'a str>,
    equations: &'a [&'static str],
    /// Radius of the box of uniqueness for each unknown, relative to its value.
    box_relative_radius: BTreeMap<&'static str, f64>,
    certificate: CertificateEntry<'a>,
}

#[derive(Serialize)]
struct ArchEntry<'a> {
    half_opening: Option<&'a str>,
    friction: Option<&'a str>,
    thickness: Option<&'a str>,
    half_opening_rad: Option<f64>,
    half_opening_deg: Option<f64>,
    friction_double: Option<f64>,
    thickness_double: Option<f64>,
    can_stand: Option<bool>,
    stands: Option<bool>,
    mode: Option<&'static str>,
}

/// The command that writes the certificate and the SHA-256 of its output; or why there is none.
#[derive(Serialize)]
struct CertificateEntry<'a> {
    command: Option<&'a str>,
    sha256: Option<&'a str>,
    reason: Option<&'a str>,
}

impl<'a> Document<'a> {
    /// Document of landmarks or arches.
    pub(super) fn new(report: &'a Answers) -> Self {
        let values = |answer: &'a Answer| {
            answer.values.iter().map(|(of, value)| ValueEntry::new(&answer.subject, *of, value))
        };
        Self {
            schema: report.schema(),
            tool: TOOL,
            digits: report.digits,
            constants: report.list.iter().flat_map(values).collect(),
            proofs: report.list.iter().map(AnswerEntry::new).collect(),
        }
    }
}

impl Owner {
    fn new(subject: &Subject) -> Self {
        Self {
            weight: subject.weight().map(|weight| weight.name()),
            landmark: subject.landmark().map(|landmark| landmark.symbol()),
            line: subject.line(),
        }
    }
}

impl<'a> ValueEntry<'a> {
    fn new(subject: &Subject, quantity: Quantity, value: &'a Value) -> Self {
        let [text, lower, upper] = value.texts();
        Self {
            owner: Owner::new(subject),
            quantity: quantity.name(),
            value: text,
            lower,
            upper,
            exact: value.exact.as_deref(),
            double: value.double,
            hex: value.double.is_finite().then(|| hexadecimal(value.double)),
            double_lower: value.binary.lower,
            double_upper: value.binary.upper,
            double_error: value.binary.error,
        }
    }
}

impl<'a> ArchEntry<'a> {
    fn new(answer: &Answer, given: [Option<&'a String>; 3], doubles: GivenDoubles) -> Self {
        let [half_opening, friction, thickness] = given.map(|text| text.map(String::as_str));
        Self {
            half_opening,
            friction,
            thickness,
            half_opening_rad: doubles.half_opening_rad,
            half_opening_deg: doubles.half_opening_deg,
            friction_double: doubles.friction,
            thickness_double: doubles.thickness,
            can_stand: answer.can_stand,
            stands: answer.stands,
            mode: answer.modes.first().map(|mode| mode.label()),
        }
    }
}

impl<'a> AnswerEntry<'a> {
    fn new(answer: &'a Answer) -> Self {
        let arch = match &answer.subject {
            Subject::Arch { half_opening, friction, thickness, doubles, .. } => {
                let given = [Some(half_opening), Some(friction), thickness.as_ref()];
                Some(ArchEntry::new(answer, given, *doubles))
            }
            Subject::Sought { half_opening, friction, thickness, .. } => {
                let given = [half_opening, friction, thickness].map(Option::as_ref);
                Some(ArchEntry::new(answer, given, GivenDoubles::default()))
            }
            Subject::Landmark { .. } | Subject::Query { .. } => None,
        };
        let fingerprint = answer.certificate.as_ref();
        let proof = answer.proof.as_ref();
        Self {
            owner: Owner::new(&answer.subject),
            arch,
            verdict: answer.status.name(),
            reason: answer.status.reason(),
            equations: proof.map_or(&[], |proof| &proof.equations),
            box_relative_radius: proof.iter().flat_map(|proof| proof.radii.clone()).collect(),
            certificate: CertificateEntry {
                command: fingerprint.ok().map(|certificate| certificate.command.as_str()),
                sha256: fingerprint.ok().map(|certificate| certificate.sha256.as_str()),
                reason: fingerprint.err().map(String::as_str),
            },
        }
    }
}
