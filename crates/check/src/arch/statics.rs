//! Statics of the half arch: what every other equation follows from.
//!
//! The part of the arch between the crown and the joint at `beta` carries its weight `beta`; at the
//! crown acts the horizontal thrust `h`, at the radius `1 + e0`. Unit: `w r`.

use crate::number::{Angle, Field};

/// The normal force on the joint, `N(beta) = h cos(beta) + beta sin(beta)`.
#[inline(always)]
pub fn normal_force<T: Field>(joint: &Angle<T>, thrust: &T) -> T {
    thrust.clone() * &joint.cos + joint.rad.clone() * &joint.sin
}

/// The shear force on the joint, `T(beta) = beta cos(beta) - h sin(beta)`: positive towards inner
/// sliding, negative towards sliding at the shoulder.
#[inline(always)]
pub fn shear_force<T: Field>(joint: &Angle<T>, thrust: &T) -> T {
    joint.rad.clone() * &joint.cos - thrust.clone() * &joint.sin
}

/// The radius of the pressure point in the joint, in units of `r`, for the crown moment `p`, from the moments about the
/// centre: `(p + fac_M (1 - cos(beta))) / N(beta)`. Undefined where the normal force is zero.
pub fn pressure_radius<T: Field>(
    joint: &Angle<T>,
    thrust: &T,
    crown_moment: &T,
    centroid_factor: &T,
) -> T {
    let weight_moment = joint.versine() * centroid_factor;
    (crown_moment.clone() + weight_moment) / normal_force(joint, thrust)
}

/// Radius of the line of thrust where there is no thrust and no crown moment, `fac_M sin(beta) / (beta (1 +
/// cos(beta)))`; at the crown it is 0/0, with the limit `fac_M/2`.
pub fn radius_without_thrust<T: Field>(joint: &Angle<T>, centroid_factor: &T) -> T {
    let below = joint.cos.int(1) + &joint.cos;
    centroid_factor.clone() * &joint.sin / (below * &joint.rad)
}

/// The radius of the line of friction, in units of `r`: `1 + (eta/2) T/(mu N)`, on the extrados where an inner
/// joint slides and on the intrados where the shoulder does. Undefined where the normal force is zero, or the
/// friction.
pub fn friction_radius<T: Field>(joint: &Angle<T>, [thrust, friction, thickness]: [&T; 3]) -> T {
    let used = shear_force(joint, thrust) / (normal_force(joint, thrust) * friction);
    thrust.int(1) + used * thickness / thrust.int(2)
}

/// The eccentricity `e` of the pressure point in the joint, in units of `r`, from the moments about
/// the centre: `1 + e = (h (1 + e0) + fac_M (1 - cos(beta))) / N(beta)`.
///
/// The line of thrust lies inside the arch where `|e| <= eta/2`. Undefined where the normal force is
/// zero.
pub fn eccentricity<T: Field>(
    joint: &Angle<T>,
    thrust: &T,
    crown_eccentricity: &T,
    centroid_factor: &T,
) -> T {
    let crown_moment = (thrust.int(1) + crown_eccentricity) * thrust;
    pressure_radius(joint, thrust, &crown_moment, centroid_factor) - thrust.int(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_thrust_the_radius_is_the_limit() {
        for beta in [0.2, 1.0, 2.5] {
            let (joint, fac) = (Angle::new(beta), 1.1);
            let radius = radius_without_thrust(&joint, &fac);
            let expected = pressure_radius(&joint, &0.0, &0.0, &fac);
            approx::assert_relative_eq!(radius, expected, epsilon = 1e-14);
        }
    }

    /// All friction is used up where the line reaches a face.
    #[test]
    fn the_line_of_friction_reaches_the_extrados_where_a_joint_slides_in() {
        let (joint, thrust, eta) = (Angle::new(0.3), 0.2, 0.5);
        let friction = shear_force(&joint, &thrust) / normal_force(&joint, &thrust);
        let radius = friction_radius(&joint, [&thrust, &friction, &eta]);
        approx::assert_relative_eq!(radius, 1.25, epsilon = 1e-15);
        let radius = friction_radius(&joint, [&thrust, &-friction, &eta]);
        approx::assert_relative_eq!(radius, 0.75, epsilon = 1e-15);
    }

    #[test]
    fn the_crown_carries_the_thrust_alone() {
        let crown = Angle::new(0.0);
        assert_eq!(normal_force(&crown, &0.3), 0.3);
        assert_eq!(shear_force(&crown, &0.3), 0.0);
        approx::assert_relative_eq!(eccentricity(&crown, &0.3, &0.05, &1.0), 0.05, epsilon = 1e-15);
    }
}
