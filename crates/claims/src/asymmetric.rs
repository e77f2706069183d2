//! Above the least thickness some horseshoes have an asymmetric mechanism without dilatancy: Eq. (19) on the whole
//! arch does not have its solution at one thickness.
//!
//! The usual argument of the static theorem takes friction as associated. In symmetric states the slips can be
//! scaled, so that it holds all the same; where a vertical force in the crown works too, it does not. The examples
//! are certified: [`certify::asymmetric`](crate::certify::asymmetric()).

use super::along::{parsed, standing};
use super::letters::{forces, ring};
use super::measured::shown;
use super::{Checked, Derivation, claims, lemmas};
use crate::arch::SelfWeight;
use crate::arch::asymmetric::{Asymmetric, AsymmetricMode};
use crate::arch::joint::Grip;
use crate::arch::whole::WholeMotion;
use crate::certify::CertifiedAsymmetric;
use crate::certify::state::Certify;
use crate::number::{Angle, Ball, Field};
use crate::symbolic::{Fraction, Letters, Relations, Symbol};

claims! {
    Ours("asymmetric-motion", "Eq. (19)", motion):
        "three kinds of asymmetric mechanisms fit, by a sliding shoulder, hinges at the crown and at the far haunch, \
         and an inner joint that slides, the shoulder that opens too, or neither; where their joints are at their \
         limits the weight works by as much as friction takes";
    Implicit("unique-asymmetric", "Sec. 5", other_thicknesses):
        "the least thickness is unique among symmetric motions (unique-thickness), and not among all: some horseshoes \
         have asymmetric solutions of (19) at larger thicknesses, for either weight and of three kinds";
}

/// The variables as letters; `b0` has none of its own.
pub(super) fn variables() -> Asymmetric<Fraction> {
    let one = Symbol::Thrust.number().int(1);
    Asymmetric {
        half_opening: Symbol::half_opening(),
        grip: Grip { shear: one, normal: Symbol::Friction.number() },
        thickness: Symbol::Thickness.number(),
        forces: forces(),
        crown_hinge: Angle {
            rad: Symbol::Radius.number(),
            sin: Symbol::F.number(),
            cos: Symbol::G.number(),
        },
        haunch: Symbol::joint(),
        sliding_joint: Symbol::sliding_joint(),
    }
}

/// The power of the weight less that of friction, and the margins at the hinges times their rates.
fn balance(motion: &WholeMotion<Fraction>, at: &Asymmetric<Fraction>) -> [Fraction; 2] {
    let ring = ring();
    let left = motion.power(&ring) - motion.friction_power(&at.forces);
    let terms = motion.complementarity(&ring, &at.grip, &at.forces);
    let hinges = motion.0.iter().zip(terms).filter(|(joint, _)| joint.contact.is_hinge());
    let sum = hinges.fold(left.int(0), |sum, (_, term)| sum + term);
    [left, sum]
}

fn motion(d: &mut Derivation) -> Checked {
    use AsymmetricMode::{InnerSliding, ShoulderOpening, ShoulderSliding};
    let (at, free) = (variables(), Relations::none());
    let (eta, none) = (at.thickness.clone(), at.thickness.int(0));
    d.define("b0, the hinge right of the crown", &at.crown_hinge.rad);
    d.define("sin(b0)", &at.crown_hinge.sin);
    d.define("cos(b0)", &at.crown_hinge.cos);
    d.define("b1, the hinge left of the crown", &at.haunch.rad);
    d.define("b2, the joint left of it that slides inwards", &at.sliding_joint.rad);
    for mode in [InnerSliding, ShoulderOpening] {
        let motion = at.motion(mode);
        for (words, gap) in ["the horizontal velocity", "the rotation", "the vertical velocity"]
            .iter()
            .zip(motion.gap(&eta))
        {
            d.identity(format!("{}: {words} beyond the left haunch", mode.name()), &gap, &none)?;
        }
        let [left, hinges] = balance(&motion, &at);
        let words = format!("{}: what the weight works, less what friction takes", mode.name());
        let shown = String::from("-(the margins at the hinges, times their rates)");
        d.identity_as(words, &left, &-hinges, &free, shown.into())?;
    }
    let misfit = at.closing(ShoulderSliding, SelfWeight::Heyman).swap_remove(0);
    let first = at.motion(InnerSliding);
    let (alpha, slides) = (&at.half_opening, &at.sliding_joint);
    let sum = alpha.sin.clone() * &slides.cos + alpha.cos.clone() * &slides.sin;
    let inner = first.0[2].rate.clone() * sum * none.int(2);
    d.identity("the slip of the inner joint, times 2 sin(alpha + b2)", &inner, &misfit)?;
    let alone = at.motion(ShoulderSliding);
    let gap = alone.gap(&eta);
    let words = "without it: the vertical velocity beyond the left haunch";
    let expected = -(misfit / (alpha.sin.clone() * none.int(2)));
    d.identity(words, &gap[2], &expected)?;
    d.conclude(
        "The left springing stays, and so the part of the arch beyond the left haunch has to. The third kind is the \
         first with an inner slip of zero. In a solution of (19) the margin at each hinge is zero, and |T| = mu N \
         where a joint slides.",
    )
}

