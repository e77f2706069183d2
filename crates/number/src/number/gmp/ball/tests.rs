use super::*;

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
