//! The static programme of the half arch on finitely many joints, in doubles: an independent route.
//!
//! The admissible states are a linear programme in two unknowns, the thrust and the crown moment; it is
//! written here for itself, with nothing of the equations (2)–(18) but the statics. It asks less than the
//! whole half arch does, so that its least thickness is a lower bound.

use crate::arch::SelfWeight;

/// The range of thrusts that friction allows at all joints.
fn thrusts(alpha: f64, mu: f64, joints: usize) -> Option<(f64, f64)> {
    let (mut low, mut high) = (0.0f64, 1e3f64);
    for i in 0..=joints {
        let beta = alpha * i as f64 / joints as f64;
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

/// The margin between the lowest upper and the highest lower bound of the crown moment, by the thrust: a concave
/// function.
fn margins(weight: SelfWeight, alpha: f64, eta: f64, joints: usize) -> impl Fn(f64) -> f64 {
    let fac = 1.0 + f64::from(weight.flag()) * eta * eta / 12.0;
    let joint = |i: usize| alpha * i as f64 / joints as f64;
    // Each bound is a line a + b h.
    let (mut upper, mut lower) = (Vec::new(), Vec::new());
    for beta in (0..=joints).map(joint) {
        let (normal, moment) = ((beta * beta.sin(), beta.cos()), fac * (1.0 - beta.cos()));
        let bound = |radius: f64| (radius * normal.0 - moment, radius * normal.1);
        upper.push(bound(1.0 + eta / 2.0));
        lower.push(bound(1.0 - eta / 2.0));
    }
    move |h| {
        let at = |(a, b): &(f64, f64)| a + b * h;
        let top = upper.iter().map(at).fold(f64::INFINITY, f64::min);
        top - lower.iter().map(at).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// The largest margin, by golden section.
fn margin(weight: SelfWeight, alpha: f64, eta: f64, (low, high): (f64, f64), joints: usize) -> f64 {
    let value = margins(weight, alpha, eta, joints);
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

/// The last number found, from `inside` towards `outside`, at which something holds.
fn bisected(steps: usize, mut inside: f64, mut outside: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..steps {
        let middle = 0.5 * (inside + outside);
        if holds(middle) { inside = middle } else { outside = middle }
    }
    inside
}

/// The admissible thrusts of a given thickness `eta`, half opening `alpha` (rad) and friction `mu`: where
/// the margin is not negative at each of `joints` equidistant joints and the crown. `None` if there are
/// none; good to about 1e-9 beside what the number of joints makes of it.
pub fn thrust_range(
    weight: SelfWeight,
    alpha: f64,
    mu: f64,
    eta: f64,
    joints: usize,
) -> Option<(f64, f64)> {
    let (low, high) = thrusts(alpha, mu, joints)?;
    let value = margins(weight, alpha, eta, joints);
    let (mut a, mut b) = (low, high);
    for _ in 0..100 {
        let third = (b - a) / 3.0;
        if value(a + third) < value(b - third) { a += third } else { b -= third }
    }
    if value(a) < 0.0 {
        return None;
    }
    let edge = |inside, outside| {
        if value(outside) >= 0.0 {
            outside
        } else {
            bisected(60, inside, outside, |h| value(h) >= 0.0)
        }
    };
    Some((edge(a, low), edge(a, high)))
}

/// The least thickness at which the programme on `joints` joints has a solution: a lower bound of that of
/// the whole half arch, up to the rounding of doubles. Infinite where friction allows no thrust.
pub fn least_thickness(weight: SelfWeight, alpha: f64, mu: f64, joints: usize) -> f64 {
    let Some(range) = thrusts(alpha, mu, joints) else { return f64::INFINITY };
    bisected(40, 0.0, 2.0, |eta| margin(weight, alpha, eta, range, joints) < 0.0)
}
