//! The second arithmetic bit by bit: every function of astro-float that is used is rounded as MPFR rounds
//! it, in every direction that is used, on arguments chosen to be hard.

use crate::hard::config;
use astro_float::{BigFloat, Consts, RoundingMode, Sign, WORD_BIT_SIZE};
use proptest::prelude::*;
use rug::float::{Constant, Round};
use rug::integer::Order;
use rug::{Float, Integer};
use std::cell::RefCell;

const DIRECTIONS: [(RoundingMode, Round); 3] = [
    (RoundingMode::Down, Round::Down),
    (RoundingMode::Up, Round::Up),
    (RoundingMode::ToEven, Round::Nearest),
];

/// The same number.
fn to_astro(x: &Float) -> BigFloat {
    let Some((mantissa, _)) = x.to_integer_exp() else { panic!("{x} is not finite") };
    if mantissa == 0 {
        return BigFloat::from_i32(0, WORD_BIT_SIZE);
    }
    // The mantissa with its top bit at the top of a word.
    let size = mantissa.significant_bits();
    let shifted = Integer::from(mantissa.abs_ref()) << (size.next_multiple_of(64) - size);
    let sign = if mantissa < 0 { Sign::Neg } else { Sign::Pos };
    BigFloat::from_words(&shifted.to_digits::<u64>(Order::Lsf), sign, x.get_exp().unwrap())
}

/// The same number; `None` if it is not finite.
fn to_mpfr(x: &BigFloat) -> Option<Float> {
    if x.is_zero() {
        return Some(Float::new(64));
    }
    let (words, _, sign, exponent, _) = x.as_raw_parts()?;
    let mantissa = Integer::from_digits(words, Order::Lsf);
    let bits = 64 * words.len() as u32;
    let size = Float::with_val(bits, mantissa) << (exponent - bits as i32);
    Some(if sign == Sign::Neg { -size } else { size })
}

thread_local! {
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().unwrap());
}

/// Compares a result of astro-float with MPFR's in each direction.
fn same(
    what: &str,
    bits: u32,
    astro: impl Fn(usize, RoundingMode, &mut Consts) -> BigFloat,
    mpfr: impl Fn(u32, Round) -> Float,
) -> Result<(), TestCaseError> {
    for (mode, round) in DIRECTIONS {
        let found = CONSTANTS.with_borrow_mut(|constants| astro(bits as usize, mode, constants));
        let right = mpfr(bits, round);
        prop_assert_eq!(to_mpfr(&found), Some(right), "{} to {} bits, {:?}", what, bits, round);
    }
    Ok(())
}

fn with_round<T>(bits: u32, round: Round, x: T) -> Float
where
    Float: rug::ops::AssignRound<T, Round = Round, Ordering = std::cmp::Ordering>,
{
    Float::with_val_round(bits, x, round).0
}

fn arithmetic(x: &Float, y: &Float, bits: u32) -> Result<(), TestCaseError> {
    let (a, b) = (to_astro(x), to_astro(y));
    same("+", bits, |p, m, _| a.add(&b, p, m), |p, r| with_round(p, r, x + y))?;
    same("-", bits, |p, m, _| a.sub(&b, p, m), |p, r| with_round(p, r, x - y))?;
    same("*", bits, |p, m, _| a.mul(&b, p, m), |p, r| with_round(p, r, x * y))?;
    same("square", bits, |p, m, _| a.mul(&a, p, m), |p, r| with_round(p, r, x.square_ref()))?;
    if !y.is_zero() {
        same("/", bits, |p, m, _| a.div(&b, p, m), |p, r| with_round(p, r, x / y))?;
    }
    let (size, root) = (x.clone().abs(), a.abs());
    same("sqrt", bits, |p, m, _| root.sqrt(p, m), |p, r| with_round(p, r, size.sqrt_ref()))
}

fn functions(x: &Float, bits: u32) -> Result<(), TestCaseError> {
    let a = to_astro(x);
    same(
        &format!("sin {x}"),
        bits,
        |p, m, c| a.sin(p, m, c),
        |p, r| with_round(p, r, x.sin_ref()),
    )?;
    same(&format!("cos {x}"), bits, |p, m, c| a.cos(p, m, c), |p, r| with_round(p, r, x.cos_ref()))
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
    let quarters = (1u32..4000, 8u32..700, -4i32..4).prop_map(|(n, bits, ulps)| {
        let x = Float::with_val(bits + 64, Constant::Pi) * n / 2u32;
        let mut x = Float::with_val(bits, x);
        for _ in 0..ulps.abs() {
            if ulps < 0 { x.next_down() } else { x.next_up() }
        }
        x
    });
    prop_oneof![number(-4..4), number(-700..-4), number(4..200), quarters]
}

fn bits() -> impl Strategy<Value = u32> {
    (1u32..9).prop_map(|words| 64 * words)
}

proptest! {
    #![proptest_config(config(20_000))]

    #[test]
    fn arithmetic_is_rounded_as_by_mpfr((x, y) in pair(), bits in bits()) {
        arithmetic(&x, &y, bits)?;
    }

    #[test]
    fn squares_have_their_roots(x in number(-20..20), bits in bits(), ulps in -2i32..=2) {
        let mut square = Float::with_val(2 * x.prec() + 2, x.square_ref());
        for _ in 0..ulps.abs() {
            if ulps < 0 { square.next_down() } else { square.next_up() }
        }
        let square = square.abs();
        let a = to_astro(&square);
        same("sqrt", bits, |p, m, _| a.sqrt(p, m), |p, r| with_round(p, r, square.sqrt_ref()))?;
    }
}

proptest! {
    #![proptest_config(config(8_000))]

    #[test]
    fn sine_and_cosine_are_rounded_as_by_mpfr(x in angle(), bits in bits()) {
        functions(&x, bits)?;
    }
}

#[test]
fn pi_is_rounded_as_by_mpfr() {
    for bits in (64..6400).step_by(64) {
        same("pi", bits, |p, m, c| c.pi(p, m), |p, r| with_round(p, r, Constant::Pi)).unwrap();
    }
}

#[test]
fn a_wrong_bit_is_seen() {
    let x = Float::with_val(64, 1.5);
    let a = to_astro(&x);
    assert_eq!(to_mpfr(&a), Some(x.clone()));
    let wrong = same(
        "sin",
        128,
        |p, m, c| a.sin(p, m, c),
        |p, r| {
            let mut y = with_round(p, r, x.sin_ref());
            y.next_up();
            y
        },
    );
    assert!(wrong.is_err());
}
