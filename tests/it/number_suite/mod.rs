//! One suite for every number type: what a field, a real number and an enclosure promise.

mod common;

use common::{Sample, circle_point, config, hard_rational, positive_rational};
use couplet::arch::cubic;
use couplet::number::{
    Angle, AstroInterval, Ball, Dual, Enclosure, Field, Magnitude, Real, Ternary,
};
use proptest::prelude::*;
use rug::{Float, Rational};

fn ring_axioms<T: Sample>(x: &Rational, y: &Rational, z: &Rational) {
    let [a, b, c] = [x, y, z].map(T::sample);
    let (sum, product) = (a.clone() + &b, a.clone() * &b);
    assert!(sum.agrees(&(b.clone() + &a)), "{a:?} + {b:?}");
    assert!(product.agrees(&(b.clone() * &a)), "{a:?} * {b:?}");
    assert!((sum.clone() * &c).agrees(&(a.clone() * &c + b.clone() * &c)), "{a:?} {b:?} {c:?}");
    assert!((a.clone() - &b).agrees(&(a.clone() + -b.clone())), "{a:?} - {b:?}");
    assert!(a.square().agrees(&(a.clone() * &a)), "{a:?}²");
    assert!(a.int(7).agrees(&(a.int(3) + a.int(4))));
    assert!(a.ratio(3, 4).agrees(&T::sample(&Rational::from((3, 4)))) || has_gradient::<T>());
    assert!(!sum.spoiled().agrees(&sum), "a false twin is seen: {sum:?}");
    if *y != 0 {
        assert!((product / &b).agrees(&a) || y.clone().abs() < Rational::from((1, 1 << 20)));
    }
}

/// A constant of a dual type has no slope while a sample has one.
fn has_gradient<T>() -> bool {
    std::any::type_name::<T>().contains("Dual")
}

fn identity_8<T: Sample>(rad: &Rational, (sin, cos): &(Rational, Rational)) {
    let joint = Angle { rad, sin, cos }.map(T::sample);
    let zero = T::sample(&Rational::new()) - T::sample(&Rational::new());
    let link = cubic::link(&joint);
    // In a dual type the three samples are one variable, of which (8) knows nothing.
    assert!(link.agrees(&zero) || has_gradient::<T>(), "{link:?}");
    assert!(!link.spoiled().agrees(&zero));
}

fn real_functions<T: Sample + Real>(x: &Rational) {
    let a = T::sample(x);
    let (sin, cos) = a.sin_cos();
    assert!((sin.square() + cos.square()).agrees(&a.int(1)) || has_gradient::<T>(), "{a:?}");
    let (twice, _) = (a.clone() + &a).sin_cos();
    assert!(twice.agrees(&(a.int(2) * sin * cos)), "sin 2x at {a:?}");
    let root = T::sample(&x.clone().abs()).sqrt();
    assert!((root.clone() * &root).agrees(&T::sample(&x.clone().abs())));
    let link = cubic::link(&Angle::new(a.clone()));
    assert!(link.agrees(&a.int(0)), "(8) at a real angle: {link:?}");
    let (_, minus_one) = a.pi().sin_cos();
    assert!(minus_one.agrees(&a.int(-1)));
}

macro_rules! suite {
    ($($name:ident: $type:ty, $($real:ident)?;)*) => {$(
        mod $name {
            use super::*;
            proptest! {
                #![proptest_config(config(200))]
                #[test]
                fn is_a_ring(x in hard_rational(), y in hard_rational(), z in hard_rational()) {
                    ring_axioms::<$type>(&x, &y, &z);
                }

                #[test]
                fn satisfies_identity_8(rad in positive_rational(), point in circle_point()) {
                    identity_8::<$type>(&rad, &point);
                }

                $(
                    #[test]
                    fn has_real_functions(x in moderate()) {
                        $real::<$type>(&x);
                    }
                )?
            }
        }
    )*};
}

/// Arguments of sine for which a double still has a few right digits.
fn moderate() -> impl Strategy<Value = Rational> {
    positive_rational().prop_map(|x| if x > 100 { Rational::from(1) / x } else { x })
}

suite! {
    double: f64, real_functions;
    mpfr: Float, real_functions;
    ball: Ball, real_functions;
    astro: AstroInterval, real_functions;
    rational: Rational, ;
    dual_of_balls: Dual<Ball>, real_functions;
    dual_of_rationals: Dual<Rational>, ;
}

/// All elementary results of two exact arguments, in one enclosure type.
fn results<E: Enclosure>(x: &E, y: &E) -> Vec<E> {
    let (sin, cos) = x.sin_cos();
    let size = x.square();
    vec![
        x.clone() + y,
        x.clone() - y,
        x.clone() * y,
        x.clone() / y,
        x.square(),
        size.sqrt(),
        sin,
        cos,
        x.pi(),
        -y.clone(),
    ]
}

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

