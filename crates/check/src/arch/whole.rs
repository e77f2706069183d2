//! Statics and kinematics of the whole arch, as Eqs. (19) and (20) have them.
//!
//! Without symmetry the crown bears a vertical force `v` beside the thrust `h` and the moment `p`: it carries `v`
//! of the weight of the right half. Joints are angles from the crown, positive to the right, in `[-alpha, alpha]`.
//! The forces on a joint `beta` are those of the half arch with `beta - v` for the weight, the sine and the cosine
//! being those of `beta`:
//!
//! ```text
//! N = h cos(beta) + (beta - v) sin(beta)
//! T = (beta - v) cos(beta) - h sin(beta)
//! ```
//!
//! On the left, at `beta < 0`, `T = -mu N` is inward sliding and `T = mu N` outward, the other way round than on
//! the right: [`Side`] turns the one into the other.
//!
//! A joint at its limit adds the same relative twist, "left of it less right of it", on both sides. All
//! twists from springing to springing add up to zero: **three equations of compatibility**, dual to `h`, `p` and
//! `v`. With a dilatancy of `mu` the row of the motion is that of the statics; without, a joint that slides does
//! not open.

use super::Ring;
use super::joint::Grip;
use super::mechanism::{Contact, Joint, Twist};
use super::statics;
use crate::number::{Angle, Field, Jet};

/// Forces that the right half of the arch bears on the left one, at the crown.
#[derive(Clone, Debug)]
pub struct Forces<T> {
    /// `h`.
    pub thrust: T,
    /// `p`, the moment about the centre.
    pub moment: T,
    /// `v`, the part of the weight of the right half that the left one carries.
    pub vertical: T,
}

/// A half of the arch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// The side of the positive angles.
    Right,
    /// The side of the negative angles.
    Left,
}

impl Side {
    /// The name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Left => "left",
        }
    }

    /// The joint at an angle from the crown, on this side.
    pub fn joint<T: Field>(self, angle: &Angle<T>) -> Angle<T> {
        match self {
            Self::Right => angle.clone(),
            Self::Left => {
                Angle { rad: -angle.rad.clone(), sin: -angle.sin.clone(), cos: angle.cos.clone() }
            }
        }
    }

    /// The condition by its signs that a joint of this side meets as `contact`; and the other way round.
    pub fn contact(self, contact: Contact) -> Contact {
        match (self, contact) {
            (Self::Left, Contact::Inwards) => Contact::Outwards,
            (Self::Left, Contact::Outwards) => Contact::Inwards,
            (_, same) => same,
        }
    }
}

/// The joint with the weight that is left to it: `beta - v`.
pub fn carried<T: Field>(joint: &Angle<T>, vertical: &T) -> Angle<T> {
    Angle { rad: joint.rad.clone() - vertical, ..joint.clone() }
}

/// Margin of a joint, which must not be negative.
pub fn margin<T: Field>(
    contact: Contact,
    joint: &Angle<T>,
    ring: &Ring<T>,
    grip: &Grip<T>,
    forces: &Forces<T>,
) -> T {
    let row = contact.row(&carried(joint, &forces.vertical), ring, grip);
    -row.at(&forces.thrust, &forces.moment)
}

/// The order of series in the joint.
const ORDER: usize = 2;

/// A joint that moves along the arch, up to the second order.
pub fn along<T: Field>(joint: &Angle<T>) -> Angle<Jet<T>> {
    let Angle { rad, sin, cos } = joint;
    let (one, two) = (rad.int(1), rad.int(2));
    Angle {
        rad: Jet::new(vec![rad.clone(), one], ORDER),
        sin: Jet::new(vec![sin.clone(), cos.clone(), -sin.clone() / &two], ORDER),
        cos: Jet::new(vec![cos.clone(), -sin.clone(), -cos.clone() / &two], ORDER),
    }
}

/// The margin as a series in the joint, up to the second order: its slope along the arch, and half its curvature.
pub fn margin_along<T: Field>(
    contact: Contact,
    joint: &Angle<T>,
    ring: &Ring<T>,
    grip: &Grip<T>,
    forces: &Forces<T>,
) -> Jet<T> {
    let along = along(joint);
    let constant = |x: &T| Jet::constant(x.clone(), ORDER);
    let ring = ring.map(constant);
    let grip = grip.clone().map(|x| constant(&x));
    let Forces { thrust, moment, vertical } = forces;
    let forces =
        Forces { thrust: constant(thrust), moment: constant(moment), vertical: constant(vertical) };
    margin(contact, &along, &ring, &grip, &forces)
}

/// The row of the static matrix: what `h`, `p` and `v` add to what must not be positive.
pub fn static_row<T: Field>(
    contact: Contact,
    joint: &Angle<T>,
    ring: &Ring<T>,
    grip: &Grip<T>,
) -> [T; 3] {
    let row = contact.row(joint, ring, grip);
    // The condition is linear in the weight that is carried.
    let [with, without] = [1, 0].map(|weight| {
        let rad = joint.rad.int(weight);
        contact.row(&Angle { rad, ..joint.clone() }, ring, grip).load
    });
    [row.thrust, row.moment, without - with]
}

