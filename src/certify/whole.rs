//! Admissible at every joint of the whole arch, by balls that cover it.
//!
//! The margins of [`whole`](crate::arch::whole) have to be not negative on `[-alpha, alpha]`. Next to a joint where one touches
//! zero, its slope being zero too, a positive curvature proves it, and next to the right springing, where one may be zero, a slope
//! that falls; elsewhere it is positive, by Taylor's theorem on each piece.

use super::Undecided;
use super::cover::{between, cover};
use crate::arch::Ring;
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::whole::{Forces, margin_along};
use crate::number::{Angle, Ball, Enclosure, Field, Jet};
use rug::Rational;

/// The state of a whole arch.
pub(super) struct Whole<'a> {
    pub half_opening: &'a Ball,
    pub ring: Ring<Ball>,
    pub grip: Grip<Ball>,
    pub forces: Forces<Ball>,
}

/// A joint at its limit, by the sign of its condition.
pub(super) struct Touching {
    pub contact: Contact,
    /// Inside the arch, where the slope of the margin is zero too; `None` at the right springing.
    pub joint: Option<Ball>,
}

/// Bits of the pieces, as those of [`cover`].
const BITS: u32 = 96;
/// How often the neighbourhood of a joint is halved.
const HALVINGS: u32 = 20;

impl Whole<'_> {
    /// Proves that no margin is negative at any joint. Where one is zero is given: that it is so at the root is proved before.
    pub(super) fn is_admissible(&self, touching: &[Touching]) -> Result<(), Undecided> {
        for contact in Contact::ALL {
            let own = touching.iter().filter(|touching| touching.contact == contact);
            let joints: Vec<Option<&Ball>> = own.map(|touching| touching.joint.as_ref()).collect();
            self.is_nowhere_negative(contact, &joints).map_err(|undecided| {
                let what = match contact {
                    Contact::Extrados => "the distance from the extrados",
                    Contact::Intrados => "the distance from the intrados",
                    Contact::Inwards => "mu N - T",
                    Contact::Outwards => "mu N + T",
                };
                undecided.about(what)
            })?;
        }
        Ok(())
    }

    fn is_nowhere_negative(
        &self,
        contact: Contact,
        joints: &[Option<&Ball>],
    ) -> Result<(), Undecided> {
        let right = rational(&self.half_opening.upper())?;
        let mut open = vec![(-right.clone(), right.clone())];
        for joint in joints {
            let (from, to, order, sign) = match joint {
                Some(joint) => (rational(&joint.lower())?, rational(&joint.upper())?, 2, 1),
                None => (rational(&self.half_opening.lower())?, right.clone(), 1, -1),
            };
            let holds = |width: &Rational| {
                let near = between(&Rational::from(&from - width), &Rational::from(&to + width));
                let derivative = self.series(contact, near).coefficient(order);
                (derivative.int(sign) * derivative).is_positive().is_proved()
            };
            let widths = (2..HALVINGS).map(|k| Rational::from((1, 1i32 << k)));
            let width = widths.into_iter().find(holds).ok_or_else(|| {
                Undecided::new("a joint at its limit is not told from those beside it")
            })?;
            let (from, to) = (from - &width, to + width);
            open = open.into_iter().flat_map(|stretch| without(stretch, &from, &to)).collect();
        }
        open.iter().try_for_each(|(low, high)| {
            cover(low, high, &|piece| self.lower_bound(contact, piece).is_positive()).map(drop)
        })
    }

    /// The margin on a piece: its value and slope in the middle, and its curvature on all of it.
    fn lower_bound(&self, contact: Contact, piece: &Ball) -> Ball {
        let middle = self.series(contact, piece.midpoint());
        let bend = self.series(contact, piece.clone()).coefficient(2);
        let offset = piece.centred();
        middle.coefficient(1) * &offset + middle.value() + bend * offset.square()
    }

    fn series(&self, contact: Contact, joint: Ball) -> Jet<Ball> {
        let few = |x: &Ball| x.with_precision(BITS);
        let ring = Ring {
            thickness: few(&self.ring.thickness),
            centroid_factor: few(&self.ring.centroid_factor),
        };
        let Forces { thrust, moment, vertical } = &self.forces;
        let forces = Forces { thrust: few(thrust), moment: few(moment), vertical: few(vertical) };
        let grip = self.grip.clone().map(|x| few(&x));
        margin_along(contact, &Angle::new(joint), &ring, &grip, &forces)
    }
}

fn rational(x: &rug::Float) -> Result<Rational, Undecided> {
    x.to_rational().ok_or_else(|| Undecided::new("a joint is not bounded"))
}

/// What is left of a stretch without what lies between two places.
fn without(
    (low, high): (Rational, Rational),
    from: &Rational,
    to: &Rational,
) -> Vec<(Rational, Rational)> {
    let before = (low.clone(), from.clone().min(high.clone()));
    let after = (to.clone().max(low), high);
    [before, after].into_iter().filter(|(low, high)| low < high).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;

    #[test]
    fn a_stretch_is_cut_out() {
        let r = |n: i32| Rational::from(n);
        assert_eq!(without((r(0), r(9)), &r(3), &r(4)), [(r(0), r(3)), (r(4), r(9))]);
        assert_eq!(without((r(0), r(9)), &r(8), &r(12)), [(r(0), r(8))]);
        assert_eq!(without((r(0), r(9)), &r(-2), &r(1)), [(r(1), r(9))]);
        assert_eq!(without((r(0), r(9)), &r(10), &r(12)), [(r(0), r(9))]);
        assert!(without((r(3), r(4)), &r(2), &r(5)).is_empty());
    }

    /// A semicircle well above its least thickness, in a state with room everywhere, and states of it that have none.
    #[test]
    fn a_state_with_room_is_admissible_and_its_twins_are_not() {
        let like = Ball::integer(0, 128);
        let alpha = like.ratio(11, 7);
        let admissible = |moment: (i32, i32), friction: (i32, i32), vertical: (i32, i32)| {
            let ratio = |(n, d): (i32, i32)| like.ratio(n, d);
            let whole = Whole {
                half_opening: &alpha,
                ring: Ring::new(SelfWeight::Heyman, &like.ratio(1, 4)),
                grip: Grip { shear: like.int(1), normal: ratio(friction) },
                forces: Forces {
                    thrust: ratio((62, 100)),
                    moment: ratio(moment),
                    vertical: ratio(vertical),
                },
            };
            whole.is_admissible(&[]).is_ok()
        };
        assert!(admissible((62, 100), (1, 1), (0, 1)));
        assert!(admissible((62, 100), (1, 1), (1, 50)), "a little vertical force");
        assert!(!admissible((54, 100), (1, 1), (0, 1)), "the intrados of the crown");
        assert!(!admissible((70, 100), (1, 1), (0, 1)), "the extrados of the crown");
        assert!(!admissible((62, 100), (1, 3), (0, 1)), "the shoulders slide");
        assert!(!admissible((62, 100), (1, 1), (1, 2)), "too much vertical force");
    }
}
