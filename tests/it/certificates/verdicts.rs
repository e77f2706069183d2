//! Certificates of the other verdicts, and their spoiled copies.

use super::originals::{alike, verdict};
use super::refusals::{Cases, MAX_DIGITS, Original, Spoiled};
use crate::arches::{H, arch};
use crate::program::{Json, ended, printed, tells};
use couplet::certify::certify_arch;
use couplet::check::Refusal;
use couplet::problem::{Problem, Verdict};
use serde_json::{Value, json};
use std::sync::OnceLock;

/// It slides: the friction would have to be 0.27…
pub(super) fn slides() -> Original {
    Original(verdict("1.5", "0.1", "1"))
}

/// It is too wide with limited friction, and with unlimited.
pub(super) fn too_wide() -> Original {
    Original(verdict("2.8", "4", "1"))
}

pub(super) fn too_wide_for_any_friction() -> Original {
    Original(verdict("2.85", "inf", "1"))
}

/// The shoulder slides from 0.1223… on.
pub(super) fn too_thin() -> Original {
    Original(verdict("pi/2", "0.38", "0.12"))
}

/// It stands, with the moment about the intrados least at the haunch, at the crown, and at the shoulder.
pub(super) fn stands() -> Original {
    Original(verdict("2.45", "1.35", "0.8"))
}

pub(super) fn stands_at_the_crown() -> Original {
    Original(verdict("2.6", "2", "1.5"))
}

/// A shallow arch with less thrust than the solver would choose: 0.9, with the moment 0.9.
pub(super) fn stands_at_the_shoulder() -> Original {
    static MADE: OnceLock<Value> = OnceLock::new();
    Original(MADE.get_or_init(|| {
        let mut made = verdict("1/10", "inf", "1/20").clone();
        for (place, new) in [
            ("/claim/stands/thrust", json!("0x7333p-15")),
            ("/claim/stands/crown_moment", json!("0x7333p-15")),
            ("/claim/stands/nearest", json!("shoulder")),
            ("/claim/unknowns", json!([])),
            ("/claim/equations", json!([])),
            ("/unique", json!({"centre": [], "radius": []})),
            ("/root", json!({"centre": [], "radius": []})),
            ("/inverse", json!([])),
        ] {
            *made.pointer_mut(place).unwrap() = new;
        }
        made
    }))
}

/// The subject of a claim.
fn subject(original: Original) -> &'static str {
    let mut all = ["slides", "too_wide", "too_thin", "stands"].into_iter();
    all.find(|kind| !original.0["claim"][*kind].is_null()).unwrap()
}

/// A copy with something else in the subject of its claim.
fn with(original: Original, field: &str, value: &str) -> Spoiled {
    original.with(&format!("/claim/{}/{field}", subject(original)), value)
}

fn given(place: &'static str, text: &str) -> Refusal {
    Refusal::Given { place, text: text.to_owned() }
}

/// The claim under another name; the witnesses stay.
fn renamed(original: Original, name: &str) -> Spoiled {
    original.changed(name, |copy| {
        let claim = copy["claim"].as_object_mut().unwrap();
        let subject = claim.remove(subject(original)).unwrap();
        claim.insert(name.to_owned(), subject);
    })
}

/// Every field of the subject left out.
fn left_out() -> Cases {
    let mut cases = Vec::new();
    for original in [slides(), too_wide(), too_thin(), stands()] {
        let place = format!("/claim/{}", subject(original));
        for key in original.0.pointer(&place).unwrap().as_object().unwrap().keys() {
            let reason = Refusal::Format(format!("missing field `{key}`"));
            cases.push((original.without(&place, key), reason));
        }
    }
    cases
}

/// No thickness is given like this.
fn no_thickness(text: &str) -> Cases {
    [too_thin(), stands()]
        .map(|original| (with(original, "thickness", text), given("thickness", text)))
        .into()
}

/// What a mode fixes is a result of its state, and not of an arch that is thinner; nor has it the opening variable.
fn no_result(original: Original, quantity: &str, value: &str) -> Cases {
    let copy = original.changed(quantity, |copy| {
        let values = copy["values"].as_array_mut().unwrap();
        values.push(json!({"quantity": quantity, "value": value}));
    });
    vec![(copy, Refusal::Quantity(quantity.to_owned()))]
}

/// It is too thin, and collapses without thrust, or without a haunch.
fn too_thin_to_overturn(friction: &str, mode: &str) -> Original {
    let original = Original(verdict("2.62", friction, "0.5"));
    assert_eq!(original.0["claim"]["too_thin"]["mode"], mode);
    original
}

/// The witness of one that stands with more bits than are read.
fn long_witness(field: &str) -> Cases {
    let long = format!("0x{}p-24000", "1".repeat(6001));
    vec![(with(stands(), field, &long), Refusal::Large { place: "claim", bits: 24_000 })]
}

