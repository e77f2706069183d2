//! Questions the other way round, each answer held against the states on both sides of it.

use super::{BOTH, float_text};
use crate::arches::{H, M, arch, number};
use crate::hard::{config, millionths, weights};
use couplet::arch::SelfWeight;
use couplet::certify::CertifiedLandmark;
use couplet::certify::state::find::{Finding, Found, Given, Question, find};
use couplet::certify::state::{Answer, Certify, Enough};
use couplet::number::{Ball, ExactNumber};
use couplet::problem::{Friction, Landmark, Line, Mode, Quantity};
use proptest::prelude::*;
use rug::ops::Pow;
use rug::{Float, Rational};

fn found(weight: SelfWeight, question: &Question, digits: usize) -> Found {
    match find(weight, question, digits).unwrap() {
        Finding::Found(found) => found,
        other => panic!("{weight:?} {question:?}: {other:?}"),
    }
}

fn widest(friction: &str, thickness: Option<&str>) -> Question {
    let friction = friction.parse().unwrap();
    Question::HalfOpening { friction, thickness: thickness.map(number) }
}

/// A value that was found, moved by its part of `10^-exponent` either way, to 80 digits.
fn around(found: &Found, of: Quantity, exponent: u32) -> [String; 2] {
    let (_, figure) = found.figures.iter().find(|(quantity, _)| *quantity == of).unwrap();
    let value = Float::with_val(400, &figure.decimal.value.to_rational());
    let hair = Float::with_val(400, &value) / Float::with_val(400, 10).pow(exponent);
    [Float::with_val(400, &value - &hair), value + hair].map(|x| float_text(&x, 80))
}

fn mode(weight: SelfWeight, half_opening: &str, friction: &str) -> Option<Mode> {
    match arch(weight, half_opening, friction).certify_alone(20) {
        Ok(Answer::Stands(state)) => Some(state.mode),
        Ok(Answer::Falls { .. }) => None,
        Err(doubt) => panic!("{weight:?} {half_opening} {friction}: {doubt:?}"),
    }
}

fn stands(weight: SelfWeight, half_opening: &str, friction: &str, thickness: &str) -> bool {
    let found = arch(weight, half_opening, friction).certify_thickness(&number(thickness), 6);
    found.unwrap().stands.unwrap()
}

proptest! {
    #![proptest_config(config(120))]

    /// The half opening of a state is found again from its thickness, in the same mode.
    #[test]
    fn the_half_opening_of_a_state_is_found_again(
        weight in weights(), alpha in millionths(1_000, 2_640_000), mu in millionths(1_000, 4_000_000),
    ) {
        let (alpha, mu) = (ExactNumber::from(&alpha), ExactNumber::from(&mu));
        let (opening, friction) = (alpha.to_string(), mu.to_string());
        let Ok(Answer::Stands(state)) = arch(weight, &opening, &friction).certify_alone(50) else {
            return Ok(());
        };
        let eta = ExactNumber::from(&state.thickness.decimal.value.to_rational());
        let question =
            Question::HalfOpening { friction: Friction::Coefficient(mu), thickness: Some(eta) };
        let found = found(weight, &question, 30);
        prop_assert_eq!(&found.modes, &[state.mode]);
        let again = &found.figures[0].1;
        let truth: Ball = alpha.enclosure(300);
        let error = (Ball::enclosing(&again.decimal.value.to_rational(), 300) - truth).mid().to_f64();
        prop_assert!(error.abs() < 1e-28, "{} {} {error}", opening, friction);
    }
}

/// In every mode, thin and thick: a hair narrower it stands at that thickness, a hair wider it does not.
#[test]
fn a_hair_wider_does_not_stand() {
    for weight in BOTH {
        for (friction, thickness, mode) in [
            ("0.6", "0.15", Mode::Rotational),
            ("inf", "0.5", Mode::Rotational),
            ("0.39", "0.12", Mode::SlidingRotational),
            ("0.1", "0.15", Mode::Sliding),
            ("31deg", "2", Mode::Sliding),
            ("1.45", "0.7", Mode::RotationalSliding),
            ("3", "1.3", Mode::OverturningSliding),
            ("inf", "1.2", Mode::Overturning),
            ("4", "2", Mode::OverturningSliding),
            ("0.3", "1e-20", Mode::Rotational),
            ("1.3e-16", "1e-20", Mode::Sliding),
            ("1e9", "1e-40", Mode::Rotational),
        ] {
            let found = found(weight, &widest(friction, Some(thickness)), 40);
            assert_eq!(found.modes, [mode], "{weight:?} {friction} {thickness}");
            let [narrower, wider] = around(&found, Quantity::HalfOpening, 30);
            assert!(stands(weight, &narrower, friction, thickness), "{friction} {thickness}");
            assert!(!stands(weight, &wider, friction, thickness), "{friction} {thickness}");
        }
    }
}

