//! JSON: `couplet.audit/1`, `couplet.state/1`, `couplet.assess/1`. Fields may be added, none changes its
//! meaning. `couplet.constants/1` is a document for other programs, in `export`.

use super::{AssessReport, Audit, StateAt, StateOf, StateReport, hexadecimal, reason, texts};
use crate::certify::state::{Figure, LimitDigits};
use serde::Serialize;
use std::collections::BTreeMap;
use std::io;

#[derive(Serialize)]
struct AuditFile {
    schema: &'static str,
    printed: Vec<PrintedEntry>,
    comparisons: Vec<ComparisonEntry>,
}

#[derive(Serialize)]
struct PrintedEntry {
    place: &'static str,
    weight: &'static str,
    landmark: &'static str,
    quantity: &'static str,
    printed: &'static str,
    error_units: String,
    correct_digits: usize,
    verdict: &'static str,
}

#[derive(Serialize)]
struct ComparisonEntry {
    landmark: &'static str,
    quantity: &'static str,
    claimed: &'static str,
    certified: &'static str,
    verdict: &'static str,
}

pub fn audit(report: &Audit, out: &mut dyn io::Write) -> io::Result<()> {
    let printed = report.printed.iter().map(|entry| PrintedEntry {
        place: entry.printed.place,
        weight: entry.printed.weight.name(),
        landmark: entry.printed.landmark.symbol(),
        quantity: entry.printed.quantity.name(),
        printed: entry.printed.text,
        error_units: entry.error_units.to_string(),
        correct_digits: entry.correct_digits,
        verdict: entry.verdict.name(),
    });
    let comparisons = report.comparisons.iter().map(|entry| ComparisonEntry {
        landmark: entry.landmark.symbol(),
        quantity: entry.quantity.name(),
        claimed: entry.claimed.name(),
        certified: entry.certified.name(),
        verdict: entry.verdict(),
    });
    write(
        &AuditFile {
            schema: "couplet.audit/1",
            printed: printed.collect(),
            comparisons: comparisons.collect(),
        },
        out,
    )
}

/// A value with its bounds.
#[derive(Serialize)]
struct FigureEntry {
    value: String,
    lower: String,
    upper: String,
    /// The nearest double, in hexadecimal.
    #[serde(skip_serializing_if = "Option::is_none")]
    double: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    hex: Option<String>,
}

impl FigureEntry {
    fn new(figure: &Figure, doubles: bool) -> Self {
        let [value, lower, upper] =
            [&figure.decimal.value, &figure.decimal.lower, &figure.decimal.upper]
                .map(ToString::to_string);
        let double = doubles.then_some(figure.double);
        Self { value, lower, upper, double, hex: double.map(hexadecimal) }
    }

    fn text([value, lower, upper]: [String; 3]) -> Self {
        Self { value, lower, upper, double: None, hex: None }
    }
}

/// The state of one arch; a missing value is null, an unbounded one the text `inf`.
#[derive(Serialize)]
pub(super) struct StateEntry<'a> {
    schema: &'static str,
    weight: &'static str,
    half_opening: &'a str,
    friction: &'a str,
    verdict: &'static str,
    stands: Option<bool>,
    mode: Option<&'static str>,
    thickness: Option<FigureEntry>,
    thrust: Option<FigureEntry>,
    intrinsic_thrust: Option<FigureEntry>,
    rotation_joint: Option<FigureEntry>,
    sliding_joint: Option<FigureEntry>,
    sliding_friction: Option<FigureEntry>,
    rotational_friction: Option<FigureEntry>,
    reason: Option<&'a str>,
    between: Vec<&'static str>,
    gap: Option<f64>,
}

impl<'a> StateEntry<'a> {
    pub(super) fn new(report: &'a StateReport) -> Self {
        let mut entry = Self {
            schema: "couplet.state/1",
            weight: report.weight.name(),
            half_opening: &report.half_opening,
            friction: &report.friction,
            verdict: "proved",
            stands: None,
            mode: None,
            thickness: None,
            thrust: None,
            intrinsic_thrust: None,
            rotation_joint: None,
            sliding_joint: None,
            sliding_friction: None,
            rotational_friction: None,
            reason: None,
            between: Vec::new(),
            gap: None,
        };
        match &report.outcome {
            StateOf::Stands(state) => {
                entry.stands = Some(true);
                entry.mode = Some(state.mode.label());
                let some = |figure| Some(FigureEntry::new(figure, report.doubles));
                entry.thickness = some(&state.thickness);
                entry.thrust = some(&state.thrust);
                entry.intrinsic_thrust = some(&state.intrinsic_thrust);
                entry.rotation_joint = some(&state.rotation_joint);
                entry.sliding_joint = state.sliding_joint.as_ref().and_then(some);
                if let Some(frictions) = &state.frictions {
                    let infinite = || FigureEntry::text([(); 3].map(|()| "inf".to_owned()));
                    entry.sliding_friction = some(&frictions.sliding);
                    entry.rotational_friction =
                        frictions.rotational.as_ref().map_or_else(|| Some(infinite()), some);
                }
            }
            StateOf::Falls(fall) => {
                entry.stands = Some(false);
                entry.reason = Some(reason(*fall));
            }
            StateOf::Undecided(doubt) => {
                entry.verdict = "undecided";
                entry.reason = Some(&doubt.reason);
                entry.between = doubt.between.iter().map(|mode| mode.label()).collect();
                entry.gap = doubt.gap.filter(|gap| gap.is_finite());
            }
        }
        entry
    }
}

