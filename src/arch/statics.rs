//! Statics of the half arch: what every other equation follows from.
//!
//! The part of the arch between the crown and the joint at `beta` carries its weight `beta`; at the
//! crown acts the horizontal thrust `h`, at the radius `1 + e0`. Unit: `w r`.

use crate::number::{Angle, Field};

/// The normal force on the joint, `N(beta) = h cos(beta) + beta sin(beta)`.
pub fn normal_force<T: Field>(joint: &Angle<T>, thrust: &T) -> T {
    thrust.clone() * &joint.cos + joint.rad.clone() * &joint.sin
}

/// The shear force on the joint, `T(beta) = beta cos(beta) - h sin(beta)`: positive towards inner
/// sliding, negative towards sliding at the shoulder.
pub fn shear_force<T: Field>(joint: &Angle<T>, thrust: &T) -> T {
    joint.rad.clone() * &joint.cos - thrust.clone() * &joint.sin
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
    let weight_moment = joint.versine() * centroid_factor;
    (crown_moment + weight_moment) / normal_force(joint, thrust) - thrust.int(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_crown_carries_the_thrust_alone() {
        let crown = Angle::new(0.0);
        assert_eq!(normal_force(&crown, &0.3), 0.3);
        assert_eq!(shear_force(&crown, &0.3), 0.0);
        approx::assert_relative_eq!(eccentricity(&crown, &0.3, &0.05, &1.0), 0.05, epsilon = 1e-15);
    }
}
