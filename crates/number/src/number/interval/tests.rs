use super::*;

fn power(exponent: i32) -> AstroInterval {
    AstroInterval::dyadic(false, &[1], exponent, 128)
}

/// Whatever the exponents come to, the sign stays right, and the truth inside.
#[test]
fn exponents_end() {
    let (mut large, mut small): (AstroInterval, AstroInterval) =
        (power(1 << 27), power(-(1 << 27)));
    for _ in 0..8 {
        (large, small) = (large.square(), small.square());
        assert_ne!(power(1 << 27).is_less_than(&large), Ternary::False, "{large:?}");
        let is_small = small.is_less_than(&power(-(1 << 27)));
        assert!(small.is_non_negative() && is_small.is_proved(), "{small:?}");
        assert_eq!(small.high.sign(), Some(Ordering::Greater));
    }
    assert!(!large.is_bounded(), "there is an end: {large:?}");
    assert!(!(large.clone() - &large).is_bounded() && !(large.int(1) / &small).is_bounded());
    assert_eq!((-large.clone()).is_positive(), Ternary::False);
    let product = large.clone() * &small;
    assert!(product.overlaps(&large.int(1)), "{product:?}");
}

/// Numbers from outside may have any exponent.
#[test]
fn any_exponent_is_held() {
    for exponent in [i32::MIN, i32::MIN + 1, -(1 << 30), -(1 << 29) - 1, 1 << 29, 1 << 30, i32::MAX]
    {
        let x: AstroInterval = power(exponent);
        let is_size = |half: &AstroInterval| half.is_less_than(&x) != Ternary::False;
        assert!(exponent < 0 || is_size(&x.int(1)), "{exponent}");
        assert!(exponent > 0 || x.is_less_than(&x.int(1)) != Ternary::False, "{exponent}");
        assert_ne!((-x.clone()).is_positive(), Ternary::True, "{exponent}");
        let (sin, cos) = x.sin_cos();
        assert!(sin.is_bounded() && cos.is_bounded(), "{exponent}");
    }
}

/// Below every precision there is one that works.
#[test]
fn no_bits_are_some_bits() {
    for prec in [0, 1, 2, 63] {
        let third = AstroInterval::integer(1, prec) / AstroInterval::integer(3, prec);
        assert!((third.clone() * third.int(3)).overlaps(&third.int(1)));
        assert!(third.with_precision(0).overlaps(&third) && third.is_bounded());
        assert!(third.sin_cos().0.is_less_than(&third).is_proved() && third.sqrt().is_bounded());
    }
}

/// Zero, and numbers that are lost beside one; the same a little further from it, where they are not.
#[test]
fn small_angles() {
    let zero: AstroInterval = AstroInterval::integer(0, 128);
    let (sin, cos) = zero.sin_cos();
    for (value, truth) in [(sin, 0), (cos, 1)] {
        let is_exact = value.low.order(&value.high) == Some(Ordering::Equal);
        assert!(is_exact && value.overlaps(&zero.int(truth)), "{value:?}");
    }
    for exponent in [-10_000_000, -100_000, -200, -66, -65, -64, -63, -40] {
        for negative in [false, true] {
            let x = AstroInterval::dyadic(negative, &[u64::MAX, u64::MAX, 3], exponent - 130, 256);
            let x = x.with_precision(128);
            let (sin, cos) = x.sin_cos();
            let (size, near) = if negative { (-x, -sin) } else { (x, sin) };
            let least = size.clone() - size.square() * &size;
            assert!(
                near.is_less_than(&size) != Ternary::False
                    && least.is_less_than(&near) != Ternary::False
            );
            let least = size.clone() - size.clone() * power(-78);
            assert!(
                least.is_less_than(&near).is_proved() && near.is_positive().is_proved(),
                "{exponent}"
            );
            let one = size.int(1);
            assert!(
                (one.clone() - size.square()).is_less_than(&cos) != Ternary::False,
                "{exponent}"
            );
            assert!(
                cos.is_less_than(&one) != Ternary::False
                    && (one - power(-77)).is_less_than(&cos).is_proved()
            );
        }
    }
}

/// Angles whose place in the turn is not looked for.
#[test]
fn large_angles() {
    for exponent in [200, 10_000_000, 500_000_000] {
        let (sin, cos) = power(exponent).sin_cos();
        for value in [sin, cos] {
            assert!(value.overlaps(&value.int(1)) && value.overlaps(&value.int(-1)));
            assert!(value.is_less_than(&value.int(2)).is_proved());
        }
    }
}

/// An interval of no number, or nowhere, is the whole line and nothing less.
#[test]
fn nowhere_is_everywhere() {
    let (zero, one) = (AstroInterval::integer(0, 64), AstroInterval::integer(1, 64));
    let unit = one.symmetric();
    let whole = AstroInterval::whole(64);
    for set in [
        one.clone() / &zero,
        one.clone() / &unit,
        unit.sqrt(),
        (-one.clone()).sqrt(),
        whole.clone() * &zero,
        whole.clone() - &whole,
        whole.square() * &unit,
    ] {
        assert!(!set.is_bounded() && set.is_positive() == Ternary::Undecided, "{set:?}");
        assert!(set.overlaps(&one.int(i32::MAX)) && set.overlaps(&one.int(i32::MIN)), "{set:?}");
        assert!(!set.lies_inside(&whole) && !set.excludes_zero());
        assert!(set.sin_cos().0.lies_inside(&one.int(2).symmetric()));
    }
}
