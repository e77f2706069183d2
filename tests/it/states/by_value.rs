//! States by a value: each one is that of its half opening, and a scan of the half openings between finds no other.

use crate::arches::arch;
use crate::hard::{config, hair};
use couplet::arch::SelfWeight;
use couplet::certify::state::find::{StatesByValue, StatesOfValue};
use couplet::certify::state::{Answer, Certify, Digits};
use couplet::certify::{CertifiedLandmark, Error};
use couplet::number::ExactNumber;
use couplet::problem::{Landmark, Quantity};
use couplet::strategies::{friction, weight};
use proptest::prelude::*;
use rug::Rational;

/// Half openings of a scan.
const PLACES: u32 = 24;

fn state(weight: SelfWeight, alpha: &str, friction: &str, digits: usize) -> Option<Box<Digits>> {
    match arch(weight, alpha, friction).certify_alone(digits) {
        Ok(Answer::Stands(state)) => Some(state),
        _ => None,
    }
}

fn value(state: &Digits, quantity: Quantity) -> Option<Rational> {
    let (_, figure) = state.figures().find(|(of, _)| *of == quantity)?;
    Some(figure?.decimal.value.to_rational())
}

/// The states that are found, and those of the half openings between, tell the same.
fn is_complete(found: &StatesOfValue, asked: (SelfWeight, Quantity, &Rational, &str)) {
    let (weight, quantity, given, friction) = asked;
    assert!(found.first_open().is_none(), "{asked:?}: {found:?}");
    assert_eq!(found.none.is_some(), found.states.is_empty(), "{asked:?}");
    let mut openings = Vec::new();
    for state_of in &found.states {
        let state_of = state_of.as_ref().unwrap();
        let alpha = state_of.value(Quantity::HalfOpening);
        let own =
            state(weight, &alpha, friction, 12).unwrap_or_else(|| panic!("{asked:?} {alpha}"));
        assert_eq!(own.mode, state_of.mode, "{asked:?} {alpha}");
        if let Some(own) = value(&own, quantity) {
            let part = Rational::from(&own - given) / given;
            assert!(part.abs() < Rational::from((1, 1_000_000)), "{asked:?} {alpha}");
        }
        openings.push(alpha.parse::<f64>().unwrap());
    }
    let limit = if weight == SelfWeight::Heyman { 2.786498 } else { 2.648388 };
    let places = (1..PLACES).map(|k| limit * f64::from(k) / f64::from(PLACES));
    let scanned = places.filter_map(|alpha| {
        let of = state(weight, &format!("{alpha:.17}"), friction, 6)?;
        Some((alpha, value(&of, quantity)? > *given))
    });
    let scanned: Vec<(f64, bool)> = scanned.collect();
    for pair in scanned.windows(2).filter(|pair| pair[0].1 != pair[1].1) {
        let between = openings.iter().filter(|x| (pair[0].0..=pair[1].0).contains(*x)).count();
        assert!(between > 0, "{asked:?}: none is found between {:?}", (pair[0].0, pair[1].0));
    }
}

fn found(
    weight: SelfWeight,
    quantity: Quantity,
    given: &Rational,
    friction: &str,
) -> Option<StatesOfValue> {
    let asked =
        StatesByValue::new((quantity, ExactNumber::from(given)), friction.parse().unwrap()).ok()?;
    // Next to an end a value has a high power of the distance from it, in whose digits the half opening ends.
    let small = given.denom().significant_bits().saturating_sub(given.numer().significant_bits());
    match asked.find(weight, 120 + small as usize) {
        Ok(found) => Some(found),
        Err(Error::Undecided(open)) => panic!("{weight:?} {quantity:?} {given} {friction}: {open}"),
        Err(_) => None,
    }
}

/// A value of ordinary size; or that of a state, to few digits or many, which lies next to those of its neighbours; or
/// one beside an end of the curve.
fn values() -> impl Strategy<Value = (Quantity, Rational)> {
    let quantity = prop::sample::select(&StatesByValue::GIVEN);
    let part = (1i64..1_000_000).prop_map(|n| Rational::from((n, 1_000_000)));
    let tiny = (1i64..1000, 3u32..100).prop_map(|(n, shift)| Rational::from(n) >> shift);
    let landmark =
        prop::sample::select(&[Landmark::RotationEnd, Landmark::OverturningEnd, Landmark::Triple]);
    let ends = (quantity.clone(), weight(), landmark, hair(4..120));
    let ends = ends.prop_filter_map("has one", |(quantity, weight, landmark, hair)| {
        let point = CertifiedLandmark::new(landmark, weight).unwrap();
        let at = point.constant(quantity, 40).ok()?.to_string().parse::<ExactNumber>().ok()?;
        Some((quantity, at.to_rational() + &hair))
    });
    prop_oneof![
        (quantity.clone(), part).prop_map(|(quantity, part)| {
            let most = if quantity == Quantity::Thrust { 1 } else { 2 };
            (quantity, part * most)
        }),
        (quantity, tiny),
        ends,
    ]
}

proptest! {
    #![proptest_config(config(60))]

    #[test]
    fn the_states_with_a_value_are_all_of_them(
        weight in weight(), (quantity, given) in values(), friction in friction(),
    ) {
        let friction = friction.to_string();
        if let Some(found) = found(weight, quantity, &given, &friction) {
            is_complete(&found, (weight, quantity, &given, &friction));
        }
    }
}

/// `cargo test --release --features proptest --test it by_value:: -- --ignored`
#[test]
#[ignore = "long: a hundred thousand values"]
fn a_hundred_thousand_values_have_all_their_states() {
    let mut runner = proptest::test_runner::TestRunner::new(config(100_000));
    let asked = (weight(), values(), friction());
    runner
        .run(&asked, |(weight, (quantity, given), friction)| {
            let friction = friction.to_string();
            if let Some(found) = found(weight, quantity, &given, &friction) {
                is_complete(&found, (weight, quantity, &given, &friction));
            }
            Ok(())
        })
        .unwrap();
}
