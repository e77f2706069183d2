//! JSON and TOML: one document, two ways to write it. Fields may be added, none changes its meaning.
//!
//! Where JSON has `null`, TOML has nothing; where a double is infinite, JSON has `null` and TOML `inf`.

use super::{Certificate, Export, Exported, Of, Subject, TOOL};
use crate::report::hexadecimal;
use serde::Serialize;
use std::collections::BTreeMap;
use std::io;

#[derive(Serialize)]
struct Document<'a> {
    schema: &'static str,
    tool: &'static str,
    digits: usize,
    constants: Vec<ValueEntry<'a>>,
    proofs: Vec<SubjectEntry<'a>>,
}

/// A proved value. `double` is the nearest to the true value, the doubles after it its bounds and a bound
/// of its error.
#[derive(Serialize)]
struct ValueEntry<'a> {
    weight: Option<&'static str>,
    #[serde(flatten)]
    of: Id,
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

/// Whose value it is.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Id {
    Landmark(&'static str),
    Line(u64),
}

#[derive(Serialize)]
struct SubjectEntry<'a> {
    weight: Option<&'static str>,
    #[serde(flatten)]
    of: Id,
    #[serde(flatten)]
    arch: Option<ArchEntry<'a>>,
    verdict: &'static str,
    reason: Option<&'a str>,
    equations: Vec<&'static str>,
    /// Radius of the box of uniqueness for each unknown, relative to its value.
    box_relative_radius: BTreeMap<&'static str, f64>,
    certificate: CertificateEntry<'a>,
}

#[derive(Serialize)]
struct ArchEntry<'a> {
    half_opening: &'a str,
    friction: &'a str,
    thickness: Option<&'a str>,
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

impl Id {
    fn new(of: &Of) -> (Option<&'static str>, Self) {
        match of {
            Of::Landmark { landmark, weight } => {
                (Some(weight.name()), Self::Landmark(landmark.symbol()))
            }
            Of::Arch { number, weight, .. } => (Some(weight.name()), Self::Line(*number)),
            Of::Query { number } => (None, Self::Line(*number)),
        }
    }
}

impl<'a> ValueEntry<'a> {
    fn new(subject: &Subject, value: &'a Exported) -> Self {
        let (weight, of) = Id::new(&subject.of);
        let [text, lower, upper] = value.texts();
        Self {
            weight,
            of,
            quantity: value.label.name,
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

impl<'a> SubjectEntry<'a> {
    fn new(subject: &'a Subject) -> Self {
        let (weight, of) = Id::new(&subject.of);
        let arch = match &subject.of {
            Of::Arch { half_opening, friction, thickness, stands, mode, .. } => Some(ArchEntry {
                half_opening,
                friction,
                thickness: thickness.as_deref(),
                stands: *stands,
                mode: mode.map(|mode| mode.label()),
            }),
            Of::Landmark { .. } | Of::Query { .. } => None,
        };
        let (verdict, reason) = subject.status.words();
        let proof = subject.proof.as_ref();
        let certificate = match &subject.certificate {
            Certificate::Hash { command, sha256 } => {
                CertificateEntry { command: Some(command), sha256: Some(sha256), reason: None }
            }
            Certificate::None(reason) => {
                CertificateEntry { command: None, sha256: None, reason: Some(reason) }
            }
        };
        Self {
            weight,
            of,
            arch,
            verdict,
            reason,
            equations: proof.map(|proof| proof.equations.clone()).unwrap_or_default(),
            box_relative_radius: proof.iter().flat_map(|proof| proof.radii.clone()).collect(),
            certificate,
        }
    }
}

impl<'a> Document<'a> {
    fn new(export: &'a Export) -> Self {
        let values = |subject: &'a Subject| {
            subject.values.iter().map(move |value| ValueEntry::new(subject, value))
        };
        Self {
            schema: export.schema,
            tool: TOOL,
            digits: export.digits,
            constants: export.subjects.iter().flat_map(values).collect(),
            proofs: export.subjects.iter().map(SubjectEntry::new).collect(),
        }
    }
}

pub fn json(export: &Export, out: &mut dyn io::Write) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, &Document::new(export))?;
    writeln!(out)
}

pub fn toml(export: &Export, out: &mut dyn io::Write) -> io::Result<()> {
    let text = ::toml::to_string(&Document::new(export)).map_err(io::Error::other)?;
    out.write_all(text.as_bytes())
}
