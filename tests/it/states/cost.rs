//! What is not asked for is not computed.

use crate::arches::{H, M, arch};
use couplet::certify::state::{Answer, Certify, Outcome};
use couplet::problem::{Equation, tally};

/// Leaving out the frictions leaves out what they need, and nothing that decides the answer.
#[test]
fn a_state_alone_evaluates_only_what_its_proof_needs() {
    let sliding = [Equation::ShoulderSliding, Equation::InnerSliding, Equation::Steepest];
    let cost = |friction: &str| {
        let (answer, tally) = tally::measure(|| arch(H, "pi/2", friction).certify_alone(17));
        let Ok(Answer::Stands(state)) = answer else { panic!("{friction}") };
        assert!(state.frictions.is_none());
        tally
    };
    let rotational = cost("inf");
    assert_eq!(sliding.map(|equation| rotational.of(equation)), [0; 3]);
    assert_eq!(rotational.landmarks, 0);
    assert!(rotational.of(Equation::Tangency) > 0 && rotational.conditions > 0);
    // With a finite friction two values are compared with it, and no system of sliding is solved.
    let limited = cost("1");
    assert_eq!(limited.of(Equation::Steepest), 0);
    assert_eq!(limited.landmarks, 0);
    let (_, whole) = tally::measure(|| arch(H, "pi/2", "1").certify(17));
    assert!(whole.of(Equation::Steepest) > 0, "the twin that is asked for more");
    assert!(whole.evaluations() > limited.evaluations());
}

/// An arch that falls, falls for the same reason on either way.
#[test]
fn a_fall_needs_no_frictions_either() {
    for (weight, alpha, friction) in [
        (H, "pi/2", "0.3"),
        (M, "2.5", "0.9"),
        (H, "3", "inf"),
        (H, "3", "5"),
        (M, "0.001", "1e-12"),
    ] {
        let arch = arch(weight, alpha, friction);
        let fall = |outcome| match outcome {
            Ok(Outcome::Falls(fall)) => fall,
            other => panic!("{alpha} {friction}: {other:?}"),
        };
        assert_eq!(fall(arch.state(300)), fall(arch.state_alone(300)), "{alpha} {friction}");
    }
}
