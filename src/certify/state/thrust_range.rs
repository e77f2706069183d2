//! The range of thrusts of an arch of a given thickness.
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
//! left is the admissible range, and **the arch stands exactly if it is not empty**.

use super::query::Query;
use crate::arch::{Ring, Unknown, contact, sliding, thrust};
use crate::certify::Undecided;
use crate::certify::undecided::{decide, require};
use crate::number::{Angle, Ball, Enclosure, Field, Real, Ternary};
use crate::problem::{Condition, Mode, System, inner_friction};
use crate::solve::start;
use rug::Float;

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

/// The thrust below which the line of thrust leaves the arch.
pub(super) fn least_thrust(query: &Query) -> Result<Limit, Undecided> {
    let given = &query.given;
    let ring = Ring::new(query.weight, &given.thickness);
    // Without thrust: (5) at the crown.
    let beyond = contact::crown_slope(query.weight, given);
    let question = "whether the arch is thicker than at the end of rotation";
    if !decide(&-beyond, question, &[])? {
        return Ok(Limit { thrust: Some(given.thrust.int(0)), touch: Touch::Nothing });
    }
    let system = System::touching(query.weight, true);
    let eta = Float::with_val(query.bits, given.thickness.mid());
    let at = query.root(system, &start::rotational_with_thickness(query.weight, &eta))?;
    let beta = &at.rotation_joint.rad;
    require(beta, "a touching joint below the crown")?;
    require(&(beta.pi() - beta), "a touching joint within half a turn")?;
    let shoulder = thrust::lower(&given.half_opening, &ring).value();
    let above = given.half_opening.rad.clone() - beta;
    match above.is_positive() {
        Ternary::True => {}
        Ternary::False => {
            return Ok(Limit { thrust: Some(shoulder), touch: Touch::Shoulder });
        }
        // The joint is the shoulder as far as can be told, and the two thrusts are as close.
        Ternary::Undecided => {
            let thrust = Some(shoulder.hull(&at.thrust));
            return Ok(Limit { thrust, touch: Touch::Shoulder });
        }
    }
    let margin =
        contact::extrados_margin_at_shoulder(query.weight, &at, &contact::crown_moment(&at));
    require(&margin, "the line of least thrust inside the extrados at the shoulder")?;
    Ok(Limit { thrust: Some(at.thrust), touch: Touch::Haunch(at.rotation_joint.rad) })
}

/// The thrust above which the line of thrust leaves the arch.
pub(super) fn largest_thrust(query: &Query) -> Result<Limit, Undecided> {
    let given = &query.given;
    let ring = Ring::new(query.weight, &given.thickness);
    let crown = thrust::upper(&given.half_opening, &Angle::zero(&given.thrust), &ring);
    let bounded = match crown.denominator.is_positive() {
        Ternary::True => true,
        Ternary::False => false,
        // Where friction bounds the thrust sooner, it does not matter.
        Ternary::Undecided if shoulder_slides_first(query)? => false,
        Ternary::Undecided => {
            decide(&crown.denominator, "whether the thrust is bounded from above", &[])?
        }
    };
    if !bounded {
        return Ok(Limit { thrust: None, touch: Touch::Nothing });
    }
    let at_crown = given.clone().with(Unknown::Thrust, crown.value());
    let slope = contact::crown_slope(query.weight, &at_crown);
    if decide(&slope, "whether the line of largest thrust touches at the crown", &[])? {
        return Ok(Limit { thrust: Some(at_crown.thrust), touch: Touch::Crown });
    }
    let system = System::touching(query.weight, false);
    let eta = given.thickness.mid();
    let start = match query.alpha() {
        alpha if alpha < 0.25 => start::scaled_largest_thrust(query.weight, &alpha, eta),
        alpha => start::largest_thrust(query.weight, alpha.to_f64(), eta.to_f64())
            .map(|x| Float::with_val(query.bits, x)),
    };
    let at = query.root(system, &start)?;
    let beta = &at.rotation_joint.rad;
    require(beta, "a touching joint below the crown")?;
    require(&(given.half_opening.rad.clone() - beta), "a touching joint above the shoulder")?;
    require(&at.thrust, "a positive largest thrust")?;
    let arm = thrust::upper(&given.half_opening, &at.rotation_joint, &ring).denominator;
    require(&arm, "a touching joint that bounds the thrust from above")?;
    let margin = contact::crown_moment(&at) - contact::shoulder_moment(query.weight, &at);
    require(&margin, "the line of largest thrust inside the extrados at the crown")?;
    Ok(Limit { thrust: Some(at.thrust), touch: Touch::Haunch(at.rotation_joint.rad) })
}