/// Arches whose solutions are certified: for each weight one of each kind.
const WITNESSES: [(SelfWeight, &str, &str, AsymmetricMode); 6] = [
    (SelfWeight::Milankovitch, "2.3", "1.05", AsymmetricMode::InnerSliding),
    (SelfWeight::Milankovitch, "2.3", "1.07", AsymmetricMode::ShoulderOpening),
    (SelfWeight::Milankovitch, "2.25", "0.99", AsymmetricMode::ShoulderSliding),
    (SelfWeight::Heyman, "2.3", "1.09", AsymmetricMode::InnerSliding),
    (SelfWeight::Heyman, "2.3", "1.09", AsymmetricMode::ShoulderOpening),
    (SelfWeight::Heyman, "2.25", "1.01", AsymmetricMode::ShoulderSliding),
];

/// Bits of the witnesses.
const BITS: u32 = 128;
/// Digits that are shown of them.
const DIGITS: usize = 12;

/// The least thickness of an arch, and that of its asymmetric solution of a kind.
fn thicknesses(
    (weight, alpha, mu, mode): (SelfWeight, &str, &str, AsymmetricMode),
) -> Checked<[Ball; 2]> {
    let arch = parsed(weight, alpha, mu)?;
    let least = standing(arch.state(BITS)?)?.thickness;
    let CertifiedAsymmetric { at, .. } = CertifiedAsymmetric::of(&arch, mode, BITS)?;
    Ok([least, at.thickness])
}

fn other_thicknesses(d: &mut Derivation) -> Checked {
    lemmas(d, ["unique-thickness", "asymmetric-motion"])?;
    for witness in WITNESSES {
        let (weight, alpha, mu, mode) = witness;
        let [least, other] = thicknesses(witness)?;
        let [shown, least_shown] = [shown(&other, DIGITS)?, shown(&least, DIGITS)?];
        let name = format!("{weight}, alpha = {alpha}, mu = {mu}");
        let words = format!(
            "{name}: {}, a solution admissible at every joint of the whole arch, with positive rates, at eta = \
             {shown}, above the least thickness {least_shown}",
            mode.name()
        );
        d.less(words, [&least, &other])?;
    }
    d.conclude(
        "Each is a solution of (19): its equations have one root in a box, by Krawczyk's test; balls cover the arch; \
         the blocks fit, and each rate is positive. The mirror image is one too. What the least thickness is does not \
         change: below it nothing is admissible. The paper says that none was recorded; its references on the \
         programme, [7, 8], were not at hand.",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::mechanism::Joint;
    use crate::arch::whole::Side;

    /// The first kind with one rate turned the other way does not fit, and its power is another.
    #[test]
    fn a_rate_with_the_wrong_sign_does_not_fit() {
        let at = variables();
        let motion = at.motion(AsymmetricMode::InnerSliding);
        let free = Relations::none();
        for place in 0..4 {
            let mut twin = motion.clone();
            let Joint { rate, .. } = &mut twin.0[place];
            *rate = -rate.clone();
            let gap = twin.gap(&at.thickness);
            assert!(!gap.iter().all(|part| part.vanishes(&free)), "{place}");
            let [left, hinges] = balance(&twin, &at);
            assert!(!(left + hinges).vanishes(&free), "{place}");
        }
    }

    /// A haunch on the side of the sliding shoulder is no such mechanism.
    #[test]
    fn a_hinge_on_the_other_side_does_not_fit() {
        let at = variables();
        let mut motion = at.motion(AsymmetricMode::InnerSliding);
        motion.0[3].at = Side::Left.joint(&motion.0[3].at);
        assert!(!motion.gap(&at.thickness)[2].vanishes(&Relations::none()));
    }

    /// Where the arch has no such solution the proof says so.
    #[test]
    fn an_arch_without_one_proves_nothing() {
        let (weight, mode) = (SelfWeight::Heyman, AsymmetricMode::InnerSliding);
        for (alpha, mu) in [("1.5", "0.6"), ("2.15", "0.8"), ("2.3", "1.2"), ("2.25", "1.01")] {
            assert!(thicknesses((weight, alpha, mu, mode)).is_err(), "{alpha} {mu}");
        }
    }
}