/// Within 1e-15 to 1e-40 of the point at which four modes meet, whatever is sooner is told.
#[test]
fn next_to_the_triple_point_the_half_opening_is_found() {
    for weight in BOTH {
        for digits in [15, 20, 30, 40] {
            let point = CertifiedLandmark::new(Landmark::Triple, weight).unwrap();
            let value = |of| point.constant(of, digits).unwrap().to_string();
            let (friction, thickness) = (value(Quantity::Friction), value(Quantity::Thickness));
            let found = found(weight, &widest(&friction, Some(&thickness)), 60);
            let [narrower, wider] = around(&found, Quantity::HalfOpening, 50);
            assert!(stands(weight, &narrower, &friction, &thickness), "{weight:?} {digits}");
            assert!(!stands(weight, &wider, &friction, &thickness), "{weight:?} {digits}");
        }
    }
}

#[test]
fn beyond_the_widest_half_opening_nothing_stands() {
    for weight in BOTH {
        for friction in ["1e-30", "0.01", "0.6", "1.2", "1.6", "1.82", "2.5", "50", "1e6", "inf"] {
            let found = found(weight, &widest(friction, None), 40);
            let [narrower, wider] = around(&found, Quantity::HalfOpening, 30);
            assert!(mode(weight, &narrower, friction).is_some(), "{weight:?} {friction}");
            assert_eq!(mode(weight, &wider, friction), None, "{weight:?} {friction}");
        }
    }
    let nothing = find(M, &widest("0", Some("0.2")), 10).unwrap();
    assert!(matches!(nothing, Finding::Nothing(_)));
}

#[test]
fn with_less_than_the_least_friction_nothing_stands() {
    for weight in BOTH {
        for half_opening in ["1e-9", "0.3", "pi/2", "2.4", "2.55", "2.62", "2.64"] {
            for thickness in [None, Some("1.7")] {
                let given = (number(half_opening), thickness.map(number));
                let question = Question::Friction { half_opening: given.0, thickness: given.1 };
                let eta = thickness.unwrap_or("2");
                let found = match find(weight, &question, 40).unwrap() {
                    Finding::Found(found) => found,
                    // Wider than any friction carries at that thickness.
                    Finding::Nothing(_) => {
                        assert!(!stands(weight, half_opening, "inf", eta), "{half_opening}");
                        continue;
                    }
                    Finding::Beyond(..) => panic!("no line is asked for"),
                };
                let [less, more] = around(&found, Quantity::Friction, 30);
                assert!(stands(weight, half_opening, &more, eta), "{half_opening} {eta}");
                assert!(!stands(weight, half_opening, &less, eta), "{half_opening} {eta}");
            }
        }
    }
}

/// A hair to either side of a boundary is its first mode, and its second or nothing.
#[test]
fn a_boundary_lies_between_its_modes() {
    for (weight, line, half_opening, friction) in [
        (M, Line::RotationShoulder, "pi/2", "0.6"),
        (H, Line::RotationShoulder, "1e-4", "1e-9"),
        (H, Line::RotationShoulder, "2.48", "1.41"),
        (M, Line::RotationInner, "2.5", "1.3"),
        (H, Line::RotationInner, "2.6", "5"),
        (M, Line::ShoulderEnd, "1", "1.2"),
        (H, Line::ShoulderEnd, "1e-5", "1e-12"),
        (M, Line::AboveHaunchEnd, "2.5", "1.5"),
        (H, Line::AboveHaunchEnd, "2.55", "1.6"),
        (M, Line::BelowHaunchEnd, "2.533", "1.543"),
        (H, Line::BelowHaunchEnd, "2.602", "1.772"),
        (M, Line::CrownEnd, "2.57", "1.8"),
        (H, Line::CrownEnd, "2.7", "2.5"),
        (M, Line::Joints, "2.54", "1.6"),
        (H, Line::Joints, "2.61", "3"),
        (M, Line::Crown, "2.55", "1.7"),
        (H, Line::Crown, "2.62", "4"),
    ] {
        let [first, second] = line.modes();
        let second = (second != Mode::Sliding).then_some(second);
        let given = Given::HalfOpening(number(half_opening));
        let found_here = found(weight, &Question::Boundary { line, given }, 40);
        assert_eq!(found_here.modes, line.modes());
        let [less, more] = around(&found_here, Quantity::Friction, 30);
        assert_eq!(mode(weight, half_opening, &more), Some(first), "{line} {half_opening}");
        assert_eq!(mode(weight, half_opening, &less), second, "{line} {half_opening}");
        let given = Given::Friction(friction.parse().unwrap());
        let found_there = found(weight, &Question::Boundary { line, given }, 40);
        let [narrower, wider] = around(&found_there, Quantity::HalfOpening, 30);
        assert_eq!(mode(weight, &narrower, friction), Some(first), "{line} {friction}");
        assert_eq!(mode(weight, &wider, friction), second, "{line} {friction}");
    }
}

