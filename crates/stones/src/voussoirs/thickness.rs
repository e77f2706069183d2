//! The least thickness of an arch of voussoirs, with its state.

use super::admissible::StoneLine;
use super::joints::{StoneJoints, leave_no_thrust};
use super::polynomial::{is_positive_up_to, rates_are_positive};
use crate::arch::Ring;
use crate::arch::joint::combination;
use crate::arch::mechanism::Contact;
use crate::arch::statics::normal_force;
use crate::number::{Ball, Field};
use crate::problem::Mode;
use crate::problem::stones::JointContact;
use crate::prover::decide::{ensure, is_positive};
use crate::prover::figure::optional;
use crate::prover::{Figure, Undecided};
use crate::solve::voussoirs::VoussoirCandidate;
use crate::zero::around_zero;
use rug::Float;

/// The least thickness of an arch of voussoirs, with its thrust and the joints of its mechanism, correctly rounded.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct VoussoirDigits {
    /// Mode of its collapse.
    pub mode: Mode,
    /// The conditions that hold with equality.
    pub contacts: [JointContact; 3],
    /// `eta`.
    pub thickness: Figure,
    /// `h`.
    pub thrust: Figure,
    /// The joint with the hinge at the intrados, rad; zero at the crown.
    pub rotation_joint: Figure,
    /// The inner joint that slides, rad.
    pub sliding_joint: Option<Figure>,
}

/// Proof about an arch of voussoirs, with the state at its least thickness in digits or in balls.
#[derive(Clone, Debug)]
pub enum Voussoirs<S = Box<VoussoirDigits>> {
    /// The arch stands from a least thickness on.
    Stands(S),
    /// The arch stands at every thickness up to 2: it has no joint inside its halves.
    AnyThickness,
    /// The arch stands at no thickness: an inner joint slides at a smaller thrust than the shoulder, or the
    /// shoulder before it.
    Slides,
    /// The arch stands at no thickness up to 2.
    TooThick,
}

/// The state at the least thickness, in balls.
#[derive(Clone, Debug)]
pub(super) struct LeastState {
    mode: Mode,
    contacts: [JointContact; 3],
    /// `eta`.
    pub thickness: Ball,
    /// `h`.
    pub thrust: Ball,
}

/// Proof before it is rounded.
pub(super) type LeastOutcome = Voussoirs<LeastState>;

impl LeastOutcome {
    /// Outcome in digits; `None` if the rounding is not decided.
    pub(super) fn rounded(&self, joints: &StoneJoints<'_>, digits: usize) -> Option<Voussoirs> {
        let LeastState { mode, contacts, thickness, thrust } = match self {
            Self::Stands(state) => state,
            Self::AnyThickness => return Some(Voussoirs::AnyThickness),
            Self::Slides => return Some(Voussoirs::Slides),
            Self::TooThick => return Some(Voussoirs::TooThick),
        };
        let joint = |contact: JointContact| joints.figure(contact.1, digits);
        let slides = contacts[0].0 == Contact::Inwards && *mode != Mode::Overturning;
        Some(Voussoirs::Stands(Box::new(VoussoirDigits {
            mode: *mode,
            contacts: *contacts,
            thickness: Figure::new(thickness, digits)?,
            thrust: Figure::new(thrust, digits)?,
            rotation_joint: joint(contacts[1])?,
            sliding_joint: optional(slides.then_some(contacts[0]), joint)?,
        })))
    }
}

/// The least thickness, proved.
pub(super) fn least(joints: &StoneJoints<'_>) -> Result<LeastOutcome, Undecided> {
    joints.searched(|search| proved(joints, search.candidate()))
}

/// Proves what a candidate says.
fn proved(
    joints: &StoneJoints<'_>,
    candidate: VoussoirCandidate,
) -> Result<LeastOutcome, Undecided> {
    match candidate {
        VoussoirCandidate::Slides { inner } => slides(joints, inner),
        VoussoirCandidate::TooThick { contacts } => {
            contradiction(joints, &contacts, &Ball::integer(2, joints.bits))?;
            Ok(LeastOutcome::TooThick)
        }
        VoussoirCandidate::AnyThickness => any_thickness(joints),
        VoussoirCandidate::Collapses { contacts, thickness } => {
            collapses(joints, contacts, &thickness).map(LeastOutcome::Stands)
        }
    }
}

