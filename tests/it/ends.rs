//! The ends of intervals bit by bit: every function of an arithmetic that is used is rounded as MPFR rounds it, in both
//! directions, on arguments chosen to be hard.

use crate::hard::{config, moved, quarter_turns};
use couplet::number::{Astro, Ball, Real, RoundingMode};
use proptest::prelude::*;
use rug::float::{Constant, Round};
use rug::integer::Order;
use rug::{Float, Integer};

const DIRECTIONS: [(RoundingMode, Round); 2] =
    [(RoundingMode::Down, Round::Down), (RoundingMode::Up, Round::Up)];

/// The same number.
fn to_end(x: &Float) -> Astro {
    let Some((mantissa, exponent)) = x.to_integer_exp() else { panic!("{x} is not finite") };
    let words: Vec<u64> = mantissa.to_digits(Order::Lsf);
    Astro::dyadic(mantissa < 0, &words, exponent).unwrap()
}

/// The same number; `None` if it is not finite.
fn to_mpfr(x: &Astro) -> Option<Float> {
    let (negative, words, exponent) = x.parts()?;
    let mantissa = Integer::from_digits(&words, Order::Lsf);
    let size = Float::with_val(mantissa.significant_bits().max(64), mantissa) << exponent;
    Some(if negative { -size } else { size })
}

/// Compares a result with MPFR's in each direction.
fn same(
    what: &str,
    bits: u32,
    ours: impl Fn(usize, RoundingMode) -> Astro,
    mpfr: impl Fn(u32, Round) -> Float,
) -> Result<(), TestCaseError> {
    for (to, round) in DIRECTIONS {
        let found = to_mpfr(&ours(bits as usize, to));
        prop_assert_eq!(found, Some(mpfr(bits, round)), "{} to {} bits, {:?}", what, bits, round);
    }
    Ok(())
}

fn with_round<T>(bits: u32, round: Round, x: T) -> Float
where
    Float: rug::ops::AssignRound<T, Round = Round, Ordering = std::cmp::Ordering>,
{
    Float::with_val_round(bits, x, round).0
}

/// The root of a number that is not negative. MPFR's root rounded down is right; next to a square GMP may say
/// that the number is one, so that the root rounded up is looked for.
fn root(bits: u32, round: Round, x: &Float) -> Float {
    let mut root = with_round(bits, Round::Down, x.sqrt_ref());
    if round == Round::Up && Float::with_val(2 * bits, root.square_ref()) != *x {
        root.next_up();
    }
    root
}

fn arithmetic(x: &Float, y: &Float, bits: u32) -> Result<(), TestCaseError> {
    let (a, b): (Astro, Astro) = (to_end(x), to_end(y));
    same("+", bits, |p, to| a.plus(&b, p, to), |p, r| with_round(p, r, x + y))?;
    same("-", bits, |p, to| a.minus(&b, p, to), |p, r| with_round(p, r, x - y))?;
    same("*", bits, |p, to| a.times(&b, p, to), |p, r| with_round(p, r, x * y))?;
    same("square", bits, |p, to| a.times(&a, p, to), |p, r| with_round(p, r, x.square_ref()))?;
    same("itself", bits, |p, to| a.rounded(p, to), |p, r| with_round(p, r, x))?;
    if !y.is_zero() {
        same("/", bits, |p, to| a.over(&b, p, to), |p, r| with_round(p, r, x / y))?;
    }
    prop_assert_eq!(a.order(&b), x.partial_cmp(y));
    prop_assert_eq!(a.sign(), x.partial_cmp(&0));
    prop_assert_eq!(a.exponent(), x.get_exp().map(i64::from));
    prop_assert_eq!(to_mpfr(&a.negated()), Some(-x.clone()));
    let size = x.clone().abs();
    let end: Astro = to_end(&size);
    same("sqrt", bits, |p, to| end.root(p, to), |p, r| root(p, r, &size))
}

/// The lower ends are those of MPFR, the upper ones too or, where one evaluation gives both, one unit above where a
/// power of two is passed.
fn functions(x: &Float, bits: u32) -> Result<(), TestCaseError> {
    let a: Astro = to_end(x);
    let both = a.sin_cos(bits as usize);
    let Some([sin, cos]) = both else { return Err(TestCaseError::fail(format!("none at {x}"))) };
    let sine = |round| with_round(bits, round, x.sin_ref());
    let cosine = |round| with_round(bits, round, x.cos_ref());
    let truths: [&dyn Fn(Round) -> Float; 2] = [&sine, &cosine];
    for ((low, high), truth) in [sin, cos].into_iter().zip(truths) {
        let (below, above) = (truth(Round::Down), truth(Round::Up));
        prop_assert_eq!(to_mpfr(&low), Some(below.clone()), "{} to {} bits", x, bits);
        let found = to_mpfr(&high).unwrap();
        let mut next = above.clone();
        next.next_up();
        let is_passed = below.is_sign_negative()
            && below.get_significand().is_some_and(|significand| significand.is_power_of_two());
        prop_assert!(
            found == above || is_passed && found == next,
            "{x} to {bits} bits: {found} {above}"
        );
    }
    Ok(())
}

