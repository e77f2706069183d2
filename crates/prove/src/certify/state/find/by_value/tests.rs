//! States by another quantity against the states of their half openings.

use super::*;
use crate::certify::state::find::{Finding, Question, find as answer};
use crate::certify::state::{Answer, Certify};
use crate::problem::Mode;

fn find(given: (Quantity, &str), friction: &str, weight: SelfWeight) -> StatesOfValue {
    find_to(25, given, friction, weight)
}

fn find_to(
    digits: usize,
    (quantity, value): (Quantity, &str),
    friction: &str,
    weight: SelfWeight,
) -> StatesOfValue {
    let given = (quantity, value.parse().unwrap());
    StatesByValue::new(given, friction.parse().unwrap()).unwrap().find(weight, digits).unwrap()
}

fn states(found: &StatesOfValue) -> Vec<&StateOfValue> {
    found.states.iter().map(|of| of.as_ref().unwrap()).collect()
}

/// The state of the half opening that was found has the mode, and the value to twenty digits.
fn is_confirmed(state: &StateOfValue, given: (Quantity, &str), arch: (SelfWeight, &str)) {
    let (weight, friction) = arch;
    let alpha = state.value(Quantity::HalfOpening);
    let arch = Arch::parse(weight.name(), &alpha, friction).unwrap();
    let Answer::Stands(found) = arch.certify_alone(25).unwrap() else { panic!("{alpha} falls") };
    assert_eq!(found.mode, state.mode, "{given:?} {arch}");
    for (quantity, figure) in found.figures() {
        let Some(figure) = figure else { continue };
        let digits = state.value(quantity);
        let other: f64 = digits.parse().unwrap();
        let error = figure.decimal.value.to_rational()
            - digits.parse::<ExactNumber>().unwrap().to_rational();
        assert!(error.to_f64().abs() <= 1e-18 * other.abs(), "{given:?} {arch} {quantity:?}");
    }
}

const JOINT: Quantity = Quantity::RotationJoint;

#[test]
fn a_joint_has_two_states_below_the_widest_and_none_beyond() {
    for weight in SelfWeight::ALL {
        for joint in ["0.1", "1.0", "57deg", "1.11"] {
            let found = find((JOINT, joint), "inf", weight);
            let states = states(&found);
            assert_eq!(states.len(), 2, "{weight:?} {joint}");
            assert!(states.iter().all(|of| of.mode == Mode::Rotational));
            for state in states {
                is_confirmed(state, (JOINT, joint), (weight, "inf"));
            }
        }
        // Beyond the second zero of (12) all roots of (7) are real, and no thickness is among them.
        for joint in ["1.2", "2.6", "3.1"] {
            let found = find((JOINT, joint), "inf", weight);
            let none = found.none.unwrap().reason();
            assert!(found.states.is_empty() && none.contains("beyond the widest"), "{joint}");
        }
        let found = find((JOINT, "1.2"), "0.6", weight);
        assert!(
            found.none.unwrap().reason().contains("with this friction") && found.others.is_empty()
        );
    }
}

/// With limited friction other modes have the joint too, or the arch has another mode.
#[test]
fn with_limited_friction_each_half_opening_is_decided() {
    use Mode as M;
    let milankovitch = SelfWeight::Milankovitch;
    for (joint, friction, modes, others) in [
        ("1.0", "2", vec![M::Rotational, M::Rotational], vec![]),
        ("1.0", "0.35", vec![M::SlidingRotational], vec![Err(()), Err(())]),
        ("0.66", "1.6", vec![M::Rotational, M::RotationalSliding], vec![Err(())]),
        ("0.2", "1.6", vec![M::Rotational, M::RotationalSlidingRotational], vec![Err(())]),
    ] {
        let found = find((JOINT, joint), friction, milankovitch);
        let found_modes: Vec<Mode> = states(&found).iter().map(|of| of.mode).collect();
        let found_others: Vec<Result<Mode, ()>> =
            found.others.iter().map(|of| of.as_ref().unwrap().mode.map_err(|_| ())).collect();
        assert_eq!((found_modes, found_others), (modes, others), "{joint} {friction}");
        for state in states(&found) {
            is_confirmed(state, (JOINT, joint), (milankovitch, friction));
        }
    }
}

