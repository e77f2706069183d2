//! The least thickness of an arch of voussoirs, proved.
//!
//! Three conditions hold with equality; their multipliers leave a polynomial `W` in the thickness
//! ([`combination`]). The proof, in balls:
//!
//! 1. **None thinner stands.** The multipliers are positive from 0 to the thickness, and so is `W` below it: by the coefficients
//!    of Bernstein's form, which bound a polynomial on an interval. Any admissible thrust and moment would make the
//!    combination zero or negative.
//! 2. **One thickness.** `W` changes its sign between two numbers next to each other: there is the root, and the thrust and the
//!    moment follow.
//! 3. **Admissible at every joint**, by signs at a few. On `(0, pi)`, at any thrust, the distance from the
//!    extrados first grows and then falls, that from the intrados falls and then grows, and where `N > 0` so does the room for inward
//!    sliding ([`contact`](crate::arch::contact)). So the joints beside the one that touches the intrados, or that slides,
//!    speak for all, and the first and the last joint for the extrados, for outward sliding and for `N`. The cost does not depend on
//!    the number of stones.
//!
//! **Thicker arches stand.** At the thrust of the state let `n = N(alpha)/(cos beta_0 - cos alpha)`. That the moments have room between
//! the extrados of the shoulder and the intrados of the first joint says `(1 + eta/2) n - 1 - delta_M eta²/12 >= 0`, as `N >= 0`
//! there. For Heyman's weight the left side grows. For Milankovitch's it is concave and, if `n < 2/3`, at most its value
//! `(3n² + 4n - 4)/4 < 0` at `eta = 3n`; so `n >= 2/3`, and it is not negative at 2 either, for joints below the first still
//! less. The room below the shoulder's extrados is concave in `eta` at every joint, that below the first joint's grows, and friction
//! does not see the thickness: so there is room from the least thickness up to 2.
//!
//! With unlimited friction the value is that to which those of large frictions come: a keystone may hang between joints
//! that bear shear alone.
//!
//! The search is in [`solve`](crate::solve::voussoirs), and nothing here rests on it.

use super::Undecided;
use super::state::{Figure, raise};
use crate::arch::joint::{Grip, Row, combination, multipliers};
use crate::arch::mechanism::Contact;
use crate::arch::statics::normal_force;
use crate::arch::{Ring, SelfWeight};
use crate::number::{Angle, Ball, Enclosure, ExactNumber, Field, Jet, bits_of};
use crate::problem::stones::{JointContact, Stones};
use crate::problem::{Arch, Friction, Mode};
use crate::solve::voussoirs::{DEGREE, Search, VoussoirCandidate};
use rug::Float;

/// The least thickness of an arch of voussoirs, with its thrust and the joints of its mechanism, correctly rounded.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct VoussoirDigits {
    /// How it collapses.
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

/// What is proved of an arch of voussoirs.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Voussoirs {
    /// It stands from a least thickness on.
    Stands(Box<VoussoirDigits>),
    /// It stands at every thickness up to 2: it has no joint inside its halves.
    AnyThickness,
    /// It stands at none: an inner joint slides at a smaller thrust than the shoulder, or the shoulder before it.
    Slides,
    /// It stands at none up to 2.
    TooThick,
}

/// Bits beyond those of the digits.
const GUARD: u32 = 64;

/// The least thickness of an arch of voussoirs with this self-weight and friction, to `digits` significant digits.
pub fn voussoirs(
    stones: &Stones,
    weight: SelfWeight,
    friction: &Friction,
    digits: usize,
) -> Result<Voussoirs, Undecided> {
    // What is public may not have been made by those who check it.
    let refused = |error: &dyn std::fmt::Display| Undecided::new(error.to_string());
    stones.check().map_err(|error| refused(&error))?;
    let arch = Arch::new(weight, stones.half_opening().clone(), friction.clone());
    let arch = arch.map_err(|error| refused(&error))?;
    let friction = arch.friction();
    raise(bits_of(digits) + GUARD, |bits| {
        let search = Search::new(stones, weight, grip(friction, bits).map(midpoint), bits);
        let is_limited = *friction != Friction::Infinite;
        let arch = Proof { stones, weight, grip: grip(friction, bits), bits, is_limited };
        arch.proved(search.candidate(), digits)
    })
}

