//! An arch of a given thickness: does it stand, with what safety, and how much may it thrust?
//!
//! It stands exactly if the [range of thrusts](super::thrust_range) is not empty; the least thickness of
//! the arch, proved on its own, has to say the same. Each answer is decided on its own: what stays open does
//! not take the others with it.

use super::query::Query;
use super::state::{Fall, Outcome};
use super::thrust_range::{
    Largest, Limit, Roots, Touch, cut_at_largest, cut_at_least, largest_thrust, least_thrust,
    required_friction,
};
use crate::arch::Unknown;
use crate::number::{Ball, ExactNumber, Ternary};
use crate::problem::{Arch, Quantity};
use crate::prover::arithmetic::Arithmetic;
use crate::prover::decide::{FEW, decide, require};
use crate::prover::figure::{Figure, Figured};
use crate::prover::ties::{friction_angle_is_half_opening, has_no_arm_at_crown};
use crate::prover::{Answered, Undecided};
use std::cell::LazyCell;

/// Certain answers about an arch of a given thickness, each answer with a reason where it stays open.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Assessment<T = Ball> {
    /// Tells whether the arch stands.
    pub stands: Result<bool, Undecided>,
    /// Reason why no thickness is enough, if none is.
    pub fall: Option<Fall>,
    /// The least thickness of the arch with this friction; `None` if there is none.
    pub least_thickness: Answered<T>,
    /// The thickness over the least thickness.
    pub geometric_safety: Answered<T>,
    /// The least friction with which the arch of this thickness stands; `None` if none is enough.
    pub required_friction: Answered<T>,
    /// The friction over the required one; `None` if either is unbounded.
    pub friction_safety: Answered<T>,
    /// The least and the largest admissible thrust; `None` if the arch does not stand.
    pub thrust: [Answered<Limit<T>>; 2],
}

impl<T> Assessment<T> {
    /// Turns all values into others, each of which may stay open; `open` says more of what does.
    pub(super) fn each<U>(
        self,
        value: impl Fn(T) -> Result<U, Undecided>,
        open: impl Fn(Undecided) -> Undecided,
    ) -> Assessment<U> {
        let single = |x: Answered<T>| x.and_then(|x| x.map(&value).transpose()).map_err(&open);
        let limit = |end: Answered<Limit<T>>| {
            end.and_then(|end| end.map(|limit| limit.each(&value)).transpose()).map_err(&open)
        };
        Assessment {
            stands: self.stands.map_err(&open),
            fall: self.fall,
            least_thickness: single(self.least_thickness),
            geometric_safety: single(self.geometric_safety),
            required_friction: single(self.required_friction),
            friction_safety: single(self.friction_safety),
            thrust: self.thrust.map(limit),
        }
    }

    /// Every value rounded to `digits` significant digits; those that enclosures of `bits` bits do not decide
    /// stay open.
    pub(super) fn rounded(self, digits: usize, bits: u32) -> AssessmentDigits
    where
        T: Figured,
    {
        let rounding = || Undecided::rounding("the rounding");
        self.each(|x| x.figure(digits).ok_or_else(rounding), |open| open.at(bits))
    }

    fn single(&self) -> [&Answered<T>; 4] {
        let Self { least_thickness, geometric_safety, required_friction, friction_safety, .. } =
            self;
        [least_thickness, geometric_safety, required_friction, friction_safety]
    }

    /// The values that there are, in the order of [`Quantity::ASSESSMENT`] and each limiting joint behind its
    /// thrust; `None` for a thrust or a safety without bound.
    pub fn figures(&self) -> impl Iterator<Item = (Quantity, Option<&T>)> {
        let single = Quantity::ASSESSMENT.into_iter().zip(self.single());
        let single = single.filter_map(|(of, figure)| Some((of, figure.as_ref().ok()?.as_ref())));
        let single = single.filter(|(of, figure)| {
            figure.is_some() || *of == Quantity::FrictionSafety && self.is_safe_from_sliding()
        });
        single.chain(THRUSTS.into_iter().zip(self.limits()).flat_map(|(thrust, limit)| {
            let joint = limit.and_then(|limit| thrust.joint().zip(limit.touch.joint()));
            let joint = joint.map(|(joint, figure)| (joint, Some(figure)));
            limit.map(|limit| (thrust, limit.thrust.as_ref())).into_iter().chain(joint)
        }))
    }

    /// The value of a quantity that there is, and that is finite.
    pub fn get(&self, quantity: Quantity) -> Option<&T> {
        self.figures().find(|(of, _)| *of == quantity)?.1
    }

    /// Tells whether the arch stands and nothing slides: some friction is required, and it is unlimited.
    fn is_safe_from_sliding(&self) -> bool {
        let Self { stands, required_friction, friction_safety, .. } = self;
        let is_required = !matches!(required_friction, Ok(None));
        *stands == Ok(true) && is_required && matches!(friction_safety, Ok(None))
    }

