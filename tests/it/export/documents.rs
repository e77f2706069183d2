//! JSON and TOML: the same content, the doubles of the true values, and hashes that anybody can make.

use super::constants;
use super::expected::of;
use crate::house::hash;
use crate::program::{Json, couplet, object, tells};
use couplet::arch::SelfWeight;
use couplet::certify::Undecided;
use couplet::problem::Landmark;
use couplet::report::{Answer, Answers, Format, Reported};
use serde_json::Value;

/// Without what one format has no word for.
fn without_nulls(value: Value) -> Value {
    match value {
        Value::Object(map) => map
            .into_iter()
            .filter(|(_, value)| !value.is_null())
            .map(|(key, value)| (key, without_nulls(value)))
            .collect(),
        Value::Array(list) => list.into_iter().map(without_nulls).collect(),
        other => other,
    }
}

#[test]
fn toml_says_what_json_says() {
    let json: Value = serde_json::from_slice(&constants("json")).unwrap();
    let toml: toml::Table = toml::from_str(&String::from_utf8(constants("toml")).unwrap()).unwrap();
    let infinite = |entry: &&toml::Value| entry["double"].as_float() == Some(f64::INFINITY);
    let entries = toml["constants"].as_array().unwrap();
    assert_eq!(entries.iter().filter(infinite).count(), 4, "the friction at l and L");
    assert_eq!(without_nulls(serde_json::to_value(&toml).unwrap()), without_nulls(json));
}

#[test]
fn doubles_are_those_of_the_true_values() {
    let json: Value = serde_json::from_slice(&constants("json")).unwrap();
    let mut differ = 0;
    for entry in json["constants"].list() {
        let expected = of(["landmark", "weight", "quantity"].map(|name| entry[name].text()));
        let number = |key: &str| entry[key].as_f64().unwrap_or(f64::INFINITY).to_bits();
        let error = if entry["value"] == "inf" { 0 } else { number("double_error") };
        expected.check([number("double"), number("double_lower"), number("double_upper"), error]);
        differ += usize::from(entry.value() != expected.doubles[0]);
    }
    assert!(differ > 100, "three digits make another double than the true value");
}

#[test]
fn the_hash_is_that_of_what_certify_writes() {
    let json: Value = serde_json::from_slice(&constants("json")).unwrap();
    let header = String::from_utf8(constants("c")).unwrap();
    let proofs = json["proofs"].list();
    assert_eq!(proofs.len(), 14);
    for proof in proofs.iter().step_by(4) {
        let command = proof["certificate"]["command"].text();
        let words: Vec<&str> = command.split(' ').collect();
        assert_eq!((words[0], words[6]), ("couplet", "3"), "{command}");
        let written = couplet(&words[1..]).stdout;
        let hash = hash(&written);
        assert_eq!(proof["certificate"]["sha256"], hash, "{command}");
        assert!(header.contains(&hash) && header.contains(command), "{command}");
    }
}

#[test]
fn where_there_is_no_hash_is_a_reason() {
    let json = object("constants L --weight heyman --digits 10001");
    let certificate = &json["proofs"][0]["certificate"];
    assert_eq!(certificate["sha256"], Value::Null);
    assert!(certificate["reason"].text().contains("10000"), "{certificate}");
}

#[test]
fn an_undecided_landmark_is_named_and_has_no_values() {
    let reason = Undecided::new("for a test").into();
    let undecided = Answer::landmark((Landmark::Triple, SelfWeight::Heyman), Err(&reason));
    let report = Answers::constants(30, vec![undecided]);
    let text = |format| {
        let mut text = Vec::new();
        let format = Format::named(Answers::content(), format).unwrap();
        report.write(format, &mut text).unwrap();
        String::from_utf8(text).unwrap()
    };
    for format in ["c", "rust", "python", "julia", "matlab", "fortran", "latex"] {
        let text = text(format);
        let words = "T, triple point, Heyman-like self-weight: undecided, no values: for a test";
        tells(&text, [words, "no certificate hash: nothing is proved"]);
        assert!(!text.to_lowercase().contains("heyman_") && !text.contains("hex2num"), "{text}");
    }
    assert!(text("latex").contains(r"$T$ & Heyman & \multicolumn{3}{l}{undecided: for a test} \\"));
    let json: Value = serde_json::from_str(&text("json")).unwrap();
    let proof = &json["proofs"][0];
    assert_eq!(json["constants"], Value::Array(Vec::new()));
    assert_eq!((&proof["verdict"], &proof["reason"]), (&"undecided".into(), &"for a test".into()));
}
