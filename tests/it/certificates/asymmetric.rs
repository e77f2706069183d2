//! Certificates of asymmetric solutions of (19), and their spoiled copies.

use super::originals::{alike, asymmetric, at_root, find_root, root, to_value};
use super::refusals::{Cases, MAX_DIGITS, Original, Spoiled};
use crate::arches::{H, M, arch};
use couplet::arch::SelfWeight;
use couplet::arch::asymmetric::AsymmetricMode::{
    self, InnerSliding, ShoulderOpening, ShoulderSliding,
};
use couplet::check::{Refusal, check_certificate};
use couplet::number::Ball;
use couplet::problem::Problem;
use serde_json::{Value, json};

/// The shoulder slides, and a joint of the other half.
pub(super) fn inner() -> Original {
    Original(asymmetric(M, "2.3", "1.05", InnerSliding))
}

/// The shoulder slides and opens.
fn opening() -> Original {
    Original(asymmetric(M, "2.3", "1.07", ShoulderOpening))
}

/// The shoulder slides, and nothing closes the motion but the two hinges.
fn alone() -> Original {
    Original(asymmetric(M, "2.25", "0.99", ShoulderSliding))
}

/// A copy with something else in the subject of its claim.
fn with(original: Original, field: &str, value: impl Into<Value>) -> Spoiled {
    original.with(&format!("/claim/asymmetric/{field}"), value)
}

/// The same joints, said otherwise.
fn contacts(spoil: impl FnOnce(&mut Vec<Value>)) -> Spoiled {
    inner().changed("contacts", |copy| {
        spoil(copy["claim"]["asymmetric"]["contacts"].as_array_mut().unwrap());
    })
}

const CONTACTS: &str = "slides outwards, right shoulder, hinge at the extrados, right crown, slides inwards, left inner, hinge \
                        at the intrados, left haunch";
const OF_OPENING: &str = "slides outwards, right shoulder, hinge at the extrados, right shoulder, hinge at the extrados, right \
                          crown, hinge at the intrados, left haunch";
const SIX: &str = "thrust, crown_moment, vertical_force, thickness, crown_hinge, rotation_joint";

fn mismatch(place: &'static str, expected: &str) -> Refusal {
    Refusal::Mismatch { place, expected: expected.to_owned() }
}

/// The root of the equations of a kind next to this point does not meet this condition.
pub(super) fn unmet(
    mode: AsymmetricMode,
    (half_opening, friction): (&str, &str),
    start: &[f64],
    words: &'static str,
) -> Cases {
    let problem = Problem::Asymmetric { mode, arch: arch(M, half_opening, friction) };
    let certificate = to_value(&at_root(&problem, start)).to_string();
    vec![(Spoiled::new(words, certificate), Refusal::Condition(words))]
}

/// The state as the mirror has it: the vertical force the other way, the joints on the other sides.
fn mirrored() -> Spoiled {
    inner().changed("mirrored", |copy| {
        for place in ["unique", "root"] {
            for k in [2, 4, 5, 6] {
                let number = &mut copy[place]["centre"][k];
                *number = json!(format!("-{}", number.as_str().unwrap()));
            }
        }
    })
}

/// Every field of the subject left out, and one more.
fn fields() -> Cases {
    let mut cases: Cases = ["mode", "half_opening", "friction", "contacts"]
        .map(|key| {
            let reason = Refusal::Format(format!("missing field `{key}`"));
            (inner().without("/claim/asymmetric", key), reason)
        })
        .into();
    let more = inner().changed("more", |copy| copy["claim"]["asymmetric"]["rates"] = json!([]));
    cases.push((more, Refusal::Format("unknown field `rates`".into())));
    cases
}

/// Each value with another last digit.
pub(super) fn another_digit(original: Original) -> Cases {
    let values = original.0["values"].as_array().unwrap();
    let spoil = |(k, value): (usize, &Value)| {
        let text = value["value"].as_str().unwrap();
        let (head, last) = text.split_at(text.len() - 1);
        let last = (last.parse::<u32>().unwrap() + 1) % 10;
        let name = value["quantity"].as_str().unwrap();
        let quantity = couplet::problem::Quantity::LANDMARK
            .into_iter()
            .chain(couplet::problem::Quantity::ASYMMETRIC)
            .find(|quantity| quantity.name() == name);
        let reason = Refusal::Rounding(quantity.unwrap().name());
        (original.with(&format!("/values/{k}/value"), format!("{head}{last}")), reason)
    };
    values.iter().enumerate().map(spoil).collect()
}