fn midpoint(x: Ball) -> Float {
    Float::with_val(x.prec(), x.mid())
}

/// Friction as the ratio that a joint asks for.
fn grip(friction: &Friction, bits: u32) -> Grip<Ball> {
    let number = |x: &ExactNumber| x.enclosure::<Ball>(bits);
    let one = Ball::integer(1, bits);
    match friction {
        Friction::Coefficient(mu) => Grip { shear: one, normal: number(mu) },
        Friction::Angle(phi) => {
            let angle = Angle::new(number(phi));
            Grip { shear: angle.cos, normal: angle.sin }
        }
        Friction::Infinite => Grip { shear: one.int(0), normal: one },
    }
}

/// An arch of voussoirs in balls of some bits.
struct Proof<'a> {
    stones: &'a Stones,
    weight: SelfWeight,
    grip: Grip<Ball>,
    bits: u32,
    is_limited: bool,
}

/// A statement that has to be proved.
fn require(is_proved: bool, question: &'static str) -> Result<(), Undecided> {
    if is_proved { Ok(()) } else { Err(Undecided::new(question)) }
}

fn is_positive(x: &Ball) -> bool {
    x.is_positive().is_proved()
}

impl Proof<'_> {
    fn angle(&self, index: u64) -> Angle<Ball> {
        let crown = index == 0 && self.stones.has_joint_at_crown();
        let like = Ball::integer(0, self.bits);
        if crown { Angle::zero(&like) } else { Angle::new(self.stones.joint(index, self.bits)) }
    }

    fn last(&self) -> u64 {
        self.stones.count() - 1
    }

    /// The conditions as polynomials in the thickness.
    fn polynomial_rows(&self, contacts: &[JointContact; 3]) -> [Row<Jet<Ball>>; 3] {
        let like = Ball::integer(0, self.bits);
        let thickness = Jet::new(vec![like.clone(), like.int(1)], DEGREE);
        let ring = Ring::new(self.weight, &thickness);
        let grip = self.grip.clone().map(|x| Jet::constant(x, DEGREE));
        contacts.map(|contact| {
            let angle = self.angle(contact.1).map(|x| Jet::constant(x, DEGREE));
            contact.0.row(&angle, &ring, &grip)
        })
    }

    /// A condition at a thickness.
    fn row(&self, contact: JointContact, ring: &Ring<Ball>) -> Row<Ball> {
        contact.0.row(&self.angle(contact.1), ring, &self.grip)
    }

    /// What a candidate says, proved; `None` if the rounding is not decided.
    fn proved(
        &self,
        candidate: VoussoirCandidate,
        digits: usize,
    ) -> Result<Option<Voussoirs>, Undecided> {
        match candidate {
            VoussoirCandidate::Slides { inner } => self.slides(inner),
            VoussoirCandidate::TooThick { contacts } => {
                self.contradiction(&contacts, &Ball::integer(2, self.bits))?;
                Ok(Some(Voussoirs::TooThick))
            }
            VoussoirCandidate::AnyThickness => self.any_thickness(),
            VoussoirCandidate::Collapses { contacts, thickness } => {
                self.collapses(contacts, &thickness, digits)
            }
        }
    }

    /// No thrust is at the same time large enough for an inner joint and small enough for the shoulder.
    fn slides(&self, inner: u64) -> Result<Option<Voussoirs>, Undecided> {
        let ring = Ring::new(self.weight, &Ball::integer(1, self.bits));
        let inner = self.row((Contact::Inwards, inner), &ring);
        let shoulder = self.row((Contact::Outwards, self.last()), &ring);
        require(is_positive(&-inner.thrust.clone()), "whether a joint slides inwards")?;
        require(is_positive(&shoulder.thrust), "whether the shoulder slides")?;
        // The two, each times the other's coefficient.
        let sum = inner.load * &shoulder.thrust - inner.thrust * &shoulder.load;
        require(is_positive(&sum), "whether everything slides")?;
        Ok(Some(Voussoirs::Slides))
    }

    /// Nothing stands from 0 to `most`: multipliers and combination are positive there.
    fn contradiction(&self, contacts: &[JointContact; 3], most: &Ball) -> Result<(), Undecided> {
        let rows = self.polynomial_rows(contacts);
        rates_are_positive(&rows, most)?;
        require(is_positive_up_to(&combination(&rows), most), "whether a thinner arch stands")
    }

    /// Arches of two or three stones stand at every thickness if they do with the thrust `h` of the line through the middle of
    /// both joints, which belongs to `fac = 1`. At thickness `eta` the room for the crown moment between the extrados of
    /// one joint and the intrados of the other is then `eta/2 [N_0 + N_1 ± delta_M eta (cos_0 - cos_1)/6]`, and `eta` is at most 2.
    fn any_thickness(&self) -> Result<Option<Voussoirs>, Undecided> {
        require(self.stones.count() == 2, "whether every thickness is enough")?;
        let zero = Ball::integer(0, self.bits);
        let ring = Ring { centroid_factor: zero.int(1), thickness: zero };
        let (thrust, moment) = self
            .row((Contact::Extrados, 0), &ring)
            .meeting(&self.row((Contact::Extrados, 1), &ring));
        self.friction_holds(&[], &thrust, &moment, &ring)?;
        let [upper, lower] = [0, 1].map(|index| self.angle(index));
        let normal = normal_force(&upper, &thrust) + normal_force(&lower, &thrust);
        let tilt = thrust.int(self.weight.flag()) * (upper.cos - &lower.cos);
        let room = normal * thrust.int(3) - tilt;
        require(is_positive(&room), "whether every thickness is enough")?;
        Ok(Some(Voussoirs::AnyThickness))
    }

    /// The thickness, if it is the least; `None` if the rounding is not decided.
    fn collapses(
        &self,
        contacts: [JointContact; 3],
        near: &Float,
        digits: usize,
    ) -> Result<Option<Voussoirs>, Undecided> {
        let mode = self.stones.mode(&contacts, self.is_limited);
        let mode = mode.ok_or_else(|| Undecided::new("how the arch collapses"))?;
        let polynomials = self.polynomial_rows(&contacts);
        let polynomial = combination(&polynomials);
        let [low, high] = bracket(&polynomial, near, self.bits);
        require(is_positive(&-polynomial.at(&high)), "whether there is a least thickness")?;
        self.contradiction(&contacts, &low)?;
        let two = Ball::integer(2, self.bits);
        require(is_positive(&(two - &high)), "whether the physical limit is enough")?;
        let thickness = low.hull(&high);
        let ring = Ring::new(self.weight, &thickness);
        let rows = contacts.map(|contact| self.row(contact, &ring));
        rates_are_positive(&polynomials, &high)?;
        let (thrust, moment) = rows[0].meeting(&rows[2]);
        self.friction_holds(&contacts, &thrust, &moment, &ring)?;
        self.line_is_inside(&contacts, &thrust, &moment, &ring)?;
        // A rational joint may be a tie, which no ball decides.
        let joint = |contact: JointContact| match self.stones.exact_joint(contact.1) {
            Some(exact) => Figure::exact(&exact, digits),
            None => Figure::new(&self.angle(contact.1).rad, digits),
        };
        let slides = contacts[0].0 == Contact::Inwards && mode != Mode::Overturning;
        let rounded = || {
            Some(VoussoirDigits {
                mode,
                contacts,
                thickness: Figure::new(&thickness, digits)?,
                thrust: Figure::new(&thrust, digits)?,
                rotation_joint: joint(contacts[1])?,
                sliding_joint: match slides {
                    true => Some(joint(contacts[0])?),
                    false => None,
                },
            })
        };
        Ok(rounded().map(|digits| Voussoirs::Stands(Box::new(digits))))
    }

    /// The line of thrust is inside the arch at all joints.
    fn line_is_inside(
        &self,
        contacts: &[JointContact],
        thrust: &Ball,
        moment: &Ball,
        ring: &Ring<Ball>,
    ) -> Result<(), Undecided> {
        let haunch = contacts[1].1;
        let ends = [0, self.last()].map(|joint| (Contact::Extrados, joint));
        let above = haunch.checked_sub(1);
        let below = Some(haunch + 1).filter(|below| *below <= self.last());
        let beside = above.into_iter().chain(below).map(|joint| (Contact::Intrados, joint));
        // In a joint that is open there is no normal force, and no moment.
        let is_open = contacts[0] == (Contact::Inwards, haunch)
            && self.stones.may_open(haunch, self.is_limited);
        let ends = ends.into_iter().filter(|end| !(is_open && end.1 == haunch));
        for contact in ends.into_iter().chain(beside).filter(|contact| !contacts.contains(contact))
        {
            let margin = -self.row(contact, ring).at(thrust, moment);
            require(is_positive(&margin), "whether the line of thrust is inside the arch")?;
        }
        Ok(())
    }

    /// Nothing slides, and every normal force is positive.
    fn friction_holds(
        &self,
        contacts: &[JointContact],
        thrust: &Ball,
        moment: &Ball,
        ring: &Ring<Ball>,
    ) -> Result<(), Undecided> {
        let last = self.last();
        let holds = |contact: JointContact| -> bool {
            contacts.contains(&contact) || is_positive(&-self.row(contact, ring).at(thrust, moment))
        };
        // A joint that is open has no normal force.
        let is_open = |joint: u64| {
            contacts.contains(&(Contact::Inwards, joint))
                && self.stones.may_open(joint, self.is_limited)
        };
        for joint in [0, last].into_iter().filter(|joint| !is_open(*joint)) {
            let normal = normal_force(&self.angle(joint), thrust);
            require(is_positive(&normal), "whether a joint opens")?;
            let outwards = (Contact::Outwards, joint);
            require(!self.is_limited || holds(outwards), "whether the shoulder slides")?;
        }
        if !self.is_limited {
            return Ok(());
        }
        let slides = contacts.iter().find_map(|contact| match contact {
            (Contact::Inwards, joint) => Some(*joint),
            _ => None,
        });
        // The shear over the normal force is largest beside this joint, or at it.
        let [from, to] = match slides {
            Some(joint) => [joint.saturating_sub(1), joint + 1],
            None => self.around_steepest(thrust)?,
        };
        for joint in from..=to.min(last) {
            require(holds((Contact::Inwards, joint)), "whether an inner joint slides")?;
        }
        Ok(())
    }

    /// Two joints next to each other, or one, that have between them `sqrt(h (1 - h))`, where the shear over the normal force is
    /// largest; at `h` outside `(0, 1)` it falls from the crown on.
    fn around_steepest(&self, thrust: &Ball) -> Result<[u64; 2], Undecided> {
        let square = (thrust.int(1) - thrust) * thrust;
        let is_below = |joint: u64| {
            let rad = self.angle(joint).rad;
            is_positive(&(square.clone() - rad.square()))
        };
        let is_above = |joint: u64| {
            let rad = self.angle(joint).rad;
            is_positive(&(rad.square() - &square))
        };
        let (mut low, mut high) = (0, self.last());
        if is_above(low) {
            return Ok([low, low]);
        }
        if !is_below(low) {
            high = 1;
        }
        if high == self.last() && is_below(high) {
            return Ok([high, high]);
        }
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            match is_below(middle) {
                true => low = middle,
                false => high = middle,
            }
        }
        require(is_above(high), "where the joints slide most easily")?;
        Ok([low, high])
    }
}