/// No thrust is at the same time large enough for an inner joint and small enough for the shoulder.
fn slides(joints: &StoneJoints<'_>, inner: u64) -> Result<LeastOutcome, Undecided> {
    let ring = Ring::new(joints.weight, &Ball::integer(1, joints.bits));
    let inner = joints.row((Contact::Inwards, inner), &ring);
    let shoulder = joints.row((Contact::Outwards, joints.last()), &ring);
    leave_no_thrust([&inner, &shoulder])?;
    Ok(LeastOutcome::Slides)
}

/// Nothing stands from 0 to `most`: multipliers and combination are positive there.
fn contradiction(
    joints: &StoneJoints<'_>,
    contacts: &[JointContact; 3],
    most: &Ball,
) -> Result<(), Undecided> {
    let rows = joints.polynomial_rows(contacts);
    rates_are_positive(&rows, most)?;
    ensure(is_positive_up_to(&combination(&rows), most), "whether a thinner arch stands")
}

/// Arches of two or three stones stand at every thickness if they do with the thrust `h` of the line through the
/// middle of both joints, which belongs to `fac = 1`. At thickness `eta` the room for the crown moment between the
/// extrados of one joint and the intrados of the other is then `eta/2 [N_0 + N_1 ± delta_M eta (cos_0 - cos_1)/6]`,
/// and `eta` is at most 2.
fn any_thickness(joints: &StoneJoints<'_>) -> Result<LeastOutcome, Undecided> {
    ensure(joints.stones.count() == 2, "whether every thickness is enough")?;
    let zero = Ball::integer(0, joints.bits);
    let ring = Ring { centroid_factor: zero.int(1), thickness: zero };
    let [upper, lower] = [0, 1].map(|joint| joints.row((Contact::Extrados, joint), &ring));
    let (thrust, moment) = upper.meeting(&lower);
    let (ring, thrust, moment) = (&ring, &thrust, &moment);
    StoneLine { joints, ring, contacts: &[], thrust, moment }.friction_holds()?;
    let [upper, lower] = [0, 1].map(|index| joints.angle(index));
    let normal = normal_force(&upper, thrust) + normal_force(&lower, thrust);
    let tilt = thrust.int(joints.weight.flag()) * (upper.cos - &lower.cos);
    let room = normal * thrust.int(3) - tilt;
    ensure(is_positive(&room), "whether every thickness is enough")?;
    Ok(LeastOutcome::AnyThickness)
}

/// The state, if its thickness is the least.
fn collapses(
    joints: &StoneJoints<'_>,
    contacts: [JointContact; 3],
    near: &Float,
) -> Result<LeastState, Undecided> {
    let mode = joints.stones.mode(&contacts, joints.is_limited());
    let mode = mode.ok_or_else(|| Undecided::new("how the arch collapses"))?;
    let polynomials = joints.polynomial_rows(&contacts);
    let polynomial = combination(&polynomials);
    let [low, high] = around_zero(polynomial.coefficients(), near, joints.bits);
    ensure(is_positive(&-polynomial.at(&high)), "whether there is a least thickness")?;
    contradiction(joints, &contacts, &low)?;
    let two = Ball::integer(2, joints.bits);
    ensure(is_positive(&(two - &high)), "whether the physical limit is enough")?;
    let thickness = low.hull(&high);
    let ring = Ring::new(joints.weight, &thickness);
    let rows = contacts.map(|contact| joints.row(contact, &ring));
    rates_are_positive(&polynomials, &high)?;
    let (thrust, moment) = rows[0].meeting(&rows[2]);
    let line =
        StoneLine { joints, ring: &ring, contacts: &contacts, thrust: &thrust, moment: &moment };
    line.friction_holds()?;
    line.is_inside()?;
    Ok(LeastState { mode, contacts, thickness, thrust })
}

#[cfg(test)]
mod tests {
    use super::super::joints::StoneAngles;
    use super::super::voussoirs;
    use super::*;
    use crate::arch::SelfWeight;
    use crate::problem::stones::Stones;

    fn found(weight: &str, alpha: &str, stones: u64, mu: &str) -> Voussoirs {
        let stones = Stones::equal(stones, alpha.parse().unwrap()).unwrap();
        voussoirs(&stones, SelfWeight::named(weight).unwrap(), &mu.parse().unwrap(), 14).unwrap()
    }

