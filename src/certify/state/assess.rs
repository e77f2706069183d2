//! An arch of a given thickness: does it stand, with what safety, and how much may it thrust?
//!
//! For a given thickness the admissible states are those thrusts `h` for which some crown moment `p`
//! fits: `p` at most `(1 + eta/2) h` (extrados at the crown) and at most
//! `(1 + eta/2) N(alpha) - fac (1 - cos alpha)` (extrados at the shoulder), and at least the largest
//! over all joints of `(1 - eta/2) N(beta) - fac (1 - cos beta)` (intrados). The last is convex in `h`.
//!
//! - Its gap to the first bound grows with `h`: the zero is the **least** thrust, where the line of
//!   thrust touches the intrados, (2) and (5) at this thickness; at the shoulder if the touching joint
//!   would lie beyond it; zero thrust from the thickness of `l` on.
//! - Its gap to the second is concave in `h`: the larger zero is the **largest** thrust, (3) and (5) at
//!   this thickness, or (3) at the crown; there is none if the lever arm at the crown is not positive.
//!   It is not negative at the least thrust (checked), so it is not in between.
//!
//! Friction cuts off thrusts below that of inner sliding and above that of shoulder sliding. What is
//! left is the admissible range, and **the arch stands exactly if it is not empty**; the least
//! thickness of the arch, proved on its own, has to say the same.

use super::choice::{Fall, Outcome, hull};
use super::inquiry::Inquiry;
use super::question::{Arch, Attempt, Query, decide, require};
use crate::arch::{Ring, Unknown, contact, sliding, thrust};
use crate::number::{Angle, Ball, Enclosure, ExactNumber, Field, Real, Ternary};
use crate::problem::inner_friction;
use crate::problem::{Equation, Mode};
use crate::solve::start;
use rug::Float;

/// What is certain of an arch of a given thickness.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Assessment {
    /// Whether it stands.
    pub stands: bool,
    /// The least thickness of the arch with this friction, or why there is none.
    pub least_thickness: Result<Ball, Fall>,
    /// The thickness over the least thickness.
    pub geometric_safety: Option<Ball>,
    /// The least friction with which the arch of this thickness stands; `None` if none is enough.
    pub required_friction: Option<Ball>,
    /// The friction over the required one; `None` if either is unbounded.
    pub friction_safety: Option<Ball>,
    /// The least and the largest admissible thrust; `None` if the arch does not stand.
    pub thrust: Option<[Limit; 2]>,
}

/// An end of the range of admissible thrusts.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Limit {
    /// The thrust; `None` if there is no bound.
    pub thrust: Option<Ball>,
    /// What limits it.
    pub touch: Touch,
}

/// What limits a thrust.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Touch {
    /// The line of thrust touches the intrados at this joint.
    Haunch(Ball),
    /// The line of thrust is on the intrados of the crown.
    Crown,
    /// The line of thrust is on the intrados of the shoulder.
    Shoulder,
    /// This inner joint slides.
    InnerSliding(Ball),
    /// The shoulder slides outwards.
    ShoulderSliding,
    /// The shoulder slides inwards: in a shallow arch the steepest joint would lie beyond it.
    ShoulderSlidingInwards,
    /// Nothing does.
    Nothing,
}

impl Touch {
    /// The words used in files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Haunch(_) => "intrados at the haunch",
            Self::Crown => "intrados at the crown",
            Self::Shoulder => "intrados at the shoulder",
            Self::InnerSliding(_) => "sliding of an inner joint",
            Self::ShoulderSliding => "sliding of the shoulder",
            Self::ShoulderSlidingInwards => "sliding of the shoulder inwards",
            Self::Nothing => "nothing",
        }
    }

    /// The joint, where it is not at an end of the half arch.
    pub fn joint(&self) -> Option<&Ball> {
        match self {
            Self::Haunch(joint) | Self::InnerSliding(joint) => Some(joint),
            _ => None,
        }
    }
}

const BETWEEN: &[Mode] = &[];

