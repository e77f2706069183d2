//! What is known of states from elsewhere: the literature and the map of the modes.

use super::{digits, fall, frictions, mode};
use crate::arches::{H, M};
use couplet::certify::state::Fall;
use couplet::problem::Mode;

/// Cocchetti & Rizzi, Frattura ed Integrità Strutturale 51 (2020): the Heyman-like semicircle.
#[test]
fn the_semicircle_agrees_with_the_literature() {
    let rotational = digits(H, "pi/2", "0.5", 6);
    assert_eq!(rotational.mode, Mode::Rotational);
    let limits = frictions(&rotational);
    for (figure, text) in [
        (&rotational.thickness, "0.107426"),
        (&rotational.rotation_joint, "0.951141"),
        (limits.rotational.as_ref().unwrap(), "0.395832"),
        (&limits.sliding, "0.309215"),
    ] {
        assert_eq!(figure.decimal.value.to_string(), text);
    }
    assert!((rotational.thrust.double - 0.621772).abs() < 1e-6);
    for (friction, thickness) in [
        ("0.39", "0.112750"),
        ("0.38", "0.122192"),
        ("0.37", "0.132031"),
        ("0.36", "0.142273"),
        ("0.35", "0.152920"),
        ("0.34", "0.163977"),
        ("0.33", "0.175448"),
        ("0.32", "0.187338"),
        ("0.31", "0.199653"),
    ] {
        let state = digits(H, "pi/2", friction, 6);
        assert_eq!(state.mode, Mode::SlidingRotational);
        assert_eq!(state.thickness.decimal.value.to_string(), thickness, "{friction}");
    }
    assert_eq!(fall(H, "pi/2", "0.309"), Fall::Sliding);
}

#[test]
fn every_mode_is_met_where_the_map_has_it() {
    for (weight, half_opening, friction, expected) in [
        (M, "2.43", "1.5", Mode::Rotational),
        (M, "2.3", "1.05", Mode::SlidingRotational),
        (M, "2.45", "1.35", Mode::RotationalSliding),
        (M, "2.533", "1.545", Mode::RotationalSlidingRotational),
        (M, "2.57", "1.75", Mode::OverturningSliding),
        (M, "2.62", "inf", Mode::Overturning),
        (H, "2.7", "inf", Mode::Overturning),
    ] {
        assert_eq!(mode(weight, half_opening, friction), expected, "{half_opening} {friction}");
    }
    assert_eq!(["5", "inf"].map(|mu| fall(M, "2.65", mu)), [Fall::Thickness; 2]);
    assert_eq!([fall(M, "3.1", "1"), fall(M, "1", "0")], [Fall::Sliding; 2]);
}
