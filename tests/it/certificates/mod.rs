//! Certificates and their spoiled copies: each is refused for exactly its reason, in every arithmetic.

#[macro_use]
mod refusals;

mod asymmetric;
mod claim;
mod clauses;
mod commands;
mod conditions;
mod edges;
mod file;
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
use originals::{alike, landmark, state};
use refusals::{Cases, MAX_DIGITS, Spoiled};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
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

/// Each table of refusals has cases of these variants and of no other.
#[test]
fn every_variant_has_a_case() {
    let tables: [(Vec<Refusal>, &[&str]); 9] = [
        (file::expected(), &["Encoding", "Format"]),
        (claim::expected(), &["Digits", "Given", "Limit", "Mismatch", "Name", "Schema", "Subject"]),
        (sizes::expected(), &["Large", "Radius", "Size"]),
        (witnesses::expected(), &["Contraction", "Denominator", "Outside"]),
        (conditions::expected(), &["Condition"]),
        (
            asymmetric::expected(),
            &[
                "Condition",
                "Contraction",
                "Decimal",
                "Format",
                "Given",
                "Mismatch",
                "Name",
                "NoValues",
                "Quantity",
                "Rounding",
                "Subject",
            ],
        ),
        (survey::expected(), &["Format", "Limit", "Part", "Schema", "Survey"]),
        (values::expected(), &["Decimal", "NoValues", "Quantity", "Rounding"]),
        (
            verdicts::expected(),
            &[
                "Condition",
                "Contraction",
                "Format",
                "Given",
                "Large",
                "Mismatch",
                "Name",
                "NoValues",
                "Quantity",
                "Rounding",
                "Subject",
            ],
        ),
    ];
    let mut all: BTreeSet<&str> = BTreeSet::new();
    for (refusals, variants) in tables {
        let found: BTreeSet<&str> = refusals.iter().map(variant).collect();
        assert_eq!(Vec::from_iter(found), variants);
        all.extend(variants);
    }
    assert_eq!(all.len(), VARIANTS);
}

/// The tests of the checker alone, which has no solver to make certificates, read some of these copies from a file:
/// `UPDATE_SNAPSHOTS=1` writes it anew. Boxes of a certificate may differ from machine to machine, reasons do not.
#[test]
fn the_checkers_own_tests_have_copies_of_every_table() {
    /// Longest of them, and how many of a table have one reason.
    const LONGEST: usize = 4000;
    const ALIKE: usize = 1;
    let tables: [(&str, Cases); 9] = [
        ("file", file::cases()),
        ("claim", claim::cases()),
        ("sizes", sizes::cases()),
        ("witnesses", witnesses::cases()),
        ("conditions", conditions::cases()),
        ("asymmetric", asymmetric::cases()),
        ("survey", survey::cases()),
        ("values", values::cases()),
        ("verdicts", verdicts::cases()),
    ];
    let mut lines = Vec::new();
    for (table, cases) in tables {
        let mut met: BTreeMap<String, usize> = BTreeMap::new();
        for (Spoiled { what, bytes }, refusal) in cases {
            let Ok(file) = String::from_utf8(bytes) else { continue };
            let count = met.entry(refusal.to_string()).or_default();
            if file.len() <= LONGEST && *count < ALIKE {
                *count += 1;
                let refusal = refusal.to_string();
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
    let reasons = |lines: &[Value]| -> Vec<[Value; 2]> {
        lines.iter().map(|line| [line["table"].clone(), line["refusal"].clone()]).collect()
    };
    assert_eq!(reasons(&stored), reasons(&lines), "if it is meant: UPDATE_SNAPSHOTS=1");
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
                assert_eq!(
                    (accepted.digits, accepted.values.len()),
                    (digits, certificate.values.len())
                );
            }
        }
    }
}
