//! One suite for every number type: what a field, a real number and an enclosure promise.

mod enclosures;
mod sample;
mod sines;

use crate::hard::{circle_point, config, hard_rational, positive_rational};
use couplet::arch::cubic;
use couplet::number::{
    Angle, AstroInterval, Ball, DoubleBall, DoubleDoubleBall, Dual, Enclosure, Field, Magnitude,
    Real, TripleWordBall,
};
use proptest::prelude::*;
use rug::{Float, Rational};
use sample::Sample;

/// Whether a sample of the type is a variable, with a slope that a constant of the type does not have.
#[derive(Clone, Copy, PartialEq)]
enum Slope {
    None,
    One,
}

fn ring_axioms<T: Sample>(slope: Slope, x: &Rational, y: &Rational, z: &Rational) {
    let [a, b, c] = [x, y, z].map(T::sample);
    let (sum, product) = (a.clone() + &b, a.clone() * &b);
    assert!(sum.agrees(&(b.clone() + &a)), "{a:?} + {b:?}");
    assert!(product.agrees(&(b.clone() * &a)), "{a:?} * {b:?}");
    assert!((sum.clone() * &c).agrees(&(a.clone() * &c + b.clone() * &c)), "{a:?} {b:?} {c:?}");
    assert!((a.clone() - &b).agrees(&(a.clone() + -b.clone())), "{a:?} - {b:?}");
    assert!(a.square().agrees(&(a.clone() * &a)), "{a:?}²");
    assert!(a.int(7).agrees(&(a.int(3) + a.int(4))));
    assert!(a.ratio(3, 4).agrees(&T::sample(&Rational::from((3, 4)))) || slope == Slope::One);
    assert!(!sum.spoiled().agrees(&sum), "a false twin is seen: {sum:?}");
    if *y != 0 {
        assert!((product / &b).agrees(&a) || y.clone().abs() < Rational::from((1, 1 << 20)));
    }
}

fn identity_8<T: Sample>(slope: Slope, rad: &Rational, (sin, cos): &(Rational, Rational)) {
    let joint = Angle { rad, sin, cos }.map(T::sample);
    let zero = T::sample(&Rational::new()) - T::sample(&Rational::new());
    let link = cubic::link(&joint);
    // In a dual type the three samples are one variable, of which (8) knows nothing.
    assert!(link.agrees(&zero) || slope == Slope::One, "{link:?}");
    assert!(!link.spoiled().agrees(&zero));
}

fn real_functions<T: Sample + Real>(slope: Slope, x: &Rational) {
    let a = T::sample(x);
    let (sin, cos) = a.sin_cos();
    assert!((sin.square() + cos.square()).agrees(&a.int(1)) || slope == Slope::One, "{a:?}");
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
    ($($(#[$only:meta])? $name:ident: $type:ty, $slope:expr $(, $real:ident)?;)*) => {$(
        $(#[$only])?
        mod $name {
            use super::*;

            /// What a failure was once shrunk to.
            #[test]
            fn is_a_ring_near_two_to_the_forty() {
                let y = Rational::from(1_023_999_998_976i64);
                ring_axioms::<$type>($slope, &Rational::new(), &y, &Rational::new());
            }

            proptest! {
                #![proptest_config(config(200))]
                #[test]
                fn is_a_ring(x in hard_rational(), y in hard_rational(), z in hard_rational()) {
                    ring_axioms::<$type>($slope, &x, &y, &z);
                }

                #[test]
                fn satisfies_identity_8(rad in positive_rational(), point in circle_point()) {
                    identity_8::<$type>($slope, &rad, &point);
                }

                $(
                    #[test]
                    fn has_real_functions(x in moderate()) {
                        $real::<$type>($slope, &x);
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
    double: f64, Slope::None, real_functions;
    mpfr: Float, Slope::None, real_functions;
    ball: Ball, Slope::None, real_functions;
    double_ball: DoubleBall, Slope::None, real_functions;
    double_double_ball: DoubleDoubleBall, Slope::None, real_functions;
    triple_word_ball: TripleWordBall, Slope::None, real_functions;
    astro: AstroInterval, Slope::None, real_functions;
    rational: Rational, Slope::None;
    dual_of_balls: Dual<Ball>, Slope::One, real_functions;
    dual_of_double_balls: Dual<DoubleBall>, Slope::One, real_functions;
    dual_of_double_double_balls: Dual<DoubleDoubleBall>, Slope::One, real_functions;
    dual_of_rationals: Dual<Rational>, Slope::One;
}

#[test]
fn a_dual_divisor_that_holds_zero_gives_the_whole_line() {
    let zero = Ball::new(Float::with_val(64, 0), Magnitude::power_of_two(-200), 64);
    let one = Dual::variable(zero.int(1), 0);
    assert!(!(one / Dual::constant(zero)).derivative(0).is_bounded());
}