/// What is out of its range is an error, and nothing is said of it.
#[test]
fn what_is_given_has_its_range() {
    assert!(find(M, &widest("-1", None), 10).is_err());
    let half_opening = number("180deg");
    assert!(find(M, &Question::Friction { half_opening, thickness: None }, 10).is_err());
    let given = Given::HalfOpening(number("4"));
    assert!(find(M, &Question::Boundary { line: Line::Crown, given }, 10).is_err());
}

/// Where a line does not run there is no point of it: proved, by its ends.
#[test]
fn beside_a_line_there_is_no_boundary() {
    let none = |line: &str, given| {
        let question = Question::Boundary { line: line.parse().unwrap(), given };
        let Ok(Finding::Beyond(of, ends)) = find(M, &question, 10) else { panic!("{line}") };
        assert!(of.to_string().contains(line) && ends.contains(" (at the "), "{line}: {of} {ends}");
    };
    for (line, half_opening) in [
        ("rrr/srr", "2.5"),
        ("rrr/rrs", "2.3"),
        ("srr/ss", "2.5"),
        ("rrs/ss", "2.4"),
        ("rrs/ss", "2.56"),
        ("rsr/ss", "2.5"),
        ("rs/ss", "2.5"),
        ("rs/ss", "2.64"),
        ("rrs/rsr", "2.5"),
        ("rsr/rs", "2.5"),
    ] {
        none(line, Given::HalfOpening(number(half_opening)));
    }
    for (line, friction) in [
        ("rrr/srr", "1.5"),
        ("rrr/rrs", "1.2"),
        ("srr/ss", "1.5"),
        ("rrs/ss", "1.2"),
        ("rs/ss", "1.3"),
        ("rs/ss", "2.2"),
        ("rrs/rsr", "1.4"),
        ("rsr/rs", "1.4"),
    ] {
        none(line, Given::Friction(friction.parse().unwrap()));
    }
}

fn enough(weight: SelfWeight, half_opening: &str, friction: &str, digits: usize) -> Box<Enough> {
    match arch(weight, half_opening, friction).certify(digits) {
        Ok(Answer::Falls { enough: Some(enough), .. }) => enough,
        other => panic!("{half_opening} {friction}: {other:?}"),
    }
}

/// An arch that falls says what would be enough, and that is just enough.
#[test]
fn what_falls_says_what_would_be_enough() {
    for (weight, half_opening, friction) in [
        (H, "pi/2", "0.3"),
        (M, "2.6", "0.3"),
        (M, "2.64", "2"),
        (H, "1e-20", "1e-70"),
        (H, "2.75", "1.9"),
    ] {
        let enough = enough(weight, half_opening, friction, 40);
        let hair = Rational::from(10).pow(-30);
        let beside = |value: &Rational| {
            [Rational::from(1) - &hair, Rational::from(1) + &hair]
                .map(|part| float_text(&Float::with_val(400, &(value.clone() * part)), 100))
        };
        let least = enough.friction.unwrap().decimal.value.to_rational();
        let stands = beside(&least).map(|mu| mode(weight, half_opening, &mu).is_some());
        assert_eq!(stands, [false, true]);
        let widest = enough.half_opening.unwrap().decimal.value.to_rational();
        let stands = beside(&widest).map(|alpha| mode(weight, &alpha, friction).is_some());
        assert_eq!(stands, [true, false]);
        assert!(enough.sliding_friction.unwrap().decimal.value.to_rational() <= least);
    }
    // Too wide for any friction.
    let enough = enough(M, "2.65", "5", 10);
    assert!(enough.friction.is_none() && enough.half_opening.is_some());
}
