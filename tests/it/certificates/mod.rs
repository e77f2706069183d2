//! Certificates and their spoiled copies: each is refused for exactly its reason, in every arithmetic.

#[macro_use]
mod refusals;

mod asymmetric;
mod claim;
mod clauses;
mod commands;
mod edges;
mod file;
mod listed;
mod monsters;
mod originals;
mod printed;
mod roots;
mod sizes;
mod spoiled;
mod spoiler;
mod survey;
mod survey_spoiled;
mod values;
mod verdicts;
mod witnesses;

use couplet::arch::SelfWeight;
use couplet::certify::certify_landmark;
use couplet::check::Refusal;
use couplet::problem::{Landmark, Problem};
use listed::listed;
use originals::{alike, landmark, state};
use refusals::{Cases, MAX_DIGITS, Spoiled};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::Path;

/// The name of a variant. A new one has to be added here, and then needs a case.
fn variant(refusal: &Refusal) -> &'static str {
    match refusal {
        Refusal::Encoding(_) => "Encoding",
        Refusal::Format(_) => "Format",
        Refusal::Schema(_) => "Schema",
        Refusal::Subject => "Subject",
        Refusal::Name { .. } => "Name",
        Refusal::Mismatch { .. } => "Mismatch",
        Refusal::Given { .. } => "Given",
        Refusal::Digits(..) => "Digits",
        Refusal::Limit(..) => "Limit",
        Refusal::Size { .. } => "Size",
        Refusal::Large { .. } => "Large",
        Refusal::Radius { .. } => "Radius",
        Refusal::Denominator(_) => "Denominator",
        Refusal::Contraction { .. } => "Contraction",
        Refusal::Outside(_) => "Outside",
        Refusal::Condition(_) => "Condition",
        Refusal::Quantity(_) => "Quantity",
        Refusal::NoValues => "NoValues",
        Refusal::Decimal(_) => "Decimal",
        Refusal::Rounding(_) => "Rounding",
        Refusal::Survey(_) => "Survey",
        Refusal::Part(..) => "Part",
    }
}

const VARIANTS: usize = 22;

/// All spoiled copies, table by table, with their reasons.
fn tables() -> [(&'static str, Cases); 9] {
    let written: [(&str, Cases); 9] = [
        ("file", file::cases()),
        ("claim", claim::cases()),
        ("sizes", sizes::cases()),
        ("witnesses", witnesses::cases()),
        ("conditions", Vec::new()),
        ("asymmetric", asymmetric::cases()),
        ("survey", survey::cases()),
        ("values", values::cases()),
        ("verdicts", verdicts::cases()),
    ];
    written.map(|(table, cases)| (table, cases.into_iter().chain(listed(table)).collect()))
}

#[test]
fn every_copy_of_the_list_is_refused_and_every_variant_has_a_case() {
    assert!(tables().iter().map(|(table, _)| listed(table).len()).sum::<usize>() > 160);
    let refusals = tables().into_iter().flat_map(|(_, cases)| cases).map(|(_, refusal)| refusal);
    let refusals: Vec<Refusal> = refusals.collect();
    assert_eq!(refusals.iter().map(variant).collect::<BTreeSet<_>>().len(), VARIANTS);
    let of_survey = refusals.iter().filter_map(|refusal| match refusal {
        Refusal::Survey(refusal) => Some(survey::variant(refusal)),
        _ => None,
    });
    assert_eq!(of_survey.collect::<BTreeSet<_>>().len(), 14);
}

/// The tests of the checker alone, which has no solver to make certificates, read some of these copies from a file:
/// `UPDATE_SNAPSHOTS=1` writes it anew. Boxes of a certificate may differ from machine to machine, reasons do not.
#[test]
fn the_checkers_own_tests_have_copies_of_every_table() {
    /// Longest of them; of a table one has each reason.
    const LONGEST: usize = 4000;
    let mut lines = Vec::new();
    for (table, cases) in tables() {
        let mut met: BTreeSet<String> = BTreeSet::new();
        for (Spoiled { what, bytes }, refusal) in cases {
            // Without the place in the file.
            let refusal = refusal.to_string().split(" at line ").next().unwrap().to_owned();
            let Ok(file) = String::from_utf8(bytes) else { continue };
            if file.len() <= LONGEST && met.insert(refusal.clone()) {
                lines.push(json!({"table": table, "what": what, "refusal": refusal, "file": file}));
            }
        }
    }
    let path = Path::new("crates/check/tests/refused.jsonl");
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
        std::fs::write(path, text).unwrap();
    }
    let stored = std::fs::read_to_string(path).unwrap();
    let stored: Vec<Value> =
        stored.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let has = |all: &[Value], line: &Value| {
        let begins =
            |of: &Value, with: &Value| of.as_str().unwrap().starts_with(with.as_str().unwrap());
        let is_it = |of: &Value| {
            let [one, other] = [&of["refusal"], &line["refusal"]];
            of["table"] == line["table"] && (begins(one, other) || begins(other, one))
        };
        all.iter().any(is_it)
    };
    for (one, others) in [(&stored, &lines), (&lines, &stored)] {
        let lacks = one.iter().find(|line| !has(others, line));
        assert_eq!(lacks, None, "if it is meant: UPDATE_SNAPSHOTS=1");
    }
}

/// What holds for every spoiled copy: the one that is not spoiled is accepted.
#[test]
fn the_originals_are_accepted() {
    for base in
        [landmark("T"), landmark("l"), landmark("sb"), state("2.45", "1.35"), state("2.5", "inf")]
    {
        alike(base.to_string().as_bytes(), MAX_DIGITS).unwrap();
    }
}

#[test]
fn every_landmark_at_60_digits_is_accepted_and_fewer_digits_too() {
    for landmark in Landmark::ALL {
        for weight in SelfWeight::ALL {
            for digits in [1, 2, 3, 60] {
                let certificate = certify_landmark(landmark, weight, digits).unwrap();
                let accepted = alike(&serde_json::to_vec(&certificate).unwrap(), digits).unwrap();
                assert_eq!(accepted.problem, Problem::Landmark { landmark, weight });
                assert_eq!(accepted.digits, digits);
                assert_eq!(accepted.values.len(), certificate.values.len());
            }
        }
    }
}
