//! The states against the static programme of the half arch, solved on its own.
//!
//! On finitely many joints the admissible states are a linear programme in two unknowns, the thrust and the
//! crown moment; it is written here for itself, in doubles, with nothing of the equations (2)–(18) but the
//! statics. It asks less than the whole half arch does, so that its least thickness is a lower bound.

mod common;

use common::config;
use couplet::arch::SelfWeight;
use couplet::certify::state::{Answer, Arch, Friction, Outcome};
use couplet::number::ExactNumber;
use proptest::prelude::*;
use rug::Rational;

fn arch(weight: SelfWeight, alpha: &Rational, mu: &Rational) -> Arch {
    let friction = Friction::Coefficient(ExactNumber::rational(mu.clone()));
    Arch::new(weight, ExactNumber::rational(alpha.clone()), friction).unwrap()
}

fn rational(low: i64, high: i64) -> impl Strategy<Value = Rational> {
    (low..high).prop_map(|n| Rational::from((n, 1_000_000)))
}

fn weights() -> impl Strategy<Value = SelfWeight> {
    prop_oneof![Just(SelfWeight::Heyman), Just(SelfWeight::Milankovitch)]
}

proptest! {
    #![proptest_config(config(150))]

    /// The static programme is a lower bound of the least thickness, and a close one.
    #[test]
    fn the_static_programme_agrees_from_below(
        alpha in rational(300_000, 2_640_000), mu in rational(100_000, 5_000_000), weight in weights(),
    ) {
        let Ok(Outcome::Stands(state)) = arch(weight, &alpha, &mu).state(256) else { return Ok(()) };
        let eta = state.thickness.mid().to_f64();
        let discrete = least_thickness(weight, alpha.to_f64(), mu.to_f64());
        prop_assert!(discrete <= eta * (1.0 + 1e-9), "{discrete} above {eta}");
        prop_assert!(discrete >= eta * (1.0 - 2e-3) - 1e-9, "{discrete} far below {eta}");
    }
}

proptest! {
    #![proptest_config(config(120))]

    /// An arch of a given thickness: the range of thrusts agrees with the static programme, and
    /// standing with the least thickness.
    #[test]
    fn an_assessment_agrees_with_the_static_programme(
        alpha in rational(200_000, 2_640_000), mu in rational(50_000, 4_000_000),
        part in rational(600_000, 3_000_000), weight in weights(),
    ) {
        let asked = arch(weight, &alpha, &mu);
        let Ok(Answer::Stands(least)) = asked.certify(17) else { return Ok(()) };
        // A thickness around the least one, from thinner to much thicker.
        let eta = Rational::from_f64(least.thickness.double).unwrap() * part;
        if eta >= Rational::from((19, 10)) { return Ok(()) }
        let found = asked.certify_thickness(&ExactNumber::rational(eta.clone()), 12).unwrap();
        prop_assert_eq!(found.stands, eta.to_f64() > least.thickness.double);
        let discrete = thrust_range(weight, alpha.to_f64(), mu.to_f64(), eta.to_f64());
        let Some([low, high]) = &found.thrust else {
            prop_assert!(!found.stands);
            // Infeasible on all joints may be feasible on some: only close to the least thickness.
            prop_assert!(discrete.is_none() || eta.to_f64() > 0.99 * least.thickness.double);
            return Ok(());
        };
        let (a, b) = discrete.expect("what stands on all joints stands on some");
        let close = |x: f64, y: f64| (x - y).abs() < 2e-3 * (1.0 + y.abs());
        let low = low.thrust.as_ref().unwrap().double;
        prop_assert!(close(a, low) && a <= low + 1e-9, "least thrust {a} and {low}");
        match &high.thrust {
            Some(high) => prop_assert!(close(b.min(999.0), high.double.min(999.0)), "largest thrust {b} and {}", high.double),
            None => prop_assert!(b > 999.0),
        }
        let safety = found.geometric_safety.unwrap().double;
        approx::assert_relative_eq!(safety, eta.to_f64() / least.thickness.double, max_relative = 1e-9);
        // With the required friction and a little more it stands, with a little less it does not.
        let required = found.required_friction.unwrap().decimal.value.to_rational();
        let with = |factor: (i32, i32)| {
            let mu = Rational::from(factor) * &required;
            arch(weight, &alpha, &mu).certify_thickness(&ExactNumber::rational(eta.clone()), 6).unwrap().stands
        };
        prop_assert!(with((1_000_001, 1_000_000)) && !with((999_999, 1_000_000)));
    }
}

