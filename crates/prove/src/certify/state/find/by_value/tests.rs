//! States by another quantity against the states of their half openings.

use super::*;
use crate::certify::state::{Answer, Certify};
use crate::problem::Mode;

fn find(given: (Quantity, &str), friction: &str, weight: SelfWeight) -> StatesOfValue {
    let (quantity, value) = given;
    let given = (quantity, value.parse().unwrap());
    StatesByValue::new(given, friction.parse().unwrap()).unwrap().find(weight, 25).unwrap()
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
        let found = find((JOINT, "1.2"), "inf", weight);
        assert!(found.states.is_empty() && found.none.unwrap().contains("beyond the widest"));
        let found = find((JOINT, "1.2"), "0.6", weight);
        assert!(found.none.unwrap().contains("with this friction") && found.others.is_empty());
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
    assert_eq!(thickness, "1.200000000000000000000000", "it is six fifths, exactly");
    for (given, friction, words) in [
        ((Q::Thrust, "0.01"), "0.6", "no state has this thrust"),
        ((Q::OpeningVariable, "0.1"), "inf", "thicker than twice its radius"),
        ((Q::OpeningVariable, "1.0"), "0.1", "it slides"),
        ((Q::Thickness, "1.9"), "0.3", "slide as [s,s]"),
        ((JOINT, "1.0"), "0", "without friction"),
    ] {
        let found = find(given, friction, SelfWeight::Milankovitch);
        assert!(found.none.unwrap().contains(words), "{given:?}: {:?}", found.none);
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