/// The row of the compatibility matrix: the horizontal velocity, the rotation clockwise and the vertical velocity
/// that a joint adds at the rate one.
pub fn motion_row<T: Field>(
    contact: Contact,
    joint: &Angle<T>,
    thickness: &T,
    dilatancy: &T,
) -> [T; 3] {
    components(contact.twist(joint, thickness, dilatancy))
}

fn components<T: Field>(twist: Twist<T>) -> [T; 3] {
    let [across, up] = twist.velocity;
    [across, -twist.rotation, up]
}

/// Joints that give way together, from the right springing to the left, each by its sign at a joint of `[-alpha,
/// alpha]`.
#[derive(Clone, Debug)]
pub struct WholeMotion<T>(pub Vec<Joint<T>>);

impl<T: Field> WholeMotion<T> {
    /// The twist beyond the last joint by components, as in [`motion_row`]: zero, if the motion is compatible.
    pub fn gap(&self, thickness: &T) -> [T; 3] {
        let add = |sum: Twist<T>, joint: &Joint<T>| sum.plus(&joint.twist(thickness));
        components(self.0.iter().fold(Twist::zero(thickness), add))
    }

    /// The power of the weight: of each block between two joints with its own velocity.
    pub fn power(&self, ring: &Ring<T>) -> T {
        let zero = ring.thickness.int(0);
        let mut twist = Twist::zero(&ring.thickness);
        self.0.iter().zip(self.0.iter().skip(1)).fold(zero, |sum, (right, left)| {
            twist = twist.plus(&right.twist(&ring.thickness));
            sum + twist.power([&left.at, &right.at], &ring.centroid_factor)
        })
    }

    /// The power that friction takes: the shear force times the slip.
    pub fn friction_power(&self, forces: &Forces<T>) -> T {
        self.0.iter().fold(forces.thrust.int(0), |sum, joint| {
            let shear = statics::shear_force(&carried(&joint.at, &forces.vertical), &forces.thrust);
            match joint.contact {
                Contact::Extrados | Contact::Intrados => sum,
                Contact::Inwards => sum + shear * &joint.rate,
                Contact::Outwards => sum - shear * &joint.rate,
            }
        })
    }

