//! An assembly of stones that is by a margin beside a threshold: the question whether it stands, with the proved
//! answer.
//!
//! **Stands** is the verdict of statics: there are forces at the joints, the springings among them, that hold the
//! weights of all stones, press inside every joint, and pass `|T| <= mu N` nowhere. The conditions are convex and the
//! assembly is its own mirror image, so that a symmetric state is there if any is. Friction without dilatancy may let
//! move what stands; what falls has no such forces, whatever the flow rule.
//!
//! **A threshold** is the least thickness at a friction, or the least friction at a thickness: thicker assemblies,
//! and those of more friction, stand too ([`voussoirs`]).

use super::margin::Margin;
use crate::arch::joint::Grip;
use crate::arch::mechanism::Contact;
use crate::arch::{Ring, SelfWeight};
use crate::certify::state::Figure;
use crate::number::{Ball, Enclosure, ExactNumber, Field, Rounded, worded};
use crate::problem::measures::{Length, Measures};
use crate::problem::stones::{JointContact, Stones};
use crate::problem::{Friction, Mode};
use couplet_stones::{
    VoussoirAssessment, VoussoirLimit, VoussoirStanding, Voussoirs, assess_voussoirs, voussoirs,
};
use rug::Rational;

worded! {
    /// Number that is near its threshold.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Near {
        /// The friction coefficient, at the given thickness.
        Friction = "friction",
        /// The thickness `t/r`, at the given friction.
        Thickness = "thickness",
    }
    /// Both of them.
    pub const ALL;
    /// The name in files.
    pub fn name -> &'static str;
}

/// Measures of an assembly in metres, as they are written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Surveyed {
    /// The span.
    pub span: String,
    /// The rise.
    pub rise: String,
    /// The circle at which both are measured, and its radius.
    pub measures: Measures,
}

/// Proof of a verdict that other arithmetic can repeat.
#[derive(Clone, Debug)]
pub enum AssemblyProof {
    /// A state that passes no condition at any joint: `h`, and the crown moment about the centre, over `w r²`.
    Stands {
        /// `h`.
        thrust: ExactNumber,
        /// Crown moment.
        moment: ExactNumber,
    },
    /// Conditions that ask for a larger thrust, the first, than others bear, the second.
    Falls(Box<[VoussoirLimit; 2]>),
}

/// Question about an assembly of stones, with its answer.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Assembly {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The stones, all of the same angle.
    pub stones: Stones,
    /// The friction coefficient.
    pub friction: ExactNumber,
    /// `t/r`.
    pub thickness: ExactNumber,
    /// The thickness as it is written: that number, or a length.
    pub thickness_text: String,
    /// Span and rise, if it is measured; the radius of the centreline is one otherwise.
    pub surveyed: Option<Surveyed>,
    /// Number that is near its threshold.
    pub near: Near,
    /// Distance of the number from it.
    pub margin: Margin,
    /// The threshold of that number.
    pub threshold: Figure,
    /// The number over its threshold.
    pub safety: Figure,
    /// Mode of the mechanism at the threshold, where it is one of the seven.
    pub mode: Option<Mode>,
    /// Contacts of that mechanism, on the half arch.
    pub contacts: Vec<JointContact>,
    /// Proof of the verdict.
    pub proof: AssemblyProof,
}

/// An assembly before its number near the threshold is known.
pub(super) struct Base {
    pub weight: SelfWeight,
    pub stones: Stones,
    pub surveyed: Option<Surveyed>,
    pub margin: Margin,
}

/// Digits of what is proved, and of a number near its threshold.
const DIGITS: usize = 12;
const GIVEN_DIGITS: usize = 7;
/// Bits in which a state is checked.
const BITS: u32 = 192;

impl Assembly {
    /// Verdict: whether the assembly stands.
    pub fn stands(&self) -> bool {
        matches!(self.proof, AssemblyProof::Stands { .. })
    }

    /// The radius of the centreline, in metres, or one.
    pub fn radius(&self) -> Option<ExactNumber> {
        let measures = self.surveyed.as_ref().map(|surveyed| &surveyed.measures);
        measures.map_or(Some(1.into()), |of: &Measures| of.exact_radius(Some(&self.thickness)))
    }

    /// Number of the joint of the whole assembly, from the left springing, on the right of the crown, or left of it.
    pub fn whole_joint(&self, joint: u64, is_right: bool) -> u64 {
        let (stones, odd) = (self.stones.number(), self.stones.number() % 2);
        match is_right {
            true => (stones + odd) / 2 + joint,
            false => (stones - odd) / 2 - joint,
        }
    }
}

