use super::*;
use crate::number::Real;
use proptest::prelude::*;

/// Every number of the ball is within what is shown of it, and no digit is shown that the ball does not have.
fn shown(ball: &Ball, digits: usize) -> String {
    let text = format!("{ball:.digits$}");
    let rational = |text: &str| text.parse::<Decimal>().unwrap().to_rational();
    let inside = text.trim_start_matches('[').trim_end_matches(']');
    let (mid, bound) = match inside.split_once("+/- ") {
        Some(("", bound)) => (Rational::new(), rational(bound)),
        Some((mid, bound)) => (rational(mid.trim()), rational(bound)),
        None => (rational(inside), Rational::new()),
    };
    let [middle, radius] =
        [ball.mid().clone(), ball.rad().to_float()].map(|x| x.to_rational().unwrap());
    assert!((middle - &mid).abs() + radius <= bound, "{text}");
    if let Some(last) = inside.split_once(" +/- ").map(|(mid, _)| mid.parse::<Decimal>().unwrap()) {
        assert!(last.significant_digits() <= digits, "{text}");
        let unit = Decimal::new(false, "2", last.exponent()).to_rational();
        assert!(bound <= unit, "a digit too many: {text}");
    }
    text
}

proptest! {
    #![proptest_config(crate::number::test_config::config(2000))]

    #[test]
    fn what_is_shown_holds_the_ball(
        mantissa in any::<i64>(), shift in -300i32..300, radius in prop::option::of(-400i64..400), digits in 1usize..60,
    ) {
        let mid = Float::with_val(64, mantissa) >> shift;
        let rad = radius.map_or(Magnitude::ZERO, Magnitude::power_of_two);
        shown(&Ball::new(mid, rad, 64), digits);
    }
}

#[test]
fn a_ball_is_shown_with_its_bound() {
    let third = Ball::integer(1, 40) / 3;
    assert_eq!(shown(&third, 20), "[0.33333333333 +/- 3.72e-12]");
    assert_eq!(shown(&third, 3), "[0.333 +/- 3.34e-4]");
    assert_eq!(shown(&-third.scaled(100), 3), "[-4.23e29 +/- 4.50e26]");
    assert_eq!(shown(&Ball::from(0.75), 20), "0.75");
    assert_eq!(shown(&Ball::from(0.1), 20), "[0.10000000000000000555 +/- 1.12e-21]");
    assert_eq!(shown(&Ball::integer(0, 64), 20), "0");
    assert_eq!(
        shown(&Ball::integer(1, 64).widened(Magnitude::from_integer(1)), 20),
        "[+/- 2.00e0]"
    );
    let around_zero = Ball::integer(0, 64).widened(Magnitude::power_of_two(-10));
    assert_eq!(shown(&around_zero, 20), "[+/- 9.77e-4]");
    assert_eq!(Ball::whole(64).to_string(), "[+/- inf]");
    assert_eq!(format!("{third:?}"), third.to_string());
    let huge = Ball::exact(Float::with_val(64, 1) << 1_000_000_000, 64);
    assert!(huge.to_string().len() < 60, "{huge}");
}

#[test]
fn operators_of_references_and_in_place_are_those_of_values() {
    let (a, b) = (Ball::integer(7, 80) / 3, Ball::from(0.1));
    let same =
        |x: &Ball, y: Ball| assert_eq!((x.mid(), x.rad(), x.prec()), (y.mid(), y.rad(), y.prec()));
    macro_rules! all {
        ($($op:tt $assign:tt),+) => {$({
            let expected = a.clone() $op b.clone();
            same(&expected, &a $op &b);
            same(&expected, &a $op b.clone());
            same(&expected, a.clone() $op &b);
            let mut x = a.clone();
            x $assign &b;
            same(&expected, x);
            let mut x = a.clone();
            x $assign b.clone();
            same(&expected, x);
            let mut x = a.clone();
            x $assign 3;
            same(&x, &a $op 3);
            same(&x, a.clone() $op a.int(3));
        })+};
    }
    all!(+ +=, - -=, * *=, / /=);
    same(&-&a, -a.clone());
    assert!(!(&a / 0).is_bounded() && !(a / Ball::integer(0, 80)).is_bounded());
}