/// What is asked of an arch of a given thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// Whether it stands, and how far its thickness is from the least: its state says so.
    Standing,
    /// Also the range of thrusts, and the friction that it asks for.
    Everything,
}

impl Arch {
    /// Proves what holds for the arch with a given thickness `t/r`, with numbers of `bits` bits, at
    /// least one. The doubt is what these could not tell, or that the thickness is not in `(0, 2)`.
    pub fn assess(&self, thickness: &ExactNumber, bits: u32) -> Attempt<Assessment> {
        Inquiry::new(self, 1, false).assessment(thickness, bits, Wanted::Everything)
    }
}

impl Inquiry<'_> {
    /// The same, as far as it is wanted, with what the inquiry knows already.
    pub(super) fn assessment(
        &mut self,
        thickness: &ExactNumber,
        bits: u32,
        wanted: Wanted,
    ) -> Attempt<Assessment> {
        let eta = thickness.enclosure(bits);
        require(&eta, "whether the thickness is positive", BETWEEN)?;
        require(&(eta.int(2) - &eta), "whether the thickness is below the limit 2", BETWEEN)?;
        let (least_thickness, stands) = match self.outcome(bits)? {
            Outcome::Falls(fall) => (Err(fall), false),
            Outcome::Stands(state) => {
                let margin = eta.clone() - &state.thickness;
                let stands = decide(&margin, "whether the thickness is enough", BETWEEN)?;
                (Ok(state.thickness), stands)
            }
        };
        let mut query = Query::new(self.arch(), bits);
        query.given = query.given.with(Unknown::Thickness, eta.clone());
        let geometric = if wanted == Wanted::Everything && self.line_of_thrust_fits(&eta, bits)? {
            Some([query.least_thrust()?, query.largest_thrust()?])
        } else {
            None
        };
        let required_friction = match &geometric {
            Some(range) => Some(query.required_friction(range)?),
            None => None,
        };
        let friction_safety = match (&query.friction, &required_friction) {
            (Some(friction), Some(required)) => Some(friction.clone() / required),
            _ => None,
        };
        let thrust = match (stands, geometric) {
            (true, Some(range)) => Some(query.cut_by_friction(range)?),
            _ => None,
        };
        let geometric_safety = least_thickness.as_ref().ok().map(|least| eta / least);
        Ok(Assessment {
            stands,
            least_thickness,
            geometric_safety,
            required_friction,
            friction_safety,
            thrust,
        })
    }

    /// Whether a line of thrust lies inside the arch at all: it would stand with unlimited friction.
    fn line_of_thrust_fits(&mut self, eta: &Ball, bits: u32) -> Attempt<bool> {
        match self.unlimited(bits)? {
            Outcome::Falls(_) => Ok(false),
            Outcome::Stands(state) => {
                let margin = eta.clone() - &state.thickness;
                decide(&margin, "whether a line of thrust fits", BETWEEN)
            }
        }
    }
}

impl Query {
    /// The thrust below which the line of thrust leaves the arch.
    fn least_thrust(&self) -> Attempt<Limit> {
        let given = &self.given;
        let ring = Ring::new(self.weight, &given.thickness);
        // Without thrust: (5) at the crown.
        let beyond = contact::crown_slope(self.weight, given);
        let question = "whether the arch is thicker than at the end of rotation";
        if !decide(&-beyond, question, BETWEEN)? {
            return Ok(Limit { thrust: Some(given.thrust.int(0)), touch: Touch::Nothing });
        }
        let system = (
            &[Unknown::RotationJoint, Unknown::Thrust][..],
            &[Equation::LowerThrust, Equation::Tangency][..],
        );
        let eta = Float::with_val(self.bits, given.thickness.mid());
        let at = self.root(system, &start::rotational_with_thickness(self.weight, &eta))?;
        let beta = &at.rotation_joint.rad;
        require(beta, "a touching joint below the crown", BETWEEN)?;
        require(&(beta.pi() - beta), "a touching joint within half a turn", BETWEEN)?;
        let shoulder = thrust::lower(&given.half_opening, &ring).value();
        let above = given.half_opening.rad.clone() - beta;
        match above.is_positive() {
            Ternary::True => {}
            Ternary::False => {
                return Ok(Limit { thrust: Some(shoulder), touch: Touch::Shoulder });
            }
            // The joint is the shoulder as far as can be told, and the two thrusts are as close.
            Ternary::Undecided => {
                let thrust = Some(hull(&shoulder, &at.thrust));
                return Ok(Limit { thrust, touch: Touch::Shoulder });
            }
        }
        let margin =
            contact::extrados_margin_at_shoulder(self.weight, &at, &contact::crown_moment(&at));
        require(&margin, "the line of least thrust inside the extrados at the shoulder", BETWEEN)?;
        Ok(Limit { thrust: Some(at.thrust), touch: Touch::Haunch(at.rotation_joint.rad) })
    }

