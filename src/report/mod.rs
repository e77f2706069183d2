//! Output only: what a command found, written in a format. One file per format.

mod arches;
mod claims;
mod csv;
pub mod export;
mod json;
mod judged;
mod rows;
mod study;
mod table;

pub use self::csv::{ASSESS_VALUES, STATE_VALUES};
pub use arches::{ArchEntries, Arches};
pub use claims::{ClaimFormat, Claims};
pub use judged::{JudgeSummary, JudgedRow, JudgedRows};
pub use rows::{Answered, Rows};
pub use study::{StudyFiles, accuracy_table, stability_table};

use crate::arch::SelfWeight;
use crate::certify::state::{AssessmentDigits, Digits, Doubt, Fall};
use crate::certify::{CertifiedLandmark, Constant, Value};
use crate::judge::{Audited, Comparison};
use crate::problem::Mode;
use crate::problem::{Landmark, System};
use export::{Export, ExportFormat, Subject};
use std::io;

/// An output format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// For a person.
    Table,
    /// For a program; the schemas are stable.
    Json,
    /// For a spreadsheet.
    Csv,
}

/// An output format of constants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstantsFormat {
    /// For a person.
    Table,
    /// For a spreadsheet.
    Csv,
    /// For another program.
    Export(ExportFormat),
}

impl ConstantsFormat {
    /// Whether it is not text.
    pub fn is_binary(self) -> bool {
        match self {
            #[cfg(feature = "parquet")]
            Self::Export(ExportFormat::Parquet) => true,
            _ => false,
        }
    }
}

/// What `couplet constants` found.
#[derive(Debug)]
pub struct Constants {
    /// Significant digits of each value.
    pub digits: usize,
    /// One per landmark and weight.
    pub landmarks: Vec<LandmarkReport>,
}

/// The proof of one landmark and its constants.
#[derive(Debug)]
pub struct LandmarkReport {
    /// The landmark.
    pub landmark: Landmark,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// What was proved, or why nothing is known.
    pub outcome: Result<Proved, String>,
    /// The hash of its certificate ([`fingerprint`](crate::certify::fingerprint)) or why there is none;
    /// `None` if it was not asked for.
    pub fingerprint: Option<Result<String, String>>,
}

/// The box of the proof, and the constants.
#[derive(Debug)]
pub struct Proved {
    /// The system that was solved.
    pub system: System,
    /// The radius of the box of uniqueness for each unknown, relative to its value.
    pub relative_radii: Vec<f64>,
    /// All quantities that exist.
    pub constants: Vec<Constant>,
}

impl Proved {
    /// A certified landmark with its constants.
    pub fn new(point: &CertifiedLandmark, constants: Vec<Constant>) -> Self {
        let isolated = point.isolated();
        Self { system: *isolated.system(), relative_radii: isolated.relative_radii(), constants }
    }
}

/// What `couplet audit` found.
#[derive(Debug)]
pub struct Audit {
    /// Every printed number.
    pub printed: Vec<Audited>,
    /// The claims that compare the two weights.
    pub comparisons: Vec<Comparison>,
}

/// What `couplet state` found of an arch.
#[derive(Debug)]
pub struct StateReport<'a> {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The half opening as given.
    pub half_opening: String,
    /// The friction as given.
    pub friction: String,
    /// Whether to give the nearest double of each value too.
    pub doubles: bool,
    /// What is certain.
    pub outcome: StateOf<'a>,
}

/// What is certain of an arch.
#[derive(Debug)]
pub enum StateOf<'a> {
    /// It stands from a least thickness on.
    Stands(&'a Digits),
    /// It does not stand.
    Falls(Fall),
    /// Not everything could be told.
    Undecided(&'a Doubt),
}

/// What `couplet assess` found of an arch.
#[derive(Debug)]
pub struct AssessReport<'a> {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The half opening as given.
    pub half_opening: String,
    /// The friction as given.
    pub friction: String,
    /// The thickness as given.
    pub thickness: String,
    /// Whether to give the nearest double of each value too.
    pub doubles: bool,
    /// What is certain, or the doubt.
    pub outcome: &'a Result<AssessmentDigits, Doubt>,
}

