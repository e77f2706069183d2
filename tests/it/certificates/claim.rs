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

/// The names of the claims' unknowns or equations, changed.
fn other_names(place: &'static str, change: fn(Vec<String>) -> Vec<String>) -> Cases {
    [point(), arch()]
        .into_iter()
        .map(|original| {
            let names: Vec<String> =
                serde_json::from_value(original.0["claim"][place].clone()).unwrap();
            let expected = Refusal::Mismatch { place, expected: names.join(", ") };
            (original.with(&format!("/claim/{place}"), change(names)), expected)
        })
        .collect()
}

fn swapped(mut names: Vec<String>) -> Vec<String> {
    names.swap(0, 1);
    names
}

fn another_name(mut names: Vec<String>) -> Vec<String> {
    names[0] = "width".to_owned();
    names
}

fn one_twice(mut names: Vec<String>) -> Vec<String> {
    names.push(names[0].clone());
    names
}

fn one_less(mut names: Vec<String>) -> Vec<String> {
    names.remove(0);
    names
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
    another_version: other_schema("couplet.certificate/2");
    a_space_behind_the_schema: other_schema("couplet.certificate/1 ");
    the_schema_of_constants: other_schema("couplet.constants/1");
    an_empty_schema: other_schema("");

    a_landmark_and_a_state: both_subjects() => Refusal::Subject;
    neither_a_landmark_nor_a_state: point().without("/claim", "landmark") => Refusal::Subject;

    an_unknown_weight: no_such(point(), "weight", "couplet");
    a_weight_in_capitals: no_such(point(), "weight", "Heyman");
    an_empty_weight: no_such(point(), "weight", "");
    an_unknown_landmark: no_such(point(), "landmark", "X");
    a_landmark_in_small_letters: no_such(point(), "landmark", "t");
    an_empty_landmark: no_such(point(), "landmark", "");
    an_unknown_mode: no_such(arch(), "mode", "[r,s,s]");
    a_mode_without_brackets: no_such(arch(), "mode", "r,r,s");
    // No thickness belongs to the purely sliding state.
    the_purely_sliding_mode: no_such(arch(), "mode", "[s,s]");

    unknowns_in_another_order: other_names("unknowns", swapped);
    another_unknown: other_names("unknowns", another_name);
    an_unknown_too_many: other_names("unknowns", one_twice);
    an_unknown_too_few: other_names("unknowns", one_less);
    no_unknowns: other_names("unknowns", |_| Vec::new());
    equations_in_another_order: other_names("equations", swapped);
    another_equation: other_names("equations", another_name);
    an_equation_too_many: other_names("equations", one_twice);
    an_equation_too_few: other_names("equations", one_less);
    no_equations: other_names("equations", |_| Vec::new());

    nothing_given: not_given_as("");
    a_whole_number: not_given_as("1");
    a_decimal: not_given_as("1.5");
    a_zero_denominator: not_given_as("1/0");
    zero_over_zero: not_given_as("0/00");
    a_negative_number: not_given_as("-1/2");
    a_negative_denominator: not_given_as("1/-2");
    a_plus: not_given_as("+1/2");
    pi_without_a_space: not_given_as("1/2pi");
    a_space_behind_pi: not_given_as("1/2 pi ");
    pi_as_a_numerator: not_given_as("pi/2");
    a_space_before_the_number: not_given_as(" 1/2");
    two_denominators: not_given_as("1/2/3");
    arabic_digits: not_given_as("١/٢");
    nan: not_given_as("nan");
    a_hexadecimal_number: not_given_as("0x1/2");
    a_long_numerator: not_given_as(&format!("{}/2", long()));
    a_long_denominator: not_given_as(&format!("2/{}", long()));
    an_infinite_half_opening: vec![given_as("half_opening", "inf")];
    half_a_turn: vec![given_as("half_opening", "1/1 pi")];
    degrees_without_their_unit: vec![given_as("half_opening", "90/1")];
    a_tangent_without_a_number: vec![given_as("friction", "tan ")];
    a_tangent_of_a_right_angle: vec![given_as("friction", "tan 1/2 pi")];
    a_tangent_of_an_obtuse_angle: vec![given_as("friction", "tan 2/3 pi")];
    the_same_tangent_of_a_larger_angle: half_a_turn_further() => given("friction", "tan 211/180 pi");
    a_tangent_in_brackets: vec![given_as("friction", "tan(1/2)")];
    a_tangent_as_a_half_opening: vec![given_as("half_opening", "tan 1/2")];
    no_friction_for_a_mode_that_slides: vec![given_as("friction", "inf")];
    a_friction_for_overturning: overturning_with_a_friction() => given("friction", "5/1");

    no_digits: no_number_of_digits(0);
    a_digit_too_many: more_than_asked_for(MAX_DIGITS + 1);
    a_million_digits: more_than_asked_for(1_000_000);
    more_than_a_million_digits: no_number_of_digits(1_000_001);
    as_many_digits_as_can_be: no_number_of_digits(usize::MAX);
}

/// Another landmark with the unknowns of this one.
#[test]
fn another_landmark_has_other_unknowns() {
    let mut copy = point().0.clone();
    copy["claim"]["landmark"] = json!("S");
    let mismatch = alike(copy.to_string().as_bytes(), MAX_DIGITS);
    assert!(matches!(mismatch, Err(Refusal::Mismatch { place: "unknowns", .. })), "{mismatch:?}");
}
