//! The cubics (7) and the radicand (12) once more, as the paper prints them, by the expressions of astro-float: its
//! macro reads the formula and chooses the precision of every step itself. At the middle of a certified state the
//! values lie in what balls enclose over all of it; with one sign changed they do not.

use crate::arches::{M, arch, at_landmark};
use astro_float::ctx::Context;
use astro_float::{BigFloat, Consts, RoundingMode, Sign, WORD_BIT_SIZE, Word, expr};
use couplet::arch::{Unknown, cubic, thrust};
use couplet::certify::state::{Certify, Outcome};
use couplet::number::{Angle, Ball, Field, Magnitude};
use couplet::problem::{Landmark, Mode};
use rug::integer::Order;
use rug::{Float, Integer, Rational};

/// Bits of the balls.
const BITS: u32 = 512;
/// Bits of an expression.
const LONG: usize = 1024;
/// A bound of the rounding errors of an expression, in bits below one. It takes fewer than 2^6 steps, each with a
/// relative error of at most 2^-1023; no part of it and no factor of a part is above 2^13, as `beta < pi`, `A <=
/// 2`, `eta <= 2`, `h <= 1`, so that `|f|` and `|g|` are below 5. Together that is below 2^(6 + 13 + 13 - 1023).
const SLACK: i64 = -991;

/// A number of MPFR as one of astro-float, exactly.
fn exactly(x: &Float) -> BigFloat {
    let (mantissa, exponent) = x.to_integer_exp().unwrap();
    let size = mantissa.significant_bits();
    let length = size.next_multiple_of(WORD_BIT_SIZE as u32);
    let words: Vec<Word> = (mantissa.clone().abs() << (length - size)).to_digits(Order::Lsf);
    let sign = if mantissa < 0 { Sign::Neg } else { Sign::Pos };
    BigFloat::from_words(&words, sign, exponent + size as i32)
}

/// A number of astro-float, exactly.
fn rational(x: &BigFloat) -> Rational {
    let (words, _, sign, exponent, _) = x.as_raw_parts().unwrap();
    let size = Rational::from(Integer::from_digits(words, Order::Lsf));
    let size = size << (exponent - (words.len() * WORD_BIT_SIZE) as i32);
    if sign == Sign::Neg { -size } else { size }
}

/// The three cubics (7) and the radicand (12) at exact numbers `beta, A, eta, h`; with a changed sign in each for
/// twins.
fn printed([b, a, eta, h]: [&BigFloat; 4], twin: bool) -> [BigFloat; 4] {
    let constants = Consts::new().unwrap();
    let mut at = Context::new(LONG, RoundingMode::ToEven, constants, -20_000, 20_000);
    let sign = if twin { -1 } else { 1 };
    let (s, c) = (expr!(sin(b), &mut at), expr!(cos(b), &mut at));
    let (f, g) = (expr!(s + b * c, &mut at), expr!(b + s * c, &mut at));
    let in_opening = expr!(
        s * s * (3 * g - 2 * s) * a * a * a + 3 * g * s * (g - f) * a * a
            - sign * 3 * f * g * g * a
            + 2 * g * g * g,
        &mut at
    );
    let in_thickness = expr!(
        s * eta * eta * eta + 3 * (f + g) * eta * eta - sign * 12 * (g - s) * eta + 12 * (g - f),
        &mut at
    );
    let in_thrust = expr!(
        6 * s * s * h * h * h
            - sign * 3 * s * (3 * f - g - 2 * s) * h * h
            - 3 * (g - f) * (f - 2 * s) * h
            + 2 * (g - f) * (g - f),
        &mut at
    );
    let radicand = expr!(
        9 * s * s * (g - f) * (g - f)
            - sign * 2 * s * (g - s) * (9 * f * f - g * g - 16 * g * s + 8 * s * s)
            - 3 * (f + g) * (f + g) * (f * f - 2 * g * s + s * s),
        &mut at
    );
    [in_opening, in_thickness, in_thrust, radicand]
}

/// Compares both at the purely rotational state of this half opening, rad.
fn agree(half_opening: &str) {
    let arch = arch(M, half_opening, "inf");
    let proved = [BITS, 2 * BITS].into_iter().find_map(|bits| arch.state(bits).ok());
    let Some(Outcome::Stands(state)) = proved else { panic!("{half_opening}") };
    assert_eq!(state.mode, Mode::Rotational, "{half_opening}");
    let alpha = Angle::new(arch.half_opening().enclosure::<Ball>(BITS));
    let a = thrust::opening_variable(&alpha).value();
    let (joint, one) = (Angle::new(state.rotation_joint), a.int(1));
    let at = cubic::abbreviations(&joint);
    let enclosed = [
        cubic::in_opening_variable(&at, &one, &a),
        cubic::in_thickness(&at, &one, &state.thickness),
        cubic::in_thrust(&at, &one, &state.thrust),
        cubic::radicand(&at, &one),
    ];
    let middle = [&joint.rad, &a, &state.thickness, &state.thrust].map(|x| exactly(x.mid()));
    let [values, twins] = [false, true].map(|twin| printed(middle.each_ref(), twin));
    for (k, enclosed) in enclosed.into_iter().enumerate() {
        let place = format!("{half_opening}: {k}");
        assert_eq!(enclosed.contains(&Rational::new()), k < 3, "{place}: the state solves (7)");
        let enclosed = enclosed.widened(Magnitude::power_of_two(SLACK));
        assert!(enclosed.contains(&rational(&values[k])), "{place}");
        assert!(!enclosed.contains(&rational(&twins[k])), "{place}: false twin");
    }
}

#[test]
fn expressions_agree_at_ordinary_arches() {
    for half_opening in ["0.001", "0.5", "pi/3", "pi/2", "2", "2.4"] {
        agree(half_opening);
    }
}

/// Next to `sb` the radicand nearly vanishes; next to `l` the joint does, and everything with it.
#[test]
fn expressions_agree_next_to_the_widest_joint_and_to_the_end() {
    let ends =
        [(Landmark::WidestJoint, [-20i32, 20, -40]), (Landmark::RotationEnd, [-9, -20, -30])];
    for (landmark, steps) in ends {
        let alpha = at_landmark(landmark, M, Unknown::HalfOpening, BITS);
        let alpha = alpha.mid().to_rational().unwrap();
        for places in steps {
            let below = Integer::from(Integer::u_pow_u(10, places.unsigned_abs()));
            let step = Rational::from((places.signum(), below));
            agree(&(alpha.clone() + step).to_string());
        }
    }
}
