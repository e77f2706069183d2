//! The joints of an arch of voussoirs, symmetric about its crown.

use super::{Arch, ArchError, Friction, Mode};
use crate::arch::SelfWeight;
use crate::arch::mechanism::Contact;
use crate::number::{Angle, AstroInterval, Dyadic, Enclosure, Engine, ExactNumber, Form, says};
use num_rational::BigRational;

/// Division of the half arch, from the crown to the shoulder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stones {
    /// The whole arch in so many stones of the same angle. An odd number has a keystone, an even one a joint at the
    /// crown.
    Equal {
        /// Number of stones, at least two.
        stones: u64,
        /// The half opening.
        half_opening: ExactNumber,
    },
    /// Joints of the half arch by their angles, rising; the last is the shoulder. If the first is not at the crown,
    /// a keystone lies above it.
    Joints(Vec<ExactNumber>),
}

/// A joint at its limit, by its index from the crown.
pub type JointContact = (Contact, u64);

/// Stones beyond this number are refused: their joints are thinner than any tool.
pub const MOST_STONES: u64 = 1_000_000_000;

/// Reason why stones are refused.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StonesError {
    /// One stone has no joint inside, and more than can be counted no thickness.
    Number(u64),
    /// One angle is a shoulder without a stone's end above it.
    Few(usize),
    /// A joint is not above the one before it, or this cannot be told.
    Order(String, String),
    /// The half opening is not between 0 and pi.
    HalfOpening(ArchError),
    /// A joint above the crown.
    Crown(String),
}

says!(StonesError {
    Self::Number(stones) => "{stones} is no number of stones: give one from 2 to {MOST_STONES}";
    Self::Few(angles) =>
        "{angles} angles are too few: give those of two joints or more, from the crown to the shoulder";
    Self::Order(first, second) =>
        "the joints do not rise from {first} to {second}: give their angles from the crown to the shoulder";
    Self::Crown(joint) =>
        "the joint {joint} is above the crown: the first angle is 0, or that of the keystone's joint";
} from {
    ArchError => Self::HalfOpening;
});

impl Stones {
    /// Divides the half arch into so many stones of the same angle.
    pub fn equal(stones: u64, half_opening: ExactNumber) -> Result<Self, StonesError> {
        let made = Self::Equal { stones, half_opening };
        made.check().map(|()| made)
    }

    /// Joints by their angles.
    pub fn joints(angles: Vec<ExactNumber>) -> Result<Self, StonesError> {
        let made = Self::Joints(angles);
        made.check().map(|()| made)
    }

    /// Tells whether the stones are those of an arch, from the crown to the shoulder.
    pub fn check(&self) -> Result<(), StonesError> {
        let angles = match self {
            Self::Equal { stones, .. } if !(2..=MOST_STONES).contains(stones) => {
                return Err(StonesError::Number(*stones));
            }
            Self::Equal { half_opening, .. } => return Ok(between_zero_and_pi(half_opening)?),
            Self::Joints(angles) => angles,
        };
        if angles.len() < 2 {
            return Err(StonesError::Few(angles.len()));
        }
        between_zero_and_pi(&angles[angles.len() - 1])?;
        let enclosure = |x: &ExactNumber| x.enclosure::<AstroInterval>(BITS);
        let is_below =
            |a: &ExactNumber, b: &ExactNumber| enclosure(a).is_less_than(&enclosure(b)).is_proved();
        let zero = ExactNumber::rational(num_bigint::BigInt::ZERO.into());
        if !is_zero(&angles[0]) && !is_below(&zero, &angles[0]) {
            return Err(StonesError::Crown(angles[0].to_string()));
        }
        match angles.windows(2).find(|pair| !is_below(&pair[0], &pair[1])) {
            Some(pair) => Err(StonesError::Order(pair[0].to_string(), pair[1].to_string())),
            None => Ok(()),
        }
    }

