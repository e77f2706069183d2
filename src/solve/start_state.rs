//! Where the search for the state of an arch starts: doubles, good to a few digits.
//!
//! Why the root found is the admissible one. All states with hinges at the haunch lie where the line
//! of thrust touches the intrados. At a given thrust and thickness that happens at one joint only,
//! because (5) fixes `beta cot(beta)`, which falls strictly from 1 on `(0, pi)`. So
//!
//! - the purely rotational states are **one curve**, along which the thickness grows and the thrust
//!   falls strictly from `alpha = 0` to the end `l`; it is tabulated once and looked up by the half
//!   opening or by the thrust, both of which are monotone on it;
//! - with a sliding inner joint the friction fixes the thrust, and the thickness is the zero of one
//!   function of one variable, the gap between the moments about the touching joint and about the
//!   shoulder, which grows with the thickness: it is bracketed and bisected.
//!
//! None of this is trusted: the proof shows existence, admissibility of the whole arch, and that no
//! thinner arch stands.

use super::polish;
use crate::arch::{Configuration, Mode, SelfWeight, Unknown};
use rug::Float;
use rug::float::Constant;
use std::sync::OnceLock;

/// Below this half opening the leading terms of the series in `alpha` are good enough.
const SMALL: f64 = 0.2;
/// Nodes of the table of rotational states.
const NODES: usize = 65;
/// The least start value of a joint: nearer to zero Newton's method finds the way by halving.
const LEAST_JOINT: f64 = 1e-9;

/// The curve of purely rotational states of one weight, at equidistant half openings.
struct Curve {
    step: f64,
    /// `(beta/alpha)²`, `eta/alpha⁴`, `h`: smooth functions of `alpha` over the whole range.
    nodes: Vec<[f64; 3]>,
}

