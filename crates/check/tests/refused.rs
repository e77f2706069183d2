//! Spoiled certificates, each refused for exactly its reason, and the stored ones, each accepted for what it says.
//!
//! The copies are those of the tests of the whole program, which has a solver to make them: a true root of which one
//! condition does not hold can be had in no other way.

use couplet_check::check::{AcceptedFile, check_file};
use couplet_number::number::AstroInterval;
use serde_json::Value;

const PROOFS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../proofs");

#[test]
fn spoiled_copies_are_refused_for_their_reasons() {
    let lines: Vec<Value> = include_str!("refused.jsonl")
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert!(lines.len() > 100, "{} copies", lines.len());
    for line in lines {
        let file = line["file"].as_str().unwrap();
        let refusal = check_file::<AstroInterval>(file.as_bytes(), 60).expect_err(file).to_string();
        // The place in the file and the types expected are the words of the reader.
        assert!(refusal.starts_with(line["refusal"].as_str().unwrap()), "{line}: {refusal}");
    }
}

/// Every stored certificate, with the digits that it has.
#[test]
fn stored_certificates_are_accepted_for_what_they_say() {
    let mut said = Vec::new();
    for folder in ["asymmetric", "constants", "states", "surveys"] {
        let files = std::fs::read_dir(format!("{PROOFS}/{folder}")).unwrap();
        let mut files: Vec<_> = files.map(|file| file.unwrap().path()).collect();
        files.retain(|path| path.extension().is_some_and(|end| end == "json"));
        files.sort();
        for path in files {
            let bytes = std::fs::read(&path).unwrap();
            let accepted = check_file::<AstroInterval>(&bytes, 120).unwrap();
            said.push(format!(
                "{folder}/{}: {}",
                path.file_stem().unwrap().to_str().unwrap(),
                accepted.summary()
            ));
            let AcceptedFile::Certificate(accepted) = accepted else { continue };
            let file: Value = serde_json::from_slice(&bytes).unwrap();
            let values = file["values"].as_array().unwrap().iter();
            let values: Vec<_> = values
                .map(|value| [&value["quantity"], &value["value"]].map(|x| x.as_str().unwrap()))
                .collect();
            let found: Vec<_> = accepted
                .values
                .iter()
                .map(|(quantity, value)| [quantity.name(), value.as_str()])
                .collect();
            assert_eq!(
                (accepted.digits as u64, found),
                (file["digits"].as_u64().unwrap(), values),
                "{path:?}"
            );
        }
    }
    assert_eq!(said.join("\n") + "\n", include_str!("accepted.txt"));
}

/// Values in another order, and each alone: an angle that is known by its tangent is looked for near its degrees.
#[test]
fn values_are_accepted_in_any_order_and_alone() {
    let bytes = include_bytes!("../../../proofs/constants/triple-point-heyman.json");
    let original: Value = serde_json::from_slice(bytes).unwrap();
    let values = original["values"].as_array().unwrap().clone();
    let of_angles =
        values.iter().filter(|value| value["quantity"].as_str().unwrap().ends_with("_degrees"));
    assert!(of_angles.count() >= 4);
    let reversed: Vec<Value> = values.iter().rev().cloned().collect();
    for values in values.into_iter().map(|value| vec![value]).chain([reversed]) {
        let mut copy = original.clone();
        copy["values"] = values.clone().into();
        let accepted = check_file::<AstroInterval>(copy.to_string().as_bytes(), 100).unwrap();
        assert_eq!(accepted.certificate().unwrap().values.len(), values.len(), "{values:?}");
    }
}