    /// The ends of the range of thrusts, where they are known and the arch stands.
    pub fn limits(&self) -> [Option<&Limit<T>>; 2] {
        self.thrust.each_ref().map(|limit| limit.as_ref().ok()?.as_ref())
    }

    /// Reason why a quantity of [`Quantity::ASSESSMENT`] stays open, if it does.
    pub fn why_open(&self, quantity: Quantity) -> Option<&Undecided> {
        self.open().find(|(of, _)| *of == quantity).map(|(_, open)| open)
    }

    /// The quantities that stay open, and why.
    pub fn open(&self) -> impl Iterator<Item = (Quantity, &Undecided)> {
        let single = self.single().map(|x| x.as_ref().err());
        let thrusts = self.thrust.each_ref().map(|limit| limit.as_ref().err());
        let all = Quantity::ASSESSMENT.into_iter().zip(single.into_iter().chain(thrusts));
        all.filter_map(|(of, open)| Some((of, open?)))
    }

    /// Reason why not everything is decided, where it is not.
    pub(in crate::certify) fn first_open(&self) -> Option<&Undecided> {
        self.stands.as_ref().err().or_else(|| self.open().next().map(|(_, undecided)| undecided))
    }

    /// Assessment completed with what another precision has decided where this one has not.
    pub(super) fn or(self, other: Self) -> Self {
        let [[least, largest], [other_least, other_largest]] = [self.thrust, other.thrust];
        Self {
            stands: self.stands.or(other.stands),
            fall: self.fall.or(other.fall),
            least_thickness: self.least_thickness.or(other.least_thickness),
            geometric_safety: self.geometric_safety.or(other.geometric_safety),
            required_friction: self.required_friction.or(other.required_friction),
            friction_safety: self.friction_safety.or(other.friction_safety),
            thrust: [least.or(other_least), largest.or(other_largest)],
        }
    }
}
/// Certain answers in digits, correctly rounded.
pub type AssessmentDigits = Assessment<Figure>;

/// The ends of the range of thrusts.
const THRUSTS: [Quantity; 2] = [Quantity::LeastThrust, Quantity::LargestThrust];

/// Question about an arch of a given thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Wanted {
    /// Verdict on whether the arch stands, and how far its thickness is from the least: its state says so.
    Standing,
    /// Also the range of thrusts, and the friction that it asks for.
    Everything,
}

impl Wanted {
    /// Quantities that the range of thrusts tells, and the state does not.
    pub const BY_THRUSTS: [Quantity; 4] = [
        Quantity::RequiredFriction,
        Quantity::FrictionSafety,
        Quantity::LeastThrust,
        Quantity::LargestThrust,
    ];

    /// Answers that quantities of an arch with a thickness need.
    pub fn of(quantities: &[Quantity]) -> Self {
        match quantities.iter().any(|of| Self::BY_THRUSTS.contains(of) || of.is_force()) {
            true => Self::Everything,
            false => Self::Standing,
        }
    }
}

/// Proves what holds for an arch with a given thickness in `(0, 2]`, as far as it is wanted, in the numbers of
/// its query. `state` proves the state of the arch, with its own friction if told so, or with unlimited
/// friction, in numbers of so many bits.
pub(super) fn assessment<E: Arithmetic>(
    arch: &Arch,
    thickness: &ExactNumber,
    mut query: Query<E>,
    wanted: Wanted,
    state: impl Fn(bool, u32) -> Result<Outcome<E>, Undecided>,
) -> Assessment<E> {
    let bits = query.bits;
    let eta: E = thickness.enclosure(bits);
    let least = |found: Result<Outcome<E>, Undecided>| match found? {
        Outcome::Stands(state) => Ok((Some(state.thickness), None)),
        Outcome::Falls(why) => Ok((None, Some(why))),
    };
    let own = least(state(true, bits));
    let fall = own.as_ref().ok().and_then(|(_, fall)| *fall);
    let mut found = standing(&eta, own.map(|(least, _)| least));
    if wanted == Wanted::Everything {
        let unlimited = |bits| least(state(!arch.is_limited(), bits)).map(|(least, _)| least);
        // Only the sign of what it leaves is asked for: few bits mostly tell it.
        let line_fits = match line_fits(&eta, &unlimited(bits.min(FEW))) {
            Err(_) => line_fits(&eta, &unlimited(bits)),
            told => told,
        };
        query.given = query.given.with(Unknown::Thickness, eta);
        let ties = [has_no_arm_at_crown(arch, thickness), friction_angle_is_half_opening(arch)];
        found = with_thrusts((found, [true; 2]), &query, &query, ties, line_fits);
    }
    Assessment { fall, ..found }
}

