//! The whole arch under a uniform horizontal acceleration of `k` times that of gravity, to the right: an earthquake
//! at rest, or the ground tilted by the angle whose tangent is `k`, where all forces are larger by the same factor.
//!
//! The part between the crown and a joint `beta` is pushed with `k beta` at its centroid, whose moments about the
//! centre add up to `k fac sin(beta)` for both weights. So the forces on a joint are those of the [whole
//! arch](super::whole) with
//!
//! ```text
//! h + k beta        for h
//! p + k fac sin(beta)   for p
//! ```
//!
//! on both sides of the crown. What must not be positive is linear in `h, p, v` and `k`. To the left it is the
//! mirror image.

use super::Ring;
use super::joint::Grip;
use super::mechanism::Contact;
use super::whole::static_row;
use crate::number::{Angle, Field};

/// A condition `h a_0 + p a_1 + v a_2 + k a_3 + load <= 0`.
#[derive(Clone, Debug)]
pub struct TiltedRow<T> {
    /// The coefficients of `h, p, v, k`.
    pub coefficients: [T; 4],
    /// Term free of the forces.
    pub load: T,
}

/// Row of a joint's condition: what must not be positive.
pub fn row<T: Field>(
    contact: Contact,
    joint: &Angle<T>,
    ring: &Ring<T>,
    grip: &Grip<T>,
) -> TiltedRow<T> {
    let [thrust, moment, vertical] = static_row(contact, joint, ring, grip);
    let push = thrust.clone() * &joint.rad + moment.clone() * &ring.centroid_factor * &joint.sin;
    let load = contact.row(joint, ring, grip).load;
    TiltedRow { coefficients: [thrust, moment, vertical, push], load }
}

impl<T> TiltedRow<T> {
    /// The row in another number.
    pub fn map<U>(&self, f: impl Fn(&T) -> U) -> TiltedRow<U> {
        TiltedRow { coefficients: self.coefficients.each_ref().map(&f), load: f(&self.load) }
    }
}

impl<T: Field> TiltedRow<T> {
    /// The left side at `h, p, v, k`, with the weight times a factor.
    pub fn at(&self, unknowns: &[T; 4], weight: &T) -> T {
        let terms = self.coefficients.iter().zip(unknowns);
        terms.fold(self.load.clone() * weight, |sum, (a, x)| sum + a.clone() * x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::arch::whole::{Forces, margin};
    use rug::Rational;

    /// The forces in the crown, and the acceleration.
    #[derive(Clone, Debug)]
    struct Tilted<T> {
        /// Forces that the halves bear on each other.
        forces: Forces<T>,
        /// `k`, the horizontal acceleration over that of gravity.
        tilt: T,
    }

    /// Margin of a joint: what must not be negative.
    fn margin_at<T: Field>(
        contact: Contact,
        joint: &Angle<T>,
        ring: &Ring<T>,
        grip: &Grip<T>,
        state: &Tilted<T>,
    ) -> T {
        let Forces { thrust, moment, vertical } = &state.forces;
        let pushed = Forces {
            thrust: state.tilt.clone() * &joint.rad + thrust,
            moment: state.tilt.clone() * &ring.centroid_factor * &joint.sin + moment,
            vertical: vertical.clone(),
        };
        margin(contact, joint, ring, grip, &pushed)
    }

    fn r(n: i32, d: i32) -> Rational {
        Rational::from((n, d))
    }

    fn parts() -> (Ring<Rational>, Grip<Rational>, Tilted<Rational>) {
        let forces = Forces { thrust: r(2, 7), moment: r(1, 5), vertical: r(1, 11) };
        let grip = Grip { shear: r(1, 1), normal: r(5, 4) };
        let ring = Ring::new(SelfWeight::Milankovitch, &r(1, 3));
        (ring, grip, Tilted { forces, tilt: r(1, 8) })
    }

    /// The rows are the margins, on both sides of the crown.
    #[test]
    fn the_rows_are_the_margins() {
        let (ring, grip, state) = parts();
        let Forces { thrust, moment, vertical } = state.forces.clone();
        let unknowns = [thrust, moment, vertical, state.tilt.clone()];
        for side in [1, -1] {
            let joint = Angle { rad: r(9 * side, 4), sin: r(4 * side, 5), cos: r(-3, 5) };
            for contact in Contact::ALL {
                let row = row(contact, &joint, &ring, &grip);
                let margin = margin_at(contact, &joint, &ring, &grip, &state);
                assert_eq!(row.at(&unknowns, &r(1, 1)), -margin.clone());
                let still = Tilted { tilt: r(0, 1), ..state.clone() };
                assert_ne!(margin, margin_at(contact, &joint, &ring, &grip, &still));
            }
        }
    }

    /// A part of the arch is in equilibrium: what its two joints bear is its weight and its push, with their
    /// moments about the centre, its centroid being at the radius `fac sin(g)/g` of half its angle `g`.
    #[test]
    fn a_stone_is_in_equilibrium() {
        let (ring, _, Tilted { forces, tilt }) = parts();
        let half = Angle { rad: r(2, 5), sin: r(3, 5), cos: r(4, 5) };
        let joint = Angle { rad: r(4, 5), sin: r(24, 25), cos: r(7, 25) };
        let (weight, radius) =
            (joint.rad.clone(), ring.centroid_factor.clone() * &half.sin / &half.rad);
        let [across, down] = [radius.clone() * &half.sin, radius * &half.cos];
        // From the forces in the crown: clockwise moments of weight and push about the centre.
        let moment =
            forces.moment.clone() + weight.clone() * across + tilt.clone() * &weight * down;
        let lowered = joint.versine() * &ring.centroid_factor + &forces.moment;
        assert_eq!(moment, lowered + tilt.clone() * &ring.centroid_factor * &joint.sin);
        assert_ne!(
            moment,
            joint.versine() * &ring.centroid_factor + &forces.moment + tilt * weight
        );
    }
}
