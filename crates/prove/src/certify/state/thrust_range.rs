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

use super::mode::steepest_root;
use super::query::Query;
use crate::arch::{Configuration, Ring, Unknown, contact, sliding, thrust};
use crate::number::{Angle, Ball, Ternary};
use crate::problem::{Condition, Mode, System, inner_friction, room_for_steepest};
use crate::prover::arithmetic::Arithmetic;
use crate::prover::decide::{decide, require};
use crate::prover::{Answered, Undecided};
use crate::solve::start::{self, Start};
use std::cell::LazyCell;
use std::cmp::Ordering;

/// An end of the range of admissible thrusts.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Limit<T = Ball> {
    /// The thrust; `None` if there is no bound.
    pub thrust: Option<T>,
    /// Touch that limits it.
    pub touch: Touch<T>,
}

impl<T> Limit<T> {
    /// Maps the values to other numbers.
    pub(super) fn each<U, E>(self, f: impl Fn(T) -> Result<U, E>) -> Result<Limit<U>, E> {
        let thrust = self.thrust.map(&f).transpose()?;
        let touch = match self.touch {
            Touch::Haunch(joint) => Touch::Haunch(f(joint)?),
            Touch::InnerSliding(joint) => Touch::InnerSliding(f(joint)?),
            Touch::Crown => Touch::Crown,
            Touch::Shoulder => Touch::Shoulder,
            Touch::AtShoulder => Touch::AtShoulder,
            Touch::ShoulderSliding => Touch::ShoulderSliding,
            Touch::ShoulderSlidingInwards => Touch::ShoulderSlidingInwards,
            Touch::Nothing => Touch::Nothing,
        };
        Ok(Limit { thrust, touch })
    }
}

/// Limit of a thrust.
#[derive(Clone, Debug)]
pub enum Touch<T = Ball> {
    /// The line of thrust touches the intrados at this joint.
    Haunch(T),
    /// The line of thrust is on the intrados of the crown.
    Crown,
    /// The line of thrust is on the intrados of the shoulder.
    Shoulder,
    /// The line of thrust touches the intrados at the shoulder, or so near to it that the two cannot be told apart.
    AtShoulder,
    /// An inner joint slides.
    InnerSliding(T),
    /// The shoulder slides outwards.
    ShoulderSliding,
    /// The shoulder slides inwards: in a shallow arch the steepest joint would lie beyond it.
    ShoulderSlidingInwards,
    /// Nothing limits the thrust.
    Nothing,
}

impl<T> Touch<T> {
    /// The words used in files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Haunch(_) => "intrados at the haunch",
            Self::Crown => "intrados at the crown",
            Self::Shoulder => "intrados at the shoulder",
            Self::AtShoulder => "intrados at the shoulder or next to it",
            Self::InnerSliding(_) => "sliding of an inner joint",
            Self::ShoulderSliding => "sliding of the shoulder",
            Self::ShoulderSlidingInwards => "sliding of the shoulder inwards",
            Self::Nothing => "nothing",
        }
    }

    /// The joint, where it is not at an end of the half arch.
    pub fn joint(&self) -> Option<&T> {
        match self {
            Self::Haunch(joint) | Self::InnerSliding(joint) => Some(joint),
            _ => None,
        }
    }
}

/// Roots that the range is made of, each proved to exist.
pub(super) trait Roots<E> {
    /// (2) and (5) at the thickness.
    fn least(&self) -> Result<Configuration<E>, Undecided>;
    /// (3) and (5) at the thickness.
    fn largest(&self) -> Result<Configuration<E>, Undecided>;
    /// The purely sliding state, (17) and (18).
    fn sliding(&self) -> Result<Configuration<E>, Undecided>;
    /// The thrust and the joint of (18) at the friction.
    fn steepest(&self) -> Result<Configuration<E>, Undecided>;
    /// The arch of these roots in few bits, for signs, where they have many.
    fn in_few_bits(&self) -> Option<Query<E>> {
        None
    }
}

impl<E: Arithmetic> Roots<E> for Query<E> {
    fn least(&self) -> Result<Configuration<E>, Undecided> {
        let eta = self.given.thickness.candidate();
        let start = start::rotational_with_thickness(self.weight, &eta);
        self.root(System::touching(self.weight, true), &start)
    }

