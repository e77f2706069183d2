//! A state in doubles: a quick look, of which nothing is certain.

use super::curve::Curve;
use super::slide::{friction_inside, sliding_at, slope_angle};
use super::touch::{InnerStart, rotational_sliding};
use crate::arch::SelfWeight;
use crate::problem::Mode;

/// A state as doubles: a quick look, of which nothing is certain.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct QuickState {
    /// How it seems to collapse; `None` if nothing seems to stand.
    pub mode: Option<Mode>,
    /// `eta`.
    pub thickness: f64,
    /// `h`.
    pub thrust: f64,
    /// `beta_r`, rad.
    pub rotation_joint: f64,
}

/// The state of an arch in doubles, good to four digits for half openings from 0.2 up: what the
/// search starts from, without any proof. `alpha` in `(0, pi)`, `mu` finite.
pub fn quick_state(weight: SelfWeight, alpha: f64, mu: f64) -> QuickState {
    let found = |mode, [beta, eta, h]: [f64; 3]| QuickState {
        mode: (eta <= 2.0).then_some(mode),
        thickness: eta,
        thrust: h,
        rotation_joint: beta,
    };
    let [least, _, _] = sliding_at(alpha, std::f64::consts::PI - alpha);
    if mu < least {
        return QuickState {
            mode: None,
            thickness: f64::NAN,
            thrust: f64::NAN,
            rotation_joint: f64::NAN,
        };
    }
    let (sin, cos) = alpha.sin_cos();
    let curve = Curve::of(weight);
    let on_curve = |alpha: f64| {
        let [ratio, eta, h] = curve.at(alpha);
        [ratio.max(0.0).sqrt() * alpha, eta * alpha.powi(4), h]
    };
    if alpha < curve.end {
        let state = on_curve(alpha);
        let h = state[2];
        let shoulder = (h * sin - alpha * cos) / (h * cos + alpha * sin);
        if mu < shoulder {
            let h = alpha * (cos + mu * sin) / (sin - mu * cos);
            let narrower = curve.search(|[_, _, thrust], _| thrust > h);
            return found(Mode::SlidingRotational, on_curve(narrower));
        }
        if mu >= friction_inside(h, (h * (1.0 - h)).max(0.0).sqrt()) {
            return found(Mode::Rotational, state);
        }
    }
    let theta = slope_angle(mu.recip().atan());
    let (h, steepest) = (theta.sin().powi(2), theta.sin() * theta.cos());
    let InnerStart { thickness, joint } = rotational_sliding(weight, alpha, h);
    match joint {
        None => found(Mode::OverturningSliding, [0.0, thickness, h]),
        Some(beta) if beta > steepest => found(Mode::RotationalSliding, [beta, thickness, h]),
        Some(beta) => found(Mode::RotationalSlidingRotational, [beta, thickness, h]),
    }
}
