//! Sines and cosines at hard angles: in intervals, in balls, and of exact angles.

use crate::hard::{config, quarter_turns};
use couplet::number::{Angle, AstroInterval, Ball, Enclosure, ExactNumber, Field, Magnitude, Real};
use proptest::prelude::*;
use rug::{Float, Rational};

/// Mantissa and exponent apart, so that sizes far from one and cancellation are met.
fn any_float(bits: u32) -> impl Strategy<Value = Float> {
    let special = prop_oneof![Just(0u64), Just(1), Just(u64::MAX), Just(1 << 63), any::<u64>()];
    (special, any::<u64>(), -200i32..60, any::<bool>()).prop_map(
        move |(high, low, shift, minus)| {
            let mut x = Float::with_val(bits.max(128), high) << 64;
            x += low;
            x >>= 128;
            let x = Float::with_val(bits, x) << shift;
            if minus { -x } else { x }
        },
    )
}

/// Multiples of a quarter turn to some bits, and numbers of any size that are none.
fn hard_angle() -> impl Strategy<Value = Float> {
    let tiny = (any_float(100), 0i32..3000).prop_map(|(x, shift)| x >> shift);
    let large = (any_float(100), 0i32..300).prop_map(|(x, shift)| x << shift);
    prop_oneof![quarter_turns(60, 8..900), any_float(128), tiny, large]
}

/// The sines of both ends and of the middle of an interval, or of a point, lie in its image; that of a point is narrow.
fn holds_the_sines(x: &Float, wide: Option<i32>, bits: usize) -> Result<(), TestCaseError> {
    let far = Float::with_val(4000, wide.map_or(0, |_| 1)) >> wide.unwrap_or(0);
    let end = Float::with_val(4000, x + &far);
    let (sin, cos) = AstroInterval::between(x, &end, bits).sin_cos();
    let images = [sin.ends().unwrap(), cos.ends().unwrap()];
    for x in [x.clone(), Float::with_val(4000, x + Float::with_val(4000, &far / 2)), end] {
        let truths = [Float::with_val(4000, x.sin_ref()), Float::with_val(4000, x.cos_ref())];
        for ((low, high), truth) in images.iter().zip(truths) {
            prop_assert!(*low <= truth && truth <= *high, "{x} {bits}: {low} {high}");
            let width = Float::with_val(64, high - low);
            let is_large = x.get_exp().is_some_and(|e| e > bits as i32 + 64);
            let narrow = Float::with_val(64, truth.abs() >> (bits as i32 - 2));
            prop_assert!(wide.is_some() || is_large || width <= narrow, "{x} {bits}: {low} {high}");
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(400))]

    /// Next to a multiple of a quarter turn by any number of bits, and anywhere else.
    #[test]
    fn sines_of_all_arithmetics_overlap(x in hard_angle(), bits in 64usize..1500, wide in prop_oneof![Just(None), (0i32..90).prop_map(Some)]) {
        holds_the_sines(&x, wide, bits)?;
    }
}

#[test]
fn a_double_lies_within_its_ball_widened_by_its_own_error() {
    for tenth in 1..300 {
        let x = f64::from(tenth) / 10.0;
        let (sin, cos) = Ball::exact(Float::with_val(53, x), 120).sin_cos();
        for (double, ball) in [(x.sin(), sin), (x.cos(), cos)] {
            let slack = Magnitude::power_of_two(-52);
            let exact = Float::with_val(53, double).to_rational().unwrap();
            assert!(ball.widened(slack).contains(&exact), "{x}");
        }
    }
}

#[test]
fn a_huge_argument_of_sine_is_refused_quickly() {
    let x: Float = Float::with_val(64, 1) << 500_000_000;
    let ball = Ball::exact(x.clone(), 64).sin_cos();
    let interval = AstroInterval::between(&x, &x, 64).sin_cos();
    assert!(ball.0.contains(&Rational::from(1)) && ball.0.contains(&Rational::from(-1)));
    assert_eq!(interval.0.ends().unwrap().0, -1);
}

