//! The curve of purely rotational states, tabulated once.

use super::LEAST_JOINT;
use super::ends::{End, NEAR, Small};
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::problem::Mode;
use crate::solve::polish;
use rug::Float;
use std::sync::OnceLock;

/// Below this half opening the series in `alpha²` are used.
const SMALL: f64 = 0.2;

/// Nodes of the table of rotational states.
const NODES: usize = 65;

/// The curve of purely rotational states of one weight. It bends sharply just before its end, so the
/// nodes are dense there: equidistant in the square root of the distance from it.
pub(super) struct Curve {
    /// The half opening of `l`.
    pub(super) end: f64,
    /// `(beta/alpha)²`, `eta/alpha⁴`, `h`: smooth functions of `alpha` over the whole range.
    nodes: Vec<[f64; 3]>,
}

impl Curve {
    pub(super) fn of(weight: SelfWeight) -> &'static Self {
        static CURVES: [OnceLock<Curve>; 2] = [OnceLock::new(), OnceLock::new()];
        CURVES[weight.flag() as usize].get_or_init(|| Self::new(weight))
    }

    fn new(weight: SelfWeight) -> Self {
        // The end l, four digits and more of the paper's Tables 3 and 4.
        let (end, thickness): (f64, f64) = match weight {
            SelfWeight::Heyman => (2.648388899151005, 1.0),
            SelfWeight::Milankovitch => (2.590843443008955, 0.9282032302755092),
        };
        let mut state = [0.5f64, 1.0 / 48.0, 1.0 - SMALL * SMALL / 6.0];
        let mut nodes = Vec::with_capacity(NODES);
        for index in 0..NODES - 1 {
            let rest = 1.0 - index as f64 / (NODES - 1) as f64;
            let alpha = end - (end - SMALL) * rest * rest;
            let given = given(alpha);
            let start = [state[0].sqrt() * alpha, state[1] * alpha.powi(4), state[2]]
                .map(|x| Float::with_val(64, x));
            if let Some(x) = polish(weight, Mode::Rotational.system(), &given, &start) {
                let [beta, eta, h] = [0, 1, 2].map(|i| x[i].to_f64());
                state = [(beta / alpha).powi(2), eta / alpha.powi(4), h];
            }
            nodes.push(state);
        }
        nodes.push([0.0, thickness / end.powi(4), 0.0]);
        Self { end, nodes }
    }

    /// The smooth functions at a half opening, by cubic interpolation.
    pub(super) fn at(&self, alpha: f64) -> [f64; 3] {
        let rest = ((self.end - alpha) / (self.end - SMALL)).max(0.0).sqrt();
        let place = (1.0 - rest) * (NODES - 1) as f64;
        let first = (place.floor() as isize - 1).clamp(0, NODES as isize - 4) as usize;
        let x = place - first as f64;
        let weights = [
            -(x - 1.0) * (x - 2.0) * (x - 3.0) / 6.0,
            x * (x - 2.0) * (x - 3.0) / 2.0,
            -x * (x - 1.0) * (x - 3.0) / 2.0,
            x * (x - 1.0) * (x - 2.0) / 6.0,
        ];
        [0, 1, 2].map(|k| (0..4).map(|j| weights[j] * self.nodes[first + j][k]).sum())
    }

    /// The half opening up to which a monotone condition on the state holds.
    pub(super) fn search(&self, is_before: impl Fn([f64; 3], f64) -> bool) -> f64 {
        let (mut low, mut high) = (SMALL, self.end);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if is_before(self.at(middle), middle) { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

fn given(alpha: f64) -> Configuration<Float> {
    let alpha = Float::with_val(64, alpha);
    Configuration::zero(&alpha).with(Unknown::HalfOpening, alpha)
}

/// Whether a half opening seems to be below that of `l`, by its first digits.
pub fn seems_to_rotate(weight: SelfWeight, alpha: &Float) -> bool {
    *alpha < Curve::of(weight).end
}

/// A candidate: `beta_r` (rad), `eta`, `h` of the purely rotational state at a half opening (rad) above
/// zero and below that of `l`.
pub fn rotational(weight: SelfWeight, alpha: &Float) -> [Float; 3] {
    let bits = alpha.prec();
    if let (true, Some(series)) = (*alpha < SMALL, Small::of(weight)) {
        return series.at(alpha);
    }
    let curve = Curve::of(weight);
    let is_near = *alpha > curve.end - 10.0 * NEAR;
    if let Some(state) = End::of(weight).filter(|_| is_near).and_then(|end| end.at(alpha)) {
        return state;
    }
    let alpha = alpha.to_f64();
    let [ratio, eta, h] = curve.at(alpha);
    let beta = (ratio.max(0.0).sqrt() * alpha).max(LEAST_JOINT);
    [beta, eta * alpha.powi(4), h.max(LEAST_JOINT)].map(|x| Float::with_val(bits, x))
}

/// A candidate: `beta_r`, `eta`, `h` where the curve of rotational states has the thrust `h`.
pub fn rotational_with_thrust(weight: SelfWeight, h: &Float) -> [Float; 3] {
    let bits = h.prec();
    // 1 - h = alpha²/6 for small openings.
    let alpha = (Float::with_val(bits, 1 - h) * 6u32).sqrt();
    let alpha = if alpha < SMALL / 2.0 {
        alpha
    } else {
        let h = h.to_f64();
        Float::with_val(bits, Curve::of(weight).search(|[_, _, thrust], _| thrust > h))
    };
    let [beta, eta, _] = rotational(weight, &alpha);
    [beta, eta, h.clone()]
}

/// A candidate: `beta_r`, `h` where the curve of rotational states has the thickness `eta`, below that of `l`.
pub fn rotational_with_thickness(weight: SelfWeight, eta: &Float) -> [Float; 2] {
    let bits = eta.prec();
    // eta = alpha⁴/48 for small openings.
    let small = Float::with_val(bits, eta * 48u32).sqrt().sqrt();
    let alpha = if small < SMALL / 2.0 {
        small
    } else {
        let curve = Curve::of(weight);
        let eta = eta.to_f64();
        Float::with_val(bits, curve.search(|[_, ratio, _], alpha| ratio * alpha.powi(4) < eta))
    };
    let [beta, _, h] = rotational(weight, &alpha);
    [beta, h]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_monotone_and_close_to_the_curve() {
        for weight in SelfWeight::ALL {
            let curve = Curve::of(weight);
            let mut last = [f64::INFINITY, 0.0];
            for step in 0..500 {
                let alpha = SMALL + (curve.end - SMALL) * f64::from(step) / 500.0;
                let [ratio, eta, h] = curve.at(alpha);
                let eta = eta * alpha.powi(4);
                assert!(h < last[0] && eta > last[1], "{weight:?} {alpha}");
                last = [h, eta];
                let start = rotational(weight, &Float::with_val(64, alpha));
                let found =
                    polish(weight, Mode::Rotational.system(), &given(alpha), &start).unwrap();
                let beta = ratio.max(0.0).sqrt() * alpha;
                approx::assert_relative_eq!(found[0].to_f64(), beta, max_relative = 1e-3);
                approx::assert_relative_eq!(found[1].to_f64(), eta, max_relative = 1e-4);
                let back = curve.search(|[_, _, thrust], _| thrust > h);
                approx::assert_relative_eq!(back, alpha, max_relative = 1e-9);
            }
        }
    }
}
