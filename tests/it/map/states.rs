//! On each side of a line an arch collapses in the mode of that side.

use couplet::arch::SelfWeight;
use couplet::atlas::{Curve, Piece, Trace};
use couplet::certify::state::NoState;
use couplet::number::Ball;
use couplet::prelude::{Arch, Certify, Mode};
use couplet::problem::Line;

/// An arch with half opening and friction as they are written, and what it does.
fn mode_of(weight: SelfWeight, alpha: f64, mu: f64) -> Result<(Mode, f64), NoState> {
    let arch = Arch::parse(weight.name(), &format!("{alpha:.17}"), &format!("{mu:.17}")).unwrap();
    let state = arch.least(12)?;
    Ok((state.mode, state.thickness.to_string().parse().unwrap()))
}

fn middle(ball: Option<&Ball>) -> f64 {
    ball.unwrap().mid().to_f64()
}

/// A parameter well inside of a piece.
fn inside(piece: &Piece) -> f64 {
    let [from, to] = piece.range();
    from + 0.37 * (to - from)
}

const TOLERANCE: f64 = 1e-9;
/// How far from a line, in friction angle or half opening, its sides are tried: well outside of a tube.
const AWAY: f64 = 2e-8;

/// Every so many pieces of the lines are tried.
const EVERY: usize = 12;

fn trace(curve: Curve, weight: SelfWeight) -> Trace {
    Trace::new(curve, weight, TOLERANCE).unwrap()
}

#[test]
fn on_each_side_of_a_line_there_is_its_mode() {
    let mut tried = 0;
    for (line, weight) in Line::ALL.iter().flat_map(|line| SelfWeight::ALL.map(|w| (*line, w))) {
        let trace = trace(Curve::Line(line), weight);
        // The first pieces are at the origin, where frictions are smaller than this step.
        for piece in trace.pieces().skip(3).step_by(EVERY) {
            let place = piece.place(inside(&piece)).unwrap();
            let alpha = middle(place.half_opening.as_ref());
            let phi = middle(place.friction_angle.as_ref());
            let eta = middle(place.thickness.as_ref());
            let [more, less] = line.modes();
            let (mode, thickness) = mode_of(weight, alpha, (phi + AWAY).tan()).unwrap();
            assert_eq!(mode, more, "{line} {weight:?} at {alpha}, {phi}");
            assert!((thickness - eta).abs() < 1e-3, "{line} {weight:?} {thickness} {eta}");
            match mode_of(weight, alpha, (phi - AWAY).tan()) {
                Ok((mode, thickness)) => {
                    assert_eq!(mode, less, "{line} {weight:?} at {alpha}, {phi}");
                    assert!((thickness - eta).abs() < 1e-3, "{line} {weight:?}");
                }
                Err(NoState::Falls(_)) => assert_eq!(less, Mode::Sliding, "{line} {weight:?}"),
                Err(error) => panic!("{line} {weight:?} at {alpha}, {phi}: {error}"),
            }
            tried += 1;
        }
    }
    assert!(tried > 60, "{tried}");
}

#[test]
fn states_at_unlimited_friction_are_on_their_curves() {
    for (curve, mode) in
        [(Curve::Rotation, Mode::Rotational), (Curve::Overturning, Mode::Overturning)]
    {
        for weight in SelfWeight::ALL {
            for piece in trace(curve, weight).pieces().step_by(EVERY) {
                let place = piece.place(inside(&piece)).unwrap();
                let alpha = middle(place.half_opening.as_ref());
                let eta = middle(place.thickness.as_ref());
                let arch = Arch::parse(weight.name(), &format!("{alpha:.17}"), "inf").unwrap();
                let state = arch.least(14).unwrap();
                assert_eq!(state.mode, mode, "{alpha}");
                let least: f64 = state.thickness.to_string().parse().unwrap();
                assert!((least - eta).abs() < 10.0 * TOLERANCE, "{alpha}: {least} {eta}");
            }
        }
    }
}

/// Beyond the limit an arch stands at no thickness, before it at one near 2.
#[test]
fn at_the_limit_the_thickness_reaches_2() {
    for weight in SelfWeight::ALL {
        for piece in trace(Curve::Limit, weight).pieces().step_by(3) {
            let place = piece.place(inside(&piece)).unwrap();
            let alpha = middle(place.half_opening.as_ref());
            let mu = middle(place.friction.as_ref());
            let (mode, thickness) = mode_of(weight, alpha * (1.0 - AWAY), mu).unwrap();
            assert_eq!(mode, Mode::OverturningSliding, "{weight:?} {alpha}");
            assert!(1.9 < thickness && thickness < 2.0, "{weight:?} {thickness}");
            let beyond = mode_of(weight, alpha * (1.0 + AWAY), mu);
            assert!(matches!(beyond, Err(NoState::Falls(_))), "{weight:?} {alpha}");
        }
    }
}

/// Sliding does not see the weight; below it nothing stands.
#[test]
fn below_the_friction_of_sliding_nothing_stands() {
    for piece in trace(Curve::Sliding, SelfWeight::Heyman).pieces().skip(3).step_by(EVERY) {
        let place = piece.place(inside(&piece)).unwrap();
        let alpha = middle(place.half_opening.as_ref());
        let phi = middle(place.friction_angle.as_ref());
        for weight in SelfWeight::ALL {
            let below = mode_of(weight, alpha, (phi - AWAY).tan());
            assert!(matches!(below, Err(NoState::Falls(_))), "{weight:?} {alpha}");
        }
    }
}