/// The multipliers are positive at every thickness up to `most`.
fn rates_are_positive(rows: &[Row<Jet<Ball>>; 3], most: &Ball) -> Result<(), Undecided> {
    let is_positive = multipliers(rows).iter().all(|rate| is_positive_up_to(rate, most));
    require(is_positive, "the rates of the mechanism")
}

/// Two numbers about a root of a polynomial, as near to each other as the bits allow: a candidate that is refined.
fn bracket(polynomial: &Jet<Ball>, near: &Float, bits: u32) -> [Ball; 2] {
    let mut x = Float::with_val(bits, near);
    let derivative = |x: &Float| {
        let terms = polynomial.coefficients().iter().enumerate().skip(1).rev();
        terms.fold(Float::with_val(bits, 0), |sum, (k, term)| {
            sum * x + Float::with_val(bits, term.mid() * k as u32)
        })
    };
    let steps = 2 + bits.ilog2();
    for _ in 0..steps {
        let at = polynomial.at(&Ball::exact(x.clone(), bits));
        let step = Float::with_val(bits, at.mid()) / derivative(&x);
        if step.is_finite() {
            x -= step;
        }
    }
    // What the coefficients leave open, and a little more.
    let at = polynomial.at(&Ball::exact(x.clone(), bits));
    let room = Float::with_val(64, at.rad().to_float() / derivative(&x).abs()) * 4u32;
    let least = Float::with_val(64, x.abs_ref()) >> (bits - 4);
    let room = if room.is_finite() && room > least { room } else { least };
    let beside = |offset: Float| Ball::exact(Float::with_val(bits + 64, &x + &offset), bits);
    [beside(-room.clone()), beside(room)]
}

