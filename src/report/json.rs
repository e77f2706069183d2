//! JSON: `couplet.constants/1` and `couplet.audit/1`. Fields may be added, none changes its meaning.

use super::{Audit, Constants, texts};
use crate::arch::{Equation, Unknown};
use serde::Serialize;
use std::collections::BTreeMap;
use std::io;

#[derive(Serialize)]
struct ConstantsFile<'a> {
    schema: &'static str,
    digits: usize,
    constants: Vec<ConstantEntry<'a>>,
    proofs: Vec<ProofEntry<'a>>,
}

#[derive(Serialize)]
struct ConstantEntry<'a> {
    weight: &'static str,
    landmark: &'static str,
    quantity: &'static str,
    value: String,
    lower: String,
    upper: String,
    exact: Option<&'a str>,
}

#[derive(Serialize)]
struct ProofEntry<'a> {
    weight: &'static str,
    landmark: &'static str,
    verdict: &'static str,
    reason: Option<&'a str>,
    equations: Vec<&'static str>,
    /// Radius of the box of uniqueness for each unknown, relative to its value.
    box_relative_radius: BTreeMap<&'static str, f64>,
}

pub fn constants(report: &Constants, out: &mut dyn io::Write) -> io::Result<()> {
    let proofs = report.landmarks.iter().map(|entry| {
        let (weight, landmark) = (entry.weight.name(), entry.landmark.symbol());
        match &entry.outcome {
            Ok(proved) => ProofEntry {
                weight,
                landmark,
                verdict: "proved",
                reason: None,
                equations: proved.system.equations.iter().copied().map(Equation::label).collect(),
                box_relative_radius: proved
                    .system
                    .unknowns
                    .iter()
                    .copied()
                    .map(Unknown::name)
                    .zip(proved.relative_radii.iter().copied())
                    .collect(),
            },
            Err(reason) => ProofEntry {
                weight,
                landmark,
                verdict: "undecided",
                reason: Some(reason),
                equations: Vec::new(),
                box_relative_radius: BTreeMap::new(),
            },
        }
    });
    let proved = report.landmarks.iter().filter_map(|entry| entry.outcome.as_ref().ok());
    let constants = proved.flat_map(|proved| &proved.constants).map(|constant| {
        let [value, lower, upper] = texts(&constant.value);
        ConstantEntry {
            weight: constant.weight.name(),
            landmark: constant.landmark.symbol(),
            quantity: constant.quantity.name(),
            value,
            lower,
            upper,
            exact: constant.exact.as_deref(),
        }
    });
    write(
        &ConstantsFile {
            schema: "couplet.constants/1",
            digits: report.digits,
            constants: constants.collect(),
            proofs: proofs.collect(),
        },
        out,
    )
}

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

fn write(value: &impl Serialize, out: &mut dyn io::Write) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, value)?;
    writeln!(out)
}