/// A value that another quantity has.
fn value(quantity: &str, text: &str) -> Spoiled {
    inner().changed(quantity, |copy| {
        copy["values"] = json!([{"quantity": quantity, "value": text}]);
    })
}

refusals! {
    // What the claim says of the joints is not believed: it has to be what its kind has.
    a_contact_moved: contacts(|all| all[3] = json!("hinge at the intrados, right haunch"))
        => mismatch("contacts", CONTACTS);
    a_contact_of_another_kind: contacts(|all| all[1] = json!("hinge at the intrados, right crown"))
        => mismatch("contacts", CONTACTS);
    a_joint_that_slides_the_other_way: contacts(|all| all[2] = json!("slides outwards, left inner"))
        => mismatch("contacts", CONTACTS);
    contacts_in_another_order: contacts(|all| all.swap(0, 1)) => mismatch("contacts", CONTACTS);
    a_contact_left_out: contacts(|all| drop(all.pop())) => mismatch("contacts", CONTACTS);
    a_contact_too_many: contacts(|all| all.push(all[0].clone())) => mismatch("contacts", CONTACTS);
    another_kind: with(inner(), "mode", "shoulder_opening") => mismatch("contacts", OF_OPENING);
    another_kind_with_its_contacts: inner().changed("kind", |copy| {
        copy["claim"]["asymmetric"] = opening().0["claim"]["asymmetric"].clone();
    }) => mismatch("unknowns", SIX);
    a_kind_that_is_none:
        with(inner(), "mode", "[s,r,r]") => Refusal::Name { place: "mode", text: "[s,r,r]".into() };
    unknowns_in_another_order: inner().changed("order", |copy| {
        copy["claim"]["unknowns"].as_array_mut().unwrap().swap(1, 2);
    }) => mismatch(
        "unknowns",
        "thrust, crown_moment, vertical_force, thickness, crown_hinge, rotation_joint, sliding_joint",
    );
    equations_of_another_kind: opening().changed("equations", |copy| {
        copy["claim"]["equations"] = alone().0["claim"]["equations"].clone();
    }) => mismatch(
        "equations",
        "E(b0) = 0, E'(b0) = 0, I(-b1) = 0, I'(-b1) = 0, O(alpha) = 0, E(alpha) = 0",
    );
    fields_of_the_subject: fields();
    unlimited_friction: with(inner(), "friction", "inf")
        => Refusal::Given { place: "friction", text: "inf".into() };
    a_state_besides: inner().changed("two", |copy| {
        copy["claim"]["slides"] = json!({"half_opening": "23/10", "friction": "21/20"});
    }) => Refusal::Subject;
    another_weight: inner().with("/claim/weight", "heyman")
        => Refusal::Contraction { place: "unique", unknown: "crown_moment" };
    another_arch: with(inner(), "half_opening", "3/2")
        => Refusal::Contraction { place: "unique", unknown: "thrust" };
    another_friction: with(inner(), "friction", "106/100")
        => Refusal::Contraction { place: "unique", unknown: "thrust" };
    the_mirror_image: mirrored() => Refusal::Contraction { place: "unique", unknown: "thrust" };

    // True roots of the equations that are no solutions.
    an_inner_joint_that_slides_outwards:
        unmet(
            InnerSliding,
            ("2.25", "0.99"),
            &[0.2175, 0.2731, 0.1073, 0.58, 0.1089, 1.0483, 0.3052],
            "an inner joint that slides inwards",
        );
    a_vertical_force_the_other_way:
        unmet(
            InnerSliding,
            ("2.3", "1.02"),
            &[0.1531, 0.1948, -0.0133, 0.5457, -0.0128, 1.089, 0.3734],
            "a positive vertical force in the crown",
        );
    a_line_of_thrust_outside_at_the_other_springing:
        unmet(
            InnerSliding,
            ("2.3", "1.1"),
            &[0.222, 0.2743, 0.1684, 0.6407, 0.1693, 1.0065, 0.2472],
            "the line of thrust inside the extrados on the whole arch",
        );

    // Values.
    a_digit_spoiled: another_digit(inner());
    a_rate_turned: value("inner_slip", "-0.21700725058751804407") => Refusal::Decimal("inner_slip");
    // The least thickness of the arch, of its symmetric state.
    the_symmetric_thickness: value("thickness", "0.51262642180325183402")
        => Refusal::Rounding("thickness");
    a_rate_of_another_kind: value("shoulder_opening", "0.1")
        => Refusal::Quantity("shoulder_opening".into());
    what_is_given: value("friction", "1.05") => Refusal::Quantity("friction".into());
    no_values: inner().with("/values", json!([])) => Refusal::NoValues;
}