    /// The stones of the whole arch.
    pub fn number(&self) -> u64 {
        match self {
            Self::Equal { stones, .. } => *stones,
            Self::Joints(_) => 2 * self.count() - 1 - u64::from(self.has_joint_at_crown()),
        }
    }

    /// The joints of the half arch, shoulder and, where there is one, crown included.
    pub fn count(&self) -> u64 {
        match self {
            Self::Equal { stones, .. } => stones / 2 + 1,
            Self::Joints(angles) => angles.len() as u64,
        }
    }

    /// The half opening.
    pub fn half_opening(&self) -> &ExactNumber {
        match self {
            Self::Equal { half_opening, .. } => half_opening,
            // There are two at least.
            Self::Joints(angles) => &angles[angles.len() - 1],
        }
    }

    /// Tells whether the first joint is at the crown.
    pub fn has_joint_at_crown(&self) -> bool {
        match self {
            Self::Equal { stones, .. } => stones % 2 == 0,
            Self::Joints(angles) => is_zero(&angles[0]),
        }
    }

    /// Tells whether a joint that is about to slide inwards has no normal force: with unlimited friction, and
    /// at the crown, where the shear force is zero.
    pub fn may_open(&self, joint: u64, is_limited: bool) -> bool {
        !is_limited || joint == 0 && self.has_joint_at_crown()
    }

    /// Description of the limit that a joint is at, in words.
    pub fn at_limit(&self, (contact, joint): JointContact, is_limited: bool) -> &'static str {
        match contact {
            slip if !slip.is_hinge() && self.may_open(joint, is_limited) => "opens",
            other => other.name(),
        }
    }

    /// Number of a joint as it is told, counted from the crown, which is no joint of a keystone.
    pub fn from_crown(&self, joint: u64) -> u64 {
        joint + u64::from(!self.has_joint_at_crown())
    }

    /// Place of a joint, in words.
    pub fn place(&self, joint: u64) -> String {
        match joint {
            0 if self.has_joint_at_crown() => "at the crown".to_owned(),
            joint if joint + 1 == self.count() => "at the shoulder".to_owned(),
            joint => format!("at joint {}", self.from_crown(joint)),
        }
    }

    /// Mode in which an arch with these contacts collapses, by its label from the shoulder; `None` for
    /// contacts that are no mechanism of the seven.
    pub fn mode(&self, contacts: &[JointContact; 3], is_limited: bool) -> Option<Mode> {
        let shoulder = self.count() - 1;
        Some(match *contacts {
            [(Contact::Extrados, 0), (Contact::Intrados, _), (Contact::Extrados, last)]
                if last == shoulder =>
            {
                Mode::Rotational
            }
            [(Contact::Extrados, 0), (Contact::Intrados, _), (Contact::Outwards, last)]
                if last == shoulder && is_limited =>
            {
                Mode::SlidingRotational
            }
            [(Contact::Inwards, slides), (Contact::Intrados, turns), (Contact::Extrados, last)]
                if last == shoulder =>
            {
                match (turns, is_limited) {
                    (0, _) if slides == 0 && self.may_open(0, is_limited) => Mode::Overturning,
                    (_, false) => return None,
                    (0, true) if self.has_joint_at_crown() => Mode::OverturningSliding,
                    (turns, true) if turns >= slides => Mode::RotationalSliding,
                    (_, true) => Mode::RotationalSlidingRotational,
                }
            }
            _ => return None,
        })
    }

    /// Angle of a joint, exactly, where it is a rational number of radians.
    pub fn exact_joint(&self, index: u64) -> Option<ExactNumber> {
        self.factor(index, Form::Rational).map(ExactNumber::rational)
    }

    /// The angle of a joint over pi, where it is a rational multiple of pi.
    pub fn exact_turn(&self, index: u64) -> Option<BigRational> {
        self.factor(index, Form::TimesPi)
    }

    /// Factor that belongs to a joint that is given in a form whose multiples have it too.
    fn factor(&self, index: u64, form: Form) -> Option<BigRational> {
        let (of, factor) = match self {
            Self::Equal { stones, half_opening } => {
                let part = |n: u64| num_bigint::BigInt::from(n);
                let share = BigRational::new(part(2 * index + stones % 2), part(*stones));
                (half_opening, half_opening.factor() * share)
            }
            Self::Joints(angles) => {
                let angle = angles.get(index as usize)?;
                (angle, angle.factor().clone())
            }
        };
        (of.form() == form).then_some(factor)
    }

    /// The place of a joint; the crown is zero exactly.
    pub fn angle<E: Engine>(&self, index: u64, bits: u32) -> Angle<E> {
        let crown = index == 0 && self.has_joint_at_crown();
        let zero = E::zero(bits as usize);
        if crown { Angle::zero(&zero) } else { Angle::new(self.joint(index, bits)) }
    }

    /// The index of the shoulder.
    pub fn last(&self) -> u64 {
        self.count() - 1
    }

    /// The angle of a joint below [`count`](Self::count) from the crown, in numbers of `bits` bits, rad.
    pub fn joint<E: Engine>(&self, index: u64, bits: u32) -> E {
        match self {
            Self::Equal { stones, half_opening } => {
                let whole = |n: u64| E::exact(&Dyadic::new(false, vec![n], 0), bits as usize);
                let alpha: E = half_opening.enclosure(bits);
                whole(2 * index + stones % 2) * alpha / whole(*stones)
            }
            Self::Joints(angles) => angles[(index as usize).min(angles.len() - 1)].enclosure(bits),
        }
    }
}

