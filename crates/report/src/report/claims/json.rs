//! Claims as JSON, `couplet.claims/3`. Fields may be added, none changes its meaning.

use super::decided::{Claims, as_printed, remarks, verdict};
use crate::claims::{Argument, DerivationStep};
use crate::report::fields::Fields;
use crate::report::json;
use serde_json::Value as Json;
use std::io;

fn step(step: &DerivationStep) -> Fields {
    let [formula, latex] = match &step.formula {
        Some(formula) => [formula.text.as_str().into(), formula.latex.as_str().into()],
        None => [Json::Null, Json::Null],
    };
    let values = [step.support.name().into(), step.words.as_str().into(), formula, latex];
    Fields::named("support words formula latex", values)
}

/// Writes all claims.
pub(crate) fn claims(report: &Claims, out: &mut dyn io::Write) -> io::Result<()> {
    let claims = report.decisions.iter().map(|decision| {
        let remarks = remarks(decision);
        let remark =
            |kind| remarks.iter().find(|(other, _)| *other == kind).map(|(_, words)| *words);
        let reason = remark("reason");
        let derivation = &decision.derivation;
        let mut fields = Fields::default();
        fields.add("id", decision.claim.id);
        fields.add("place", decision.claim.place);
        fields.add("statement", decision.claim.statement);
        fields.add("as_printed", as_printed(decision));
        fields.add("counterexample", remark("as printed"));
        fields.add("corrected", remark("corrected"));
        fields.add("equal", remark("equal"));
        fields.add("holds_with", remark("holds with"));
        fields.add("fails_with", remark("does not hold with"));
        fields.add("verdict", verdict(decision));
        fields.add("reason", reason);
        fields.add("hypotheses", derivation.hypotheses().collect::<Vec<_>>());
        fields.add("method", derivation.method());
        fields.add("argument", derivation.argument().map(Argument::name));
        if report.timed {
            fields.add("seconds", decision.time.as_secs_f64());
        }
        if report.show {
            fields.add_list("derivation", derivation.steps().iter().map(step));
        }
        fields
    });
    let mut file = Fields::of("couplet.claims/3");
    file.add_list("claims", claims);
    json::write(&file, out)
}