impl Curve {
    fn of(weight: SelfWeight) -> &'static Self {
        static CURVES: [OnceLock<Curve>; 2] = [OnceLock::new(), OnceLock::new()];
        CURVES[weight.flag() as usize].get_or_init(|| Self::new(weight))
    }

    fn new(weight: SelfWeight) -> Self {
        // The end l, four digits and more of the paper's Tables 3 and 4.
        let (end, thickness): (f64, f64) = match weight {
            SelfWeight::Heyman => (2.648388899151005, 1.0),
            SelfWeight::Milankovitch => (2.590843443008955, 0.9282032302755092),
        };
        let step = (end - SMALL) / (NODES - 1) as f64;
        let mut state = [0.5f64, 1.0 / 48.0, 1.0 - SMALL * SMALL / 6.0];
        let mut nodes = Vec::with_capacity(NODES);
        for index in 0..NODES - 1 {
            let alpha = SMALL + step * index as f64;
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
        Self { step, nodes }
    }

    /// The smooth functions at a half opening, by cubic interpolation.
    fn at(&self, alpha: f64) -> [f64; 3] {
        let place = (alpha - SMALL) / self.step;
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
    fn search(&self, is_before: impl Fn([f64; 3], f64) -> bool) -> f64 {
        let (mut low, mut high) = (SMALL, SMALL + self.step * (NODES - 1) as f64);
        for _ in 0..50 {
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

/// `beta_r`, `eta`, `h` of the purely rotational state at a half opening below that of `l`.
pub fn rotational(weight: SelfWeight, alpha: &Float) -> [Float; 3] {
    let bits = alpha.prec();
    let square = Float::with_val(bits, alpha.square_ref());
    if *alpha < SMALL {
        // beta = alpha/√2, eta = alpha⁴/48, h = 1 - alpha²/6: the leading terms.
        let beta = Float::with_val(bits, alpha / Float::with_val(bits, 2).sqrt());
        let eta = Float::with_val(bits, square.square_ref()) / 48;
        return [beta, eta, 1 - square / 6];
    }
    let alpha = alpha.to_f64();
    let [ratio, eta, h] = Curve::of(weight).at(alpha);
    let beta = (ratio.max(0.0).sqrt() * alpha).max(LEAST_JOINT);
    [beta, eta * alpha.powi(4), h.max(LEAST_JOINT)].map(|x| Float::with_val(bits, x))
}

/// `beta_r`, `eta`, `h` where the curve of rotational states has the thrust `h`.
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

/// The thrust and the sliding joint at which an inner joint just slides: `h = sin²θ` with
/// `θ + sin θ cos θ = acot(mu)`, which is (18) with `beta_s = sin θ cos θ`.
pub fn inner_sliding(friction: &Float) -> [Float; 2] {
    let bits = friction.prec();
    let target = Float::with_val(bits, friction.recip_ref()).atan();
    let mut theta = Float::with_val(bits, &target / 2u32);
    if target > 1e-3 {
        let target = target.to_f64();
        let mut t = target / 2.0;
        for _ in 0..30 {
            t -= (t + t.sin() * t.cos() - target) / (2.0 * t.cos().powi(2)).max(0.1);
        }
        theta = Float::with_val(bits, t);
    }
    let (sin, cos) = theta.sin_cos(Float::new(bits));
    [Float::with_val(bits, sin.square_ref()), sin * cos]
}

/// `mu`, `h`, `beta_s` of the purely sliding state at a half opening.
pub fn sliding(alpha: &Float) -> [Float; 3] {
    let bits = alpha.prec();
    let square = Float::with_val(bits, alpha.square_ref());
    if *alpha < 0.01 {
        // mu = alpha³/12, h = 1 - alpha²/4, beta_s = alpha/2: the leading terms.
        let mu = Float::with_val(bits, &square * alpha) / 12u32;
        return [mu, 1 - square / 4u32, Float::with_val(bits, alpha / 2u32)];
    }
    // In θ, h = sin²θ: θ + sin θ cos θ + atan(h/alpha) + alpha = pi, whose left side grows with θ.
    let pi = Float::with_val(bits, Constant::Pi);
    let near_pi = Float::with_val(bits, &pi - alpha).to_f64();
    let a = alpha.to_f64();
    let excess = |t: f64| t + t.sin() * t.cos() + (t.sin().powi(2) / a).atan() - near_pi;
    let (mut low, mut high) = (0.0f64, std::f64::consts::FRAC_PI_2);
    for _ in 0..60 {
        // Close to pi the root is tiny: halve the exponent before the mantissa.
        let middle = if low == 0.0 && high > 1e-3 { high / 8.0 } else { 0.5 * (low + high) };
        if excess(middle) < 0.0 { low = middle } else { high = middle }
    }
    let (sin, cos) = (0.5 * (low + high)).sin_cos();
    let (h, joint) = (sin * sin, sin * cos);
    let mu = ((1.0 - h) * joint.cos() - joint * joint.sin())
        / ((1.0 - h) * joint.sin() + joint * joint.cos());
    [mu, h, joint].map(|x| Float::with_val(bits, x))
}

/// A start with a sliding inner joint: the thickness, and the rotational joint unless it is the crown.
pub struct InnerStart {
    /// `eta`.
    pub thickness: f64,
    /// `beta_r`, or `None` if the intrados is touched at the crown.
    pub joint: Option<f64>,
}

/// The thickness at a half opening and a thrust that the sliding of an inner joint fixes.
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
    let gap = |eta: f64| {
        let beta = inverse_times_cotangent(cotangent(eta));
        let touching = (1.0 - 0.5 * eta) * (h * beta.cos() + beta * beta.sin())
            - fac(eta) * (1.0 - beta.cos());
        (1.0 + 0.5 * eta) * normal - fac(eta) * drop - touching
    };
    let (mut low, mut high) = (crown.max(0.0), 2.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if gap(middle) < 0.0 { low = middle } else { high = middle }
    }
    let eta = 0.5 * (low + high);
    let joint = inverse_times_cotangent(cotangent(eta)).max(LEAST_JOINT);
    InnerStart { thickness: eta, joint: Some(joint) }
}

/// The angle whose product with its cotangent is `k`; zero from `k = 1` on.
fn inverse_times_cotangent(k: f64) -> f64 {
    if k >= 1.0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, std::f64::consts::PI);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if middle * middle.cos() > k * middle.sin() { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// `beta_r`, `h` where the curve of rotational states has the thickness `eta`, below that of `l`.
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