/// Whether the line of thrust still fits, touching the intrados at the crown, at the thrust at which
/// the shoulder slides: then that comes before any other bound.
fn shoulder_slides_first(query: &Query) -> Result<bool, Undecided> {
    let Some(friction) = query.friction() else { return Ok(false) };
    let shoulder = sliding::shoulder_thrust(&query.given.half_opening, friction);
    if shoulder.denominator.is_positive() != Ternary::True {
        return Ok(false);
    }
    let slides = query.root(Mode::Sliding.system(query.weight), &start::sliding(&query.alpha()))?;
    let at = query.given.clone().with(Unknown::Thrust, shoulder.value());
    // Above the purely sliding thrust the required friction does not see the bound either.
    let above = slides.thrust.is_less_than(&at.thrust);
    let intrados = Ring::new(query.weight, &at.thickness).intrados() * &at.thrust;
    let margin = contact::shoulder_moment(query.weight, &at) - intrados / at.thrust.int(2);
    let at_crown = contact::crown_slope(query.weight, &at).is_positive();
    Ok(margin.is_positive().and(at_crown).and(above).is_proved())
}

/// The least friction for which some thrust of the range slides nowhere. The shoulder asks for more
/// the larger the thrust, an inner joint the smaller: best is the thrust at which they ask for the
/// same, or the end of the range next to it.
pub(super) fn required_friction(
    query: &Query,
    [least, largest]: &[Limit; 2],
) -> Result<Ball, Undecided> {
    let slides = query.root(Mode::Sliding.system(query.weight), &start::sliding(&query.alpha()))?;
    let question = "which joint the friction is needed for";
    if let Some(least) = &least.thrust
        && decide(&(least.clone() - &slides.thrust), question, &[])?
    {
        return Ok(sliding::shoulder(&query.given.half_opening, least).value());
    }
    if let Some(largest) = &largest.thrust
        && decide(&(slides.thrust.clone() - largest), question, &[])?
    {
        let at = query.given.clone().with(Unknown::Thrust, largest.clone());
        let steepest = (largest.clone() * (largest.int(1) - largest)).sqrt();
        let margin = at.half_opening.rad.clone() - steepest;
        require(&margin, Condition::SteepestAboveShoulder.label())?;
        return Ok(inner_friction(&at));
    }
    Ok(slides.friction)
}

/// The range without the thrusts at which a joint slides.
pub(super) fn cut_by_friction(
    query: &Query,
    [mut least, mut largest]: [Limit; 2],
) -> Result<[Limit; 2], Undecided> {
    let Some(friction) = query.friction() else { return Ok([least, largest]) };
    let question = "whether sliding or the line of thrust limits the thrust";
    let [h, joint] = start::inner_sliding(&Float::with_val(query.bits, friction.mid()));
    let inner = query.root(System::inner_sliding(query.weight), &[h, joint])?;
    let (alpha, joint) = (&query.given.half_opening, inner.sliding_joint.rad);
    // T/N grows up to the steepest joint: if that lies beyond the shoulder, the shoulder counts.
    let inside = alpha.rad.clone() - &joint;
    let slid = if decide(&inside, "whether the steepest joint is above the shoulder", &[])? {
        Limit { thrust: Some(inner.thrust), touch: Touch::InnerSliding(joint) }
    } else {
        let thrust = sliding::shoulder_thrust(alpha, &-friction.clone()).value();
        Limit { thrust: Some(thrust), touch: Touch::ShoulderSlidingInwards }
    };
    if let (Some(thrust), Some(bound)) = (&least.thrust, &slid.thrust)
        && decide(&(bound.clone() - thrust), question, &[])?
    {
        least = slid;
    }
    let shoulder = sliding::shoulder_thrust(&query.given.half_opening, friction);
    let first = match &largest.thrust {
        // numerator / denominator < thrust, without dividing by what may be zero: the numerator
        // is positive, since something stands.
        Some(thrust) => {
            let margin = shoulder.denominator.clone() * thrust - &shoulder.numerator;
            decide(&margin, question, &[])?
        }
        None => decide(&shoulder.denominator, "whether the shoulder can slide", &[])?,
    };
    if first {
        let touch = Touch::ShoulderSliding;
        largest = Limit { thrust: Some(shoulder.value()), touch };
    }
    if let (Some(low), Some(high)) = (&least.thrust, &largest.thrust) {
        require(&(high.clone() - low), "a range of thrusts that is not empty")?;
    }
    Ok([least, largest])
}