/// Boxes: the sines and cosines of their points are inside, and the slope in the middle bounds how wide they are.
#[test]
fn sines_of_boxes_are_held() {
    let boxes = [(0.3, 0.1), (1.5, 0.01), (-2.0, 1e-9), (0.0, 0.5), (3.1, 2.0), (1.0, 1e-30)];
    for (middle, radius) in boxes.map(|(x, r)| (Float::with_val(300, x), Float::with_val(300, r))) {
        let low = Float::with_val(400, &middle - &radius);
        let high = Float::with_val(400, &middle + &radius);
        let (sin, cos) = AstroInterval::between(&low, &high, 128).sin_cos();
        let (slope, fall) = (middle.clone().cos(), middle.clone().sin());
        for (found, slope, is_sin) in [(sin, slope, true), (cos, fall, false)] {
            let (least, most) = found.ends().unwrap();
            for tenth in 0..=10 {
                let x: Float = Float::with_val(400, &high - &low) * tenth / 10 + &low;
                let truth = if is_sin { x.sin() } else { x.cos() };
                assert!(least <= truth && truth <= most, "{middle} {radius} {tenth}");
            }
            let bent: Float = slope.abs() * &radius + radius.clone().square() / 2;
            let step: Float = bent.min(&radius) * 2;
            let width = Float::with_val(100, &most - &least);
            assert!(width <= step * 1.000_001 + 1e-37, "{middle} {radius}: {width}");
        }
    }
}

/// Of twice the arctangent of 3/4 sine and cosine are 24/25 and 7/25; every other angle has those of its radians.
#[test]
fn an_angle_has_its_sine_and_cosine() {
    for (text, known) in [("2atan(3/4)", Some([24, 7])), ("80deg", None), ("5/4", None)] {
        let angle = text.parse::<ExactNumber>().unwrap().angle::<Ball>(200);
        let by_radians = Angle::new(angle.rad.clone());
        assert!(angle.sin.overlaps(&by_radians.sin) && angle.cos.overlaps(&by_radians.cos));
        assert!(!angle.sin.overlaps(&angle.cos), "false twin");
        if let Some(known) = known {
            let [sin, cos] = known.map(|n| Rational::from((n, 25)));
            assert!(angle.sin.contains(&sin) && angle.cos.contains(&cos));
        }
        assert!(angle.sin.rad().to_float() < 1e-58 && angle.cos.rad().to_float() < 1e-58);
    }
}

/// The angle of a root has the tangent that it says, on its side of a right angle; in every engine, read back from its
/// text; it rises with its factor; and what is a part of pi, or twice an arctangent, is given as that.
#[test]
fn an_angle_of_a_root_has_that_tangent() {
    let read = |text: &str| text.parse::<ExactNumber>().unwrap();
    let texts = [
        "atan(√(1/1000000))",
        "atan(√(3/5))",
        "atan(√(1000001/3))",
        "pi-atan(√(1000001/3))",
        "pi-atan(sqrt(0.6))",
        "pi-atan(√(1/1000000))",
    ];
    let all = texts.map(read);
    assert_eq!(all[4].to_string(), "pi-atan(√(3/5))");
    for (text, angle) in texts.iter().zip(&all) {
        assert_eq!(&read(&angle.to_string()), angle);
        let [sin, cos] = {
            let (sin, cos) = angle.enclosure::<Ball>(200).sin_cos();
            [sin, cos]
        };
        let square = (sin.clone() / &cos) * &(sin / &cos);
        let below = text.split_once("√(").map_or("0.6", |(_, rest)| rest.trim_end_matches(')'));
        let below: Ball = read(below).enclosure(200);
        assert!(square.overlaps(&below), "{text}");
        assert!(!square.overlaps(&(below.clone() * below.ratio(999_999, 1_000_000))), "false twin");
        assert_eq!(cos.is_positive().is_proved(), !text.starts_with("pi"), "{text}");
        let other: AstroInterval = angle.enclosure(100);
        assert!(
            (other - angle.enclosure::<AstroInterval>(60))
                .overlaps(&AstroInterval::integer(0, 100))
        );
    }
    for pair in all.windows(2) {
        let [low, high] = [&pair[0], &pair[1]].map(|angle| angle.enclosure::<Ball>(200));
        assert!(low.is_less_than(&high).is_proved() && pair[0].factor() < pair[1].factor());
    }
    for (text, told) in [
        ("atan(√(1))", "1pi/4"),
        ("atan(√(3))", "1pi/3"),
        ("pi-atan(√(1/3))", "5pi/6"),
        ("atan(√(9/16))", "2atan(1/3)"),
        ("pi-atan(√(9/16))", "2atan(3)"),
    ] {
        assert_eq!(read(text).to_string(), told);
    }
    for text in
        ["atan(√(0))", "atan(√(-1))", "atan(√(pi))", "atan(√())", "2-atan(√(2))", "atan(√(2))deg"]
    {
        assert!(text.parse::<ExactNumber>().is_err(), "{text}");
    }
}