    fn largest(&self) -> Result<Configuration<E>, Undecided> {
        let eta = self.given.thickness.candidate();
        let start = match self.alpha() {
            alpha if alpha < 0.25 => start::scaled_largest_thrust(self.weight, &alpha, &eta),
            alpha => start::largest_thrust(self.weight, alpha.to_double(), eta.to_double())
                .map(|x| eta.like(x)),
        };
        self.root(System::touching(self.weight, false), &start)
    }

    fn sliding(&self) -> Result<Configuration<E>, Undecided> {
        self.root(Mode::Sliding.system(self.weight), &start::sliding(&self.alpha()))
    }

    fn steepest(&self) -> Result<Configuration<E>, Undecided> {
        steepest_root(self)
    }

    fn in_few_bits(&self) -> Option<Query<E>> {
        self.in_few_bits()
    }
}

/// The thrust below which the line of thrust leaves the arch.
pub(super) fn least_thrust<E: Arithmetic>(
    query: &Query<E>,
    roots: &impl Roots<E>,
) -> Result<Limit<E>, Undecided> {
    let given = &query.given;
    let ring = Ring::new(query.weight, &given.thickness);
    // Without thrust: (5) at the crown.
    let beyond = contact::crown_slope(query.weight, given);
    let question = "whether the arch is thicker than at the end of rotation";
    if !decide(&-beyond, question, &[])? {
        return Ok(Limit { thrust: Some(given.thrust.int(0)), touch: Touch::Nothing });
    }
    let at = roots.least()?;
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
            let thrust = Some(shoulder.hull_with(&at.thrust));
            return Ok(Limit { thrust, touch: Touch::AtShoulder });
        }
    }
    let margin =
        contact::extrados_margin_at_shoulder(query.weight, &at, &contact::crown_moment(&at));
    require(&margin, "the line of least thrust inside the extrados at the shoulder")?;
    Ok(Limit { thrust: Some(at.thrust), touch: Touch::Haunch(at.rotation_joint.rad) })
}

