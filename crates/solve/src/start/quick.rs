//! A state in doubles: a quick look, of which nothing is certain.

use super::rotation::{before_end, rotational_in_doubles, with_thrust};
use super::sliding::{friction_inside, inner_sliding_in_doubles, sliding_in_doubles};
use super::touch::{InnerStart, rotational_sliding};
use crate::arch::{SelfWeight, sliding};
use crate::number::Angle;
use crate::problem::Mode;

/// A state as doubles: a quick look, of which nothing is certain.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct QuickState {
    /// Mode in which it seems to collapse; `None` if nothing seems to stand.
    pub mode: Option<Mode>,
    /// `eta`.
    pub thickness: f64,
    /// `h`.
    pub thrust: f64,
    /// `beta_r`, rad.
    pub rotation_joint: f64,
}

/// The state of an arch in doubles, without any proof: for half openings from 0.2 up and away from where the
/// mode changes it is good to about ten digits. `alpha` in `(0, pi)`, `mu` finite.
pub fn quick_state(weight: SelfWeight, alpha: f64, mu: f64) -> QuickState {
    let found = |mode, [beta, eta, h]: [f64; 3]| QuickState {
        mode: (eta <= 2.0).then_some(mode),
        thickness: eta,
        thrust: h,
        rotation_joint: beta,
    };
    let opening = Angle::new(alpha);
    let mut shoulder = f64::NEG_INFINITY;
    if before_end(weight, alpha) > 0.0 {
        let state @ [_, _, h] = rotational_in_doubles(weight, alpha);
        shoulder = sliding::shoulder(&opening, &h).value();
        let steepest = sliding::steepest_joint(&h.max(0.0));
        if mu >= shoulder.max(friction_inside([h, steepest]).value()) {
            return found(Mode::Rotational, state);
        }
    }
    let [least, ..] = sliding_in_doubles(&opening);
    if mu < least {
        return QuickState { mode: None, ..found(Mode::Sliding, [f64::NAN; 3]) };
    }
    if mu < shoulder {
        let h = sliding::shoulder_thrust(&opening, &mu).value();
        let [beta, eta] = with_thrust(weight, h);
        return found(Mode::SlidingRotational, [beta, eta, h]);
    }
    let [h, steepest] = inner_sliding_in_doubles(mu);
    let InnerStart { thickness, joint, .. } = rotational_sliding(weight, alpha, h);
    match joint {
        None => found(Mode::OverturningSliding, [0.0, thickness, h]),
        Some(beta) if beta > steepest => found(Mode::RotationalSliding, [beta, thickness, h]),
        Some(beta) => found(Mode::RotationalSlidingRotational, [beta, thickness, h]),
    }
}