/// Joints at which the conditions are asked for.
const JOINTS: usize = 1500;

/// `a + b h` as a line.
type Line = (f64, f64);

fn lines(weight: SelfWeight, alpha: f64, eta: f64) -> (Vec<Line>, Vec<Line>) {
    let fac = 1.0 + f64::from(weight.flag()) * eta * eta / 12.0;
    let joint = |i: usize| alpha * i as f64 / JOINTS as f64;
    let (mut upper, mut lower) = (Vec::new(), Vec::new());
    for beta in (0..=JOINTS).map(joint) {
        let (normal, moment) = ((beta * beta.sin(), beta.cos()), fac * (1.0 - beta.cos()));
        let bound = |radius: f64| (radius * normal.0 - moment, radius * normal.1);
        upper.push(bound(1.0 + eta / 2.0));
        lower.push(bound(1.0 - eta / 2.0));
    }
    (upper, lower)
}

/// The range of thrusts that friction allows at all joints.
fn thrusts(alpha: f64, mu: f64) -> Option<(f64, f64)> {
    let (mut low, mut high) = (0.0f64, 1e3f64);
    for i in 0..=JOINTS {
        let beta = alpha * i as f64 / JOINTS as f64;
        let (sin, cos) = beta.sin_cos();
        // mu N - T >= 0 and mu N + T >= 0, each a + b h >= 0; and N >= 0.
        for (a, b) in [
            (mu * beta * sin - beta * cos, mu * cos + sin),
            (mu * beta * sin + beta * cos, mu * cos - sin),
            (beta * sin, cos),
        ] {
            if b > 0.0 {
                low = low.max(-a / b)
            } else if b < 0.0 {
                high = high.min(-a / b)
            }
        }
    }
    (low <= high).then_some((low, high))
}

/// The largest margin between the lowest upper and the highest lower bound of the crown moment:
/// a concave function of the thrust, maximised by golden section.
fn margin(weight: SelfWeight, alpha: f64, eta: f64, (low, high): (f64, f64)) -> f64 {
    let (upper, lower) = lines(weight, alpha, eta);
    let value = |h: f64| {
        let at = |(a, b): &Line| a + b * h;
        let top = upper.iter().map(at).fold(f64::INFINITY, f64::min);
        let bottom = lower.iter().map(at).fold(f64::NEG_INFINITY, f64::max);
        top - bottom
    };
    let ratio = 0.618_033_988_749_894_9;
    let (mut a, mut b) = (low, high);
    let (mut x, mut y) = (b - ratio * (b - a), a + ratio * (b - a));
    let (mut fx, mut fy) = (value(x), value(y));
    for _ in 0..60 {
        if fx > fy {
            (b, y, fy) = (y, x, fx);
            x = b - ratio * (b - a);
            fx = value(x);
        } else {
            (a, x, fx) = (x, y, fy);
            y = a + ratio * (b - a);
            fy = value(y);
        }
    }
    fx.max(fy).max(value(low)).max(value(high))
}

/// The admissible thrusts of a given thickness: where the margin is not negative.
fn thrust_range(weight: SelfWeight, alpha: f64, mu: f64, eta: f64) -> Option<(f64, f64)> {
    let (low, high) = thrusts(alpha, mu)?;
    let (upper, lower) = lines(weight, alpha, eta);
    let at = |(a, b): &Line, h: f64| a + b * h;
    let value = |h: f64| {
        let top = upper.iter().map(|line| at(line, h)).fold(f64::INFINITY, f64::min);
        top - lower.iter().map(|line| at(line, h)).fold(f64::NEG_INFINITY, f64::max)
    };
    let (mut a, mut b) = (low, high);
    for _ in 0..100 {
        let third = (b - a) / 3.0;
        if value(a + third) < value(b - third) { a += third } else { b -= third }
    }
    if value(a) < 0.0 {
        return None;
    }
    let edge = |mut inside: f64, mut outside: f64| {
        if value(outside) >= 0.0 {
            return outside;
        }
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            if value(middle) >= 0.0 { inside = middle } else { outside = middle }
        }
        inside
    };
    Some((edge(a, low), edge(a, high)))
}

fn least_thickness(weight: SelfWeight, alpha: f64, mu: f64) -> f64 {
    let Some(range) = thrusts(alpha, mu) else { return f64::INFINITY };
    let (mut low, mut high) = (0.0, 2.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if margin(weight, alpha, middle, range) < 0.0 { low = middle } else { high = middle }
    }
    low
}