#[test]
fn a_thrust_a_thickness_and_an_opening_variable_have_one_state_at_most() {
    use Quantity as Q;
    for weight in SelfWeight::ALL {
        for (given, friction, mode) in [
            ((Q::Thrust, "0.6"), "inf", Mode::Rotational),
            ((Q::Thrust, "0.3"), "inf", Mode::Rotational),
            ((Q::Thrust, "0.01"), "inf", Mode::Rotational),
            ((Q::Thrust, "0.6"), "0.6", Mode::Rotational),
            ((Q::Thrust, "0.999"), "0.6", Mode::Rotational),
            ((Q::Thrust, "0.6"), "0.35", Mode::SlidingRotational),
            ((Q::Thickness, "0.15"), "inf", Mode::Rotational),
            ((Q::Thickness, "1.5"), "inf", Mode::Overturning),
            ((Q::OpeningVariable, "1.3"), "1", Mode::Rotational),
            ((Q::OpeningVariable, "1.99999999"), "inf", Mode::Rotational),
        ] {
            let found = find(given, friction, weight);
            let states = states(&found);
            assert_eq!(states.len(), 1, "{given:?} {friction}");
            assert_eq!(states[0].mode, mode, "{given:?} {friction}");
            is_confirmed(states[0], given, (weight, friction));
        }
    }
    let found = find((Q::OpeningVariable, "0.7"), "inf", SelfWeight::Milankovitch);
    assert_eq!(states(&found)[0].mode, Mode::Overturning);
    is_confirmed(states(&found)[0], (Q::OpeningVariable, "0.7"), (SelfWeight::Milankovitch, "inf"));
    let thickness = states(&found)[0].value(Q::Thickness);
    assert_eq!(thickness, "1.2", "it is six fifths, exactly");
    for (given, friction, words) in [
        ((Q::Thrust, "0.01"), "0.6", "no state has this thrust"),
        ((Q::OpeningVariable, "0.1"), "inf", "thicker than twice its radius"),
        ((Q::OpeningVariable, "1.0"), "0.1", "it slides"),
        ((Q::Thickness, "1.9"), "0.3", "slide as [s,s]"),
        ((JOINT, "1.0"), "0", "without friction"),
    ] {
        let found = find(given, friction, SelfWeight::Milankovitch);
        assert!(found.none.unwrap().reason().contains(words), "{given:?}: {:?}", found.none);
    }
}

/// The round trip: a state by each of its quantities.
#[test]
fn any_one_quantity_gives_the_others() {
    let arch = Arch::parse("milankovitch", "80deg", "0.6").unwrap();
    let state = arch.least(30).unwrap();
    for (quantity, figure) in state.figures() {
        if !StatesByValue::GIVEN.contains(&quantity) {
            continue;
        }
        let text = figure.unwrap().to_string();
        let found = find((quantity, &text), "0.6", SelfWeight::Milankovitch);
        let degrees: Vec<f64> = states(&found)
            .iter()
            .map(|of| of.value(Quantity::HalfOpeningDegrees).parse().unwrap())
            .collect();
        assert!(degrees.iter().any(|x| (x - 80.0).abs() < 1e-12), "{quantity:?}: {degrees:?}");
    }
}

#[test]
fn what_is_out_of_range_is_refused() {
    use Quantity as Q;
    for (quantity, value, words) in [
        (Q::RotationJoint, "0", "between 0 and pi"),
        (Q::RotationJoint, "57", "did you mean 57deg?"),
        (Q::Thrust, "1", "thrust = 1 is not between 0 and 1"),
        (Q::Thrust, "0", "between 0 and 1"),
        (Q::Thickness, "2.1", "not between 0 and 2"),
        (Q::OpeningVariable, "2", "A = 2 is not between 0 and 2"),
        (Q::OpeningVariable, "-1", "not between 0 and 2"),
        (Q::SlidingJoint, "0.1", "there is no sliding_joint here"),
    ] {
        let given = (quantity, value.parse().unwrap());
        let refused = StatesByValue::new(given, Friction::Infinite).unwrap_err().to_string();
        assert!(refused.contains(words), "{refused}");
    }
    assert!(StatesByValue::new((Q::Thrust, "0.5".parse().unwrap()), Friction::Infinite).is_ok());
}