    /// The rates times the margins, term by term: each zero in a solution of Eq. (19).
    pub fn complementarity(&self, ring: &Ring<T>, grip: &Grip<T>, forces: &Forces<T>) -> Vec<T> {
        let term =
            |joint: &Joint<T>| margin(joint.contact, &joint.at, ring, grip, forces) * &joint.rate;
        self.0.iter().map(term).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use rug::Rational;

    fn angle(rad: (i32, i32), sin: (i32, i32), cos: (i32, i32)) -> Angle<Rational> {
        Angle { rad: rad.into(), sin: sin.into(), cos: cos.into() }
    }

    fn joints() -> [Angle<Rational>; 3] {
        [
            angle((9, 4), (4, 5), (-3, 5)),
            angle((1, 3), (5, 13), (12, 13)),
            angle((-1, 1), (-20, 29), (21, 29)),
        ]
    }

    fn ring() -> Ring<Rational> {
        Ring::new(SelfWeight::Milankovitch, &Rational::from((1, 3)))
    }

    fn grip() -> Grip<Rational> {
        Grip { shear: Rational::from(1), normal: Rational::from((5, 4)) }
    }

    fn forces(vertical: (i32, i32)) -> Forces<Rational> {
        Forces { thrust: (1, 7).into(), moment: (1, 5).into(), vertical: vertical.into() }
    }

    /// The margins are what is left of the rows.
    #[test]
    fn a_margin_is_linear_in_the_three_forces() {
        for joint in joints() {
            for contact in Contact::ALL {
                let [by_thrust, by_moment, by_vertical] =
                    static_row(contact, &joint, &ring(), &grip());
                let forces = forces((2, 9));
                let load = contact.row(&joint, &ring(), &grip()).load;
                let sum = by_thrust * forces.thrust.clone() + by_moment * forces.moment.clone();
                let sum = sum + by_vertical * forces.vertical.clone() + load;
                assert_eq!(margin(contact, &joint, &ring(), &grip(), &forces), -sum);
            }
        }
    }

    /// With a dilatancy of the friction the two matrices are one; without, those of a joint that slides differ.
    #[test]
    fn dilatancy_makes_the_motion_dual_to_the_statics() {
        let Ring { thickness, .. } = ring();
        for joint in joints() {
            for contact in Contact::ALL {
                let row = static_row(contact, &joint, &ring(), &grip());
                assert_eq!(motion_row(contact, &joint, &thickness, &grip().normal), row);
                let plain = motion_row(contact, &joint, &thickness, &Rational::new());
                assert_eq!(plain == row, contact.is_hinge(), "{contact:?}");
            }
        }
    }

    /// The mirror image has the same margins: the other side, and the vertical force the other way.
    #[test]
    fn the_mirror_image_is_as_admissible() {
        for joint in joints() {
            for contact in Contact::ALL {
                let here = margin(contact, &joint, &ring(), &grip(), &forces((2, 9)));
                let there = Side::Left.joint(&joint);
                let mirrored = Side::Left.contact(contact);
                assert_eq!(margin(mirrored, &there, &ring(), &grip(), &forces((-2, 9))), here);
                let twin = margin(mirrored, &there, &ring(), &grip(), &forces((2, 9)));
                assert_ne!(twin, here, "false twin");
                assert_eq!(Side::Left.contact(mirrored), contact);
            }
        }
    }

    /// For any rates that fit, the weight works by as much as friction takes less the rates times the margins.
    #[test]
    fn the_power_of_the_weight_is_dual_to_the_margins() {
        let [shoulder, inner, left] = joints();
        let at = [
            (Contact::Outwards, shoulder),
            (Contact::Extrados, angle((1, 2), (33, 65), (56, 65))),
            (Contact::Inwards, inner),
            (Contact::Intrados, angle((-1, 4), (-7, 25), (24, 25))),
            (Contact::Outwards, left),
        ];
        // Three rates follow from two.
        let eta = ring().thickness;
        let none = Rational::new();
        let rows: Vec<[Rational; 3]> =
            at.iter().map(|(contact, joint)| motion_row(*contact, joint, &eta, &none)).collect();
        let det = |a: &[Rational; 3], b: &[Rational; 3], c: &[Rational; 3]| -> Rational {
            let minor =
                |i: usize, j: usize| Rational::from(&b[i] * &c[j]) - Rational::from(&b[j] * &c[i]);
            a[0].clone() * minor(1, 2) - a[1].clone() * minor(0, 2) + a[2].clone() * minor(0, 1)
        };
        let given: [Rational; 3] = [0, 1, 2].map(|k: usize| {
            let sum: Rational = rows[1][k].clone() * 2 + &rows[0][k];
            -sum
        });
        let whole = det(&rows[2], &rows[3], &rows[4]);
        let rates = [
            Rational::from(1),
            Rational::from(2),
            det(&given, &rows[3], &rows[4]) / &whole,
            det(&rows[2], &given, &rows[4]) / &whole,
            det(&rows[2], &rows[3], &given) / whole,
        ];
        let motion = |rates: &[Rational; 5]| {
            let joints = at.iter().zip(rates).map(|((contact, at), rate)| Joint {
                contact: *contact,
                at: at.clone(),
                rate: rate.clone(),
                dilatancy: none.clone(),
            });
            WholeMotion(joints.collect())
        };
        let balance = |motion: &WholeMotion<Rational>| {
            let forces = forces((2, 9));
            let terms = motion.complementarity(&ring(), &grip(), &forces);
            let terms = terms.into_iter().fold(Rational::new(), |sum, term| sum + term);
            // Friction at its limit takes mu N; here the joints are not at their limits.
            let taken = motion.0.iter().fold(Rational::new(), |sum, joint| {
                let seen = carried(&joint.at, &forces.vertical);
                let normal = statics::normal_force(&seen, &forces.thrust) * grip().normal;
                if joint.contact.is_hinge() { sum } else { sum + normal * &joint.rate }
            });
            motion.power(&ring()) - taken + terms
        };
        let fits = motion(&rates);
        assert_eq!(fits.gap(&eta), [none.clone(), none.clone(), none.clone()]);
        assert_eq!(balance(&fits), 0);
        let mut spoiled = rates;
        spoiled[4] = -spoiled[4].clone();
        let twin = motion(&spoiled);
        assert!(twin.gap(&eta) != [none.clone(), none.clone(), none.clone()]);
        assert_ne!(balance(&twin), 0, "false twin");
    }

    /// The slope of the margin along the arch is that of its values.
    #[test]
    fn the_series_of_a_margin_is_its_taylor_series() {
        let at = |rad: f64| {
            let ring = Ring::new(SelfWeight::Milankovitch, &0.5);
            let grip = Grip { shear: 1.0, normal: 1.05 };
            let forces = Forces { thrust: 0.18, moment: 0.23, vertical: 0.06 };
            Contact::ALL
                .map(|contact| margin_along(contact, &Angle::new(rad), &ring, &grip, &forces))
        };
        let step = 1e-4;
        for rad in [-1.2, 0.3, 2.0] {
            let [before, here, after] = [-step, 0.0, step].map(|by| at(rad + by));
            for k in 0..4 {
                let slope = (after[k].value() - before[k].value()) / (2.0 * step);
                approx::assert_abs_diff_eq!(here[k].coefficient(1), slope, epsilon = 1e-6);
                let bend = after[k].value() - 2.0 * here[k].value() + before[k].value();
                let bend = bend / (2.0 * step * step);
                approx::assert_abs_diff_eq!(here[k].coefficient(2), bend, epsilon = 1e-5);
            }
        }
    }
}
