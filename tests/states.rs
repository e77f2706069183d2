//! States of any arch: hard queries, random queries, monotony, the landmarks, the literature, and the
//! static programme as a second route.

mod common;

use common::config;
use couplet::arch::{SelfWeight, Unknown};
use couplet::certify::CertifiedLandmark;
use couplet::certify::state::{
    Answer, Arch, Digits, Fall, Figure, Friction, Frictions, Outcome, State,
};
use couplet::number::{Ball, Enclosure, ExactNumber};
use couplet::problem::{Equation, Landmark, Mode, tally};
use proptest::prelude::*;
use rug::{Float, Rational};

fn number(text: &str) -> ExactNumber {
    text.parse().unwrap()
}

fn arch(weight: SelfWeight, half_opening: &str, friction: &str) -> Arch {
    let friction = match friction {
        "inf" => Friction::Infinite,
        mu => Friction::Coefficient(number(mu)),
    };
    Arch::new(weight, number(half_opening), friction).unwrap()
}

fn digits(weight: SelfWeight, half_opening: &str, friction: &str, digits: usize) -> Box<Digits> {
    match arch(weight, half_opening, friction).certify(digits) {
        Ok(Answer::Stands(state)) => state,
        other => panic!("{weight:?} {half_opening} {friction}: {other:?}"),
    }
}

fn mode(weight: SelfWeight, half_opening: &str, friction: &str) -> Mode {
    digits(weight, half_opening, friction, 10).mode
}

fn float_text(x: &Float, digits: usize) -> String {
    x.to_string_radix(10, Some(digits))
}

const BOTH: [SelfWeight; 2] = SelfWeight::ALL;
const H: SelfWeight = SelfWeight::Heyman;
const M: SelfWeight = SelfWeight::Milankovitch;

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
    assert!(matches!(arch(H, "pi/2", "0.309").certify(6), Ok(Answer::Falls(Fall::Sliding))));
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
    assert!(matches!(arch(M, "2.65", "5").certify(10), Ok(Answer::Falls(Fall::Thickness))));
    assert!(matches!(arch(M, "2.65", "inf").certify(10), Ok(Answer::Falls(Fall::Thickness))));
    assert!(matches!(arch(M, "3.1", "1").certify(10), Ok(Answer::Falls(Fall::Sliding))));
    assert!(matches!(arch(M, "1", "0").certify(10), Ok(Answer::Falls(Fall::Sliding))));
}

/// The landmark's half opening or friction moved by `10^-exponent` in some direction.
fn beside(
    landmark: Landmark,
    weight: SelfWeight,
    unknown: Unknown,
    exponent: u32,
    up: bool,
) -> String {
    let point = CertifiedLandmark::new(landmark, weight).unwrap();
    let x = point.enclosure(1000).unwrap().value(unknown).unwrap();
    let hair = Float::with_val(1000, 10).recip();
    let hair = (0..exponent).fold(Float::with_val(1000, 1), |h, _| h * &hair);
    let moved = if up {
        Float::with_val(1000, x.mid() + &hair)
    } else {
        Float::with_val(1000, x.mid() - &hair)
    };
    float_text(&moved, 150)
}

/// Proved to 40 digits at the first precision that is enough and at twice as much: they overlap.
fn frictions(state: &Digits) -> &Frictions<Figure> {
    state.frictions.as_ref().unwrap()
}

fn proved_twice(weight: SelfWeight, half_opening: &str, friction: &str) -> Option<Mode> {
    let arch = arch(weight, half_opening, friction);
    let first = match arch.certify(40) {
        Ok(Answer::Stands(state)) => state,
        Ok(Answer::Falls(_)) => return None,
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
        let (lower, upper) =
            (figure.decimal.lower.to_rational(), figure.decimal.upper.to_rational());
        let lower = Float::with_val_round(3000, &lower, rug::float::Round::Down).0;
        let upper = Float::with_val_round(3000, &upper, rug::float::Round::Up).0;
        assert!(ball.upper() >= lower && ball.lower() <= upper, "{half_opening} {friction}");
        let significant = figure.decimal.value.significant_digits();
        assert!(significant == 40 || significant == 0, "full relative accuracy");
    }
    Some(first.mode)
}

