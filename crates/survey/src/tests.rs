//! Random surveys, and random arches inside them.

use super::{EndValue, QuantityRange, SurveyAnswer, SurveyVerdict, survey};
use crate::arch::SelfWeight;
use crate::certify::state::{Answer, Balls, Certify};
use crate::number::{ExactNumber, test_config::config};
use crate::problem::measures::{Circle, Length, Measures, of_span_and_rise};
use crate::problem::survey::{Shape, Survey};
use crate::problem::{Arch, Friction, Quantity};
use proptest::prelude::*;
use rug::Rational;

const DIGITS: usize = 8;

/// Decimal of six places.
fn text(x: f64) -> String {
    format!("{x:.6}")
}

fn number(x: f64) -> ExactNumber {
    text(x).parse().unwrap()
}

fn length(x: f64) -> Length {
    format!("{x:.6}m").parse().unwrap()
}

fn friction(x: f64) -> Friction {
    text(x).parse().unwrap()
}

/// Ends at a relative half width about a value.
fn about(x: f64, by: f64) -> [f64; 2] {
    [x * (1.0 - by), x * (1.0 + by)]
}

fn within(of: [f64; 2], part: f64) -> f64 {
    of[0] + (of[1] - of[0]) * part
}

fn range(found: &SurveyAnswer, of: Quantity) -> Option<&QuantityRange> {
    found.ranges.iter().find(|range| range.of == of)
}

/// Checks a value against a range: a figure, or that nothing is enough.
fn lies_in(range: &QuantityRange, value: Option<&Rational>) -> bool {
    let safety = matches!(range.of, Quantity::GeometricSafety | Quantity::FrictionSafety);
    let bound = |end: &EndValue| match end {
        EndValue::Number(decimal) => Some(decimal.to_rational()),
        EndValue::NotEnough | EndValue::AnyIsEnough | EndValue::Unbounded => None,
    };
    let (lower, upper) = (bound(&range.lower.value), bound(&range.upper.value));
    let Some(value) = value else {
        let worst = if safety { &range.lower } else { &range.upper };
        return worst.value == EndValue::NotEnough;
    };
    lower.is_none_or(|lower| lower <= *value) && upper.is_none_or(|upper| *value <= upper)
}

/// Checks that an arch contradicts nothing that is said of all.
fn agrees(found: &SurveyAnswer, arch: &Arch, eta: &ExactNumber) -> Result<(), TestCaseError> {
    let own = arch.certify_thickness(eta, 12).unwrap();
    if let (Some(Ok(verdict)), Ok(stands)) = (&found.verdict, &own.stands) {
        let contradicts = match verdict {
            SurveyVerdict::AllStand => !stands,
            SurveyVerdict::NoneStands => *stands,
            SurveyVerdict::BothOccur => false,
        };
        prop_assert!(!contradicts, "{arch} {eta}: {verdict:?}");
    }
    for (of, value) in [
        (Quantity::LeastThickness, &own.least_thickness),
        (Quantity::GeometricSafety, &own.geometric_safety),
        (Quantity::RequiredFriction, &own.required_friction),
    ] {
        let (Some(range), Ok(value)) = (range(found, of), value) else { continue };
        let value = value.as_ref().map(|figure| figure.decimal.value.to_rational());
        prop_assert!(lies_in(range, value.as_ref()), "{arch} {eta}: {value:?} not in {range:?}");
    }
    if let [Some(least), Some(largest)] = own.limits() {
        for (of, limit) in [(Quantity::LeastThrust, least), (Quantity::LargestThrust, largest)] {
            let (Some(range), Some(thrust)) = (range(found, of), &limit.thrust) else { continue };
            let value = thrust.decimal.value.to_rational();
            prop_assert!(lies_in(range, Some(&value)), "{arch} {eta}: {value} not in {range:?}");
        }
    }
    if let Ok(Answer::Stands(state)) = Balls::DoubleDoubles.state(arch, 8, false) {
        let thrust = state.thrust.decimal.value.to_rational();
        let range = range(found, Quantity::Thrust);
        let is_in = range.is_none_or(|range| lies_in(range, Some(&thrust)));
        prop_assert!(is_in, "{arch}: thrust {thrust} not in {range:?}");
        let modes = found.modes.as_ref().unwrap();
        let is_known = modes.occur.contains(&state.mode) || modes.may_occur.contains(&state.mode);
        prop_assert!(is_known, "{arch}: {} not in {modes:?}", state.mode);
    }
    Ok(())
}

/// Ends that are said to be attained are values of the arches that are named.
fn ends_are_attained(found: &SurveyAnswer) -> Result<(), TestCaseError> {
    for range in &found.ranges {
        for (end, up) in [(&range.lower, false), (&range.upper, true)] {
            let (Some(at), EndValue::Number(bound)) = (&end.at, &end.value) else { continue };
            let Some(eta) = &at.thickness else { continue };
            let own = at.arch.certify_thickness(eta, DIGITS).unwrap();
            let Some(value) = own.get(range.of) else { continue };
            let rounded = if up { &value.decimal.upper } else { &value.decimal.lower };
            prop_assert_eq!(rounded.to_rational(), bound.to_rational(), "{:?} at {:?}", range, at);
        }
    }
    Ok(())
}

fn weight() -> impl Strategy<Value = SelfWeight> {
    prop::sample::select(SelfWeight::ALL.to_vec())
}

