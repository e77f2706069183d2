//! The joints of each mode, from the shoulder to the crown, and their rates.
//!
//! The rates are the multipliers of [`contact`](crate::arch::contact), by which no thinner arch is proved to stand;
//! that of friction is the horizontal part of the slip.

use super::contact::{Contact, Joint};
use super::twist::Twist;
use crate::arch::{Configuration, Ring, contact, statics};
use crate::number::{Angle, Field};

/// The joints that give way together, with one degree of freedom.
#[derive(Clone, Debug)]
pub struct Mechanism<T> {
    /// Joints below the crown, from the shoulder: each has a block above it.
    pub joints: Vec<Joint<T>>,
    /// Joints at the crown: none if it stays closed, both hinges if it opens along the whole joint.
    pub crown: Vec<Joint<T>>,
}

impl<T: Field> Mechanism<T> {
    /// The hinge at the crown, unless it opens along the whole joint.
    pub fn crown_hinge(&self) -> Option<&Joint<T>> {
        match &self.crown[..] {
            [hinge] => Some(hinge),
            _ => None,
        }
    }

    /// Rate at which a crown that opens along its whole joint opens at the centreline, in units of `r`: the
    /// mean of what its two hinges open at the other face. `None` of a crown that turns or stays closed.
    pub fn opening(&self, thickness: &T) -> Option<T> {
        match &self.crown[..] {
            [inner, outer] => {
                Some((inner.rate.clone() + &outer.rate) * thickness / thickness.int(2))
            }
            _ => None,
        }
    }

    /// Mechanism beside a keystone, which is a block above the hinge of the crown and moves up and down only.
    pub fn below_keystone(mut self) -> Self {
        self.joints.append(&mut self.crown);
        self
    }

    /// The twists of the blocks, from the shoulder.
    pub fn twists(&self, thickness: &T) -> Vec<Twist<T>> {
        let add = |sum: &mut Twist<T>, joint: &Joint<T>| {
            *sum = sum.plus(&joint.twist(thickness));
            Some(sum.clone())
        };
        self.joints.iter().scan(Twist::zero(thickness), add).collect()
    }

    /// The rotation and the horizontal velocity behind the crown: both zero, if the motion is compatible.
    pub fn gap(&self, thickness: &T) -> [T; 2] {
        let all = self.joints.iter().chain(&self.crown);
        let sum = all.fold(Twist::zero(thickness), |sum, joint| sum.plus(&joint.twist(thickness)));
        let [across, _] = sum.velocity;
        [sum.rotation, across]
    }

    /// The power of the weight of the half arch.
    pub fn power(&self, ring: &Ring<T>) -> T {
        let crown = Angle::zero(&ring.thickness);
        let uppers = self.joints.iter().skip(1).map(|joint| &joint.at).chain([&crown]);
        let blocks = self.joints.iter().zip(uppers).zip(self.twists(&ring.thickness));
        let power = |((lower, upper), twist): ((&Joint<T>, &Angle<T>), Twist<T>)| {
            twist.power([upper, &lower.at], &ring.centroid_factor)
        };
        blocks.map(power).fold(ring.thickness.int(0), |sum, power| sum + power)
    }

    /// The power that friction takes without dilatancy, the sum of `mu N` times the slips.
    pub fn friction_power(&self, thrust: &T, friction: &T) -> T {
        let slides = self.joints.iter().filter(|joint| !joint.contact.is_hinge());
        slides.fold(thrust.int(0), |sum, joint| {
            let normal = statics::normal_force(&joint.at, thrust);
            sum + friction.clone() * normal * &joint.rate
        })
    }

    /// The rates times the margins of their contacts: what is zero in the state, term by term.
    pub fn complementarity(&self, ring: &Ring<T>, load: [&T; 3]) -> T {
        let all = self.joints.iter().chain(&self.crown);
        all.fold(ring.thickness.int(0), |sum, joint| {
            sum + joint.contact.margin(&joint.at, ring, load) * &joint.rate
        })
    }
}