/// Whether a polynomial of at most [`DEGREE`] is positive from 0 to `most`, by the coefficients of its Bernstein form:
/// `b_i = sum over k <= i of C(i,k)/C(n,k) c_k most^k`.
fn is_positive_up_to(polynomial: &Jet<Ball>, most: &Ball) -> bool {
    const BINOMIALS: [[i32; DEGREE + 1]; DEGREE + 1] =
        [[1, 0, 0, 0], [1, 1, 0, 0], [1, 2, 1, 0], [1, 3, 3, 1]];
    let mut power = most.int(1);
    let term = |(k, count): (usize, &i32)| {
        let term = polynomial.coefficient(k) * &power / most.int(*count);
        power = power.clone() * most;
        term
    };
    let scaled: Vec<Ball> = BINOMIALS[DEGREE].iter().enumerate().map(term).collect();
    BINOMIALS.iter().all(|row| {
        let terms = scaled.iter().zip(row).filter(|(_, count)| **count > 0);
        let sum = terms.fold(most.int(0), |sum, (term, count)| sum + most.int(*count) * term);
        is_positive(&sum)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

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
            ("2.45", "1.35", "[r,r,s]", 2000, "0.65024288568029"),
            ("2.57", "2.2", "[r,s]", 200, "0.97572237870073"),
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
            let grip = || grip(&friction, 200);
            let search = Search::new(&stones, weight, grip().map(midpoint), 200);
            let proof =
                Proof { stones: &stones, weight, grip: grip(), bits: 200, is_limited: true };
            let VoussoirCandidate::Collapses { contacts, thickness } = search.candidate() else {
                panic!("{alpha} {mu}")
            };
            let prove = |contacts, thickness: &Float| {
                let thickness = thickness.clone();
                proof.proved(VoussoirCandidate::Collapses { contacts, thickness }, 20)
            };
            assert!(matches!(prove(contacts, &thickness), Ok(Some(_))));
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
            let contradiction = proof.contradiction(&contacts, &Ball::exact(thicker, 200));
            assert!(contradiction.is_err(), "{alpha} {mu}: not above the least thickness");
            assert!(proof.proved(VoussoirCandidate::TooThick { contacts }, 20).is_err());
            assert!(proof.proved(VoussoirCandidate::AnyThickness, 20).is_err());
            assert!(proof.proved(VoussoirCandidate::Slides { inner: 2 }, 20).is_err());
        }
    }
}
