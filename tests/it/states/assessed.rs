//! Arches of a given thickness.

use super::mode;
use crate::arches::{H, M, arch, critical_friction, number, tangent_of_one_half};
use couplet::arch::SelfWeight;
use couplet::certify::state::{AssessmentDigits, Certify};
use couplet::problem::{Mode, Quantity};
use std::collections::HashSet;

fn assessed(weight: SelfWeight, alpha: &str, mu: &str, eta: &str) -> AssessmentDigits {
    let found = arch(weight, alpha, mu).certify_thickness(&number(eta), 20);
    found.unwrap_or_else(|doubt| panic!("{alpha} {mu} {eta}: {doubt:?}"))
}

/// What is no thickness is refused at every door (`misuse`); the limit is one.
#[test]
fn the_largest_thickness_is_assessed() {
    for thickness in ["1.99", "2"] {
        assert_eq!(assessed(H, "pi/2", "0.5", thickness).stands, Ok(true), "{thickness}");
    }
}

/// Arches on which a comparison of the assessment is an exact tie: everything is decided.
#[test]
fn exact_ties_do_not_hide_the_answer() {
    let cases = [
        // The lever arm that bounds the thrust at the crown is zero: (2 - eta) = (2 + eta) cos(alpha).
        (M, "pi/3", "0.5", "2/3"),
        // Besides, the line of least thrust touches the intrados exactly at the shoulder.
        (H, "pi/3", "0.5", "2/3"),
        (H, "pi/3", "inf", "2/3"),
        (M, "60deg", "2", "2/3"),
        (M, "pi/3", "60deg", "2/3"),
        (M, "pi/2", "0.5", "2"),
        (H, "90deg", "inf", "2"),
        // The friction angle is the half opening: the shoulder can just not slide.
        (M, "pi/4", "1", "0.1"),
        (H, "pi/4", "1", "0.5"),
        (M, "pi/4", "1", "0.5"),
        (M, "30deg", "30deg", "0.5"),
        (H, "60deg", "tan(60deg)", "0.7"),
        (M, "1/3", "tan(1/3)", "0.7"),
        // The thickness is that of the end of rotation.
        (H, "pi/2", "0.5", "1"),
        (H, "pi/2", "inf", "1"),
        // No friction at all.
        (M, "1", "0", "0.2"),
        // A thrust far below any double.
        (M, "2.3", "1e900", "1.5"),
    ];
    for (weight, alpha, mu, eta) in cases {
        let found = assessed(weight, alpha, mu, eta);
        assert_eq!(found.stands, Ok(mu != "0"), "{alpha} {mu} {eta}");
        assert_eq!(found.open().collect::<Vec<_>>(), [], "{alpha} {mu} {eta}");
    }
    assert_eq!(mode(M, "2.6", "1e900"), Mode::OverturningSliding);
}

/// Where the shoulder slides at no thrust, and where the crown has no lever arm, nothing bounds the thrust.
/// The least thrusts come from a derivation of their own.
#[test]
fn exact_ties_leave_the_thrust_unbounded() {
    for (weight, alpha, mu, eta, least) in [
        (M, "pi/4", "1", "0.5", Some(0.1633041930418988)),
        (H, "pi/3", "inf", "2/3", Some(0.1045997880780726)),
        (M, "pi/3", "inf", "2/3", Some(0.08658346485675566)),
        (M, "pi/3", "60deg", "2/3", None),
        (H, "pi/2", "inf", "2", Some(0.0)),
    ] {
        let found = assessed(weight, alpha, mu, eta);
        let [low, high] = found.limits().map(Option::unwrap);
        assert!(high.thrust.is_none(), "{alpha} {mu} {eta}");
        let low = low.thrust.as_ref().unwrap().double;
        if let Some(least) = least {
            approx::assert_relative_eq!(low, least, max_relative = 1e-12);
        }
    }
    // Hair's breadth on either side there is a bound, or none.
    let bounded = |mu: &str| assessed(M, "pi/4", mu, "0.5").limits()[1].unwrap().thrust.is_some();
    assert!(bounded("0.99999999999999999999") && !bounded("1.00000000000000000001"));
}

/// A comparison that stays open leaves the others decided.
#[test]
fn an_open_answer_is_open_alone() {
    let found = assessed(M, "1/2", &tangent_of_one_half(), "0.6");
    assert_eq!(found.stands, Ok(true));
    let open: Vec<_> = found.open().map(|(of, why)| (of, why.reason.as_ref())).collect();
    assert_eq!(open, [(Quantity::LargestThrust, "whether the shoulder can slide")]);
    assert!(found.figures().any(|(of, _)| of == Quantity::FrictionSafety));
    assert!(found.figures().any(|(of, _)| of == Quantity::LeastThrust));
}

/// On the line between two modes the least thickness stays open; that the arch stands does not.
#[test]
fn an_arch_between_modes_stands() {
    let mu = critical_friction();
    for (eta, stands) in [("0.2", true), ("0.05", false)] {
        let found = assessed(H, "pi/2", &mu, eta);
        assert_eq!(found.stands, Ok(stands), "{eta}");
        assert!(found.least_thickness.is_err() && found.geometric_safety.is_err());
        assert_eq!(found.limits().map(|end| end.is_some()), [stands; 2]);
    }
}

/// With many bits signs are decided in few of them, and what only a sign is asked of is known no better: the values are
/// those of bits that are all used, whatever limits the thrusts and asks for the friction.
#[test]
fn signs_in_few_bits_are_those_in_all() {
    let mut touches = HashSet::new();
    for (alpha, friction, thickness) in [
        ("80deg", "0.35", "0.12"),
        ("2.3", "1.05", "0.5"),
        ("1", "0.31", "0.1"),
        ("0.3", "0.6", "1.2"),
        ("2.9", "3", "1.9"),
        ("pi/2", "inf", "0.15"),
        ("2.5", "0.7", "0.9"),
        ("1.2", "0.2", "0.1"),
    ] {
        let arch = arch(M, alpha, friction);
        let told = |digits| {
            let found = arch.certify_thickness(&number(thickness), digits).unwrap();
            assert_eq!(found.open().count(), 0, "{arch}");
            let limits = found.limits().map(|limit| limit.map(|limit| limit.touch.name()));
            let values: Vec<_> = found.figures().map(|(of, x)| (of, x.map(|x| x.double))).collect();
            (found.stands.unwrap(), limits, values)
        };
        let (few, many) = (told(100), told(500));
        assert_eq!(few, many, "{arch}");
        touches.extend(many.1.into_iter().flatten());
    }
    assert!(touches.len() > 3, "{touches:?}");
}