#[test]
fn the_originals_are_accepted() {
    for original in [inner(), opening(), alone()] {
        let accepted = alike(original.0.to_string().as_bytes(), MAX_DIGITS).unwrap();
        assert_eq!(accepted.values.len(), original.0["values"].as_array().unwrap().len());
    }
}

/// Newton's method finds many roots of the equations from many starts; of those of a kind no other is accepted than
/// the one that is known.
#[test]
fn of_all_the_roots_one_is_accepted() {
    let mut state = 7u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut refused, mut accepted) = (0, 0);
    let arches: [(SelfWeight, &str, &str, AsymmetricMode); 4] = [
        (M, "2.3", "1.05", InnerSliding),
        (H, "2.3", "1.09", InnerSliding),
        (H, "2.3", "1.09", ShoulderOpening),
        (M, "2.25", "0.99", ShoulderSliding),
    ];
    for (weight, half_opening, friction, mode) in arches {
        let known = root(asymmetric(weight, half_opening, friction, mode));
        let problem = Problem::Asymmetric { mode, arch: arch(weight, half_opening, friction) };
        for near in 0..12 {
            // From beside the known root, and from anywhere.
            let size = if near < 4 { 0.02 } else { 1.0 };
            let start: Vec<f64> = known.iter().map(|x| x + size * (random() - 0.5)).collect();
            let Some(certificate) = find_root(&problem, &start) else { continue };
            match check_certificate::<Ball>(&certificate, 5) {
                Err(Refusal::NoValues) => {
                    accepted += 1;
                    let root = root(&to_value(&certificate));
                    let same = known.iter().zip(&root).all(|(a, b)| (a - b).abs() < 1e-12);
                    assert!(same, "{problem:?}: {known:?} and {root:?}");
                }
                Err(Refusal::Condition(_)) => refused += 1,
                other => assert!(other.is_err(), "{problem:?} {other:?}"),
            }
        }
    }
    assert!(refused > 4 && accepted > 8, "{refused} {accepted}");
}

/// The command writes what is found, and the checker says it.
#[test]
fn what_is_certified_is_said() {
    use crate::program::{couplet, fed, said, text};
    let certify = |arguments: &[&str]| {
        couplet(&[&["certify", "asymmetric", "--digits", "5"], arguments].concat())
    };
    let made = certify(&["--alpha", "2.3", "--mu", "1.05"]);
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    assert_eq!(
        said(&fed(&["check", "-"], &made.stdout)).1,
        "-: accepted  asymmetric solution of (19), inner_sliding, half_opening 23/10 friction 21/20 milankovitch  \
         thickness 0.58308 to 5 digits\n"
    );
    let two = ["--weight", "heyman", "--alpha", "2.3", "--mu", "1.09"];
    let made = certify(&[&two[..], &["--mode", "shoulder_opening"]].concat());
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    for (arguments, code, words) in [
        (&two[..], 2, "it has several: give --mode shoulder_opening or inner_sliding"),
        (&["--alpha", "pi/2", "--mu", "0.35"], 1, "no asymmetric solution is found"),
        (&["--alpha", "2.3", "--mu", "inf"], 2, "limited friction"),
        (&["--alpha", "2.3"], 2, "--friction (or --friction-angle) is missing"),
        (&["--alpha", "2.3", "--mu", "1.05", "--mode", "[r,r]"], 2, "one of inner_sliding"),
        (&["--alpha", "2.3", "--mu", "1.05", "--mode", "shoulder_opening"], 1, "no solution"),
        (&["--alpha", "2.3", "--mu", "1.05", "--thickness", "1"], 2, "belongs to `arch`"),
    ] {
        let (found, _, message) = said(&certify(arguments));
        assert!(found == Some(code) && message.contains(words), "{arguments:?}: {message}");
        assert_eq!(message.trim_end().lines().count(), 1, "{message}");
    }
    let (code, _, message) = said(&couplet(&["certify", "T", "--mode", "inner_sliding"]));
    assert!(code == Some(2) && message.contains("a mode belongs to `asymmetric`"), "{message}");
}