/// The assessment of a thickness, as far as the least thickness of the arch tells it.
pub(super) fn standing<E: Arithmetic>(eta: &E, least_thickness: Answered<E>) -> Assessment<E> {
    let stands =
        of(&least_thickness, |least| enough(eta, least, "whether the thickness is enough"));
    Assessment {
        stands: stands.map(|enough| enough == Some(true)),
        fall: None,
        geometric_safety: of(&least_thickness, |least| Ok(eta.clone() / least)),
        least_thickness,
        required_friction: Ok(None),
        friction_safety: Ok(None),
        thrust: [Ok(None), Ok(None)],
    }
}

fn enough<E: Arithmetic>(eta: &E, least: &E, question: &'static str) -> Result<bool, Undecided> {
    decide(&(eta.clone() - least), question, &[])
}

/// Tells whether a line of thrust lies inside an arch of this thickness at all, with unlimited friction, by the least
/// thickness of that: `Some` if one does.
pub(super) fn line_fits<E: Arithmetic>(eta: &E, unlimited: &Answered<E>) -> Answered<()> {
    let fits = of(unlimited, |least| enough(eta, least, "whether a line of thrust fits"));
    fits.map(|fits| (fits == Some(true)).then_some(()))
}

/// The assessment with the required friction and the range of thrusts, as they are wanted, from roots and whether a
/// line of thrust fits. The ties are that the crown has no arm, and that the shoulder never slides.
pub(super) fn with_thrusts<E: Arithmetic>(
    (standing, [wants_friction, wants_thrusts]): (Assessment<E>, [bool; 2]),
    query: &Query<E>,
    roots: &impl Roots<E>,
    [has_no_arm, never_slides]: [bool; 2],
    line_fits: Answered<()>,
) -> Assessment<E> {
    let least = of(&line_fits, |()| least_thrust(query, roots));
    let largest = Largest {
        in_few_bits: roots.in_few_bits().map(|few| {
            let largest = of(&line_fits, |()| largest_thrust(&few, &few, has_no_arm));
            (few, largest)
        }),
        whole: LazyCell::new(|| of(&line_fits, |()| largest_thrust(query, roots, has_no_arm))),
    };
    let not_asked = || Undecided::new("what is not asked for");
    let required_friction = match wants_friction {
        true => of(&line_fits, |()| required_friction(query, roots, &least, &largest)),
        false => Err(not_asked()),
    };
    // Friction enough and a line of thrust that fits are the other way to say that it stands.
    let stands =
        standing.stands.clone().or_else(|open| match (&required_friction, query.friction()) {
            (Ok(None), _) => Ok(false),
            (Ok(Some(_)), None) => Ok(true),
            (Ok(Some(least)), Some(mu)) => match least.is_less_than(mu) {
                Ternary::True => Ok(true),
                Ternary::False => Ok(false),
                Ternary::Undecided => Err(open),
            },
            (Err(_), _) => Err(open),
        });
    let friction_safety = match query.friction() {
        Some(friction) => of(&required_friction, |required| Ok(friction.clone() / required)),
        None => Ok(None),
    };
    let cut_at_largest = |largest: &Answered<Limit<E>>| {
        of(largest, |largest| cut_at_largest(query, largest.clone(), never_slides))
    };
    let thrust = match stands {
        _ if !wants_thrusts => [Err(not_asked()), Err(not_asked())],
        Ok(false) => [Ok(None), Ok(None)],
        Ok(true) => not_empty([
            of(&least, |least| cut_at_least(query, roots, least.clone())),
            match largest.in_few_bits.as_ref().map(|(_, largest)| cut_at_largest(largest)) {
                Some(Ok(Some(slid @ Limit { touch: Touch::ShoulderSliding, .. }))) => {
                    Ok(Some(slid))
                }
                _ => cut_at_largest(&largest.whole),
            },
        ]),
        Err(ref open) => [Err(open.clone()), Err(open.clone())],
    };
    Assessment { stands, required_friction, friction_safety, thrust, ..standing }
}

/// The range of an arch that stands: the two routes have to agree.
fn not_empty<E: Arithmetic>(ends: [Answered<Limit<E>>; 2]) -> [Answered<Limit<E>>; 2] {
    let [least, largest] = ends.each_ref().map(|end| end.as_ref().ok()?.as_ref()?.thrust.as_ref());
    let Some((least, largest)) = least.zip(largest) else { return ends };
    let question = "a range of thrusts that is not empty";
    match require(&(largest.clone() - least), question) {
        Ok(()) => ends,
        Err(open) => [Err(open.clone()), Err(open)],
    }
}

/// Maps an answer, where it is known and there is one.
fn of<T, U>(known: &Answered<T>, f: impl FnOnce(&T) -> Result<U, Undecided>) -> Answered<U> {
    known.as_ref().map_err(Clone::clone)?.as_ref().map(f).transpose()
}
