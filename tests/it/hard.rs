//! Hard arguments for property tests.

use couplet::arch::SelfWeight;
pub(crate) use couplet::number::test_config::{config, fixed};
use proptest::prelude::*;
use rug::float::Constant;
use rug::{Float, Rational};
use std::ops::Range;

/// Rationals that uniform ranges never hit: neighbours of simple fractions, and any size.
pub(crate) fn hard_rational() -> impl Strategy<Value = Rational> {
    let simple = (-20i64..20, 1i64..12).prop_map(Rational::from);
    let any_size = (any::<i64>(), -80i32..20).prop_map(|(m, e)| Rational::from(m) << e);
    prop_oneof![simple.clone(), (simple, hair(1..90)).prop_map(|(x, hair)| x + hair), any_size]
}

/// A power of one half, of either sign.
pub(crate) fn hair(powers: Range<u32>) -> impl Strategy<Value = Rational> {
    (any::<bool>(), powers).prop_map(|(up, power)| {
        let hair = Rational::from((1, 1)) >> power;
        if up { hair } else { -hair }
    })
}

/// A positive rational of ordinary size, next to a simple fraction or not.
pub(crate) fn positive_rational() -> impl Strategy<Value = Rational> {
    hard_rational().prop_filter_map("positive and of ordinary size", |x| {
        let x = x.abs();
        (x > Rational::from((1, 1_000_000)) && x < 1_000_000).then_some(x)
    })
}

/// A point of the unit circle with rational coordinates, from half its tangent.
pub(crate) fn circle_point() -> impl Strategy<Value = (Rational, Rational)> {
    positive_rational().prop_map(|t| {
        let square = Rational::from(t.square_ref());
        let norm = Rational::from(1) + &square;
        (t * 2 / &norm, (Rational::from(1) - square) / norm)
    })
}

/// Millionths of one, from `low` to below `high` of them.
pub(crate) fn millionths(low: i64, high: i64) -> impl Strategy<Value = Rational> {
    (low..high).prop_map(|n| Rational::from((n, 1_000_000)))
}

/// Numbers from 0 to 1, always the same of one seed.
pub(crate) fn random(mut seed: u64) -> impl FnMut() -> f64 {
    move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A number some units in its last place away.
pub(crate) fn moved(mut x: Float, units: i32) -> Float {
    for _ in 0..units.abs() {
        if units < 0 { x.next_down() } else { x.next_up() }
    }
    x
}

/// Up to so many quarter turns to some bits, and some units beside.
pub(crate) fn quarter_turns(most: u32, bits: Range<u32>) -> impl Strategy<Value = Float> {
    (1..most, bits, -4i32..=4).prop_map(|(n, bits, units)| {
        let x = Float::with_val(bits + 64, Constant::Pi) * n / 2u32;
        moved(Float::with_val(bits, x), units)
    })
}

pub(crate) fn weights() -> impl Strategy<Value = SelfWeight> {
    prop_oneof![Just(SelfWeight::Heyman), Just(SelfWeight::Milankovitch)]
}