/// Bits in which the order of joints is told.
const BITS: u32 = 512;

fn between_zero_and_pi(half_opening: &ExactNumber) -> Result<(), ArchError> {
    let any = SelfWeight::Milankovitch;
    Arch::new(any, half_opening.clone(), Friction::Infinite).map(|_| ())
}

fn is_zero(x: &ExactNumber) -> bool {
    x.factor().numer().sign() == num_bigint::Sign::NoSign
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Field;

    fn number(text: &str) -> ExactNumber {
        text.parse().unwrap()
    }

    #[test]
    fn equal_stones_have_their_joints() {
        for (stones, count, crown) in [(2, 2, true), (3, 2, false), (10, 6, true), (11, 6, false)] {
            let arch = Stones::equal(stones, number("1")).unwrap();
            assert_eq!((arch.count(), arch.has_joint_at_crown()), (count, crown), "{stones}");
            let last: AstroInterval = arch.joint(count - 1, 100);
            assert!(last.overlaps(&last.int(1)), "the shoulder: {stones}");
            let first: AstroInterval = arch.joint(0, 100);
            let keystone = if crown { first.int(0) } else { first.ratio(1, stones as i32) };
            assert!(first.overlaps(&keystone), "{stones}");
            let step = arch.joint::<AstroInterval>(1, 100) - &first;
            assert!(step.overlaps(&first.ratio(2, stones as i32)), "{stones}");
        }
    }

    #[test]
    fn joints_have_to_rise_from_the_crown() {
        let joints =
            |texts: &[&str]| Stones::joints(texts.iter().map(|text| number(text)).collect());
        let given = joints(&["0", "0.1", "20deg", "pi/2"]).unwrap();
        assert_eq!((given.count(), given.half_opening()), (4, &number("pi/2")));
        assert!(!joints(&["0.1", "1"]).unwrap().has_joint_at_crown());
        assert_eq!(joints(&["1"]), Err(StonesError::Few(1)));
        assert!(matches!(joints(&["-0.1", "1"]), Err(StonesError::Crown(_))));
        assert!(matches!(joints(&["0", "1", "1"]), Err(StonesError::Order(..))));
        assert!(matches!(joints(&["0", "90deg", "1.5"]), Err(StonesError::Order(..))));
        for wrong in [0, 1, MOST_STONES + 1] {
            assert_eq!(Stones::equal(wrong, number("1")), Err(StonesError::Number(wrong)));
        }
    }
}