fn hinge<T: Field>(contact: Contact, at: &Angle<T>, rate: T) -> Joint<T> {
    let dilatancy = rate.int(0);
    Joint { contact, at: at.clone(), rate, dilatancy }
}

/// A joint whose slip has a horizontal part.
fn slide<T: Field>(contact: Contact, at: &Angle<T>, across: &T, dilatancy: &T) -> Joint<T> {
    let rate = contact.slip(at, across, dilatancy);
    Joint { contact, at: at.clone(), rate, dilatancy: dilatancy.clone() }
}

/// `[r,r,r]`, with rotation one at the crown.
pub fn rotation<T: Field>(at: &Configuration<T>) -> Mechanism<T> {
    let rates = contact::rates_of_rotation(at);
    Mechanism {
        joints: vec![
            hinge(Contact::Extrados, &at.half_opening, rates.shoulder),
            hinge(Contact::Intrados, &at.rotation_joint, rates.haunch),
        ],
        crown: vec![hinge(Contact::Extrados, &at.crown_hinge, rates.crown)],
    }
}

/// `[s,r,r]`, with rotation one at the crown.
pub fn shoulder_sliding<T: Field>(at: &Configuration<T>, dilatancy: &T) -> Mechanism<T> {
    let rates = contact::rates_of_shoulder_sliding(at);
    Mechanism {
        joints: vec![
            slide(Contact::Outwards, &at.half_opening, &rates.sliding, dilatancy),
            hinge(Contact::Intrados, &at.rotation_joint, rates.haunch),
        ],
        crown: vec![hinge(Contact::Extrados, &at.crown_hinge, rates.crown)],
    }
}

/// `[r,r,s]`, with rotation one at the shoulder.
pub fn sliding_above_haunch<T: Field>(at: &Configuration<T>, dilatancy: &T) -> Mechanism<T> {
    let rates = contact::rates_of_inner_sliding(at);
    Mechanism {
        joints: vec![
            hinge(Contact::Extrados, &at.half_opening, rates.shoulder),
            hinge(Contact::Intrados, &at.rotation_joint, rates.haunch),
            slide(Contact::Inwards, &at.sliding_joint, &rates.sliding, dilatancy),
        ],
        crown: Vec::new(),
    }
}

/// `[r,s,r]`, with rotation one at the shoulder.
pub fn sliding_below_haunch<T: Field>(at: &Configuration<T>, dilatancy: &T) -> Mechanism<T> {
    let Mechanism { mut joints, crown } = sliding_above_haunch(at, dilatancy);
    joints.swap(1, 2);
    Mechanism { joints, crown }
}

/// `[r,s]`, with rotation one at the shoulder: `[r,s,r]` with its upper hinge at the crown.
pub fn overturning_sliding<T: Field>(at: &Configuration<T>, dilatancy: &T) -> Mechanism<T> {
    let Mechanism { mut joints, .. } = sliding_below_haunch(at, dilatancy);
    let crown = joints.split_off(2);
    Mechanism { joints, crown }
}

/// `[r]`, with rotation one at the shoulder. The crown opens along the whole joint, without thrust: it is at both
/// faces.
pub fn overturning<T: Field>(at: &Configuration<T>) -> Mechanism<T> {
    let rates = contact::rates_of_inner_sliding(at);
    let (crown, outer) = (Angle::zero(&at.thickness), rates.sliding / &at.thickness);
    Mechanism {
        joints: vec![hinge(Contact::Extrados, &at.half_opening, rates.shoulder)],
        crown: vec![
            hinge(Contact::Intrados, &crown, rates.haunch + &outer),
            hinge(Contact::Extrados, &crown, outer),
        ],
    }
}