/// Towards the end of rotation the thrust falls to zero: there is one state all the way, and with any friction at the
/// most one.
#[test]
fn every_thrust_has_its_state() {
    for weight in SelfWeight::ALL {
        for exponent in (1..=60).chain((65..=200).step_by(15)) {
            let digits = ["1", "3.7", "9.1"];
            let few = if exponent > 60 { &digits[..1] } else { &digits[..] };
            for &digits in few {
                let given = format!("{digits}e-{exponent}");
                let given = (Quantity::Thrust, given.as_str());
                // Next to the end the half opening needs more digits than what it decides.
                let found = find_to(25 + exponent as usize, given, "inf", weight);
                let [state] = states(&found)[..] else { panic!("{weight:?} {given:?}: {found:?}") };
                assert!(state.mode == Mode::Rotational && found.none.is_none(), "{given:?}");
                is_confirmed(state, given, (weight, "inf"));
                for friction in ["1e12", "1e20"] {
                    // An inner joint slides at the thrust 1/(4 mu²) and a little more.
                    let slides = 2 * friction[2..].parse::<i32>().unwrap() + 1;
                    let found = find(given, friction, weight);
                    let is_there = exponent < slides || exponent == slides && digits != "1";
                    assert_eq!(states(&found).len(), usize::from(is_there), "{given:?} {friction}");
                    assert_eq!(found.none.is_some(), !is_there, "{given:?} {friction}");
                    assert_eq!(found.others.len(), usize::from(!is_there), "{given:?} {friction}");
                }
            }
        }
    }
}

/// A joint below the widest one has two states, the narrow one and that next to the end of rotation.
#[test]
fn every_joint_has_its_two_states() {
    for weight in SelfWeight::ALL {
        for exponent in [1, 2, 4, 8, 16, 17, 20, 30, 41, 55, 80, 100, 150] {
            let given = format!("3.7e-{exponent}");
            let found = find_to(25 + 2 * exponent, (JOINT, &given), "inf", weight);
            let states = states(&found);
            assert_eq!(states.len(), 2, "{weight:?} {given}: {found:?}");
            for state in states {
                assert_eq!(state.mode, Mode::Rotational);
                is_confirmed(state, (JOINT, &given), (weight, "inf"));
            }
            for friction in ["1e12", "1e20"] {
                let found = find((JOINT, &given), friction, weight);
                assert!(found.first_open().is_none(), "{weight:?} {given} {friction}: {found:?}");
            }
        }
    }
}

/// The exact values of the tables are ends of curves, where balls alone decide nothing.
#[test]
fn exact_ends_have_their_state() {
    use {Mode as M, Quantity as Q};
    let [heyman, milankovitch] = SelfWeight::ALL;
    for (weight, given, opening) in [
        (heyman, (Q::Thickness, "1"), "2.64838889915100541147745904"),
        (heyman, (Q::OpeningVariable, "2/3"), "2.64838889915100541147745904"),
        (heyman, (Q::OpeningVariable, "1/2"), "2.7864981506511"),
        (milankovitch, (Q::OpeningVariable, "2/3"), "2.64838889915100541147745904"),
        (heyman, (Q::Thickness, "2"), "2.7864981506511"),
        (milankovitch, (Q::Thickness, "2"), "2.64838889915100541147745904"),
    ] {
        let found = find(given, "inf", weight);
        let [state] = states(&found)[..] else { panic!("{weight:?} {given:?}: {found:?}") };
        assert_eq!(state.mode, M::Overturning, "{given:?}");
        let found = state.value(Q::HalfOpening);
        assert!(found.starts_with(&opening[..15]), "{given:?}: {found}");
        assert_eq!(state.value(Q::Thrust), "0");
        for friction in ["2", "1e6"] {
            let found = find(given, friction, weight);
            assert!(found.first_open().is_none(), "{weight:?} {given:?} {friction}: {found:?}");
        }
    }
    let one = Some("1".parse().unwrap());
    for (friction, mode) in [("inf", M::Overturning), ("2", M::OverturningSliding)] {
        let question =
            Question::HalfOpening { friction: friction.parse().unwrap(), thickness: one.clone() };
        let Finding::Found(found) = answer(heyman, &question, 20).unwrap() else { panic!() };
        assert_eq!(found.modes, [mode], "{friction}");
    }
}

/// Next to the widest joint nothing is said of what cannot be told.
#[test]
fn next_to_the_widest_joint_it_stays_open() {
    let point = crate::certify::CertifiedLandmark::new(
        crate::problem::Landmark::WidestJoint,
        SelfWeight::Heyman,
    );
    let joint = |digits| {
        let found = point.clone().unwrap().constant(JOINT, digits).unwrap();
        (JOINT, found.value.to_string().parse().unwrap())
    };
    let ask = |digits| StatesByValue::new(joint(digits), Friction::Infinite).unwrap();
    let near = ask(2600).find(SelfWeight::Heyman, 5);
    assert!(matches!(near, Err(Error::Undecided(_))), "{near:?}");
    let found = ask(20).find(SelfWeight::Heyman, 5).unwrap();
    assert!(found.first_open().is_none() && matches!(found.states.len(), 0 | 2), "false twin");
}
