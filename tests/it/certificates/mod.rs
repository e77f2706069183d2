//! Certificates and their spoiled copies: each is refused for exactly its reason, in every arithmetic.

#[macro_use]
mod refusals;

mod asymmetric;
mod claim;
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
use refusals::MAX_DIGITS;
use std::collections::BTreeSet;

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