impl Base {
    /// The assemblies above and below the least thickness, if that has this mode.
    pub(super) fn near_thickness(&self, friction: &str, mode: Mode) -> Option<[Assembly; 2]> {
        let friction: ExactNumber = friction.parse().ok()?;
        let mu = Friction::Coefficient(friction.clone());
        let Ok(Voussoirs::Stands(state)) = voussoirs(&self.stones, self.weight, &mu, DIGITS) else {
            return None;
        };
        let threshold = &state.thickness;
        let collapse = (threshold, Some(mode), &state.contacts[..]);
        let beside = |factor: &Rational| {
            let written = self.written(&beside(threshold, factor), GIVEN_DIGITS)?;
            let found = self.assessed(&friction, &written.1)?;
            self.assembly(Near::Thickness, (friction.clone(), written), found, collapse)
        };
        let [above, below] = &self.margin.factors();
        let pair = [beside(above)?, beside(below)?];
        (state.mode == mode && self.is_apart(&pair)).then_some(pair)
    }

    /// Assemblies above and below the least friction with which this thickness stands, if that is above zero.
    pub(super) fn near_friction(
        &self,
        thickness: &Rational,
        digits: usize,
    ) -> Option<[Assembly; 2]> {
        let written = self.written(thickness, digits)?;
        let threshold = self.assessed(&1.into(), &written.1)?.required_friction.ok()??;
        let at = |factor: &Rational| {
            let friction = Rounded::from_rational(&beside(&threshold, factor), GIVEN_DIGITS)?.value;
            let friction: ExactNumber = friction.to_string().parse().ok()?;
            let found = self.assessed(&friction, &written.1)?;
            Some((friction, found))
        };
        let [above, below] = &self.margin.factors();
        let (above, below) = (at(above)?, at(below)?);
        // What gives way at the threshold is told next to it.
        let next = match self.margin == Margin::default() {
            true => below.1.standing.clone(),
            false => at(&Margin::default().factors()[1])?.1.standing,
        };
        let contacts = match &next {
            Ok(VoussoirStanding::Falls(ends)) => mechanism(ends),
            _ => return None,
        };
        let collapse = (&threshold, self.mode(&contacts), &contacts[..]);
        let of = |(friction, found): (ExactNumber, VoussoirAssessment)| {
            self.assembly(Near::Friction, (friction, written.clone()), found, collapse)
        };
        let pair = [of(above)?, of(below)?];
        self.is_apart(&pair).then_some(pair)
    }

    /// The assembly with a friction and a thickness, as it is assessed, and with what gives way at the threshold;
    /// `None` without a proof.
    fn assembly(
        &self,
        near: Near,
        (friction, (thickness_text, thickness)): (ExactNumber, (String, ExactNumber)),
        found: VoussoirAssessment,
        (threshold, mode, contacts): (&Figure, Option<Mode>, &[JointContact]),
    ) -> Option<Assembly> {
        let safety = match near {
            Near::Friction => &found.friction_safety,
            Near::Thickness => &found.geometric_safety,
        };
        let safety = safety.clone().ok()??;
        let proof = self.proof(&friction, &thickness, found)?;
        Some(Assembly {
            weight: self.weight,
            stones: self.stones.clone(),
            friction,
            thickness,
            thickness_text,
            surveyed: self.surveyed.clone(),
            near,
            margin: self.margin,
            threshold: threshold.clone(),
            safety,
            mode,
            contacts: contacts.to_vec(),
            proof,
        })
    }

    /// Tells whether the first of two stands and the second falls, and both are as far off as is said, to a part in a
    /// hundred thousand.
    fn is_apart(&self, pair: &[Assembly; 2]) -> bool {
        let is_beside = |(of, factor): (&Assembly, Rational)| {
            (of.safety.double / factor.to_f64() - 1.0).abs() < 1e-5
        };
        let [above, below] = pair;
        above.stands() && !below.stands() && pair.iter().zip(self.margin.factors()).all(is_beside)
    }

    /// The least thickness at a friction, if it has this mode; none where any is enough.
    pub(super) fn least(&self, friction: &str, mode: Mode) -> Option<Rational> {
        let friction = friction.parse().ok()?;
        match voussoirs(&self.stones, self.weight, &friction, DIGITS).ok()? {
            Voussoirs::Stands(state) if state.mode == mode => {
                Some(state.thickness.decimal.value.to_rational())
            }
            _ => None,
        }
    }