/// Mantissas of some words: any, all ones, a single one, ones at both ends, a long run.
fn mantissa() -> impl Strategy<Value = Integer> {
    let words = prop::collection::vec(any::<u64>(), 1..7);
    let runs = (1u32..380, 0u32..380);
    prop_oneof![
        words.prop_map(|words| Integer::from_digits(&words, Order::Lsf) | 1u32),
        runs.clone().prop_map(|(size, _)| (Integer::from(1) << size) - 1u32),
        runs.clone().prop_map(|(size, _)| (Integer::from(1) << size) + 1u32),
        runs.clone().prop_map(|(size, zeros)| ((Integer::from(1) << size) - 1u32) << zeros),
        runs.prop_map(|(a, b)| (Integer::from(1) << (a + b)) - (Integer::from(1) << a) + 1u32),
        Just(Integer::from(1)),
        Just(Integer::from(0)),
    ]
}

/// A number of any sign whose size is about `2^exponent`.
fn number(exponents: std::ops::Range<i32>) -> impl Strategy<Value = Float> {
    (mantissa(), exponents, any::<bool>()).prop_map(|(mantissa, exponent, minus)| {
        let size = mantissa.significant_bits();
        let x = Float::with_val(size.max(64), mantissa) << (exponent - size as i32);
        if minus { -x } else { x }
    })
}

/// A number and one that nearly cancels it, or is lost beside it, or is a simple multiple of it.
fn pair() -> impl Strategy<Value = (Float, Float)> {
    let near =
        (number(-8..8), any::<u64>(), 0u32..500, any::<bool>()).prop_map(|(x, m, shift, minus)| {
            let hair = Float::with_val(64, m) >> (64 + shift);
            let y = Float::with_val(1200, &x + if minus { -hair } else { hair });
            (x, y)
        });
    let apart = (number(-8..8), number(-900..900));
    let multiple = (number(-8..8), 1u32..1000).prop_map(|(x, n)| {
        let y = Float::with_val(x.prec() + 32, &x * n);
        (y, x)
    });
    let any = (number(-300..300), number(-300..300));
    prop_oneof![near, apart, multiple, any]
}

/// Angles: of any size, tiny ones, large ones, and multiples of a quarter turn to some bits.
fn angle() -> impl Strategy<Value = Float> {
    let quarters = quarter_turns(4000, 8..700);
    prop_oneof![number(-4..4), number(-700..-4), number(4..200), quarters]
}

/// Bits from few to many: those of astro-float in whole words.
fn bits() -> impl Strategy<Value = u32> {
    prop_oneof![(1u32..9).prop_map(|words| 64 * words), 64u32..520]
}

/// The precision that astro-float makes of what is asked.
fn of(bits: u32) -> u32 {
    bits.next_multiple_of(64)
}

/// A number some units beside a square.
fn near_a_square(x: &Float, ulps: i32) -> Float {
    moved(Float::with_val(2 * x.prec() + 2, x.square_ref()), ulps).abs()
}

proptest! {
    #![proptest_config(config(20_000))]

    #[test]
    fn a_ball_holds_the_root_of_what_is_nearly_a_square(
        x in number(-20..20), bits in bits(), ulps in -2i32..=2,
    ) {
        if x.is_zero() {
            return Ok(());
        }
        let near = near_a_square(&x, ulps);
        let root = Ball::exact(near.clone(), bits).sqrt();
        let square = |end: Float| Float::with_val(2 * end.prec(), end.square_ref());
        prop_assert!(square(root.lower()) <= near && near <= square(root.upper()), "{:?}", root);
    }
}

fn the_root_of_a_square(square: &Float, bits: u32) -> Result<(), TestCaseError> {
    let a: Astro = to_end(square);
    same("sqrt", bits, |p, to| a.root(p, to), |p, r| root(p, r, square))
}

#[test]
fn pi_is_rounded_as_by_mpfr() {
    for bits in (64..6400).step_by(64) {
        same("pi", bits, Astro::pi, |p, r| with_round(p, r, Constant::Pi)).unwrap();
    }
}

#[test]
fn a_wrong_bit_is_seen() {
    let x = Float::with_val(64, 1.5);
    let a: Astro = to_end(&x);
    assert_eq!(to_mpfr(&a), Some(x.clone()));
    let wrong = |p, r| {
        let mut y = with_round(p, r, x.sqrt_ref());
        y.next_up();
        y
    };
    assert!(same("sqrt", 128, |p, to| a.root(p, to), wrong).is_err());
}

proptest! {
    #![proptest_config(config(20_000))]

    #[test]
    fn arithmetic_is_rounded_as_by_mpfr((x, y) in pair(), bits in bits()) {
        arithmetic(&x, &y, of(bits))?;
    }

    #[test]
    fn squares_have_their_roots(x in number(-20..20), bits in bits(), ulps in -2i32..=2) {
        if x.is_zero() {
            return Ok(());
        }
        the_root_of_a_square(&near_a_square(&x, ulps), of(bits))?;
    }
}

proptest! {
    #![proptest_config(config(8_000))]

    #[test]
    fn sine_and_cosine_are_rounded_as_by_mpfr(x in angle(), bits in bits()) {
        // An interval asks for no sine of zero.
        if x.is_zero() {
            return Ok(());
        }
        functions(&x, of(bits))?;
    }
}