impl StateEntry<'_> {
    /// Without the values that are not among these.
    pub(super) fn only(mut self, quantities: &[&str]) -> Self {
        let keep = |name: &str, value: &mut Option<FigureEntry>| {
            *value = value.take().filter(|_| quantities.contains(&name));
        };
        keep("thickness", &mut self.thickness);
        keep("thrust", &mut self.thrust);
        keep("intrinsic_thrust", &mut self.intrinsic_thrust);
        keep("rotation_joint", &mut self.rotation_joint);
        keep("sliding_joint", &mut self.sliding_joint);
        keep("sliding_friction", &mut self.sliding_friction);
        keep("rotational_friction", &mut self.rotational_friction);
        self
    }
}

pub fn state(report: &StateReport, out: &mut dyn io::Write) -> io::Result<()> {
    write(&StateEntry::new(report), out)
}

/// An arch of a given thickness.
#[derive(Serialize)]
pub(super) struct AssessEntry<'a> {
    schema: &'static str,
    weight: &'static str,
    half_opening: &'a str,
    friction: &'a str,
    thickness: &'a str,
    verdict: &'static str,
    stands: Option<bool>,
    least_thickness: Option<FigureEntry>,
    geometric_safety: Option<FigureEntry>,
    required_friction: Option<FigureEntry>,
    friction_safety: Option<FigureEntry>,
    least_thrust: Option<LimitEntry>,
    largest_thrust: Option<LimitEntry>,
    reason: Option<&'a str>,
}

/// An end of the range of thrusts; a thrust of null has no bound.
#[derive(Serialize)]
struct LimitEntry {
    thrust: Option<FigureEntry>,
    limited_by: &'static str,
    joint: Option<FigureEntry>,
}

impl LimitEntry {
    fn new(limit: &LimitDigits, doubles: bool) -> Self {
        let figure = |x: &Option<Figure>| x.as_ref().map(|x| FigureEntry::new(x, doubles));
        Self {
            thrust: figure(&limit.thrust),
            limited_by: limit.limited_by,
            joint: figure(&limit.joint),
        }
    }
}

impl<'a> AssessEntry<'a> {
    pub(super) fn new(report: &'a AssessReport) -> Self {
        let found = report.outcome.as_ref().ok();
        let figure = |x: Option<&Figure>| x.map(|x| FigureEntry::new(x, report.doubles));
        let limits = found.and_then(|found| found.thrust.as_ref());
        let fall = found.and_then(|found| found.least_thickness.as_ref().err());
        let doubt = report.outcome.as_ref().err().map(|doubt| &*doubt.reason);
        Self {
            schema: "couplet.assess/1",
            weight: report.weight.name(),
            half_opening: &report.half_opening,
            friction: &report.friction,
            thickness: &report.thickness,
            verdict: if found.is_some() { "proved" } else { "undecided" },
            stands: found.map(|found| found.stands),
            least_thickness: figure(found.and_then(|found| found.least_thickness.as_ref().ok())),
            geometric_safety: figure(found.and_then(|found| found.geometric_safety.as_ref())),
            required_friction: figure(found.and_then(|found| found.required_friction.as_ref())),
            friction_safety: figure(found.and_then(|found| found.friction_safety.as_ref())),
            least_thrust: limits.map(|[least, _]| LimitEntry::new(least, report.doubles)),
            largest_thrust: limits.map(|[_, largest]| LimitEntry::new(largest, report.doubles)),
            reason: doubt.or(fall.map(|fall| reason(*fall))),
        }
    }
}

impl AssessEntry<'_> {
    /// Without the values that are not among these.
    pub(super) fn only(mut self, quantities: &[&str]) -> Self {
        let asked = |name: &str| quantities.contains(&name);
        self.least_thickness = self.least_thickness.filter(|_| asked("least_thickness"));
        self.geometric_safety = self.geometric_safety.filter(|_| asked("geometric_safety"));
        self.required_friction = self.required_friction.filter(|_| asked("required_friction"));
        self.friction_safety = self.friction_safety.filter(|_| asked("friction_safety"));
        self.least_thrust = self.least_thrust.filter(|_| asked("least_thrust"));
        self.largest_thrust = self.largest_thrust.filter(|_| asked("largest_thrust"));
        self
    }
}

pub fn assess(report: &AssessReport, out: &mut dyn io::Write) -> io::Result<()> {
    write(&AssessEntry::new(report), out)
}

#[derive(Serialize)]
struct StateAtEntry {
    schema: &'static str,
    weight: &'static str,
    landmark: &'static str,
    verdict: &'static str,
    modes: Vec<&'static str>,
    values: BTreeMap<&'static str, FigureEntry>,
}

pub fn state_at(report: &StateAt, out: &mut dyn io::Write) -> io::Result<()> {
    let figure = |value: &crate::certify::Value| FigureEntry::text(texts(value));
    let values = report.constants.iter().map(|c| (c.quantity.name(), figure(&c.value)));
    let entry = StateAtEntry {
        schema: "couplet.state_at/1",
        weight: report.weight.name(),
        landmark: report.landmark.symbol(),
        verdict: "proved",
        modes: report.modes.iter().map(|mode| mode.label()).collect(),
        values: values.collect(),
    };
    write(&entry, out)
}

fn write(value: &impl Serialize, out: &mut dyn io::Write) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, value)?;
    writeln!(out)
}
