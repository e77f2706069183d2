//! States of any arch: hard queries, random queries, monotony, the landmarks, the literature, and the
//! static programme as a second route.

mod assessed;
mod borders;
mod by_value;
mod cost;
mod crown;
mod found;
mod known;
mod quick;
mod random;
mod small;
mod widths;

use crate::arches::{arch, at_landmark, stands};
use couplet::arch::{SelfWeight, Unknown};
use couplet::certify::state::{Answer, Certify, Digits, Fall, Figure, Frictions, Outcome};
use couplet::problem::{Landmark, Mode};
use rug::Float;

fn digits(weight: SelfWeight, half_opening: &str, friction: &str, digits: usize) -> Box<Digits> {
    stands(&arch(weight, half_opening, friction), digits)
}

fn mode(weight: SelfWeight, half_opening: &str, friction: &str) -> Mode {
    digits(weight, half_opening, friction, 10).mode
}

/// Why an arch falls.
fn fall(weight: SelfWeight, half_opening: &str, friction: &str) -> Fall {
    match arch(weight, half_opening, friction).certify(40) {
        Ok(Answer::Falls { fall, .. }) => fall,
        other => panic!("{weight:?} {half_opening} {friction}: {other:?}"),
    }
}

fn float_text(x: &Float, digits: usize) -> String {
    x.to_string_radix(10, Some(digits))
}

const BOTH: [SelfWeight; 2] = SelfWeight::ALL;

/// The landmark's half opening or friction moved by `10^-exponent` in some direction.
fn beside(
    landmark: Landmark,
    weight: SelfWeight,
    unknown: Unknown,
    exponent: u32,
    up: bool,
) -> String {
    let x = at_landmark(landmark, weight, unknown, 1000);
    let tenth = Float::with_val(1000, 10).recip();
    let hair = (0..exponent).fold(Float::with_val(1000, 1), |hair, _| hair * &tenth);
    float_text(&Float::with_val(1000, x.mid() + if up { hair } else { -hair }), 150)
}

fn frictions(state: &Digits) -> &Frictions<Figure> {
    state.frictions.as_ref().unwrap()
}

/// Proved to 40 digits at the first precision that is enough and at twice as much: they overlap.
fn proved_twice(weight: SelfWeight, half_opening: &str, friction: &str) -> Option<Mode> {
    let arch = arch(weight, half_opening, friction);
    let first = match arch.certify(40) {
        Ok(Answer::Stands(state)) => state,
        Ok(Answer::Falls { .. }) => return None,
        Err(doubt) => panic!("{weight:?} {half_opening} {friction}: {doubt:?}"),
    };
    let bits = 2000 + arch.bits_lost();
    let Ok(Outcome::Stands(second)) = arch.state(bits) else { panic!("{half_opening} {friction}") };
    let Ok(Outcome::Stands(alone)) = arch.state_alone(bits) else { panic!("{friction} alone") };
    assert_eq!([first.mode, first.mode], [second.mode, alone.mode]);
    for (figure, ball) in [
        (&first.thickness, &second.thickness),
        (&first.thrust, &second.thrust),
        (&first.rotation_joint, &second.rotation_joint),
        (&frictions(&first).sliding, &second.frictions.as_ref().unwrap().sliding),
        // The state alone, found on another way, is the same.
        (&first.thickness, &alone.thickness),
        (&first.thrust, &alone.thrust),
        (&first.rotation_joint, &alone.rotation_joint),
    ] {
        let [lower, upper] =
            [&figure.decimal.lower, &figure.decimal.upper].map(|x| x.to_rational());
        let lower = Float::with_val_round(3000, &lower, rug::float::Round::Down).0;
        let upper = Float::with_val_round(3000, &upper, rug::float::Round::Up).0;
        assert!(ball.upper() >= lower && ball.lower() <= upper, "{half_opening} {friction}");
        let significant = figure.decimal.value.significant_digits();
        assert!(significant == 40 || significant == 0, "full relative accuracy");
    }
    Some(first.mode)
}