    /// Values of an exact linear programme over the same joints.
    #[test]
    fn known_values() {
        let of = |alpha: &str, stones, mu: &str| match found("milankovitch", alpha, stones, mu) {
            Voussoirs::Stands(state) => (state.mode.label(), state.thickness.to_string()),
            other => panic!("{other:?}"),
        };
        for (stones, eta) in [
            (7, "0.0962450310810"),
            (8, "0.100861491132"),
            (10, "0.107460109892"),
            (20, "0.107460109892"),
            (11, "0.104910343045"),
            (21, "0.106789938671"),
            (40, "0.107460109892"),
            (60, "0.107460109892"),
            (51, "0.107373698432"),
        ] {
            let (mode, found) = of("pi/2", stones, "inf");
            assert!(mode == "[r,r,r]" && found.starts_with(&eta[..13]), "{stones}: {found} {eta}");
        }
        for (alpha, mu, mode, stones, eta) in [
            ("pi/2", "0.35", "[s,r,r]", 20, "0.15025383190821"),
            ("pi/2", "0.35", "[s,r,r]", 21, "0.14950633689283"),
            ("pi/2", "0.35", "[s,r,r]", 200_000, "0.15185797140251"),
            ("2.45", "1.35", "[r,r,s]", 20, "0.64485493060826"),
            ("pi/2", "0.35", "[s,r,r]", 200, "0.15184878009868"),
            ("pi/2", "0.35", "[s,r,r]", 2000, "0.15185792017299"),
            ("2.45", "1.35", "[r,r,s]", 21, "0.64749960088913"),
            ("2.45", "1.35", "[r,r,s]", 200, "0.65006996973787"),
            ("2.45", "1.35", "[r,r,s]", 2000, "0.65024288568029"),
            ("2.45", "1.35", "[r,r,s]", 200_000, "0.65024378065717"),
            ("2.57", "2.2", "[r,s]", 20, "0.96612547936313"),
            // Between a keystone's joints the hinge is not at the crown.
            ("2.57", "2.2", "[r,r,s]", 21, "0.94113390690795"),
            ("2.57", "2.2", "[r,s]", 200, "0.97572237870073"),
            ("2.57", "2.2", "[r,s]", 2000, "0.97580343735121"),
            ("2.57", "2.2", "[r,s]", 200_000, "0.97580615917702"),
        ] {
            assert_eq!(of(alpha, stones, mu), (mode, eta.to_owned()), "{alpha} {mu} {stones}");
        }
    }

    /// With the hinge or the slip at another joint, or another mode, nothing is proved.
    #[test]
    fn forged_contacts_are_refused() {
        for (alpha, mu, stones) in [("pi/2", "0.6", 11), ("pi/2", "0.35", 20), ("2.45", "1.35", 40)]
        {
            let stones = Stones::equal(stones, alpha.parse().unwrap()).unwrap();
            let (weight, friction) = (SelfWeight::Milankovitch, mu.parse().unwrap());
            let angles = StoneAngles::new(&stones);
            let joints = StoneJoints::new(&angles, weight, &friction, 200);
            let found = joints.searched(|search| Ok(search.candidate()));
            let Ok(VoussoirCandidate::Collapses { contacts, thickness }) = found else {
                panic!("{alpha} {mu}")
            };
            let prove = |contacts, thickness: &Float| {
                let thickness = thickness.clone();
                proved(&joints, VoussoirCandidate::Collapses { contacts, thickness })
            };
            assert!(matches!(prove(contacts, &thickness), Ok(LeastOutcome::Stands(_))));
            let (first, last) = (contacts[0], contacts[2]);
            let haunch = contacts[1].1;
            for forged in [
                [first, (Contact::Intrados, haunch - 1), last],
                [first, (Contact::Intrados, haunch + 1), last],
                [(Contact::Inwards, 1), contacts[1], (Contact::Extrados, last.1)],
                [last, contacts[1], first],
                [(Contact::Extrados, 1), contacts[1], last],
            ] {
                let found = prove(forged, &thickness);
                assert!(found.is_err(), "{alpha} {mu}: {forged:?} {found:?}");
            }
            let thicker = Float::with_val(200, &thickness * 1.01);
            let contradiction = contradiction(&joints, &contacts, &Ball::exact(thicker, 200));
            assert!(contradiction.is_err(), "{alpha} {mu}: not above the least thickness");
            assert!(proved(&joints, VoussoirCandidate::TooThick { contacts }).is_err());
            assert!(proved(&joints, VoussoirCandidate::AnyThickness).is_err());
            assert!(proved(&joints, VoussoirCandidate::Slides { inner: 2 }).is_err());
        }
    }
}