    /// The thrust above which the line of thrust leaves the arch.
    fn largest_thrust(&self) -> Attempt<Limit> {
        let given = &self.given;
        let ring = Ring::new(self.weight, &given.thickness);
        let crown = thrust::upper(&given.half_opening, &Angle::zero(&given.thrust), &ring);
        let bounded = match crown.denominator.is_positive() {
            Ternary::True => true,
            Ternary::False => false,
            // Where friction bounds the thrust sooner, it does not matter.
            Ternary::Undecided if self.shoulder_slides_first()? => false,
            Ternary::Undecided => {
                decide(&crown.denominator, "whether the thrust is bounded from above", BETWEEN)?
            }
        };
        if !bounded {
            return Ok(Limit { thrust: None, touch: Touch::Nothing });
        }
        let at_crown = given.clone().with(Unknown::Thrust, crown.value());
        let slope = contact::crown_slope(self.weight, &at_crown);
        if decide(&slope, "whether the line of largest thrust touches at the crown", BETWEEN)? {
            return Ok(Limit { thrust: Some(at_crown.thrust), touch: Touch::Crown });
        }
        let system = (
            &[Unknown::RotationJoint, Unknown::Thrust][..],
            &[Equation::UpperThrust, Equation::Tangency][..],
        );
        let eta = given.thickness.mid();
        let start = match self.alpha() {
            alpha if alpha < 0.25 => start::scaled_largest_thrust(self.weight, &alpha, eta),
            alpha => start::largest_thrust(self.weight, alpha.to_f64(), eta.to_f64())
                .map(|x| Float::with_val(self.bits, x)),
        };
        let at = self.root(system, &start)?;
        let beta = &at.rotation_joint.rad;
        require(beta, "a touching joint below the crown", BETWEEN)?;
        require(
            &(given.half_opening.rad.clone() - beta),
            "a touching joint above the shoulder",
            BETWEEN,
        )?;
        require(&at.thrust, "a positive largest thrust", BETWEEN)?;
        let arm = thrust::upper(&given.half_opening, &at.rotation_joint, &ring).denominator;
        require(&arm, "a touching joint that bounds the thrust from above", BETWEEN)?;
        let margin = contact::crown_moment(&at) - contact::shoulder_moment(self.weight, &at);
        require(&margin, "the line of largest thrust inside the extrados at the crown", BETWEEN)?;
        Ok(Limit { thrust: Some(at.thrust), touch: Touch::Haunch(at.rotation_joint.rad) })
    }

    /// Whether the line of thrust still fits, touching the intrados at the crown, at the thrust at which
    /// the shoulder slides: then that comes before any other bound.
    fn shoulder_slides_first(&self) -> Attempt<bool> {
        let Some(friction) = &self.friction else { return Ok(false) };
        let shoulder = sliding::shoulder_thrust(&self.given.half_opening, friction);
        if shoulder.denominator.is_positive() != Ternary::True {
            return Ok(false);
        }
        let slides = self.root(Mode::Sliding.system(), &start::sliding(&self.alpha()))?;
        let at = self.given.clone().with(Unknown::Thrust, shoulder.value());
        // Above the purely sliding thrust the required friction does not see the bound either.
        let above = slides.thrust.is_less_than(&at.thrust);
        let intrados = Ring::new(self.weight, &at.thickness).intrados() * &at.thrust;
        let margin = contact::shoulder_moment(self.weight, &at) - intrados / at.thrust.int(2);
        let at_crown = contact::crown_slope(self.weight, &at).is_positive();
        Ok(margin.is_positive().and(at_crown).and(above).is_proved())
    }

