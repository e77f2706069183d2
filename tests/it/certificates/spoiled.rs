//! Whatever is done to a certificate: what is still accepted is still true.

use super::originals::{alike, answers, asymmetric, landmark, state, verdict};
use super::spoiler::spoiled;
use couplet::arch::SelfWeight;
use couplet::arch::asymmetric::AsymmetricMode;
use couplet::certify::state::{Answer, Certify, Fall};
use couplet::certify::{AsymmetricDigits, CertifiedLandmark, Value as Constant};
use couplet::check::Accepted;
use couplet::number::{ExactNumber, Rounded};
use couplet::problem::{Arch, Landmark, Problem, Quantity, Verdict};
use rug::ops::Pow;
use rug::{Integer, Rational};
use serde_json::Value;
use std::cell::RefCell;
use std::collections::HashMap;

/// The largest number of digits in this file.
const MAX_DIGITS: usize = 40;

/// The number that a text of the form `d.ddd[e±n]` stands for.
pub(super) fn decimal(text: &str) -> Rational {
    let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: Integer = format!("{whole}{part}").parse().unwrap();
    let power = power.parse::<i32>().unwrap() - part.len() as i32;
    Rational::from(10).pow(power) * digits
}

/// The correctly rounded value as the solver has it; `None` for infinity.
fn truth(accepted: &Accepted, quantity: Quantity) -> Option<Rational> {
    let digits = accepted.digits;
    let rational = |rounded: Rounded| Some(rounded.value.to_rational());
    match &accepted.problem {
        Problem::Landmark { landmark, weight } => {
            let point = CertifiedLandmark::new(*landmark, *weight).unwrap();
            let constants = point.constants(digits).unwrap();
            match constants.into_iter().find(|c| c.quantity == quantity).unwrap().value {
                Constant::Infinite => None,
                Constant::Finite(rounded) => rational(rounded),
            }
        }
        Problem::State { mode, arch } => {
            let Answer::Stands(known) = arch.certify(digits).unwrap() else { panic!("{arch}") };
            assert_eq!(known.mode, *mode);
            let figure = match quantity {
                Quantity::Thickness => known.thickness,
                Quantity::Thrust => known.thrust,
                Quantity::IntrinsicThrust => known.intrinsic_thrust,
                Quantity::RotationJoint => known.rotation_joint,
                Quantity::SlidingJoint => known.sliding_joint.unwrap(),
                // The solver has no degrees: a quantity put in by the spoiler, rare enough.
                _ => panic!("{quantity:?}"),
            };
            rational(figure.decimal)
        }
        Problem::Asymmetric { mode, arch } => {
            let known = solution(*mode, arch, digits).unwrap();
            let figure = match quantity {
                Quantity::Thickness => known.thickness,
                Quantity::Thrust => known.thrust,
                Quantity::CrownMoment => known.crown_moment,
                Quantity::VerticalForce => known.vertical_force,
                Quantity::Power => known.power,
                _ => panic!("{quantity:?}"),
            };
            rational(figure.decimal)
        }
        Problem::Verdict { verdict, arch } => match (verdict, quantity) {
            (Verdict::Slides, Quantity::Friction) => {
                let friction = arch.sliding_friction(400).unwrap();
                rational(Rounded::from_ball(&friction, digits).unwrap())
            }
            (Verdict::TooThin { mode, .. }, _) => {
                let problem = Problem::State { mode: *mode, arch: arch.clone() };
                truth(&Accepted { problem, ..accepted.clone() }, quantity)
            }
            _ => panic!("{quantity:?}"),
        },
    }
}

/// The asymmetric solution of a kind; those of an arch are looked for once.
fn solution(mode: AsymmetricMode, arch: &Arch, digits: usize) -> Option<AsymmetricDigits> {
    thread_local! {
        static KNOWN: RefCell<HashMap<String, Vec<AsymmetricDigits>>> = RefCell::default();
    }
    KNOWN.with_borrow_mut(|known| {
        let all = known.entry(format!("{arch} {digits}")).or_insert_with(|| {
            let all = couplet::certify::asymmetric(arch, digits).unwrap();
            all.found.into_iter().flatten().collect()
        });
        all.iter().find(|solution| solution.mode == mode).cloned()
    })
}