/// Arches of measures say what their survey says.
fn measured_ones_agree(
    weight: SelfWeight,
    circle: Circle,
    [span, rise, mu, t]: [f64; 4],
    [by_span, by_rise, by_mu, by_t]: [f64; 4],
    parts: &[(f64, f64, f64, f64)],
) -> Result<(), TestCaseError> {
    let (spans, rises) = (about(span, by_span), about(rise, by_rise));
    let (mus, ts) = (about(mu, by_mu), about(t, by_t));
    let shape = Shape::Spanned {
        circle,
        span: spans.map(length),
        rise: rises.map(length),
        thickness: ts.map(length),
    };
    let found = survey(&Survey::new(weight, mus.map(friction), shape).unwrap(), DIGITS).unwrap();
    prop_assert!(!matches!(found.verdict, Some(Err(_))), "{:?}", found.verdict);
    for &(a, b, c, d) in parts {
        let (alpha, radius) =
            of_span_and_rise(&length(within(spans, a)), &length(within(rises, b)));
        let eta = Measures::new(circle, radius, None).thickness(&length(within(ts, d)));
        let arch = Arch::new(weight, alpha, friction(within(mus, c))).unwrap();
        agrees(&found, &arch, &eta.unwrap())?;
    }
    ends_are_attained(&found)
}

/// A failure once: all arches are one.
#[test]
fn a_survey_of_one_flat_arch_agrees_with_it() {
    let one = [10.0, 0.5, 0.1, 0.1];
    let parts = [(0.0, 0.0, 0.0, 0.0)];
    measured_ones_agree(SelfWeight::Heyman, Circle::Intrados, one, [0.0; 4], &parts).unwrap();
}

proptest! {
    #![proptest_config(config(120))]

    #[test]
    fn no_arch_of_a_survey_contradicts_it(
        weight in weight(),
        (alpha, mu, eta) in (0.2..2.7, 0.05..2.5, 0.01..1.5),
        (by_alpha, by_mu, by_eta) in (0.0..0.05, 0.0..0.05, 0.0..0.05),
        parts in prop::collection::vec((0.0..1.0, 0.0..1.0, 0.0..1.0), 12),
    ) {
        let (alphas, mus, etas) = (about(alpha, by_alpha), about(mu, by_mu), about(eta, by_eta));
        let shape = Shape::Free {
            half_opening: alphas.map(number),
            thickness: Some(etas.map(number)),
        };
        let found = survey(&Survey::new(weight, mus.map(friction), shape).unwrap(), DIGITS).unwrap();
        for &(a, b, c) in &parts {
            let arch = Arch::new(weight, number(within(alphas, a)), friction(within(mus, b)));
            agrees(&found, &arch.unwrap(), &number(within(etas, c)))?;
        }
        ends_are_attained(&found)?;
        // The same arches with their least thicknesses.
        let shape = Shape::Free { half_opening: alphas.map(number), thickness: None };
        let found = survey(&Survey::new(weight, mus.map(friction), shape).unwrap(), DIGITS).unwrap();
        for (a, b, c) in parts {
            let arch = Arch::new(weight, number(within(alphas, a)), friction(within(mus, b)));
            agrees(&found, &arch.unwrap(), &number(within(etas, c)))?;
        }
    }

    #[test]
    fn no_arch_of_measured_ones_contradicts_their_survey(
        weight in weight(),
        circle in prop::sample::select(Circle::ALL.to_vec()),
        (slope, mu, t) in (0.1..1.6, 0.1..1.5, 0.1..0.8),
        (by_span, by_rise, by_mu, by_t) in (0.0..0.05, 0.0..0.05, 0.0..0.05, 0.0..0.05),
        parts in prop::collection::vec((0.0..1.0, 0.0..1.0, 0.0..1.0, 0.0..1.0), 12),
    ) {
        measured_ones_agree(weight, circle, [10.0, 5.0 * slope, mu, t], [by_span, by_rise, by_mu, by_t], &parts)?;
    }
}

/// At a friction of 0.11 the wider of two flat arches is the safer one, and a longer span does not make it fall.
#[test]
fn the_worst_arch_need_not_have_the_longest_span() {
    let shape = Shape::Spanned {
        circle: Circle::Intrados,
        span: [length(9.0), length(11.0)],
        rise: [length(1.0), length(1.0)],
        thickness: [length(0.4), length(0.4)],
    };
    let arches = Survey::new(SelfWeight::Heyman, [friction(0.11), friction(0.11)], shape);
    let found = survey(&arches.unwrap(), 6).unwrap();
    let [span, ..] = found.worst.measured.unwrap();
    assert!(span.metres() < length(11.0).metres(), "{span}");
}

/// Where all arches rotate, the ends of the thrust are those of two arches; with another mode they enclose.
#[test]
fn the_thrust_of_arches_that_rotate_has_its_ends() {
    let ends = |mu: f64| {
        let shape = Shape::Free { half_opening: [number(1.2), number(1.5)], thickness: None };
        let arches = Survey::new(SelfWeight::Milankovitch, [friction(mu), friction(0.8)], shape);
        let found = survey(&arches.unwrap(), 6).unwrap();
        let of = range(&found, Quantity::Thrust).unwrap().clone();
        let is_at = |at: Option<_>, arch| at == Some(arch);
        [is_at(of.lower.at, found.worst), is_at(of.upper.at, found.best)]
    };
    assert_eq!((ends(0.4), ends(0.3)), ([true; 2], [false; 2]));
}
