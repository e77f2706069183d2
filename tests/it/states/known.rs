//! What is known of states from elsewhere: the literature and the map of the modes.

use super::{digits, frictions, mode};
use crate::arches::{H, M, arch};
use couplet::certify::state::{Answer, Certify, Fall};
use couplet::problem::Mode;

/// Cocchetti & Rizzi, Frattura ed Integrità Strutturale 51 (2020): the Heyman-like semicircle.
#[test]
fn the_semicircle_agrees_with_the_literature() {
    let rotational = digits(H, "pi/2", "0.5", 6);
    assert_eq!(rotational.mode, Mode::Rotational);
    assert_eq!(rotational.thickness.decimal.value.to_string(), "0.107426");
    assert_eq!(rotational.rotation_joint.decimal.value.to_string(), "0.951141");
    assert!((rotational.thrust.double - 0.621772).abs() < 1e-6);
    assert_eq!(
        frictions(&rotational).rotational.as_ref().unwrap().decimal.value.to_string(),
        "0.395832"
    );
    assert_eq!(frictions(&rotational).sliding.decimal.value.to_string(), "0.309215");
    let table = [
        ("0.39", "0.112750"),
        ("0.38", "0.122192"),
        ("0.37", "0.132031"),
        ("0.36", "0.142273"),
        ("0.35", "0.152920"),
        ("0.34", "0.163977"),
        ("0.33", "0.175448"),
        ("0.32", "0.187338"),
        ("0.31", "0.199653"),
    ];
    for (friction, thickness) in table {
        let state = digits(H, "pi/2", friction, 6);
        assert_eq!(state.mode, Mode::SlidingRotational);
        assert_eq!(state.thickness.decimal.value.to_string(), thickness, "{friction}");
    }
    assert!(matches!(
        arch(H, "pi/2", "0.309").certify(6),
        Ok(Answer::Falls { fall: Fall::Sliding, .. })
    ));
}

#[test]
fn every_mode_is_met_where_the_map_has_it() {
    assert_eq!(mode(M, "2.43", "1.5"), Mode::Rotational);
    assert_eq!(mode(M, "2.3", "1.05"), Mode::SlidingRotational);
    assert_eq!(mode(M, "2.45", "1.35"), Mode::RotationalSliding);
    assert_eq!(mode(M, "2.533", "1.545"), Mode::RotationalSlidingRotational);
    assert_eq!(mode(M, "2.57", "1.75"), Mode::OverturningSliding);
    assert_eq!(mode(M, "2.62", "inf"), Mode::Overturning);
    assert_eq!(mode(H, "2.7", "inf"), Mode::Overturning);
    assert!(matches!(
        arch(M, "2.65", "5").certify(10),
        Ok(Answer::Falls { fall: Fall::Thickness, .. })
    ));
    assert!(matches!(
        arch(M, "2.65", "inf").certify(10),
        Ok(Answer::Falls { fall: Fall::Thickness, .. })
    ));
    assert!(matches!(
        arch(M, "3.1", "1").certify(10),
        Ok(Answer::Falls { fall: Fall::Sliding, .. })
    ));
    assert!(matches!(arch(M, "1", "0").certify(10), Ok(Answer::Falls { fall: Fall::Sliding, .. })));
}
