//! Hard arguments for property tests.

use couplet::arch::SelfWeight;
pub(crate) use couplet::number::test_config::{config, fixed};
use proptest::prelude::*;
use rug::Rational;

/// Rationals that uniform ranges never hit: neighbours of simple fractions, and any size.
pub(crate) fn hard_rational() -> impl Strategy<Value = Rational> {
    let simple = (-20i64..20, 1i64..12).prop_map(Rational::from);
    let hair = (any::<bool>(), 1u32..90).prop_map(|(up, shift)| {
        let hair = Rational::from((1, 1)) >> shift;
        if up { hair } else { -hair }
    });
    let any_size = (any::<i64>(), -80i32..20).prop_map(|(m, e)| Rational::from(m) << e);
    prop_oneof![simple.clone(), (simple, hair).prop_map(|(x, hair)| x + hair), any_size,]
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

pub(crate) fn weights() -> impl Strategy<Value = SelfWeight> {
    prop_oneof![Just(SelfWeight::Heyman), Just(SelfWeight::Milankovitch)]
}
