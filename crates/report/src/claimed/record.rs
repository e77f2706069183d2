//! The record of a claim.

use super::decided::{Claims, as_printed, remarks, verdict};
use super::text;
use crate::claims::{Argument, Decision, DerivationStep};
use crate::record::Record;
use serde_json::Value as Json;

fn step(step: &DerivationStep) -> Record {
    let [formula, latex] = match &step.formula {
        Some(formula) => [formula.text.as_str().into(), formula.latex.as_str().into()],
        None => [Json::Null, Json::Null],
    };
    let values = [step.support.name().into(), step.words.as_str().into(), formula, latex];
    Record::named("support words formula latex", values)
}

pub(super) fn of(report: &Claims, decision: &Decision) -> Record {
    let remarks = remarks(decision);
    let remark = |kind| remarks.iter().find(|(other, _)| *other == kind).map(|(_, words)| *words);
    let derivation = &decision.derivation;
    let mut record = Record::default();
    text::say(report, decision, &mut record);
    record.add("id", decision.claim.id);
    record.add("place", decision.claim.place);
    record.add("statement", decision.claim.statement);
    record.add("as_printed", as_printed(decision));
    record.add("counterexample", remark("as printed"));
    record.add("corrected", remark("corrected"));
    record.add("equal", remark("equal"));
    record.add("holds_with", remark("holds with"));
    record.add("fails_with", remark("does not hold with"));
    record.add("verdict", verdict(decision));
    record.add("reason", remark("reason"));
    record.add("hypotheses", derivation.hypotheses().collect::<Vec<_>>());
    record.add("method", derivation.method());
    record.add("argument", derivation.argument().map(Argument::name));
    if report.timed {
        record.add("seconds", decision.time.as_secs_f64());
    }
    if report.show {
        record.add_list("derivation", derivation.steps().iter().map(step));
    }
    record
}