/// `[s,s]`, with slip one at the shoulder if nothing opens.
pub fn sliding<T: Field>(at: &Configuration<T>, dilatancy: &T) -> Mechanism<T> {
    let across = &at.half_opening.sin;
    Mechanism {
        joints: vec![
            slide(Contact::Outwards, &at.half_opening, across, dilatancy),
            slide(Contact::Inwards, &at.sliding_joint, across, dilatancy),
        ],
        crown: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use rug::Rational;

    type Exact = Rational;

    fn at() -> Configuration<Exact> {
        Configuration::rational()
    }

    /// With a keystone of some width.
    fn keystone() -> Configuration<Exact> {
        let angle = Angle { rad: (1, 5).into(), sin: (9, 41).into(), cos: (40, 41).into() };
        Configuration { crown_hinge: angle, ..at() }
    }

    fn all(dilatancy: &Exact) -> Vec<(Configuration<Exact>, Mechanism<Exact>)> {
        let crown = Configuration { rotation_joint: Angle::zero(&Exact::new()), ..at() };
        vec![
            (at(), rotation(&at())),
            (at(), shoulder_sliding(&at(), dilatancy)),
            (keystone(), rotation(&keystone()).below_keystone()),
            (keystone(), shoulder_sliding(&keystone(), dilatancy).below_keystone()),
            (at(), sliding_above_haunch(&at(), dilatancy)),
            (at(), sliding_below_haunch(&at(), dilatancy)),
            (crown.clone(), overturning_sliding(&crown, dilatancy)),
            (crown.clone(), overturning(&crown)),
            (at(), sliding(&at(), dilatancy)),
        ]
    }

    fn is_compatible(at: &Configuration<Exact>, mechanism: &Mechanism<Exact>) -> bool {
        mechanism.gap(&at.thickness) == [Exact::new(), Exact::new()]
    }

    #[test]
    fn every_mode_is_compatible_with_positive_rates() {
        for dilatancy in [Exact::new(), at().friction] {
            for (at, mechanism) in all(&dilatancy) {
                assert!(is_compatible(&at, &mechanism));
                let mut joints = mechanism.joints.iter().chain(&mechanism.crown);
                assert!(joints.all(|joint| joint.rate > 0));
            }
        }
    }

    #[test]
    fn a_false_twin_is_not_compatible() {
        for (at, mechanism) in all(&at().friction) {
            for place in 0..mechanism.joints.len() {
                let spoiled = |spoil: &dyn Fn(&mut Joint<Exact>)| {
                    let mut twin = mechanism.clone();
                    spoil(&mut twin.joints[place]);
                    !is_compatible(&at, &twin)
                };
                assert!(spoiled(&|joint| joint.rate = -joint.rate.clone()), "turned the other way");
                match mechanism.joints[place].contact {
                    Contact::Extrados => {
                        assert!(spoiled(&|joint| joint.contact = Contact::Intrados), "wrong face");
                    }
                    Contact::Intrados => {
                        assert!(spoiled(&|joint| joint.contact = Contact::Extrados), "wrong face");
                    }
                    _ => {
                        assert!(spoiled(&|joint| joint.dilatancy = Exact::new()), "one joint only")
                    }
                }
            }
        }
    }

    /// The weight works by as much as friction takes, but for what the margins leave: for any thrust and crown moment.
    #[test]
    fn the_power_of_the_weight_is_that_of_the_forces() {
        let load = [Exact::from((1, 5)), (2, 7).into(), (5, 4).into()];
        let load = load.each_ref();
        for weight in SelfWeight::ALL {
            for dilatancy in [Exact::new(), at().friction] {
                for (at, mechanism) in all(&dilatancy) {
                    let ring = Ring::new(weight, &at.thickness);
                    let mut taken = -mechanism.complementarity(&ring, load);
                    if dilatancy == 0 {
                        taken += mechanism.friction_power(load[0], load[2]);
                    }
                    assert_eq!(mechanism.power(&ring), taken);
                }
            }
        }
    }
}
