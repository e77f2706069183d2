//! What is no certificate is told with its place.

use super::listed::listed;
use super::originals::alike;
use super::refusals::{Cases, MAX_DIGITS, Original, Spoiled, arch, point};
use couplet::check::Refusal;
use serde_json::{Value, json};

fn format(words: &str) -> Refusal {
    Refusal::Format(words.to_owned())
}

fn missing(key: &str) -> Refusal {
    format(&format!("missing field `{key}`"))
}

/// A stored file, as it came.
macro_rules! stored {
    ($name:literal) => {
        Spoiled::new($name, include_bytes!(concat!("refused/", $name, ".json")))
    };
}

/// A text in place of a number.
fn no_number(text: &str) -> Cases {
    let words =
        format!("{text:?} is not a valid certificate number: it is not of the form -0x1f3p-12");
    vec![(point().with("/root/centre/0", text), format(&words))]
}

fn too_large(text: &str) -> Cases {
    let words =
        format!("{text:?} is not a valid certificate number: its exponent is beyond ±10000000");
    vec![(point().with("/inverse/0/0", text), format(&words))]
}

refusals! {
    // No JSON, or not the JSON of an object.
    an_empty_file: stored!("empty") => format("EOF while parsing a value at line 1 column 0");
    null: stored!("null") => format("invalid type: null, expected an object");
    a_number: Spoiled::new("number", "1") => format("invalid type: integer `1`, expected an object");
    a_file_that_is_cut: stored!("cut") => format("EOF while parsing a list");
    a_list: stored!("list") => format("invalid type: sequence, expected an object");
    latin_1: stored!("latin-1") => Refusal::Encoding(49);
    utf_16: stored!("utf-16") => Refusal::Encoding(0);
    two_byte_order_marks:
        stored!("two-byte-order-marks") => format("expected value at line 1 column 1");
    half_a_surrogate: stored!("surrogate") => format("unexpected end of hex escape");
    a_comment: stored!("comment") => format("expected value at line 1 column 1");
    plain_text: stored!("text") => format("expected value at line 1 column 1");
    control_characters: stored!("control") => format("unknown field `a\\n\\u{1b}[2J`");
    an_empty_object: Spoiled::new("{}", "{}") => missing("schema");
    lists_that_are_too_long: long_lists();
    a_null_character_behind_the_end:
        point().replaced("}]}", "}]}\u{0}") => format("trailing characters");

    // Texts that are no numbers.
    texts_that_are_no_numbers: [
        "", "1.5", "0x1", "0x1p", "0xFp1", "+0x1p1", "0x1.8p0", "0x1p+1", "--0x1p0", " 0x1p0", "0x1p0\n",
        "inf",
    ].into_iter().flat_map(no_number).collect();
    exponents_beyond_what_is_read: [
        "0x1p10000001", "0x1p-10000001", "0x0p10000001", "0x1p999999999999999999",
    ].into_iter().flat_map(too_large).collect();
}

/// Lists of one entry more than is read, each in its place.
fn long_lists() -> Cases {
    let longest = |place: &str, entry: Value| {
        let list = vec![entry; 33];
        (point().with(place, list), format("a list of more than 32 entries"))
    };
    let value = json!({"quantity": "thrust", "value": "1"});
    vec![
        longest("/inverse", json!([])),
        longest("/inverse/0", json!("0x1p0")),
        longest("/unique/centre", json!("0x1p0")),
        longest("/root/radius", json!("0x1p0")),
        longest("/claim/unknowns", json!("a")),
        longest("/claim/equations", json!("ab")),
        longest("/values", value),
    ]
}

#[test]
fn one_byte_order_mark_is_no_part_of_the_file() {
    let plain = point().0.to_string();
    let marked = format!("\u{feff}{plain}");
    assert_eq!(alike(marked.as_bytes(), MAX_DIGITS), alike(plain.as_bytes(), MAX_DIGITS));
    assert!(alike(plain.as_bytes(), MAX_DIGITS).is_ok());
}

/// The table above leaves out each field of each object, but for the landmark, without which a claim may
/// be that of a state.
#[test]
fn every_field_of_every_object_is_left_out() {
    let keys = |Original(base): Original, place: &str| {
        base.pointer(place).unwrap().as_object().unwrap().len()
    };
    let places = ["", "/claim", "/unique", "/root", "/values/0"];
    let fields: usize = places.map(|place| keys(point(), place)).iter().sum();
    let fields = fields - 1 + keys(arch(), "/claim/state");
    let reasons = cases().into_iter().chain(listed("file")).map(|(_, refusal)| refusal.to_string());
    let left_out = reasons.filter(|reason| reason.contains("missing field")).count();
    // The empty object lacks a field too.
    assert_eq!(left_out - 1, fields);
}
