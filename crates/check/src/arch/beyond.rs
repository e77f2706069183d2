//! Lines of thrust of an arch that is too thin for them: as far beyond the extrados of one joint as beyond the
//! intrados of another.
//!
//! With the radius `X` of the pressure point at the one and `2 - X` at the other, the moments of the parts above both
//! leave
//!
//! ```text
//! X N(a) - fac (1 - cos a) = p = (2 - X) N(b) - fac (1 - cos b)
//! ```
//!
//! Such a line fits exactly into a ring whose extrados has the radius `X`, under the weight of the arch that there is.

use super::{Configuration, Ring, statics};
use crate::number::{Angle, Field, Real};

/// The radius `X` at the joint `outer`, for a thrust: `(2 N(b) + fac (cos b - cos a)) / (N(a) + N(b))`.
pub fn radius<T: Field>(ring: &Ring<T>, [outer, inner]: [&Angle<T>; 2], thrust: &T) -> T {
    let [a, b] = [outer, inner].map(|joint| statics::normal_force(joint, thrust));
    let fall = ring.centroid_factor.clone() * (inner.cos.clone() - &outer.cos);
    (b.clone() + &b + fall) / (a + b)
}

/// The crown moment of that line, `p = X N(a) - fac (1 - cos a)`.
pub fn crown_moment<T: Field>(ring: &Ring<T>, joints: [&Angle<T>; 2], thrust: &T) -> T {
    let [outer, _] = joints;
    let radius = radius(ring, joints, thrust);
    radius * statics::normal_force(outer, thrust) - outer.versine() * &ring.centroid_factor
}

/// The thrust of the line that is as far beyond the extrados of the shoulder as beyond that of the crown's hinge `b0`
/// and the intrados of the haunch `beta`.
///
/// With `s = (alpha sin alpha - b0 sin b0)/(cos b0 - cos alpha)` the first two leave `h = s - fac/X`, and the third
/// a quadratic equation in `X`, whose larger root is meant:
///
/// ```text
/// X² [s c + m] - X [fac c + 2 (s cos beta + beta sin beta) + fac (cos beta - cos b0)] + 2 fac cos beta = 0
/// ```
///
/// with `c = cos b0 + cos beta` and `m = b0 sin b0 + beta sin beta`.
pub fn thrust_of_rotation<T: Real>(ring: &Ring<T>, at: &Configuration<T>) -> T {
    let (crown, haunch, shoulder) = (&at.crown_hinge, &at.rotation_joint, &at.half_opening);
    let fac = &ring.centroid_factor;
    let rise = |joint: &Angle<T>| joint.rad.clone() * &joint.sin;
    let slope = (rise(shoulder) - rise(crown)) / (crown.cos.clone() - &shoulder.cos);
    let both = crown.cos.clone() + &haunch.cos;
    let square = slope.clone() * &both + rise(crown) + rise(haunch);
    let normal = slope.clone() * &haunch.cos + rise(haunch);
    let linear = (both + &haunch.cos - &crown.cos) * fac + normal.clone() + normal;
    let last = fac.clone() * &haunch.cos * fac.int(2);
    let root = (linear.square() - square.clone() * last * fac.int(4)).sqrt();
    let radius = (linear + root) / (square.clone() + square);
    slope - fac.clone() / radius
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::arch::contact;
    use rug::Rational;

    /// Both pressure points are as far beyond their faces; with another crown moment they are not.
    #[test]
    fn the_line_is_as_far_beyond_both_faces() {
        let at = Configuration::<Rational>::rational();
        let ring = Ring::new(SelfWeight::Milankovitch, &at.thickness);
        let joints = [&at.half_opening, &at.rotation_joint];
        let moment = crown_moment(&ring, joints, &at.thrust);
        let beyond = |p: Rational| {
            let radius = |joint: &Angle<Rational>| {
                statics::pressure_radius(joint, &at.thrust, &p, &ring.centroid_factor)
            };
            let half = |twice: Rational| twice / Rational::from(2);
            let [outer, inner] = joints.map(radius);
            [outer - half(ring.extrados()), half(ring.intrados()) - inner]
        };
        let [out, within] = beyond(moment.clone());
        assert_eq!(out, within);
        let [out, within] = beyond(moment + Rational::from((1, 100)));
        assert_ne!(out, within);
    }

    /// At the crown, too; and at its least thickness an arch needs nothing beyond it.
    #[test]
    fn three_joints_fix_the_thrust() {
        // The semicircle of Heyman's weight: its least thickness is 0.107426, its haunch at 0.951141.
        let state = Configuration {
            half_opening: Angle::new(std::f64::consts::FRAC_PI_2),
            rotation_joint: Angle::new(0.951_141),
            ..Configuration::zero(&0.0)
        };
        for (eta, beyond) in [(0.107_426, 0.0), (0.05, 0.028_713), (0.02, 0.043_713)] {
            let ring = Ring::new(SelfWeight::Heyman, &eta);
            let h = thrust_of_rotation(&ring, &state);
            let p = crown_moment(&ring, [&state.half_opening, &state.rotation_joint], &h);
            let radius =
                |joint: &Angle<f64>| statics::pressure_radius(joint, &h, &p, &ring.centroid_factor);
            let out = [&state.half_opening, &state.crown_hinge].map(radius);
            assert!(out.iter().all(|x| (x - 1.0 - eta / 2.0 - beyond).abs() < 1e-6), "{out:?}");
            assert!((1.0 - eta / 2.0 - radius(&state.rotation_joint) - beyond).abs() < 1e-6);
            assert!((h - 0.621_772).abs() < 1e-5, "{h}");
            // The conditions of the arch itself contradict each other.
            let at = Configuration { thickness: eta, ..state.clone() };
            let rates = contact::rates_of_rotation(&at);
            assert!(rates.crown > 0.0 && rates.haunch > 0.0 && rates.shoulder > 0.0);
        }
    }
}