    /// A thickness `t/r` as it is written in so many digits, and what that is exactly.
    fn written(&self, thickness: &Rational, digits: usize) -> Option<(String, ExactNumber)> {
        let short = |x: &Rational| Some(Rounded::from_rational(x, digits)?.value.to_string());
        let Some(Surveyed { measures, .. }) = &self.surveyed else {
            let text = short(thickness)?;
            let exact = text.parse().ok()?;
            return Some((text, exact));
        };
        let radius = measures.exact_radius(Some(&ExactNumber::from(thickness)))?.to_rational();
        let text = short(&(radius * thickness))? + "m";
        let exact = measures.thickness(&text.parse::<Length>().ok()?).ok()?;
        Some((text, exact))
    }

    fn assessed(
        &self,
        friction: &ExactNumber,
        thickness: &ExactNumber,
    ) -> Option<VoussoirAssessment> {
        let friction = Friction::Coefficient(friction.clone());
        assess_voussoirs(&self.stones, self.weight, &friction, thickness, DIGITS).ok()
    }

    /// The mode of these contacts.
    fn mode(&self, contacts: &[JointContact]) -> Option<Mode> {
        match contacts {
            [(Contact::Inwards, _), (Contact::Outwards, _)] => Some(Mode::Sliding),
            _ => self.stones.mode(contacts.try_into().ok()?, true),
        }
    }

    /// Proof of the verdict; `None` where it is open, or no short state is admissible.
    fn proof(
        &self,
        friction: &ExactNumber,
        thickness: &ExactNumber,
        found: VoussoirAssessment,
    ) -> Option<AssemblyProof> {
        let ends = match found.standing.ok()? {
            VoussoirStanding::Falls(ends) => return Some(AssemblyProof::Falls(Box::new(ends))),
            VoussoirStanding::Stands(ends) => ends,
        };
        let end = |of: &VoussoirLimit| of.thrust.as_ref().map(|thrust| thrust.double);
        let least = end(&ends[0])?;
        let thrust = (least + end(&ends[1]).unwrap_or(least + 1.0)) / 2.0;
        let ring = Ring::new(self.weight, &thickness.enclosure::<Ball>(BITS));
        let zero = ring.thickness.int(0);
        let thrust = short(thrust)?;
        let [most, least] = [Contact::Extrados, Contact::Intrados].map(|contact| {
            let grip = Grip { shear: zero.int(1), normal: zero.clone() };
            let joints = (0..self.stones.count()).map(|joint| {
                let row = contact.row(&self.stones.angle(joint, BITS), &ring, &grip);
                row.moment_at(&thrust.enclosure(BITS)).mid().to_f64()
            });
            let by = |a: &f64, b: &f64| a.total_cmp(b);
            if contact == Contact::Extrados { joints.min_by(by) } else { joints.max_by(by) }
        });
        let moment = short((most? + least?) / 2.0)?;
        let grip: Grip<Ball> = Friction::Coefficient(friction.clone()).grip(BITS);
        let is_admissible = (0..self.stones.count()).all(|joint| {
            let angle = self.stones.angle(joint, BITS);
            let beyond = |contact: &Contact| {
                let row = contact.row(&angle, &ring, &grip);
                row.at(&thrust.enclosure(BITS), &moment.enclosure(BITS))
            };
            Contact::ALL.iter().all(|contact| beyond(contact).is_less_than(&zero).is_proved())
        });
        is_admissible.then_some(AssemblyProof::Stands { thrust, moment })
    }
}

/// A number near its threshold.
fn beside(threshold: &Figure, factor: &Rational) -> Rational {
    threshold.decimal.value.to_rational() * factor
}

/// A double in the digits of a proof.
fn short(x: f64) -> Option<ExactNumber> {
    format!("{x:.*e}", DIGITS - 1).parse().ok()
}

/// Contacts of two bounds that contradict each other, a hinge at the intrados between the others.
fn mechanism(ends: &[VoussoirLimit; 2]) -> Vec<JointContact> {
    let mut contacts: Vec<JointContact> =
        ends.iter().flat_map(|end| end.contacts.iter().copied()).collect();
    if let Some(hinge) = contacts.iter().position(|(contact, _)| *contact == Contact::Intrados) {
        let hinge = contacts.remove(hinge);
        contacts.insert(1.min(contacts.len()), hinge);
    }
    contacts
}
