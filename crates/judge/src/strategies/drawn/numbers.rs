//! Self-weights, and half openings and frictions as exact numbers, from ordinary to absurd.

use crate::arch::SelfWeight;
use crate::number::ExactNumber;
use crate::problem::Friction;
use proptest::prelude::*;
use proptest::sample::select;
use std::f64::consts::{FRAC_PI_2, PI};

/// The smallest and the largest numbers are `1e±100`, about.
const POWERS: std::ops::RangeInclusive<u32> = 4..=100;
/// Places of the longest ordinary decimal.
const PLACES: std::ops::RangeInclusive<usize> = 1..=17;

/// Either self-weight model; shrinks to Heyman's.
pub fn weight() -> impl Strategy<Value = SelfWeight> + Clone {
    select(&SelfWeight::ALL)
}

/// An exact half opening in `(0, pi)`, in radians: ordinary ones, to which others shrink, decimals, parts of `pi`
/// (`5pi/12`), tiny ones (`3e-60`), and next to half a turn (`0.9999pi`).
pub fn half_opening() -> impl Strategy<Value = ExactNumber> {
    prop_oneof![
        1 => select(&["1", "2", "0.5", "1.5", "2.5"]).prop_map(str::to_owned),
        6 => decimal(0.0, PI),
        1 => part_of_pi(12, 1),
        1 => (1u32..=999, POWERS).prop_map(|(m, k)| format!("{m}e-{k}")),
        1 => (1usize..=60).prop_map(|nines| format!("0.{}pi", "9".repeat(nines))),
    ]
    .prop_filter_map("is a number", |text| text.parse().ok())
}

/// Any friction: ordinary ones, to which others shrink, coefficients up to 5, none, tiny and huge ones, unlimited, and
/// friction angles in `[0, pi/2)`, in radians.
pub fn friction() -> impl Strategy<Value = Friction> {
    let coefficient = prop_oneof![
        6 => decimal(0.0, 5.0),
        1 => Just("0".to_owned()),
        1 => (1u32..=999, POWERS).prop_map(|(m, k)| format!("{m}e-{k}")),
        1 => (1u32..=999, POWERS).prop_map(|(m, k)| format!("{m}e{k}")),
    ];
    let angle = prop_oneof![decimal(0.0, FRAC_PI_2), part_of_pi(12, 2)];
    prop_oneof![
        1 => select(&["inf", "1", "0.5"]).prop_filter_map("is a number", |mu| mu.parse().ok()),
        8 => coefficient.prop_filter_map("is a number", |mu| Some(Friction::Coefficient(mu.parse().ok()?))),
        1 => angle.prop_filter_map("is a number", |phi| Some(Friction::Angle(phi.parse().ok()?))),
    ]
}

/// A decimal between two numbers, neither of them. Shrinks to fewer places, then towards the lower.
pub(super) fn decimal(low: f64, high: f64) -> impl Strategy<Value = String> + Clone {
    (PLACES, 0.0..1.0f64)
        .prop_map(move |(places, part)| format!("{:.places$}", low + part * (high - low)))
        .prop_filter("lies between", move |text| {
            text.parse::<f64>().is_ok_and(|x| x > low && x < high)
        })
}

/// `k pi/n` below `pi/divisor`.
fn part_of_pi(largest: u32, divisor: u32) -> impl Strategy<Value = String> {
    (2..=largest, 1..largest)
        .prop_filter("is below", move |(n, k)| k * divisor < *n)
        .prop_map(|(n, k)| format!("{k}pi/{n}"))
}
