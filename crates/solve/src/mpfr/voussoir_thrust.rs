//! Candidates for the range of thrusts of an arch of voussoirs at a given thickness, and for the friction it asks for.
//!
//! The room for the crown moment is a concave function of the thrust, made of straight pieces: from beyond an end
//! Newton's method reaches it in a few steps and never passes it.

use super::voussoirs::{Search, VoussoirCandidate, peak};
use crate::arch::joint::{Row, even_thrust};
use crate::arch::mechanism::Contact;
use crate::arch::statics::{normal_force, shear_force};
use crate::number::Ball;
use crate::problem::stones::JointContact;
use crate::start::Start;
use rug::Float;

/// The end of a range of thrusts that is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThrustSide {
    /// The least thrust.
    Least,
    /// The largest.
    Largest,
}

impl ThrustSide {
    /// Both sides.
    pub const BOTH: [Self; 2] = [Self::Least, Self::Largest];
}

/// Probable limit of the thrust.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ThrustEnd {
    /// A joint that slides or opens, or a hinge at the extrados and one at the intrados.
    At(Vec<JointContact>),
    /// Nothing limits the thrust.
    Unbounded,
    /// The first conditions ask for a larger thrust than the second allow.
    Contradiction([Vec<JointContact>; 2]),
}

/// Thrust at which the least friction is probably needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needed {
    /// The least friction is needed at the thrust at which this joint asks for as much as the shoulder.
    Even(u64),
    /// The least friction is needed at the least thrust, by the shoulder.
    AtLeast,
    /// The least friction is needed at the largest thrust, by this joint.
    AtLargest(u64),
}

/// Questions about an arch of voussoirs that a search answers, whatever its numbers are.
pub trait Searches {
    /// The least thickness with a thrust between the two at which something slides.
    fn candidate(&self) -> VoussoirCandidate;

    /// An end of the range of thrusts.
    fn thrust_end(&self, thickness: &Ball, side: ThrustSide) -> ThrustEnd;

    /// A crown moment between those of the hinges at the extrados and at the intrados.
    fn moment_between(&self, thrust: &Ball, thickness: &Ball) -> Float;

    /// Thrust at which the least friction is needed, of those between two.
    fn needed(&self, thrusts: [Option<&Ball>; 2]) -> Needed;
}

/// More rounds than pieces near an end.
const ROUNDS: usize = 100;

fn bounds<T: Start>(side: ThrustSide, row: &Row<T>) -> bool {
    match side {
        ThrustSide::Least => row.thrust < 0.0,
        ThrustSide::Largest => row.thrust > 0.0,
    }
}

/// Sum of the conditions on the thrust of one joint, or two hinges.
fn together<T: Start>(
    search: &Search<'_, T>,
    contacts: &[JointContact],
    thickness: &T,
) -> Option<Row<T>> {
    let rows = contacts.iter().map(|contact| search.row(*contact, thickness));
    rows.reduce(|sum, row| sum.plus(&row))
}

/// The joint at which the shear force is largest over the normal force.
fn steepest<T: Start>(search: &Search<'_, T>, thrust: &T) -> u64 {
    // At the crown it is zero.
    let first = u64::from(search.stones.has_joint_at_crown());
    peak(first, search.last(), |index| {
        let joint = search.angle(index);
        let (shear, normal) = (shear_force(&joint, thrust), normal_force(&joint, thrust));
        // A joint that opens asks for more than any other.
        let opens = normal < 0.0 || normal.exponent() < -i64::from(normal.bits() / 2);
        (opens, if opens { normal.int(0) } else { shear / normal })
    })
}

impl<T: Start> Searches for Search<'_, T> {
    fn candidate(&self) -> VoussoirCandidate {
        self.least()
    }

    fn thrust_end(&self, thickness: &Ball, side: ThrustSide) -> ThrustEnd {
        let thickness = &(self.near)(thickness);
        let (zero, last) = (thickness.int(0), self.last());
        let [slip, upper, lower] = match side {
            ThrustSide::Least => [
                (Contact::Inwards, self.inner()),
                (Contact::Extrados, 0),
                (Contact::Intrados, last),
            ],
            ThrustSide::Largest => {
                [(Contact::Outwards, last), (Contact::Extrados, last), (Contact::Intrados, 0)]
            }
        };
        let mut at: Option<(T, Vec<JointContact>)> = None;
        for contacts in [vec![slip], vec![upper, lower]] {
            let row = together(self, &contacts, thickness).filter(|row| bounds(side, row));
            let Some(thrust) = row.map(|row| row.bound()) else { continue };
            let is_tighter = at.as_ref().is_none_or(|(best, _)| match side {
                ThrustSide::Least => thrust > *best,
                ThrustSide::Largest => thrust < *best,
            });
            if is_tighter {
                at = Some((thrust, contacts));
            }
        }
        let Some((mut thrust, mut contacts)) = at else { return ThrustEnd::Unbounded };
        for _ in 0..ROUNDS {
            let [crown, shoulder] = [0, last].map(|joint| (Contact::Extrados, joint));
            let depth = |contact| self.row(contact, thickness).at(&thrust, &zero);
            let upper = if depth(crown) > depth(shoulder) { crown } else { shoulder };
            let pair = vec![upper, (Contact::Intrados, self.haunch(&thrust, thickness))];
            let Some(row) = together(self, &pair, thickness) else { break };
            if row.at(&thrust, &zero) <= zero || pair == contacts {
                break;
            }
            if !bounds(side, &row) {
                return ThrustEnd::Contradiction(match side {
                    ThrustSide::Least => [contacts, pair],
                    ThrustSide::Largest => [pair, contacts],
                });
            }
            thrust = row.bound();
            contacts = pair;
        }
        ThrustEnd::At(contacts)
    }

    fn moment_between(&self, thrust: &Ball, thickness: &Ball) -> Float {
        let [thrust, thickness] = &[thrust, thickness].map(|x| (self.near)(x));
        let moment = |contact| self.row(contact, thickness).moment_at(thrust);
        let [crown, shoulder] = [0, self.last()].map(|joint| moment((Contact::Extrados, joint)));
        let least = moment((Contact::Intrados, self.haunch(thrust, thickness)));
        let most = if crown < shoulder { crown } else { shoulder };
        self.to_float(&((most + least) / thrust.int(2)))
    }

    fn needed(&self, thrusts: [Option<&Ball>; 2]) -> Needed {
        let [least, largest] = thrusts.map(|thrust| thrust.map(|x| (self.near)(x)));
        let shoulder = self.angle(self.last());
        let mut joint = self.last().div_ceil(2);
        let mut thrust = even_thrust(&self.angle(joint), &shoulder);
        for _ in 0..ROUNDS {
            let next =
                steepest(self, least.as_ref().filter(|least| thrust < **least).unwrap_or(&thrust));
            if next == joint {
                break;
            }
            joint = next;
            thrust = even_thrust(&self.angle(joint), &shoulder);
        }
        match (least, largest) {
            (Some(least), _) if thrust < least => Needed::AtLeast,
            (_, Some(largest)) if thrust > largest => Needed::AtLargest(steepest(self, &largest)),
            _ => Needed::Even(joint),
        }
    }
}