/// Whether the solver says so too.
fn is_so(problem: &Problem) -> bool {
    if let Problem::Asymmetric { mode, arch } = problem {
        return solution(*mode, arch, 20).is_some();
    }
    let Problem::Verdict { verdict, arch } = problem else { return true };
    let least = match arch.certify_alone(5).unwrap() {
        Answer::Falls { fall, .. } => Err(fall),
        Answer::Stands(state) => Ok(state),
    };
    let stands =
        |thickness: &ExactNumber| arch.certify_thickness(thickness, 2).unwrap().stands.unwrap();
    match (verdict, &least) {
        (Verdict::Slides, Err(Fall::Sliding)) | (Verdict::TooWide, Err(Fall::Thickness)) => true,
        (Verdict::TooThin { mode, thickness }, Ok(state)) => {
            state.mode == *mode && !stands(thickness)
        }
        (Verdict::Stands(standing), Ok(_)) => stands(&standing.thickness),
        _ => false,
    }
}

/// Whether one of the arithmetics accepts it (at the edge one may and the other not); if so, every value
/// has to be the right one.
fn accepted_and_true(bytes: &[u8]) -> bool {
    let verdicts = answers(bytes, MAX_DIGITS);
    let Some(accepted) = verdicts.into_iter().find_map(Result::ok) else { return false };
    let accepted = accepted.certificate().expect("no survey").clone();
    assert!(is_so(&accepted.problem), "{:?}", accepted.problem);
    for (quantity, text) in &accepted.values {
        let right = truth(&accepted, *quantity);
        let found = (text != "inf").then(|| decimal(text));
        assert_eq!(found, right, "{:?} {quantity:?}", accepted.problem);
    }
    true
}

/// The certificates that are spoiled: most of them small, so that each part is hit.
fn originals() -> Vec<Value> {
    let mut all = vec![
        landmark("T").clone(),
        landmark("l").clone(),
        landmark("sb").clone(),
        state("2.45", "1.35").clone(),
        state("2.5", "inf").clone(),
        verdict("1.5", "0.1", "1").clone(),
        verdict("pi/2", "0.38", "0.12").clone(),
        verdict("2.45", "1.35", "0.8").clone(),
        verdict("2.6", "2", "1.5").clone(),
        asymmetric(SelfWeight::Milankovitch, "2.3", "1.05", AsymmetricMode::InnerSliding).clone(),
    ];
    for value in &mut all {
        // A value is looked for among the constants each time: a few are enough.
        let few = match value["claim"].get("slides").or_else(|| value["claim"].get("asymmetric")) {
            Some(_) => 1,
            None => 3,
        };
        value["values"].as_array_mut().unwrap().truncate(few);
    }
    all
}

#[test]
fn what_is_accepted_after_changes_is_true() {
    let originals = originals();
    let originals: Vec<&Value> = originals.iter().collect();
    spoiled(4000, [[100, 500], [25, 500]], &originals, accepted_and_true);
}

/// The right values of another claim are not those of this one.
#[test]
fn the_oracle_sees_what_is_false() {
    let accepted = alike(landmark("T").to_string().as_bytes(), MAX_DIGITS).unwrap();
    let (quantity, text) = &accepted.values[0];
    assert_eq!(truth(&accepted, *quantity), Some(decimal(text)));
    let fewer = Accepted { digits: accepted.digits - 1, ..accepted.clone() };
    assert_ne!(truth(&fewer, *quantity), Some(decimal(&text[..text.len() - 3])));
    for landmark in [Landmark::Triple, Landmark::Junction] {
        let problem = Problem::Landmark { landmark, weight: SelfWeight::Milankovitch };
        let other = Accepted { problem, ..accepted.clone() };
        assert_ne!(truth(&other, *quantity), Some(decimal(text)));
    }
    assert_eq!(decimal("1.25e-1"), Rational::from((1, 8)));
    assert_eq!(decimal("150"), 150);
}
