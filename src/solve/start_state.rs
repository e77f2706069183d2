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

/// The curve of purely rotational states of one weight. It bends sharply just before its end, so the
/// nodes are dense there: equidistant in the square root of the distance from it.
struct Curve {
    end: f64,
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
    fn at(&self, alpha: f64) -> [f64; 3] {
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
    fn search(&self, is_before: impl Fn([f64; 3], f64) -> bool) -> f64 {
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
    let theta = match target.to_f64() {
        moderate if moderate > 1e-3 => Float::with_val(bits, slope_angle(moderate)),
        _ => target / 2u32,
    };
    let (sin, cos) = theta.sin_cos(Float::new(bits));
    [Float::with_val(bits, sin.square_ref()), sin * cos]
}

/// `θ` with `θ + sin θ cos θ = target`.
fn slope_angle(target: f64) -> f64 {
    let right = std::f64::consts::FRAC_PI_2;
    zero(0.0, right, 0.5 * target, |t| (t + t.sin() * t.cos() - target, 2.0 * t.cos().powi(2)))
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
    let pi = Float::with_val(bits, Constant::Pi);
    let near_pi = Float::with_val(bits, &pi - alpha).to_f64();
    sliding_at(alpha.to_f64(), near_pi).map(|x| Float::with_val(bits, x))
}

/// The same for `alpha` and `pi - alpha`, which are both needed to be accurate.
fn sliding_at(alpha: f64, rest: f64) -> [f64; 3] {
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

fn friction_inside(h: f64, joint: f64) -> f64 {
    let (sin, cos) = joint.sin_cos();
    ((1.0 - h) * cos - joint * sin) / ((1.0 - h) * sin + joint * cos)
}

/// A state as doubles: a quick look, of which nothing is certain.
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// The zero of a growing function in `(low, high)`: Newton's method, or halving where it would leave
/// what is known to hold the zero. `f` gives value and slope.
fn zero(mut low: f64, mut high: f64, mut x: f64, f: impl Fn(f64) -> (f64, f64)) -> f64 {
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