#[test]
fn tiny_openings_keep_full_relative_accuracy() {
    for weight in BOTH {
        for half_opening in ["1e-3", "1e-30", "1e-100"] {
            assert_eq!(proved_twice(weight, half_opening, "0.5"), Some(Mode::Rotational));
            let state = digits(weight, half_opening, "0.5", 12);
            let alpha = number(half_opening).enclosure(64).mid().to_f64();
            // alpha⁴/48, of which a double can only hold the first.
            if alpha > 1e-50 {
                approx::assert_relative_eq!(
                    state.thickness.double,
                    alpha.powi(4) / 48.0,
                    max_relative = 1e-5
                );
            }
        }
        // Between alpha³/12 and alpha³/6 the shoulder slides.
        assert_eq!(proved_twice(weight, "1e-40", "1.2e-121"), Some(Mode::SlidingRotational));
        assert_eq!(proved_twice(weight, "1e-40", "0.8e-121"), None);
    }
}

/// Small openings are proved in scaled variables, with as few bits as any other; with very many bits the
/// printed equations are used, and say the same.
#[test]
fn small_openings_need_no_more_bits_and_agree_with_the_printed_equations() {
    for weight in BOTH {
        for (half_opening, part) in
            [("0.18", "0.001"), ("0.01", "1.1e-7"), ("1e-9", "1.1e-28"), ("1e-40", "1.1e-121")]
        {
            for friction in ["inf", "0.3", part] {
                let arch = arch(weight, half_opening, friction);
                let (answer, cost) = tally::measure(|| arch.certify(20));
                let Ok(Answer::Stands(small)) = answer else { panic!("{half_opening} {friction}") };
                assert!(cost.working_bits < 150, "{half_opening} {friction}: {cost:?}");
                let printed = |bits| match tally::measure(|| arch.state(bits)) {
                    (Ok(Outcome::Stands(state)), cost) => (state, cost),
                    other => panic!("{half_opening} {friction}: {other:?}"),
                };
                let (large, cost_of_printed) = printed(8_000 + arch.bits_lost());
                assert!(cost_of_printed.of(Equation::Tangency) > 0);
                assert_eq!(small.mode, large.mode);
                for (figure, ball) in [
                    (&small.thickness, &large.thickness),
                    (&small.thrust, &large.thrust),
                    (&small.rotation_joint, &large.rotation_joint),
                    (&frictions(&small).sliding, &large.frictions.as_ref().unwrap().sliding),
                    (
                        frictions(&small).rotational.as_ref().unwrap(),
                        large.frictions.as_ref().unwrap().rotational.as_ref().unwrap(),
                    ),
                ] {
                    let again = Figure::new(ball, 20).unwrap();
                    assert_eq!(
                        figure.decimal.value, again.decimal.value,
                        "{half_opening} {friction}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_ends_of_the_branches_are_approached_from_both_sides() {
    for weight in BOTH {
        for (landmark, below, above) in [
            (Landmark::RotationEnd, Some(Mode::Rotational), Some(Mode::Overturning)),
            (Landmark::OverturningEnd, Some(Mode::Overturning), None),
            (Landmark::WidestJoint, Some(Mode::Rotational), Some(Mode::Rotational)),
        ] {
            for exponent in [10, 30] {
                let at = |up| beside(landmark, weight, Unknown::HalfOpening, exponent, up);
                assert_eq!(
                    proved_twice(weight, &at(false), "inf"),
                    below,
                    "{landmark:?} {exponent}"
                );
                assert_eq!(
                    proved_twice(weight, &at(true), "inf"),
                    above,
                    "{landmark:?} {exponent}"
                );
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
            let fall = |friction| match arch(weight, alpha, friction).certify(40) {
                Ok(Answer::Falls(fall)) => fall,
                other => panic!("{weight:?} {alpha} {friction}: {other:?}"),
            };
            assert_eq!(fall("0.5"), Fall::Sliding);
            assert_eq!(fall("1e60"), Fall::Thickness);
            assert_eq!(fall("inf"), Fall::Thickness);
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
        let hair = Rational::from((1, 1)) / rug::Integer::from(rug::Integer::u_pow_u(10, 30));
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
        let at = |landmark| {
            let point = CertifiedLandmark::new(landmark, weight).unwrap();
            point.enclosure(200).unwrap().value(Unknown::HalfOpening).unwrap().mid().to_f64()
        };
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
        for (landmark, up) in
            [(Landmark::Triple, true), (Landmark::Shift, true), (Landmark::Junction, true)]
        {
            let point = CertifiedLandmark::new(landmark, weight).unwrap();
            let truth = point.enclosure(300).unwrap().value(Unknown::Thickness).unwrap();
            let alpha = beside(landmark, weight, Unknown::HalfOpening, 90, false);
            let mu = beside(landmark, weight, Unknown::Friction, 40, up);
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
    // Nearer to the boundary than any precision that is tried can tell.
    let alpha = "pi/2";
    let critical = match arch(H, alpha, "1").state(40_000) {
        Ok(Outcome::Stands(state)) => state.frictions.unwrap().rotational.unwrap(),
        other => panic!("{other:?}"),
    };
    let friction = float_text(critical.mid(), 11_000);
    let doubt = arch(H, alpha, &friction).certify(10).unwrap_err();
    assert_eq!(doubt.between, [Mode::Rotational, Mode::SlidingRotational]);
    assert!(doubt.gap < 1e-300 && doubt.gap >= 0.0);
}

fn state(weight: SelfWeight, alpha: &Rational, mu: &Rational) -> Option<Box<State>> {
    let friction = Friction::Coefficient(ExactNumber::rational(mu.clone()));
    let arch = Arch::new(weight, ExactNumber::rational(alpha.clone()), friction).unwrap();
    for bits in [128, 256, 1024] {
        match arch.state(bits) {
            Ok(Outcome::Stands(state)) => return Some(state),
            Ok(Outcome::Falls(_)) => return None,
            Err(_) => {}
        }
    }
    panic!("undecided at {alpha} {mu}")
}

fn rational(low: i64, high: i64) -> impl Strategy<Value = Rational> {
    (low..high).prop_map(|n| Rational::from((n, 1_000_000)))
}

proptest! {
    #![proptest_config(config(150))]

    /// The least thickness falls when friction rises, and never falls when the opening grows.
    #[test]
    fn the_least_thickness_is_monotone(
        alpha in rational(50_000, 2_640_000), wider in rational(1_000, 200_000),
        mu in rational(100, 5_000_000), more in rational(1_000, 500_000), heyman in any::<bool>(),
    ) {
        let weight = if heyman { H } else { M };
        let Some(first) = state(weight, &alpha, &mu) else { return Ok(()) };
        let rougher = state(weight, &alpha, &Rational::from(&mu + &more)).expect("friction only helps");
        prop_assert!(rougher.thickness.is_less_than(&first.thickness) == couplet::number::Ternary::True
            || rougher.thickness.overlaps(&first.thickness));
        if let Some(open) = state(weight, &Rational::from(&alpha + &wider), &mu) {
            prop_assert!(first.thickness.is_less_than(&open.thickness).is_proved());
        }
    }
}

/// A thickness outside `(0, 2)` is none: nothing is said of it.
#[test]
fn an_impossible_thickness_is_a_doubt() {
    for (thickness, question) in [
        ("0", "whether the thickness is positive"),
        ("-1/10", "whether the thickness is positive"),
        ("2", "whether the thickness is below the limit 2"),
        ("3", "whether the thickness is below the limit 2"),
    ] {
        let doubt = arch(H, "pi/2", "0.5").certify_thickness(&number(thickness), 6).unwrap_err();
        assert_eq!(doubt.question, question, "{thickness}");
    }
    assert!(arch(H, "pi/2", "0.5").certify_thickness(&number("1.99"), 6).unwrap().stands);
}

/// Arches on which a comparison of the assessment is an exact tie that does not matter for the answer.
#[test]
fn exact_ties_do_not_hide_the_answer() {
    let cases = [
        // The lever arm that bounds the thrust at the crown is zero: (2 - eta) = (2 + eta) cos(alpha).
        (M, "pi/3", "0.5", "2/3"),
        // Besides, the line of least thrust touches the intrados exactly at the shoulder.
        (H, "pi/3", "0.5", "2/3"),
        // The friction angle is the half opening: the shoulder can just not slide.
        (M, "pi/4", "1", "0.1"),
        // The thickness is that of the end of rotation.
        (H, "pi/2", "0.5", "1"),
        (H, "pi/2", "inf", "1"),
        // No friction at all.
        (M, "1", "0", "0.2"),
        // A thrust far below any double.
        (M, "2.3", "1e900", "1.5"),
    ];
    for (weight, alpha, mu, eta) in cases {
        let found = arch(weight, alpha, mu).certify_thickness(&number(eta), 20);
        let found = found.unwrap_or_else(|doubt| panic!("{alpha} {mu} {eta}: {doubt:?}"));
        assert_eq!(found.stands, mu != "0", "{alpha} {mu} {eta}");
    }
    assert_eq!(mode(M, "2.6", "1e900"), Mode::OverturningSliding);
}

/// A fixed sequence of random queries over `(0, alpha_L) x (0, 5)`: each ends proved.
fn random_queries(count: u64, weight: SelfWeight) -> [usize; 9] {
    let limit = if weight == H { 2.786498 } else { 2.648388 };
    let mut seed = 0x9E37_79B9_7F4A_7C15u64 + weight.flag() as u64;
    let mut random = || {
        // xorshift64*: any sequence does, as long as it is always the same.
        seed ^= seed >> 12;
        seed ^= seed << 25;
        seed ^= seed >> 27;
        (seed.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut met = [0; 9];
    for _ in 0..count {
        let (alpha, mu) = (format!("{:.17}", random() * limit), format!("{:.17}", random() * 5.0));
        let slot = match arch(weight, &alpha, &mu).certify(16) {
            Ok(Answer::Stands(state)) => Mode::ALL.iter().position(|m| *m == state.mode).unwrap(),
            Ok(Answer::Falls(Fall::Sliding)) => 7,
            Ok(Answer::Falls(Fall::Thickness)) => 8,
            Err(doubt) => panic!("{weight:?} {alpha} {mu}: {doubt:?}"),
        };
        met[slot] += 1;
    }
    met
}

/// The quick look in doubles is near the proved state almost everywhere; nothing relies on it.
#[test]
fn the_quick_look_is_close() {
    for weight in BOTH {
        for i in 0..400 {
            let (alpha, mu) = (0.3 + 0.0057 * f64::from(i), 0.05 + 0.0123 * f64::from(i * 7 % 400));
            let quick = couplet::solve::start::quick_state(weight, alpha, mu);
            match arch(weight, &format!("{alpha:.17}"), &format!("{mu:.17}")).certify(8) {
                Ok(Answer::Stands(state)) => {
                    assert_eq!(quick.mode, Some(state.mode), "{alpha} {mu}");
                    approx::assert_relative_eq!(
                        quick.thickness,
                        state.thickness.double,
                        max_relative = 1e-9
                    );
                }
                _ => assert_eq!(quick.mode, None, "{alpha} {mu}"),
            }
        }
    }
}

#[test]
fn two_thousand_random_queries_are_proved() {
    for weight in BOTH {
        let met = random_queries(1000, weight);
        assert!(met[0] > 300 && met[7] > 50, "{met:?}");
    }
}

/// `cargo test --release --test states -- --ignored`
#[test]
#[ignore = "long: a hundred thousand queries"]
fn a_hundred_thousand_random_queries_are_proved() {
    let met = BOTH.map(|weight| random_queries(50_000, weight));
    println!("by mode, then falls by sliding and by thickness: {met:?}");
}

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

/// Far nearer to the end of rotation than can be told, a friction still decides: what stays open is only
/// whether a larger one would be enough for rotation.
#[test]
fn a_friction_decides_where_the_end_of_rotation_cannot_be_told() {
    let point = CertifiedLandmark::new(Landmark::RotationEnd, H).unwrap();
    let end = point.enclosure(40_000).unwrap().value(Unknown::HalfOpening).unwrap();
    let half_opening = float_text(end.mid(), 11_000);
    let arch = arch(H, &half_opening, "2");
    let Ok(Answer::Stands(state)) = arch.certify_alone(10) else { panic!() };
    assert_eq!(state.mode, Mode::OverturningSliding);
    let doubt = arch.certify(10).unwrap_err();
    assert_eq!(doubt.between, [Mode::OverturningSliding]);
}

/// The range of thrusts of a tiny arch, next to its least thickness and far from it.
#[test]
fn the_thrusts_of_tiny_openings_are_found() {
    for weight in BOTH {
        for half_opening in ["0.24", "0.2", "0.01", "1e-4", "1e-8", "1e-50"] {
            let arch = arch(weight, half_opening, "inf");
            let Ok(Outcome::Stands(state)) = arch.state_alone(400) else { panic!() };
            for part in [(1_000_001, 1_000_000), (3, 2), (4, 1)] {
                let thickness = state.thickness.mid().to_rational().unwrap() * Rational::from(part);
                let assessed = arch.certify_thickness(&ExactNumber::rational(thickness), 12);
                let found =
                    assessed.unwrap_or_else(|doubt| panic!("{half_opening} {part:?}: {doubt:?}"));
                let [least, largest] = found.thrust.unwrap().map(|end| end.thrust.unwrap().decimal);
                assert!(found.stands && least.value.to_rational() <= largest.value.to_rational());
            }
        }
    }
}
