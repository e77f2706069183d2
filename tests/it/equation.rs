//! Equations of the paper at a rotational joint, on the command line.

use crate::arches::number;
use crate::program::{Json, couplet, object, printed, said};
use couplet::certify::equation::{Evaluated, NumberedEquation};
use couplet::prelude::*;
use serde_json::Value;

fn of(arguments: &str) -> (Option<i32>, String, String) {
    said(&couplet(format!("equation {arguments}")))
}

fn json(arguments: &str) -> Value {
    object(format!("equation {arguments}"))
}

/// The closed forms and the roots of the cubics are one, to many digits; the other branch is another.
#[test]
fn any_digits_of_a_closed_form_are_those_of_the_root() {
    for (number, place, index) in [(9, 0, 2), (10, 1, 1), (11, 2, 2)] {
        let arguments = "--rotation-joint 57deg --digits 200";
        let closed = &json(&format!("{number} {arguments}"))["branches"][0];
        let roots = &json(&format!("7 {arguments}"))["polynomials"][place]["real_roots"];
        let root = &roots[index];
        assert_eq!(root["branch"], "upper");
        assert_eq!(closed["printed"]["value"], root["root"]["value"]);
        assert_eq!(closed["trigonometric"], closed["printed"]);
        assert_ne!(closed["printed"]["value"], roots[3 - index]["root"]["value"], "false twin");
        assert!(root["root"]["value"].text().len() > 200);
    }
}

/// Each root is a state of `couplet state` with that joint, and the state of its half opening.
#[test]
fn each_branch_is_a_state_with_the_joint() {
    let state = |arguments: &str| object(format!("state {arguments} --digits 25"));
    let found = state("--rotation-joint 1.0");
    let roots = &json("7 --rotation-joint 1.0 --digits 25")["polynomials"][1]["real_roots"];
    let states = found["states"].list();
    assert_eq!(states.len(), 2);
    for (index, of) in states.iter().enumerate() {
        assert_eq!(of["thickness"], roots[index + 1]["root"]);
        assert_ne!(of["thickness"], roots[2 - index]["root"], "false twin");
        let alpha = of["half_opening"]["value"].text();
        let back = state(&format!("--half-opening {alpha} --friction inf"));
        let joint = back["rotation_joint"].value();
        assert!((joint - 1.0).abs() < 1e-15, "{joint}");
    }
}

#[test]
fn the_sign_of_the_radicand_tells_whether_there_are_states() {
    for (joint, is_positive, states) in [("1.1198", false, 2), ("1.1199", true, 0)] {
        let found = json(&format!("12 --beta {joint}"));
        assert_eq!(found["is_positive"], is_positive, "{joint}");
        let polynomials = json(&format!("7 --beta {joint}"));
        let roots = polynomials["polynomials"][1]["real_roots"].list();
        assert_eq!(roots.iter().filter(|root| !root["branch"].is_null()).count(), states);
    }
}

#[test]
fn what_stays_open_has_a_reason_and_exit_code_1() {
    let asked = "--quantity rotation_joint --digits 2600 --weight milankovitch --plain";
    let joint = printed(format!("constants sb {asked}")).trim().to_owned();
    let (code, out, error) = of(&format!("12 --beta {joint}"));
    assert_eq!(code, Some(1));
    assert!(out.contains("undecided: the sign of (12)"), "{out}");
    assert!(error.contains("undecided"), "{error}");
    let (code, out, _) = of(&format!("7 --beta {joint} --digits 5"));
    assert_eq!(code, Some(1));
    assert!(out.contains("coefficient of A^3") && !out.contains("root  "), "{out}");
    assert_eq!(of(&format!("12 --beta {}", &joint[..40])).0, Some(0), "false twin");
}

/// Exact arguments of the paper: of an angle, and of a ratio.
const ANGLES: &str = "0 1/2 2/3 1 2 pi/6 pi/5 45deg 60deg 90deg 120deg 3pi/4 5pi/6 180deg 2atan(1) 2atan(1/2) 2atan(1/3)";
const RATIOS: &str = "0 2/7 1/2 2/3 4/5 1 2 pi/6";