/// The thrust above which the line of thrust leaves the arch; `has_no_arm` if its lever arm at the crown is
/// exactly zero. Then the gap, which is concave, is constant in the end: it stays open.
pub(super) fn largest_thrust<E: Arithmetic>(
    query: &Query<E>,
    roots: &impl Roots<E>,
    has_no_arm: bool,
) -> Result<Limit<E>, Undecided> {
    let given = &query.given;
    let ring = Ring::new(query.weight, &given.thickness);
    let crown = thrust::upper(&given.half_opening, &Angle::zero(&given.thrust), &ring);
    let question = "whether the thrust is bounded from above";
    let bounded = !has_no_arm && decide(&crown.denominator, question, &[])?;
    if !bounded {
        return Ok(Limit { thrust: None, touch: Touch::Nothing });
    }
    let at_crown = given.clone().with(Unknown::Thrust, crown.value());
    let slope = contact::crown_slope(query.weight, &at_crown);
    if decide(&slope, "whether the line of largest thrust touches at the crown", &[])? {
        return Ok(Limit { thrust: Some(at_crown.thrust), touch: Touch::Crown });
    }
    let at = roots.largest()?;
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

/// The largest thrust, in few bits for signs, where there are many, and in all of them where its value is asked for.
pub(super) struct Largest<E: Arithmetic, F> {
    pub in_few_bits: Option<(Query<E>, Answered<Limit<E>>)>,
    pub whole: LazyCell<Answered<Limit<E>>, F>,
}

/// Place of the purely sliding state's thrust: below the range, in it or above it.
fn beside_range<E: Arithmetic>(
    slides: &Configuration<E>,
    least: &Answered<Limit<E>>,
    largest: &Answered<Limit<E>>,
) -> Result<Ordering, Undecided> {
    require(&slides.friction, "a positive purely sliding friction")?;
    let question = "which joint the friction is needed for";
    if let Some(least) = bound(least)?
        && decide(&(least - &slides.thrust), question, &[])?
    {
        return Ok(Ordering::Less);
    }
    let Some(largest) = bound(largest)? else { return Ok(Ordering::Equal) };
    let is_above = decide(&(slides.thrust.clone() - &largest), question, &[])?;
    Ok(if is_above { Ordering::Greater } else { Ordering::Equal })
}

/// The thrust at an end, where it has a bound.
fn bound<E: Arithmetic>(end: &Answered<Limit<E>>) -> Answered<E> {
    Ok(end.clone()?.and_then(|limit| limit.thrust))
}

/// The least friction for which some thrust of the range slides nowhere. The shoulder asks for more
/// the larger the thrust, an inner joint the smaller: best is the thrust at which they ask for the
/// same, or the end of the range next to it.
pub(super) fn required_friction<E: Arithmetic>(
    query: &Query<E>,
    roots: &impl Roots<E>,
    least: &Answered<Limit<E>>,
    largest: &Largest<E, impl FnOnce() -> Answered<Limit<E>>>,
) -> Result<E, Undecided> {
    let slides = LazyCell::new(|| roots.sliding());
    let in_few_bits = largest
        .in_few_bits
        .as_ref()
        .and_then(|(few, largest)| beside_range(&few.sliding().ok()?, least, largest).ok());
    let beside = in_few_bits.map_or_else(
        || beside_range(slides.as_ref().map_err(Clone::clone)?, least, &largest.whole),
        Ok,
    )?;
    let end = match beside {
        Ordering::Less => bound(least)?,
        Ordering::Equal => None,
        Ordering::Greater => bound(&largest.whole)?,
    };
    let Some(thrust) = end else { return Ok(LazyCell::force(&slides).clone()?.friction) };
    if beside == Ordering::Less {
        return Ok(sliding::shoulder(&query.given.half_opening, &thrust).value());
    }
    let at = query.given.clone().with(Unknown::Thrust, thrust);
    require(&room_for_steepest(&at), Condition::SteepestAboveShoulder.label())?;
    Ok(inner_friction(&at))
}

/// Question that is open where friction and the line of thrust may limit a thrust.
const WHICH_LIMIT: &str = "whether sliding or the line of thrust limits the thrust";

/// The least thrust of an arch that stands, where a joint may slide sooner.
pub(super) fn cut_at_least<E: Arithmetic>(
    query: &Query<E>,
    roots: &impl Roots<E>,
    least: Limit<E>,
) -> Result<Limit<E>, Undecided> {
    let Some(friction) = query.friction() else { return Ok(least) };
    let few = roots.in_few_bits();
    let in_few_bits =
        few.and_then(|few| slid_before(few.friction()?, &few, few.steepest().ok()?, &least).ok());
    match in_few_bits {
        Some(None) => Ok(least),
        _ => Ok(slid_before(friction, query, roots.steepest()?, &least)?.unwrap_or(least)),
    }
}

/// The thrust at which a joint slides at a friction, if that is before the least one is reached; `inner` is the
/// inner joint that slides.
fn slid_before<E: Arithmetic>(
    friction: &E,
    query: &Query<E>,
    inner: Configuration<E>,
    least: &Limit<E>,
) -> Answered<Limit<E>> {
    let (alpha, joint) = (&query.given.half_opening, inner.sliding_joint.rad);
    // T/N grows up to the steepest joint: if that lies beyond the shoulder, the shoulder counts.
    let inside = alpha.rad.clone() - &joint;
    let (slid, touch) = if decide(&inside, "whether the steepest joint is above the shoulder", &[])?
    {
        (inner.thrust, Touch::InnerSliding(joint))
    } else {
        let thrust = sliding::shoulder_thrust(alpha, &-friction.clone()).value();
        (thrust, Touch::ShoulderSlidingInwards)
    };
    let slides_first = match &least.thrust {
        Some(thrust) => decide(&(slid.clone() - thrust), WHICH_LIMIT, &[])?,
        None => false,
    };
    Ok(slides_first.then_some(Limit { thrust: Some(slid), touch }))
}

/// Cuts the range at the largest thrust; `never_slides` if the friction angle is exactly the half opening.
pub(super) fn cut_at_largest<E: Arithmetic>(
    query: &Query<E>,
    largest: Limit<E>,
    never_slides: bool,
) -> Result<Limit<E>, Undecided> {
    let Some(friction) = query.friction().filter(|_| !never_slides) else { return Ok(largest) };
    let shoulder = sliding::shoulder_thrust(&query.given.half_opening, friction);
    let slides_first = match &largest.thrust {
        // numerator / denominator < thrust, without dividing by what may be zero: the numerator
        // is positive, since something stands.
        Some(thrust) => {
            let margin = shoulder.denominator.clone() * thrust - &shoulder.numerator;
            decide(&margin, WHICH_LIMIT, &[])?
        }
        None => decide(&shoulder.denominator, "whether the shoulder can slide", &[])?,
    };
    Ok(match slides_first {
        true => Limit { thrust: Some(shoulder.value()), touch: Touch::ShoulderSliding },
        false => largest,
    })
}