proptest! {
    #![proptest_config(config(400))]

    /// The contract: results at a low precision hold those at a much higher one.
    #[test]
    fn a_ball_holds_the_result_at_higher_precision(x in any_float(128), y in any_float(128), prec in 2u32..300) {
        let make = |prec| (Ball::exact(x.clone(), prec), Ball::exact(y.clone(), prec));
        let ((a, b), (c, d)) = (make(prec), make(2000));
        for (index, (coarse, fine)) in results(&a, &b).iter().zip(results(&c, &d)).enumerate() {
            prop_assert!(coarse.lower() <= fine.upper() && fine.lower() <= coarse.upper(), "{index} {x} {y}");
            // Much finer, so that overlapping means holding: the finer ball sticks out by a hair at most.
            let hair = Float::with_val(2100, fine.upper() - fine.lower());
            prop_assert!(coarse.lower() <= Float::with_val(2100, fine.lower() + &hair));
            prop_assert!(coarse.upper() >= Float::with_val(2100, fine.upper() - &hair));
        }
    }

    /// Two arithmetics that share nothing agree.
    #[test]
    fn both_arithmetics_overlap(x in any_float(128), y in any_float(128), words in 1usize..12) {
        let prec = 64 * words;
        let (a, b) = (Ball::exact(x.clone(), prec as u32), Ball::exact(y.clone(), prec as u32));
        let (c, d) = (AstroInterval::between(&x, &x, prec), AstroInterval::between(&y, &y, prec));
        for (index, (ball, interval)) in results(&a, &b).iter().zip(results(&c, &d)).enumerate() {
            let Some((low, high)) = interval.ends() else {
                prop_assert!(!ball.is_bounded(), "{index} {x} {y}");
                continue;
            };
            prop_assert!(ball.lower() <= high && low <= ball.upper(), "{index} {x} {y}: {ball:?} {low} {high}");
        }
    }

    /// Wide arguments: the image of every number inside lies in the image of the ball.
    #[test]
    fn a_wide_ball_holds_the_image_of_its_numbers(
        x in any_float(64), y in any_float(64), wide in -100i64..8, inside in -1.0f64..=1.0, along in -1.0f64..=1.0,
    ) {
        let (a, b) = (
            Ball::new(x.clone(), Magnitude::power_of_two(wide), 100),
            Ball::new(y.clone(), Magnitude::power_of_two(wide - 3), 100),
        );
        let moved = |x: &Float, part: f64, shift: i64| {
            let offset = Float::with_val(600, part) << shift as i32;
            Ball::exact(Float::with_val(600, x + &offset), 2000)
        };
        let (p, q) = (moved(&x, inside, wide), moved(&y, along, wide - 3));
        for (index, (image, point)) in results(&a, &b).iter().zip(results(&p, &q)).enumerate() {
            let outside = image.is_bounded() && point.is_bounded()
                && (image.upper() < point.lower() || point.upper() < image.lower());
            prop_assert!(!outside, "{index} {x} {y}: {image:?} does not hold {point:?}");
        }
    }

    #[test]
    fn decided_comparisons_are_true(x in hard_rational(), y in hard_rational()) {
        let ball = Ball::enclosing(&x, 80).is_less_than(&Ball::enclosing(&y, 80));
        let astro = AstroInterval::enclosing(&x, 64).is_less_than(&AstroInterval::enclosing(&y, 64));
        for answer in [ball, astro] {
            match answer {
                Ternary::True => prop_assert!(x < y),
                Ternary::False => prop_assert!(x >= y),
                Ternary::Undecided => {}
            }
        }
    }

    #[test]
    fn aliasing_makes_no_difference(x in hard_rational()) {
        let a = Ball::sample(&x);
        prop_assert!((a.clone() - &a).contains(&Rational::new()));
        prop_assert!((a.clone() * &a).contains(&Rational::from(x.square_ref())));
        if x != 0 {
            prop_assert!((a.clone() / &a).contains(&Rational::from(1)));
        }
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
fn a_divisor_that_holds_zero_gives_the_whole_line() {
    let zero = Ball::new(Float::with_val(64, 0), Magnitude::power_of_two(-200), 64);
    assert!(!(Ball::integer(1, 64) / &zero).is_bounded());
    assert!(!(Dual::variable(zero.int(1), 0) / Dual::constant(zero)).derivative(0).is_bounded());
}

#[test]
fn a_huge_argument_of_sine_is_refused_quickly() {
    let x: Float = Float::with_val(64, 1) << 500_000_000;
    let ball = Ball::exact(x.clone(), 64).sin_cos();
    let interval = AstroInterval::between(&x, &x, 64).sin_cos();
    assert!(ball.0.contains(&Rational::from(1)) && ball.0.contains(&Rational::from(-1)));
    assert_eq!(interval.0.ends().unwrap().0, -1);
}
