//! Equations at joints against numbers of another program, and what they refuse.

use super::*;
use crate::arch::SelfWeight;
use crate::certify::CertifiedLandmark;
use crate::problem::{Landmark, Quantity};
use crate::prover::Error;

fn at(number: u8, weight: SelfWeight, joint: &str, digits: usize) -> Result<Evaluated, Error> {
    let equation = NumberedEquation::named(&format!("({number})")).unwrap();
    equation.evaluate(weight, &[(Quantity::RotationJoint, joint.parse().unwrap())], digits)
}

fn cubics(weight: SelfWeight, joint: &str, digits: usize) -> Vec<PolynomialAt> {
    match at(7, weight, joint, digits) {
        Ok(Evaluated::Cubics(all)) => all,
        other => panic!("{other:?}"),
    }
}

fn roots(weight: SelfWeight, joint: &str, digits: usize) -> Vec<Vec<String>> {
    let shown = |of: &RootAt| format!("{} {:?}", of.value, of.branch.map(RootBranch::name));
    let all = cubics(weight, joint, digits);
    all.iter().map(|of| of.roots.as_ref().unwrap().iter().map(shown).collect()).collect()
}

/// The roots at the joint 1 by mpmath.
#[test]
fn the_cubics_have_the_roots_that_another_program_finds() {
    let [none, upper, lower] = ["None", "Some(\"upper\")", "Some(\"lower\")"];
    assert_eq!(
        roots(SelfWeight::Milankovitch, "1.0", 12),
        [
            [
                format!("-2.50374836684 {none}"),
                format!("0.864406565510 {lower}"),
                format!("1.49837273157 {upper}")
            ],
            [
                format!("-10.9217226303 {none}"),
                format!("0.142745381947 {upper}"),
                format!("0.666607165582 {lower}")
            ],
            [
                format!("-0.0512319890609 {none}"),
                format!("0.0866163911752 {lower}"),
                format!("0.563405815964 {upper}")
            ]
        ]
    );
    assert_eq!(
        roots(SelfWeight::Heyman, "1.0", 12),
        [
            [format!("0.811197474647 {lower}"), format!("1.49912012507 {upper}")],
            [format!("0.142249234331 {upper}"), format!("0.722470793536 {lower}")],
            [format!("0.0765706772729 {lower}"), format!("0.565521938661 {upper}")]
        ]
    );
}

#[test]
fn beyond_the_widest_joint_no_root_is_a_state() {
    for (weight, joint, count) in [
        (SelfWeight::Milankovitch, "1.2", 1),
        (SelfWeight::Heyman, "1.2", 0),
        (SelfWeight::Milankovitch, "3", 3),
        (SelfWeight::Heyman, "3", 2),
    ] {
        for polynomial in cubics(weight, joint, 8) {
            let roots = polynomial.roots.as_ref().unwrap();
            assert!(roots.len() == count && roots.iter().all(|root| root.branch.is_none()));
            let all = polynomial.coefficients.len() - 1;
            assert_eq!(polynomial.has_complex_pair(), Some(count < all), "{weight:?} {joint}");
        }
    }
}

/// At a tiny joint every formula cancels: `eta` is `beta⁴/12` and `h` just below one.
#[test]
fn at_a_tiny_joint_the_digits_are_proved() {
    let all = roots(SelfWeight::Milankovitch, "1e-30", 6);
    assert_eq!(all[1][1], "8.33333e-122 Some(\"upper\")");
    assert_eq!(all[0].len(), 3);
}

#[test]
fn the_closed_forms_are_roots_with_digits_lost() {
    for number in 9..=11u8 {
        for joint in ["0.3", "1.0", "57deg"] {
            let Ok(Evaluated::Closed(form, branches)) =
                at(number, SelfWeight::Milankovitch, joint, 40)
            else {
                panic!()
            };
            let all = cubics(SelfWeight::Milankovitch, joint, 40);
            let polynomial = all.iter().find(|of| of.unknown == form).unwrap();
            for found in branches {
                let roots = polynomial.roots.as_ref().unwrap();
                let root = roots.iter().find(|root| root.branch == Some(found.branch)).unwrap();
                let other = roots.iter().find(|root| root.branch != Some(found.branch)).unwrap();
                assert_eq!(found.printed.to_string(), root.value.to_string(), "{number} {joint}");
                assert_eq!(found.trigonometric.to_string(), root.value.to_string());
                assert_ne!(found.printed.to_string(), other.value.to_string(), "false twin");
                assert!(found.printed_loss < 20 && found.trigonometric_loss < 20);
            }
        }
    }
    let lost = |joint| match at(10, SelfWeight::Milankovitch, joint, 10) {
        Ok(Evaluated::Closed(_, all)) => all[0].printed_loss,
        other => panic!("{other:?}"),
    };
    assert!(lost("1e-8") > 10 + lost("1.0"), "small joints lose more");
}

#[test]
fn the_link_holds_and_the_radicand_has_a_sign() {
    for joint in ["1e-20", "1.0", "3"] {
        let Ok(Evaluated::Link(link)) = at(8, SelfWeight::Heyman, joint, 30) else { panic!() };
        assert!(link.holds, "{joint}");
        assert!(link.difference[0].to_rational() <= 0 && link.difference[1].to_rational() >= 0);
    }
    for (weight, joint, value, sign) in [
        (SelfWeight::Milankovitch, "1.0", "-5.23611333", false),
        (SelfWeight::Heyman, "1.0", "-4.08575555", false),
        (SelfWeight::Milankovitch, "1.2", "5.23340348", true),
    ] {
        let Ok(Evaluated::Radicand(found)) = at(12, weight, joint, 9) else { panic!() };
        assert_eq!((found.value.to_string().as_str(), found.is_positive), (value, sign));
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    for (number, weight, joint, words) in [
        (7, SelfWeight::Heyman, "0", "is not between 0 and pi"),
        (8, SelfWeight::Heyman, "pi", "is not between 0 and pi"),
        (12, SelfWeight::Heyman, "57", "did you mean 57deg?"),
        (9, SelfWeight::Heyman, "1.0", "for Milankovitch's weight"),
        (10, SelfWeight::Milankovitch, "1.2", "beyond the widest one"),
        (11, SelfWeight::Milankovitch, "3", "beyond the widest one"),
    ] {
        let error = at(number, weight, joint, 5).unwrap_err();
        assert!(matches!(error, Error::Refused(_)), "{error}");
        assert!(error.to_string().contains(words), "{error}");
    }
    assert!(at(7, SelfWeight::Heyman, "1.0", 0).is_err());
    for none in ["1", "19", "x"] {
        assert!(NumberedEquation::named(none).is_none());
    }
}

/// The widest joint itself cannot be given; its first 2500 digits are nearer than the bits that are tried.
#[test]
fn next_to_the_widest_joint_the_roots_stay_open() {
    let point = CertifiedLandmark::new(Landmark::WidestJoint, SelfWeight::Milankovitch).unwrap();
    let joint = |digits| point.constant(Quantity::RotationJoint, digits).unwrap().value.to_string();
    let near = joint(2500);
    assert!(matches!(at(12, SelfWeight::Milankovitch, &near, 5), Err(Error::Undecided(_))));
    assert!(matches!(at(10, SelfWeight::Milankovitch, &near, 5), Err(Error::Undecided(_))));
    let all = cubics(SelfWeight::Milankovitch, &near, 5);
    assert!(all.iter().all(|of| of.roots.is_err() && of.coefficients.len() == 4));
    let farther = joint(20);
    assert!(at(12, SelfWeight::Milankovitch, &farther, 5).is_ok(), "false twin");
}
