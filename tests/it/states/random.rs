//! Many queries without a choice.

use super::BOTH;
use crate::arches::{H, arch, rational_arch};
use crate::hard::{config, millionths, random, weights};
use couplet::arch::SelfWeight;
use couplet::certify::state::{Answer, Certify, Fall, Outcome, State};
use couplet::number::Enclosure;
use couplet::problem::Mode;
use proptest::prelude::*;
use rug::Rational;

fn state(weight: SelfWeight, alpha: &Rational, mu: &Rational) -> Option<Box<State>> {
    let arch = rational_arch(weight, alpha, mu);
    for bits in [128, 256, 1024] {
        match arch.state(bits) {
            Ok(Outcome::Stands(state)) => return Some(state),
            Ok(Outcome::Falls(_)) => return None,
            Err(_) => {}
        }
    }
    panic!("undecided at {alpha} {mu}")
}

proptest! {
    #![proptest_config(config(150))]

    /// The least thickness falls when friction rises, and never falls when the opening grows.
    #[test]
    fn the_least_thickness_is_monotone(
        alpha in millionths(50_000, 2_640_000), wider in millionths(1_000, 200_000),
        mu in millionths(100, 5_000_000), more in millionths(1_000, 500_000), weight in weights(),
    ) {
        let Some(first) = state(weight, &alpha, &mu) else { return Ok(()) };
        let rougher = state(weight, &alpha, &Rational::from(&mu + &more)).expect("friction only helps");
        prop_assert!(rougher.thickness.is_less_than(&first.thickness) == couplet::number::Ternary::True
            || rougher.thickness.overlaps(&first.thickness));
        if let Some(open) = state(weight, &Rational::from(&alpha + &wider), &mu) {
            prop_assert!(first.thickness.is_less_than(&open.thickness).is_proved());
        }
    }
}

/// A fixed sequence of random queries over `(0, alpha_L) x (0, 5)`: each ends proved.
fn random_queries(count: u64, weight: SelfWeight) -> [usize; 9] {
    let limit = if weight == H { 2.786498 } else { 2.648388 };
    let mut random = random(weight.flag() as u64);
    let mut met = [0; 9];
    for _ in 0..count {
        let (alpha, mu) = (format!("{:.17}", random() * limit), format!("{:.17}", random() * 5.0));
        let slot = match arch(weight, &alpha, &mu).certify(16) {
            Ok(Answer::Stands(state)) => Mode::ALL.iter().position(|m| *m == state.mode).unwrap(),
            Ok(Answer::Falls { fall: Fall::Sliding, .. }) => 7,
            Ok(Answer::Falls { fall: Fall::Thickness, .. }) => 8,
            Err(doubt) => panic!("{weight:?} {alpha} {mu}: {doubt:?}"),
        };
        met[slot] += 1;
    }
    met
}

/// The quick look in doubles is near the proved state almost everywhere; nothing relies on it.
#[test]
fn the_quick_look_is_close() {
    for weight in BOTH {
        for i in 0..400 {
            let (alpha, mu) = (0.3 + 0.0057 * f64::from(i), 0.05 + 0.0123 * f64::from(i * 7 % 400));
            let quick = couplet::solve::start::quick_state(weight, alpha, mu);
            match arch(weight, &format!("{alpha:.17}"), &format!("{mu:.17}")).certify(8) {
                Ok(Answer::Stands(state)) => {
                    assert_eq!(quick.mode, Some(state.mode), "{alpha} {mu}");
                    let (quick, proved) = (quick.thickness, state.thickness.double);
                    approx::assert_relative_eq!(quick, proved, max_relative = 1e-4);
                }
                _ => assert_eq!(quick.mode, None, "{alpha} {mu}"),
            }
        }
    }
}

#[test]
fn two_thousand_random_queries_are_proved() {
    for weight in BOTH {
        let met = random_queries(1000, weight);
        assert!(met[0] > 300 && met[7] > 50, "{met:?}");
    }
}

/// `cargo test --release --test it states:: -- --ignored`
#[test]
#[ignore = "long: a hundred thousand queries"]
fn a_hundred_thousand_random_queries_are_proved() {
    let met = BOTH.map(|weight| random_queries(50_000, weight));
    println!("by mode, then falls by sliding and by thickness: {met:?}");
}