refusals! {
    a_long_thrust: long_witness("thrust");
    a_long_moment: long_witness("crown_moment");

    // Names and numbers.
    every_field_of_a_subject: left_out();
    texts_that_are_no_thickness: [
        "0/1", "200000000001/100000000000", "0.1", "1/4 pi", "inf",
    ].into_iter().flat_map(no_thickness).collect();
    what_slides_as_too_wide: renamed(slides(), "too_wide")
        => Refusal::Mismatch {
            place: "unknowns",
            expected: "half_opening, thrust, sliding_joint".into(),
        };
    what_slides_as_a_state: renamed(slides(), "state") => Refusal::Format("missing field `mode`".into());
    what_is_too_thin_as_standing: renamed(too_thin(), "stands") => Refusal::Format("unknown field `mode`".into());
    two_subjects: slides().changed("two", |copy| {
        copy["claim"]["too_wide"] = copy["claim"]["slides"].clone();
    }) => Refusal::Subject;
    a_null_subject: slides().changed("null", |copy| copy["claim"]["stands"] = Value::Null)
        => Refusal::Format("invalid type: null, expected an object".into());
    the_thrust_of_one_too_thin: no_result(too_thin_to_overturn("inf", "[r]"), "thrust", "0");
    the_haunch_of_one_too_thin: no_result(too_thin_to_overturn("2.5", "[r,s]"), "rotation_joint", "0");
    the_opening_variable_of_a_limit: no_result(too_wide_for_any_friction(), "A", "0.66666666666666666667");
}

#[test]
fn the_originals_are_accepted() {
    for original in [
        slides,
        too_wide,
        too_wide_for_any_friction,
        too_thin,
        stands,
        stands_at_the_crown,
        stands_at_the_shoulder,
    ] {
        alike(original().0.to_string().as_bytes(), MAX_DIGITS).unwrap();
    }
    for (original, nearest) in [
        (stands(), "haunch"),
        (stands_at_the_crown(), "crown"),
        (stands_at_the_shoulder(), "shoulder"),
    ] {
        assert_eq!(original.0["claim"]["stands"]["nearest"], nearest);
    }
}

/// Whatever is done to a given thickness, half opening or friction: what is accepted is so.
#[test]
fn around_its_limit_a_claim_is_accepted_on_one_side_only() {
    use crate::arches::{M, number};
    // The least thickness of the semicircle at this friction is 0.12219…
    for weight in [H, M] {
        let semicircle = arch(weight, "pi/2", "0.38");
        for thickness in ["0.1", "0.1221", "0.1223", "0.2"] {
            let made = certify_arch(&semicircle, Some(&number(thickness)), 5).unwrap();
            let accepted = alike(&serde_json::to_vec(&made).unwrap(), MAX_DIGITS).unwrap();
            let Problem::Verdict { verdict, .. } = accepted.problem else { panic!("{thickness}") };
            let stands = matches!(verdict, Verdict::Stands(_));
            assert_eq!(stands, made.claim.stands.is_some(), "{thickness}");
            assert_eq!(stands, semicircle_stands(&format!("{weight:?}"), thickness));
        }
    }
}

/// What `couplet assess` says.
fn semicircle_stands(weight: &str, thickness: &str) -> bool {
    let weight = weight.to_lowercase();
    let arch = "--half-opening pi/2 --friction 0.38 --digits 5";
    let output = printed(format!("assess {arch} --thickness {thickness} --weight {weight}"));
    output.contains("\nstands, proved")
}

/// Next to half a turn the friction of pure sliding is 3e40.
#[test]
fn an_arch_next_to_half_a_turn_has_a_certificate() {
    let arch = arch(H, "0.99999999999999999999999999999999999999999pi", "1");
    let certificate = certify_arch(&arch, None, 10).unwrap();
    let accepted = alike(&serde_json::to_vec(&certificate).unwrap(), MAX_DIGITS).unwrap();
    assert!(matches!(accepted.problem, Problem::Verdict { verdict: Verdict::Slides, .. }));
}

/// A limit is told of the quantity that is compared, whatever the order of the values.
#[test]
fn what_is_printed_compares_only_what_is_compared() {
    let mut made = verdict("1.5", "0.1", "1").clone();
    let printed = |made: &Value| ended(0, "check -", made.to_string()).0;
    let values = made["values"].list().to_vec();
    made["values"] = values.iter().rev().cloned().collect();
    tells(&printed(&made), ["as it is below the limit, friction 0.27"]);
    let is_thrust = |value: &&Value| value["quantity"] == "thrust";
    made["values"] = values.iter().filter(is_thrust).cloned().collect();
    assert!(!printed(&made).contains("as it is"), "{}", printed(&made));
}
