//! The four ways in which a joint can be at its limit, as conditions on the thrust `h` and the crown moment `p`.

use super::letters::ring;
use crate::arch::statics;
use crate::number::{Angle, Field};
use crate::symbolic::{Fraction, Letters, Polynomial, Symbol};

/// A joint at its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Contact {
    /// The line of thrust is on the extrados, `U = 0`.
    Extrados,
    /// The line of thrust is on the intrados, `L = 0`.
    Intrados,
    /// `T = mu N`: the part above slides inwards.
    Inwards,
    /// `-T = mu N`: the part above slides outwards.
    Outwards,
}

impl Contact {
    pub(super) const ALL: [Self; 4] =
        [Self::Extrados, Self::Intrados, Self::Inwards, Self::Outwards];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Extrados => "U",
            Self::Intrados => "L",
            Self::Inwards => "mu N - T",
            Self::Outwards => "mu N + T",
        }
    }

    /// What must not be negative at a joint.
    pub(super) fn margin(self, joint: &Angle<Fraction>) -> Fraction {
        let (h, p, mu) =
            (Symbol::Thrust.number(), Symbol::CrownMoment.number(), Symbol::Friction.number());
        let (ring, two) = (ring(), h.int(2));
        let (normal, shear) = (statics::normal_force(joint, &h), statics::shear_force(joint, &h));
        let moment = p + joint.versine() * &ring.centroid_factor;
        match self {
            Self::Extrados => ring.extrados() * normal / two - moment,
            Self::Intrados => moment - ring.intrados() * normal / two,
            Self::Inwards => mu * normal - shear,
            Self::Outwards => mu * normal + shear,
        }
    }

    /// The work of a unit thrust and of a unit crown moment on the motion of the joint: the contact gives way by
    /// itself, so a hinge turns about its face, and a joint slides along itself, without dilatancy.
    pub(super) fn row(self, joint: &Angle<Fraction>) -> [Fraction; 2] {
        let (ring, one) = (ring(), joint.cos.int(1));
        let half = |radius: Fraction| radius * &joint.cos / one.int(2);
        match self {
            Self::Extrados => [half(ring.extrados()), -one],
            Self::Intrados => [-half(ring.intrados()), one],
            Self::Inwards => [joint.sin.clone(), one.int(0)],
            Self::Outwards => [-joint.sin.clone(), one.int(0)],
        }
    }
}

/// `d/dh` and `d/dp` of a condition.
pub(super) fn slopes(condition: &Fraction) -> [Fraction; 2] {
    [Symbol::Thrust, Symbol::CrownMoment]
        .map(|symbol| condition.derivative(&[(symbol, Polynomial::from(1))]))
}
