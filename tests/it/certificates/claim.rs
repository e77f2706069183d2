//! A claim that is none is told.

use super::originals::{alike, state};
use super::refusals::{Cases, MAX_DIGITS, Original, Spoiled, arch, point};
use couplet::check::Refusal;
use serde_json::json;

fn other_schema(text: &str) -> Cases {
    vec![(point().with("/schema", text), Refusal::Schema(text.into()))]
}

/// The claim names what does not exist.
fn no_such(original: Original, place: &'static str, text: &str) -> Cases {
    let whole = match place {
        "mode" => "/claim/state/mode".to_owned(),
        _ => format!("/claim/{place}"),
    };
    vec![(original.with(&whole, text), Refusal::Name { place, text: text.into() })]
}

/// In another order, with another name, with one twice, with one less and with none.
const CHANGES: [fn(&mut Vec<String>); 5] = [
    |names| names.swap(0, 1),
    |names| names[0] = "width".to_owned(),
    |names| names.push(names[0].clone()),
    |names| drop(names.remove(0)),
    |names| names.clear(),
];

/// The names of the claims' unknowns or equations, changed.
fn other_names(place: &'static str, change: fn(&mut Vec<String>)) -> Cases {
    [point(), arch()]
        .into_iter()
        .map(|original| {
            let mut names: Vec<String> =
                serde_json::from_value(original.0["claim"][place].clone()).unwrap();
            let expected = Refusal::Mismatch { place, expected: names.join(", ") };
            change(&mut names);
            (original.with(&format!("/claim/{place}"), names), expected)
        })
        .collect()
}

fn given(place: &'static str, text: &str) -> Refusal {
    let more = if text.chars().count() > 40 { "…" } else { "" };
    Refusal::Given { place, text: text.chars().take(40).collect::<String>() + more }
}

fn given_as(place: &'static str, text: &str) -> (Spoiled, Refusal) {
    (arch().with(&format!("/claim/state/{place}"), text), given(place, text))
}

/// Neither a half opening nor a friction is given like this.
fn not_given_as(text: &str) -> Cases {
    ["half_opening", "friction"].map(|place| given_as(place, text)).into()
}

fn no_number_of_digits(digits: usize) -> Cases {
    vec![(point().with("/digits", digits), Refusal::Digits(digits, 1_000_000))]
}

fn more_than_asked_for(digits: usize) -> Cases {
    vec![(point().with("/digits", digits), Refusal::Limit(digits, MAX_DIGITS))]
}

/// A number of more digits than are read.
fn long() -> String {
    "7".repeat(100_001)
}

/// The same tangent, of an angle that is half a turn larger.
fn half_a_turn_further() -> Spoiled {
    let original = Original(state("80deg", "31deg"));
    assert_eq!(original.0["claim"]["state"]["friction"], "tan 31/180 pi");
    original.with("/claim/state/friction", "tan 211/180 pi")
}

/// Overturning is a state of unlimited friction only.
fn overturning_with_a_friction() -> Spoiled {
    let original = Original(state("2.62", "inf"));
    assert_eq!(original.0["claim"]["state"]["mode"], "[r]");
    original.with("/claim/state/friction", "5/1")
}

fn both_subjects() -> Spoiled {
    let state = arch().0["claim"]["state"].clone();
    point().changed("both", |copy| copy["claim"]["state"] = state)
}

refusals! {
    other_schemas: [
        "couplet.certificate/2", "couplet.certificate/1 ", "couplet.constants/1", "",
    ].into_iter().flat_map(other_schema).collect();
    a_landmark_and_a_state: both_subjects() => Refusal::Subject;
    texts_that_are_nothing_given: [
        "", "1", "1.5", "1/0", "0/00", "-1/2", "1/-2", "+1/2", "1/2pi", "1/2 pi ", "pi/2", " 1/2", "1/2/3",
        "١/٢", "nan", "0x1/2",
    ].into_iter().flat_map(not_given_as).collect();
    a_long_numerator: not_given_as(&format!("{}/2", long()));
    a_long_denominator: not_given_as(&format!("2/{}", long()));
    the_same_tangent_of_a_larger_angle: half_a_turn_further() => given("friction", "tan 211/180 pi");
    a_friction_for_overturning: overturning_with_a_friction() => given("friction", "5/1");
    no_digits: no_number_of_digits(0);
    a_digit_too_many: more_than_asked_for(MAX_DIGITS + 1);
    a_million_digits: more_than_asked_for(1_000_000);
    more_than_a_million_digits: no_number_of_digits(1_000_001);
    as_many_digits_as_can_be: no_number_of_digits(usize::MAX);
    // No thickness belongs to the purely sliding state.
    names_of_nothing: [
        (point(), "weight", "couplet"), (point(), "weight", "Heyman"), (point(), "weight", ""),
        (point(), "landmark", "X"), (point(), "landmark", "t"), (point(), "landmark", ""),
        (arch(), "mode", "[r,s,s]"), (arch(), "mode", "r,r,s"), (arch(), "mode", "[s,s]"),
    ].into_iter().flat_map(|(original, place, text)| no_such(original, place, text)).collect();
    numbers_that_are_not_given_so: [
        ("half_opening", "inf"), ("half_opening", "1/1 pi"), ("half_opening", "90/1"), ("friction", "tan "),
        ("friction", "tan 1/2 pi"), ("friction", "tan 2/3 pi"), ("friction", "tan(1/2)"),
        ("half_opening", "tan 1/2"), ("friction", "inf"),
    ].into_iter().map(|(place, text)| given_as(place, text)).collect();
    other_unknowns_and_equations: CHANGES.into_iter()
        .flat_map(|change| [other_names("unknowns", change), other_names("equations", change)])
        .flatten().collect();
}

/// Another landmark with the unknowns of this one.
#[test]
fn another_landmark_has_other_unknowns() {
    let mut copy = point().0.clone();
    copy["claim"]["landmark"] = json!("S");
    let mismatch = alike(copy.to_string().as_bytes(), MAX_DIGITS);
    assert!(matches!(mismatch, Err(Refusal::Mismatch { place: "unknowns", .. })), "{mismatch:?}");
}