    /// The least friction for which some thrust of the range slides nowhere. The shoulder asks for more
    /// the larger the thrust, an inner joint the smaller: best is the thrust at which they ask for the
    /// same, or the end of the range next to it.
    fn required_friction(&self, [least, largest]: &[Limit; 2]) -> Attempt<Ball> {
        let slides = self.root(Mode::Sliding.system(), &start::sliding(&self.alpha()))?;
        let question = "which joint the friction is needed for";
        if let Some(least) = &least.thrust
            && decide(&(least.clone() - &slides.thrust), question, BETWEEN)?
        {
            return Ok(sliding::shoulder(&self.given.half_opening, least).value());
        }
        if let Some(largest) = &largest.thrust
            && decide(&(slides.thrust.clone() - largest), question, BETWEEN)?
        {
            let at = self.given.clone().with(Unknown::Thrust, largest.clone());
            let steepest = (largest.clone() * (largest.int(1) - largest)).sqrt();
            let margin = at.half_opening.rad.clone() - steepest;
            require(&margin, "the steepest joint above the shoulder", BETWEEN)?;
            return Ok(inner_friction(&at));
        }
        Ok(slides.friction)
    }

    /// The range without the thrusts at which a joint slides.
    fn cut_by_friction(&self, [mut least, mut largest]: [Limit; 2]) -> Attempt<[Limit; 2]> {
        let Some(friction) = &self.friction else { return Ok([least, largest]) };
        let question = "whether sliding or the line of thrust limits the thrust";
        let [h, joint] = start::inner_sliding(&Float::with_val(self.bits, friction.mid()));
        let system = (
            &[Unknown::Thrust, Unknown::SlidingJoint][..],
            &[Equation::InnerSliding, Equation::Steepest][..],
        );
        let inner = self.root(system, &[h, joint])?;
        let (alpha, joint) = (&self.given.half_opening, inner.sliding_joint.rad);
        // T/N grows up to the steepest joint: if that lies beyond the shoulder, the shoulder counts.
        let inside = alpha.rad.clone() - &joint;
        let slid = if decide(&inside, "whether the steepest joint is above the shoulder", BETWEEN)?
        {
            Limit { thrust: Some(inner.thrust), touch: Touch::InnerSliding(joint) }
        } else {
            let thrust = sliding::shoulder_thrust(alpha, &-friction.clone()).value();
            Limit { thrust: Some(thrust), touch: Touch::ShoulderSlidingInwards }
        };
        if let (Some(thrust), Some(bound)) = (&least.thrust, &slid.thrust)
            && decide(&(bound.clone() - thrust), question, BETWEEN)?
        {
            least = slid;
        }
        let shoulder = sliding::shoulder_thrust(&self.given.half_opening, friction);
        let first = match &largest.thrust {
            // numerator / denominator < thrust, without dividing by what may be zero: the numerator
            // is positive, since something stands.
            Some(thrust) => {
                let margin = shoulder.denominator.clone() * thrust - &shoulder.numerator;
                decide(&margin, question, BETWEEN)?
            }
            None => decide(&shoulder.denominator, "whether the shoulder can slide", BETWEEN)?,
        };
        if first {
            let touch = Touch::ShoulderSliding;
            largest = Limit { thrust: Some(shoulder.value()), touch };
        }
        if let (Some(low), Some(high)) = (&least.thrust, &largest.thrust) {
            require(&(high.clone() - low), "a range of thrusts that is not empty", BETWEEN)?;
        }
        Ok([least, largest])
    }
}