impl AssessReport<'_> {
    /// Writes the report.
    pub fn write(&self, format: Format, out: &mut dyn io::Write) -> io::Result<()> {
        match format {
            Format::Table => table::assess(self, out),
            Format::Json => json::assess(self, out),
            Format::Csv => csv::assess(self, out),
        }
    }
}

/// What `couplet state --at` found of a landmark.
#[derive(Debug)]
pub struct StateAt {
    /// The landmark.
    pub landmark: Landmark,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// All modes that meet there.
    pub modes: Vec<Mode>,
    /// Its quantities.
    pub constants: Vec<Constant>,
}

impl StateReport<'_> {
    /// Writes the report.
    pub fn write(&self, format: Format, out: &mut dyn io::Write) -> io::Result<()> {
        match format {
            Format::Table => table::state(self, out),
            Format::Json => json::state(self, out),
            Format::Csv => csv::state(self, out),
        }
    }
}

impl StateAt {
    /// Writes the report.
    pub fn write(&self, format: Format, out: &mut dyn io::Write) -> io::Result<()> {
        match format {
            Format::Table => table::state_at(self, out),
            Format::Json => json::state_at(self, out),
            Format::Csv => csv::state_at(self, out),
        }
    }
}

/// A double as C and many others write it in hexadecimal: exact. Infinity is `inf`, as `printf` has it.
fn hexadecimal(x: f64) -> String {
    if x.is_infinite() {
        return x.to_string();
    }
    if x == 0.0 {
        return "0x0p+0".to_owned();
    }
    let (bits, sign) = (x.to_bits(), if x < 0.0 { "-" } else { "" });
    let (mut exponent, mut mantissa) = ((bits >> 52 & 0x7ff) as i64 - 1023, bits & ((1 << 52) - 1));
    if exponent == -1023 {
        // Subnormal: the leading one is moved to the front.
        let shift = mantissa.leading_zeros() - 11;
        mantissa = (mantissa << shift) & ((1 << 52) - 1);
        exponent = -1022 - i64::from(shift);
    }
    let digits = format!("{mantissa:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x1{point}{digits}p{exponent:+}")
}

/// The word for why an arch does not stand.
fn reason(fall: Fall) -> &'static str {
    match fall {
        Fall::Sliding => "sliding",
        Fall::Thickness => "thickness",
    }
}

impl Constants {
    /// Writes the report.
    pub fn write(&self, format: ConstantsFormat, out: &mut dyn io::Write) -> io::Result<()> {
        match format {
            ConstantsFormat::Table => table::constants(self, out),
            ConstantsFormat::Csv => csv::constants(self, out),
            ConstantsFormat::Export(format) => export::write(format, &self.export(), out),
        }
    }

    /// The constants for another program.
    pub fn export(&self) -> Export {
        let subject = |report| Subject::landmark(report, self.digits);
        Export {
            title: "Landmark constants of the finite-friction Couplet-Heyman problem",
            schema: "couplet.constants/1",
            digits: self.digits,
            subjects: self.landmarks.iter().map(subject).collect(),
        }
    }
}

impl Audit {
    /// Writes the report.
    pub fn write(&self, format: Format, out: &mut dyn io::Write) -> io::Result<()> {
        match format {
            Format::Table => table::audit(self, out),
            Format::Json => json::audit(self, out),
            Format::Csv => csv::audit(self, out),
        }
    }
}

/// The texts of a value: itself, its lower and its upper bound.
fn texts(value: &Value) -> [String; 3] {
    match value {
        Value::Finite(rounded) => {
            [&rounded.value, &rounded.lower, &rounded.upper].map(ToString::to_string)
        }
        Value::Infinite => [(); 3].map(|()| "inf".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::hexadecimal;

    #[test]
    fn hexadecimal_doubles_are_exact() {
        for (x, text) in [
            (1.0, "0x1p+0"),
            (0.1, "0x1.999999999999ap-4"),
            (-2.5, "-0x1.4p+1"),
            (f64::MIN_POSITIVE, "0x1p-1022"),
            (5e-324, "0x1p-1074"),
            (f64::MAX, "0x1.fffffffffffffp+1023"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(hexadecimal(x), text);
        }
    }
}
