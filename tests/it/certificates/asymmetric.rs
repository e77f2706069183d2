//! Certificates of asymmetric solutions of (19), and their spoiled copies.

use super::originals::{alike, asymmetric, find_root, is_near, root, to_value};
use super::refusals::{Cases, MAX_DIGITS, Original, Spoiled};
use crate::arches::{H, M, arch};
use crate::hard::random;
use crate::program::{ended, printed, tells};
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

/// The same joints, said otherwise.
fn contacts(spoil: impl FnOnce(&mut Vec<Value>)) -> Spoiled {
    inner().changed("contacts", |copy| {
        spoil(copy["claim"]["asymmetric"]["contacts"].as_array_mut().unwrap());
    })
}

const CONTACTS: &str = "slides outwards, right shoulder, hinge at the extrados, right crown, slides inwards, left inner, hinge \
                        at the intrados, left haunch";
const SIX: &str = "thrust, crown_moment, vertical_force, thickness, crown_hinge, rotation_joint";

fn mismatch(place: &'static str, expected: &str) -> Refusal {
    Refusal::Mismatch { place, expected: expected.to_owned() }
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
    another_kind_with_its_contacts: inner().changed("kind", |copy| {
        copy["claim"]["asymmetric"] = opening().0["claim"]["asymmetric"].clone();
    }) => mismatch("unknowns", SIX);
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
    a_state_besides: inner().changed("two", |copy| {
        copy["claim"]["slides"] = json!({"half_opening": "23/10", "friction": "21/20"});
    }) => Refusal::Subject;
    the_mirror_image: mirrored() => Refusal::Contraction { place: "unique", unknown: "thrust" };


    // Values.
    a_digit_spoiled: another_digit(inner());
    a_rate_turned: value("inner_slip", "-0.21700725058751804407") => Refusal::Decimal("inner_slip");
    // The least thickness of the arch, of its symmetric state.
    the_symmetric_thickness: value("thickness", "0.51262642180325183402")
        => Refusal::Rounding("thickness");
    a_rate_of_another_kind: value("shoulder_opening", "0.1")
        => Refusal::Quantity("shoulder_opening".into());
    what_is_given: value("friction", "1.05") => Refusal::Quantity("friction".into());
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
    let mut random = random(7);
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
                    is_near(&known, &root, 1e-12);
                }
                Err(Refusal::Condition(_)) => refused += 1,
                other => assert!(other.is_err(), "{problem:?} {other:?}"),
            }
        }
    }
    assert!(refused > 4 && accepted > 8, "{refused} {accepted}");
}

/// Of two kinds one is asked for, and what is not found is open.
#[test]
fn a_kind_is_asked_for() {
    printed("certify asymmetric --weight heyman --alpha 2.3 --mu 1.09 --mode shoulder_opening");
    for (arguments, words) in [
        ("--alpha pi/2 --mu 0.35", "no asymmetric solution is found"),
        ("--alpha 2.3 --mu 1.05 --mode shoulder_opening", "no solution"),
    ] {
        let (_, message) = ended(1, format!("certify asymmetric {arguments}"), "");
        assert_eq!(message.lines().count(), 1, "{message}");
        tells(&message, [words]);
    }
}
