//! States of sliding alone: each the zero of one growing function.

use rug::Float;
use rug::float::Constant;

/// A candidate for a positive friction: the thrust and the sliding joint (rad) at which an inner joint just slides: `h = sin²θ` with
/// `θ + sin θ cos θ = acot(mu)`, which is (18) with `beta_s = sin θ cos θ`.
pub fn inner_sliding(friction: &Float) -> [Float; 2] {
    let bits = friction.prec();
    let target = Float::with_val(bits, friction.recip_ref()).atan();
    let theta = match target.to_f64() {
        moderate if moderate > 1e-3 => Float::with_val(bits, slope_angle(moderate)),
        _ => target / 2u32,
    };
    let (sin, cos) = theta.sin_cos(Float::new(bits));
    [Float::with_val(bits, sin.square_ref()), sin * cos]
}

/// `θ` with `θ + sin θ cos θ = target`.
pub(super) fn slope_angle(target: f64) -> f64 {
    let right = std::f64::consts::FRAC_PI_2;
    zero(0.0, right, 0.5 * target, |t| (t + t.sin() * t.cos() - target, 2.0 * t.cos().powi(2)))
}

/// A candidate: `mu`, `h`, `beta_s` (rad) of the purely sliding state at a half opening in `(0, pi)`, rad.
pub fn sliding(alpha: &Float) -> [Float; 3] {
    let bits = alpha.prec();
    let square = Float::with_val(bits, alpha.square_ref());
    if *alpha < 0.01 {
        // mu = alpha³/12, h = 1 - alpha²/4, beta_s = alpha/2: the leading terms.
        let mu = Float::with_val(bits, &square * alpha) / 12u32;
        return [mu, 1 - square / 4u32, Float::with_val(bits, alpha / 2u32)];
    }
    let pi = Float::with_val(bits, Constant::Pi);
    let near_pi = Float::with_val(bits, &pi - alpha).to_f64();
    sliding_at(alpha.to_f64(), near_pi).map(|x| Float::with_val(bits, x))
}

/// The same for `alpha` and `pi - alpha`, which are both needed to be accurate.
pub(super) fn sliding_at(alpha: f64, rest: f64) -> [f64; 3] {
    // In θ, h = sin²θ: θ + sin θ cos θ + atan(h/alpha) = pi - alpha, whose left side grows with θ.
    let excess = |t: f64| {
        let (sin, cos) = t.sin_cos();
        let ratio = sin * sin / alpha;
        let slope = 2.0 * cos * cos + 2.0 * sin * cos / alpha / (1.0 + ratio * ratio);
        (t + sin * cos + ratio.atan() - rest, slope)
    };
    let theta = zero(0.0, std::f64::consts::FRAC_PI_2, (0.5 * rest).min(1.5), excess);
    let (sin, cos) = theta.sin_cos();
    let (h, joint) = (sin * sin, sin * cos);
    [friction_inside(h, joint), h, joint]
}

pub(super) fn friction_inside(h: f64, joint: f64) -> f64 {
    let (sin, cos) = joint.sin_cos();
    ((1.0 - h) * cos - joint * sin) / ((1.0 - h) * sin + joint * cos)
}

/// The zero of a growing function in `(low, high)`: Newton's method, or halving where it would leave
/// what is known to hold the zero. `f` gives value and slope.
pub(super) fn zero(mut low: f64, mut high: f64, mut x: f64, f: impl Fn(f64) -> (f64, f64)) -> f64 {
    for _ in 0..100 {
        let (value, slope) = f(x);
        if value < 0.0 {
            low = x
        } else {
            high = x
        }
        let newton = x - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        let done = (next - x).abs() <= 1e-14 * x.abs();
        x = next;
        if done {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zero_is_found_from_anywhere() {
        for x in [0.01, 0.5, 1.0, 1.99] {
            let root = zero(0.0, 2.0, x, |t| (t.powi(5) - 3.0, 5.0 * t.powi(4)));
            approx::assert_relative_eq!(root, 3f64.powf(0.2), max_relative = 1e-13);
        }
    }

    #[test]
    fn the_purely_sliding_state_uses_its_friction_at_both_joints() {
        for alpha in [0.02, 0.3, 1.0, 2.0, 2.8, 3.1] {
            let [mu, h, joint] = sliding(&Float::with_val(64, alpha)).map(|x| x.to_f64());
            let (sin, cos) = f64::sin_cos(alpha);
            let shoulder = (h * sin - alpha * cos) / (h * cos + alpha * sin);
            approx::assert_relative_eq!(shoulder, mu, max_relative = 1e-6);
            approx::assert_relative_eq!(joint * joint, h * (1.0 - h), max_relative = 1e-9);
            let [again, _] = inner_sliding(&Float::with_val(64, mu)).map(|x| x.to_f64());
            approx::assert_relative_eq!(again, h, max_relative = 1e-6);
        }
    }
}