/// Every equation at every choice of exact arguments has values, or a sentence that says why there are none.
#[test]
fn at_exact_arguments_every_equation_answers() {
    for weight in SelfWeight::ALL {
        for equation in NumberedEquation::ALL {
            for choice in equation.choices() {
                let mut all: Vec<Vec<(Quantity, ExactNumber)>> = vec![Vec::new()];
                for &of in *choice {
                    let is_angle = matches!(of, Quantity::HalfOpening | Quantity::RotationJoint);
                    let values = if is_angle { ANGLES } else { RATIOS };
                    let with = |given: Vec<(Quantity, ExactNumber)>| {
                        let next = |text: &str| [given.clone(), vec![(of, number(text))]].concat();
                        values.split(' ').map(next).collect::<Vec<_>>()
                    };
                    all = all.into_iter().flat_map(with).collect();
                }
                let answered = all.iter().filter(|given| {
                    match equation.evaluate(weight, given, 30) {
                        Err(Error::Undecided(open)) => panic!("{equation:?} {given:?}: {open}"),
                        Err(_) => return false,
                        Ok(Evaluated::Values(values)) => assert!(!values.is_empty()),
                        Ok(Evaluated::Cubics(all)) => {
                            assert!(all.iter().all(|of| of.roots.is_ok()), "{given:?}");
                        }
                        Ok(Evaluated::Link(link)) => assert!(link.holds, "{given:?}"),
                        Ok(_) => {}
                    }
                    true
                });
                let other = match equation {
                    NumberedEquation::OverturningHeyman => weight != SelfWeight::Heyman,
                    NumberedEquation::OverturningMilankovitch
                    | NumberedEquation::OpeningVariable
                    | NumberedEquation::Thickness
                    | NumberedEquation::Thrust => weight == SelfWeight::Heyman,
                    _ => false,
                };
                assert_eq!(answered.count() == 0, other, "{equation:?} {weight:?}");
            }
        }
    }
}

/// What is exactly a decimal has its digits and no zeros behind; what has no value says why.
#[test]
fn exact_values_are_shown_exact() {
    for (arguments, index, value) in [
        ("2 --beta 60deg --eta 2 --weight heyman", 0, "-0.25"),
        ("4 --opening-variable 1 --eta 1/2 --weight heyman", 1, "0.2"),
        ("5 --beta 90deg --eta 1 --weight heyman", 0, "-1"),
        ("13 --eta 1.2 --weight heyman", 0, "0.625"),
        ("14 --opening-variable 0.8 --weight heyman", 0, "0.5"),
        ("14 --opening-variable 1/2 --weight heyman", 0, "2"),
        ("14 --opening-variable 1 --weight heyman", 0, "0"),
        ("15 --opening-variable 2/3", 0, "2"),
        ("15 --opening-variable 1", 0, "0"),
        ("16 --eta 1 --weight heyman", 0, "0"),
        ("18 --thrust 0.8", 0, "0.4"),
    ] {
        let found = &json(arguments)["values"][index];
        for bound in ["value", "lower", "upper"] {
            assert_eq!(found[bound], value, "{arguments}");
        }
    }
    assert_ne!(json("18 --thrust 0.81")["values"][0]["value"], "0.4", "false twin");
    assert_eq!(of("3 --alpha 2atan(1/2) --beta 2atan(1/3) --eta 2/9").0, Some(0), "false twin");
}

/// At the angles of a set square coefficients are exact; one root is too, and it is that of the state.
#[test]
fn at_the_angles_of_a_set_square_the_cubics_have_exact_coefficients() {
    for (joint, weight, polynomial, coefficient, value) in [
        ("60deg", "milankovitch", 2, 0, "4.5"),
        ("45deg", "milankovitch", 2, 0, "3"),
        ("2pi/3", "milankovitch", 2, 0, "4.5"),
        ("pi/6", "milankovitch", 1, 0, "0.5"),
        ("pi/6", "heyman", 2, 0, "1"),
        ("pi/2", "heyman", 2, 1, "0"),
    ] {
        let all = json(&format!("7 --beta {joint} --weight {weight}"));
        let found = &all["polynomials"][polynomial];
        assert_eq!(found["coefficients"][coefficient]["value"], value, "{joint} {weight}");
    }
    let thrusts = |joint: &str| {
        json(&format!("7 --beta {joint} --weight heyman"))["polynomials"][2]["real_roots"].clone()
    };
    let exact =
        |roots: &Value| roots.list().iter().filter(|of| of["root"]["value"] == "0.5").count();
    assert_eq!((exact(&thrusts("60deg")), exact(&thrusts("59deg"))), (1, 0));
    for (given, value, other) in [
        ("--rotation-joint 60deg", "thrust", "0.5"),
        ("--opening-variable 0.625", "thickness", "1.2"),
        ("--thickness 1.2", "A", "0.625"),
    ] {
        let states = object(format!("state --weight heyman {given}"));
        let states = states["states"].list();
        let holds = |of: &&Value| ["value", "lower", "upper"].iter().all(|x| of[value][x] == other);
        assert_eq!(states.iter().filter(holds).count(), 1, "{given}: {states:?}");
    }
}
