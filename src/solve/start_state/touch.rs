//! Where the line of thrust touches the intrados with the shoulder on its extrados.

use super::LEAST_JOINT;
use super::slide::zero;
use crate::arch::SelfWeight;

/// A start with a sliding inner joint: the thickness, and the rotational joint unless it is the crown.
pub struct InnerStart {
    /// `eta`.
    pub thickness: f64,
    /// `beta_r`, or `None` if the intrados is touched at the crown.
    pub joint: Option<f64>,
}

/// A candidate: the thickness at a half opening (rad) and a thrust that the sliding of an inner joint fixes.
pub fn rotational_sliding(weight: SelfWeight, alpha: f64, h: f64) -> InnerStart {
    let delta = f64::from(weight.flag());
    let (sin, cos) = alpha.sin_cos();
    let normal = h * cos + alpha * sin;
    let drop = 1.0 - cos;
    let fac = |eta: f64| 1.0 + delta * eta * eta / 12.0;
    // At the crown: (3) with beta = 0 is a quadratic in eta.
    let (a, b, c) = (delta * drop / 12.0, 0.5 * (normal + h), drop - normal + h);
    let crown = 2.0 * c / (b + (b * b - 4.0 * a * c).max(0.0).sqrt());
    let cotangent = |eta: f64| h - 1.0 + 2.0 * fac(eta) / (2.0 - eta);
    if crown >= 2.0 || cotangent(crown) >= 1.0 {
        return InnerStart { thickness: crown, joint: None };
    }
    // The gap and its slope: the touching joint is where the gap is least, so that its own change
    // with the thickness does not count.
    let gap = |eta: f64| {
        let beta = inverse_times_cotangent(cotangent(eta));
        let (touching, fall) = (h * beta.cos() + beta * beta.sin(), 1.0 - beta.cos());
        let value = (1.0 + 0.5 * eta) * normal - fac(eta) * drop - (1.0 - 0.5 * eta) * touching
            + fac(eta) * fall;
        (value, 0.5 * (normal + touching) + delta * eta / 6.0 * (fall - drop))
    };
    let low = crown.max(0.0);
    let eta = zero(low, 2.0, low + 1e-3, gap);
    let joint = inverse_times_cotangent(cotangent(eta)).max(LEAST_JOINT);
    InnerStart { thickness: eta, joint: Some(joint) }
}

/// `beta_r`, `h` of the largest thrust that a thickness bears with the line of thrust touching the
/// intrados below the crown.
///
/// The gap between the moments about the shoulder's extrados and about the touching joint is concave in
/// the thrust: its larger zero is right of its maximum.
pub fn largest_thrust(weight: SelfWeight, alpha: f64, eta: f64) -> [f64; 2] {
    let fac = 1.0 + f64::from(weight.flag()) * eta * eta / 12.0;
    let (sin, cos) = alpha.sin_cos();
    let joint = |h: f64| inverse_times_cotangent(h - 1.0 + 2.0 * fac / (2.0 - eta));
    let gap = |h: f64| {
        let beta = joint(h);
        let touching =
            (1.0 - 0.5 * eta) * (h * beta.cos() + beta * beta.sin()) - fac * (1.0 - beta.cos());
        (1.0 + 0.5 * eta) * (h * cos + alpha * sin) - fac * (1.0 - cos) - touching
    };
    // From this thrust on the crown is touched.
    let crown = 2.0 - 2.0 * fac / (2.0 - eta);
    let (mut low, mut high) = (0.0, crown.max(0.0));
    for _ in 0..80 {
        let third = (high - low) / 3.0;
        if gap(low + third) < gap(high - third) { low += third } else { high -= third }
    }
    high = crown.max(low);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if gap(middle) > 0.0 { low = middle } else { high = middle }
    }
    [joint(low).max(LEAST_JOINT), low.max(LEAST_JOINT)]
}

/// The angle whose product with its cotangent is `k`; zero from `k = 1` on.
fn inverse_times_cotangent(k: f64) -> f64 {
    if k >= 1.0 {
        return 0.0;
    }
    // k(beta) falls and is concave: Newton's method comes from the right after one step. The start has
    // the right behaviour at both ends of the range.
    let gap = 1.0 - k;
    let pi = std::f64::consts::PI;
    let mut beta = pi * (gap / (gap + pi * pi / 3.0)).sqrt();
    for _ in 0..30 {
        let (sin, cos) = beta.sin_cos();
        let step = (beta * cos - k * sin) * sin / (beta - sin * cos);
        let next = (beta + step).clamp(0.5 * beta, 0.5 * (beta + pi));
        let done = (next - beta).abs() < 1e-14 * beta;
        beta = next;
        if done {
            break;
        }
    }
    beta
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_undoes_the_cotangent() {
        for beta in [1e-5, 0.1, 1.0, 1.5, 2.0, 3.0, 3.125] {
            let k = beta * f64::cos(beta) / f64::sin(beta);
            // Near zero k is nearly one, and a double of it knows only half the digits of beta.
            approx::assert_relative_eq!(inverse_times_cotangent(k), beta, max_relative = 1e-5);
        }
        assert_eq!(inverse_times_cotangent(1.0), 0.0);
    }
}
