//! On both sides of every border between modes, as near to it as can be told and nearer.

use super::{BOTH, beside, digits, fall, float_text, frictions, proved_twice};
use crate::arches::{H, M, arch, at_landmark, critical_friction};
use couplet::Error;
use couplet::arch::Unknown;
use couplet::certify::Open;
use couplet::certify::state::{Answer, Certify, Fall};
use couplet::number::Ball;
use couplet::problem::{Landmark, Mode};
use rug::ops::Pow;
use rug::{Float, Rational};

#[test]
fn the_ends_of_the_branches_are_approached_from_both_sides() {
    for weight in BOTH {
        for (landmark, below, above) in [
            (Landmark::RotationEnd, Some(Mode::Rotational), Some(Mode::Overturning)),
            (Landmark::OverturningEnd, Some(Mode::Overturning), None),
            (Landmark::WidestJoint, Some(Mode::Rotational), Some(Mode::Rotational)),
        ] {
            for exponent in [10, 30] {
                let found = [false, true].map(|up| {
                    let alpha = beside(landmark, weight, Unknown::HalfOpening, exponent, up);
                    proved_twice(weight, &alpha, "inf")
                });
                assert_eq!(found, [below, above], "{landmark:?} {exponent}");
            }
        }
        for friction in ["1e12", "7"] {
            for up in [false, true] {
                let alpha = beside(Landmark::RotationEnd, weight, Unknown::HalfOpening, 30, up);
                assert_eq!(proved_twice(weight, &alpha, friction), Some(Mode::OverturningSliding));
            }
        }
        assert_eq!(proved_twice(weight, "2.5", "1e12"), Some(Mode::Rotational));
    }
}

/// Far beyond every limit, and next to half a turn: decided, with a reason.
#[test]
fn openings_close_to_half_a_turn() {
    for weight in BOTH {
        for alpha in ["3", "3.14", "3.1415926535", "3.14159265358979323846264338327950"] {
            let falls = ["0.5", "1e60", "inf"].map(|friction| fall(weight, alpha, friction));
            assert_eq!(falls, [Fall::Sliding, Fall::Thickness, Fall::Thickness], "{alpha}");
        }
    }
    for (weight, alpha) in [(H, "2.78"), (M, "2.648")] {
        assert_eq!(proved_twice(weight, alpha, "1e9"), Some(Mode::OverturningSliding));
    }
}

#[test]
fn frictions_just_above_and_below_the_purely_sliding_one() {
    for (weight, alpha) in
        [(H, "pi/2"), (M, "2.2"), (M, "2.5"), (H, "2.7"), (M, "2.61"), (H, "0.3")]
    {
        let least = frictions(&digits(weight, alpha, "3", 100)).sliding.clone();
        let (below, above) = (least.decimal.lower.to_rational(), least.decimal.upper.to_rational());
        let hair = Rational::from(10).pow(-30);
        let text = |x: Rational| float_text(&Float::with_val(600, &x), 120);
        assert_eq!(proved_twice(weight, alpha, &text(below - &hair)), None, "{alpha}");
        assert!(proved_twice(weight, alpha, &text(above + &hair)).is_some(), "{alpha}");
    }
}

/// Within 1e-20 of T in every direction: below and above the two critical frictions and between them,
/// at half openings on both sides. All four modes that meet there are met.
#[test]
fn around_the_triple_point() {
    for weight in BOTH {
        for (up, between) in [(false, Mode::SlidingRotational), (true, Mode::RotationalSliding)] {
            let alpha = beside(Landmark::Triple, weight, Unknown::HalfOpening, 20, up);
            let limits = digits(weight, &alpha, "9", 80);
            let low = frictions(&limits).sliding.decimal.value.to_rational();
            let high = frictions(&limits).rotational.as_ref().unwrap().decimal.value.to_rational();
            let gap = Rational::from(&high - &low);
            assert!(gap > 0 && gap < Rational::from((1, 1_000_000_000_000_000_000i64)));
            let at = |part: (i32, i32)| {
                let mu = Rational::from(part) * &gap + &low;
                proved_twice(weight, &alpha, &float_text(&Float::with_val(500, &mu), 120))
            };
            assert_eq!(at((-1, 100)), None, "nothing stands");
            for part in [(1, 100), (1, 2), (99, 100)] {
                assert_eq!(at(part), Some(between));
            }
            assert_eq!(at((101, 100)), Some(Mode::Rotational));
        }
    }
}

/// Between S and J the rotational joint is above the sliding one and below the crown.
#[test]
fn between_shift_and_junction() {
    for weight in BOTH {
        let (mut modes, steps) = (Vec::new(), 6);
        let at = |of| at_landmark(of, weight, Unknown::HalfOpening, 200).mid().to_f64();
        for step in -1..=steps + 1 {
            let part = f64::from(step) / f64::from(steps);
            let (s, j) = (at(Landmark::Shift), at(Landmark::Junction));
            let alpha = format!("{:.17}", s + part * (j - s));
            // A little more friction than on the divide, so that something stands.
            let mu = frictions(&digits(weight, &alpha, "9", 17)).sliding.double + 1e-6;
            modes.push(proved_twice(weight, &alpha, &format!("{mu:.17}")).unwrap());
        }
        assert_eq!(modes.first(), Some(&Mode::RotationalSliding));
        assert!(modes.contains(&Mode::RotationalSlidingRotational), "{modes:?}");
        assert_eq!(modes.last(), Some(&Mode::OverturningSliding));
    }
}

/// At the landmarks the states have the landmarks' values: approached along the friction.
#[test]
fn states_end_in_the_landmarks() {
    for weight in BOTH {
        for landmark in [Landmark::Triple, Landmark::Shift, Landmark::Junction] {
            let truth = at_landmark(landmark, weight, Unknown::Thickness, 300);
            let alpha = beside(landmark, weight, Unknown::HalfOpening, 90, false);
            let mu = beside(landmark, weight, Unknown::Friction, 40, true);
            let state = digits(weight, &alpha, &mu, 30);
            let near = Ball::enclosing(&state.thickness.decimal.value.to_rational(), 300);
            let gap = (near - truth).mid().to_f64().abs();
            assert!(gap < 1e-18, "{landmark:?} {weight:?}: {gap}");
        }
    }
}

/// Exactly on a boundary enclosures cannot decide: the answer is a doubt with its modes, never a guess.
#[test]
fn beyond_the_last_precision_the_answer_is_undecided() {
    let arch = arch(H, "pi/2", &critical_friction());
    let doubt = Error::apart(arch.certify(10)).unwrap().unwrap_err();
    assert_eq!((doubt.kind, doubt.bits.is_some_and(|bits| bits > 4_000)), (Open::Comparison, true));
    assert_eq!(doubt.between, [Mode::Rotational, Mode::SlidingRotational]);
    assert!(doubt.gap.is_some_and(|gap| (0.0..1e-300).contains(&gap)));
}

/// Far nearer to the end of rotation than can be told, a friction still decides: what stays open is only
/// whether a larger one would be enough for rotation.
#[test]
fn a_friction_decides_where_the_end_of_rotation_cannot_be_told() {
    let end = at_landmark(Landmark::RotationEnd, H, Unknown::HalfOpening, 40_000);
    let half_opening = float_text(end.mid(), 11_000);
    let arch = arch(H, &half_opening, "2");
    let Ok(Answer::Stands(state)) = arch.certify_alone(10) else { panic!() };
    assert_eq!(state.mode, Mode::OverturningSliding);
    let doubt = Error::apart(arch.certify(10)).unwrap().unwrap_err();
    assert_eq!(doubt.between, [Mode::OverturningSliding]);
}
