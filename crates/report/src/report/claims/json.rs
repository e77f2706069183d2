//! Claims as JSON, `couplet.claims/3`. Fields may be added, none changes its meaning.

use super::decided::{Claims, as_printed, remarks, verdict};
use crate::claims::{Argument, Step};
use crate::report::json;
use serde::Serialize;
use std::io;

#[derive(Serialize)]
struct ClaimsFile<'a> {
    schema: &'static str,
    claims: Vec<Entry<'a>>,
}

#[derive(Serialize)]
struct Entry<'a> {
    id: &'static str,
    place: &'static str,
    statement: &'static str,
    /// `proved`, `equality`, `measured`, `refuted`, `not stated` or `undecided`.
    as_printed: &'static str,
    counterexample: Option<&'a str>,
    corrected: Option<&'a str>,
    equal: Option<&'a str>,
    holds_with: Option<&'a str>,
    fails_with: Option<&'a str>,
    /// What became of the statement: `proved`, `refuted` or `undecided`.
    verdict: &'static str,
    reason: Option<&'a str>,
    hypotheses: Vec<&'a str>,
    method: String,
    /// `own` or `beneath`: where an argument in words carries it.
    argument: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    seconds: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    derivation: Option<Vec<StepEntry<'a>>>,
}

#[derive(Serialize)]
struct StepEntry<'a> {
    support: &'static str,
    words: &'a str,
    formula: Option<&'a str>,
    latex: Option<&'a str>,
}

impl<'a> From<&'a Step> for StepEntry<'a> {
    fn from(step: &'a Step) -> Self {
        Self {
            support: step.support.name(),
            words: &step.words,
            formula: step.formula.as_ref().map(|formula| formula.text.as_str()),
            latex: step.formula.as_ref().map(|formula| formula.latex.as_str()),
        }
    }
}

/// All claims.
pub(crate) fn claims(report: &Claims, out: &mut dyn io::Write) -> io::Result<()> {
    let claims = report.decisions.iter().map(|decision| {
        let remarks = remarks(decision);
        let remark =
            |kind| remarks.iter().find(|(other, _)| *other == kind).map(|(_, words)| *words);
        let reason = remark("reason");
        let steps = decision.derivation.steps();
        Entry {
            id: decision.claim.id,
            place: decision.claim.place,
            statement: decision.claim.statement,
            as_printed: as_printed(decision),
            counterexample: remark("as printed"),
            corrected: remark("corrected"),
            equal: remark("equal"),
            holds_with: remark("holds with"),
            fails_with: remark("does not hold with"),
            verdict: verdict(decision),
            reason,
            hypotheses: decision.derivation.hypotheses().collect(),
            method: decision.derivation.method(),
            argument: decision.derivation.argument().map(Argument::name),
            seconds: report.timed.then_some(decision.time.as_secs_f64()),
            derivation: report.show.then(|| steps.iter().map(StepEntry::from).collect()),
        }
    });
    let file = ClaimsFile { schema: "couplet.claims/3", claims: claims.collect() };
    json::write(&file, out)
}