#[test]
fn a_double_is_itself_and_what_is_none_is_nothing() {
    for x in [0.1, -0.0, f64::from_bits(1), f64::MAX] {
        let ball = Ball::from(x);
        assert!(ball.rad().is_zero() && *ball.mid() == x && ball.prec() == 53, "{x}");
    }
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(!Ball::from(x).is_bounded(), "{x}");
    }
    let longer = Ball::from(0.1) + Ball::integer(1, 300);
    assert!(longer.prec() == 300 && longer.rad().is_zero());
}

#[test]
fn exact_operations_have_no_radius() {
    let third = Ball::integer(1, 100) / Ball::integer(3, 100);
    assert!(!third.rad().is_zero());
    assert!(third.contains(&Rational::from((1, 3))));
    let quarter = Ball::integer(1, 100) / Ball::integer(4, 100);
    assert!(quarter.rad().is_zero());
    let zero = Ball::integer(0, 100) / third;
    assert!(zero.mid().is_zero() && zero.rad().is_zero(), "zero over anything but zero");
}

/// `x²` a little more than a square: GMP says that it is one, and MPFR that its root is exact.
#[test]
fn the_root_of_what_is_nearly_a_square_is_held() {
    let x = (Integer::from(1) << 222u32) + 1u32;
    for prec in [384, 400, 447, 448, 449, 512] {
        for quarters in 0u32..6 {
            let near = (Integer::from(&x * &x) << 2u32) + quarters;
            let near = Float::with_val(near.significant_bits(), near) >> 448u32;
            let root = Ball::exact(near.clone(), prec).sqrt();
            let square = |end: Float| Float::with_val(2000, end.square_ref());
            assert!(
                square(root.lower()) <= near && near <= square(root.upper()),
                "{prec} {quarters}"
            );
            assert!(
                !root.rad().is_zero() || square(root.mid().clone()) == near,
                "{prec} {quarters}"
            );
        }
    }
}

#[test]
fn outside_the_domain_is_the_whole_line() {
    let zeroish = Ball::new(Float::with_val(64, 1), Magnitude::from_integer(1), 64);
    assert!(!(Ball::integer(1, 64) / &zeroish).is_bounded());
    assert!(!Ball::integer(-1, 64).sqrt().is_bounded());
    let straddling = Ball::new(Float::with_val(64, 1e-9), Magnitude::power_of_two(-20), 64);
    assert!(!straddling.sqrt().is_bounded());
    assert!(Ball::integer(0, 64).sqrt().rad().is_zero());
    assert!(!Ball::exact(Float::with_val(64, f64::NAN), 64).is_bounded());
}

#[test]
fn overflow_and_underflow_stay_enclosures() {
    let huge = Ball::exact(Float::with_val(64, 1) << (rug::float::exp_max() - 1), 64);
    assert!(!huge.square().is_bounded());
    let tiny = Ball::exact(Float::with_val(64, 3) >> (rug::float::exp_max() - 4), 64);
    let square = tiny.square();
    assert!(square.is_bounded() && !square.rad().is_zero());
    assert!(square.lower() <= 0, "the true square lies between zero and the least float");
    assert!(square.upper() > 0);
}

#[test]
fn a_huge_argument_is_refused_not_reduced() {
    let huge = Ball::exact(Float::with_val(64, 1) << 1_000_000_000, 64);
    let (sin, cos) = huge.sin_cos();
    assert!(sin.contains(&Rational::from(1)) && cos.contains(&Rational::from(-1)));
}

#[test]
fn lying_inside_is_strict() {
    let outer = Ball::new(Float::with_val(64, 1), Magnitude::power_of_two(-4), 64);
    assert!(!outer.lies_inside(&outer));
    let inner = Ball::new(Float::with_val(64, 1), Magnitude::power_of_two(-5), 64);
    assert!(inner.lies_inside(&outer) && !outer.lies_inside(&inner));
    assert!(!Ball::whole(64).lies_inside(&Ball::whole(64)));
}

#[test]
fn trimming_keeps_the_set() {
    let fine =
        (Ball::integer(1, 4000) / Ball::integer(3, 4000)).widened(Magnitude::power_of_two(-100));
    let trimmed = fine.clone().trimmed();
    assert!(trimmed.mid().prec() < 140 && trimmed.prec() == 4000);
    assert!(fine.lower() >= trimmed.lower() && fine.upper() <= trimmed.upper());
}
