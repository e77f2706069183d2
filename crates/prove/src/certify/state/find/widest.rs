//! The widest half opening that stands at a thickness and a friction.
//!
//! Either friction is used up inside and at the shoulder, whatever the thickness, or the thickness is the
//! least one of the half opening. The thrust and the touching joint do not see the half opening: they are
//! found first and tell the mode.

use crate::arch::{Configuration, Ring, SelfWeight, Unknown, contact, thrust};
use crate::certify::landmark::CertifiedLandmark;
use crate::certify::state::inner::by_the_higher_joint;
use crate::certify::state::mode::prove;
use crate::certify::state::query::Query;
use crate::number::{Angle, Ball, ExactNumber, Field};
use crate::problem::{
    Arch, Condition, Examined, Landmark, Mode, Quantity, System, room_for_steepest,
};
use crate::prover::Undecided;
use crate::prover::arithmetic::Arithmetic;
use crate::prover::decide::{decide, in_few_bits, require, require_condition};
use crate::solve::start::{self, Start};

/// A mode, and where its equations hold.
pub(in crate::certify::state) type ModeAt<E> = (Mode, Configuration<E>);

/// A mode, and where the search for the unknowns of its equations starts.
type ModeStart<E> = (Mode, Vec<<E as Arithmetic>::Candidate>);

/// Above this friction no thickness in the range is limited by sliding at both places: a start only.
const ROUGH: f64 = 10.0;

/// Given values of an arch at a thickness; its half opening is asked for.
pub(in crate::certify::state) fn at_thickness<E: Arithmetic>(
    arch: &Arch,
    thickness: &ExactNumber,
    bits: u32,
) -> Query<E> {
    let query: Query<E> = Query::new(arch, bits);
    let zero = query.given.thrust.clone();
    let given = query.given.clone().with(Unknown::HalfOpening, zero);
    Query { given: given.with(Unknown::Thickness, thickness.enclosure(bits)), ..query }
}

/// Bits that the equations lose to cancellation at a small thickness or friction, where the half opening is
/// small too, or at a large friction, where the thrust is.
pub(in crate::certify::state) fn bits_lost(query: &Query) -> u32 {
    let exponent = |x: &Ball| i64::from(x.mid().get_exp().unwrap_or(0));
    let given = &query.given;
    // eta falls like the fourth power of the half opening, the friction like the third.
    let narrow = [
        -exponent(&given.half_opening.rad),
        -exponent(&given.thickness) / 4,
        -exponent(&given.friction) / 3,
    ];
    let narrow = narrow.into_iter().max().unwrap_or(0).max(0);
    let rough = exponent(&given.friction).max(0);
    u32::try_from(6 * narrow + 4 * rough).unwrap_or(u32::MAX)
}

/// The end of rotation or of overturning, where a quantity has exactly this value there.
pub(in crate::certify::state) fn exact_end(
    weight: SelfWeight,
    quantity: Quantity,
    value: &ExactNumber,
) -> Option<Landmark> {
    let value = value.is_rational().then(|| value.to_rational())?;
    let ends = [Landmark::RotationEnd, Landmark::OverturningEnd];
    ends.into_iter().find(|end| {
        let exact = CertifiedLandmark::new(*end, weight).ok().and_then(|end| end.exact(quantity));
        exact.is_some_and(|exact| exact.rational() == Some(&value))
    })
}

/// Place of the end of rotation or of overturning.
pub(in crate::certify::state) fn at_end<E: Arithmetic>(
    end: Landmark,
    weight: SelfWeight,
    bits: u32,
) -> Result<Configuration<E>, Undecided> {
    let end = CertifiedLandmark::new(end, weight)?.enclosure(bits)?;
    Ok(end.configuration().map_ref(|x| E::from_ball(x, bits)))
}

/// The widest half opening for the thickness and the friction of `query`, which has no half opening; `end` is where
/// the thickness is [exactly](exact_end) that of an end.
pub(in crate::certify::state) fn widest<E: Arithmetic>(
    query: &Query<E>,
    end: Option<Landmark>,
) -> Result<ModeAt<E>, Undecided> {
    let slides = match query.friction() {
        // Where few bits tell that not both slide, the root is of no use.
        Some(friction) if friction.candidate() < ROUGH => {
            let few = query.in_few_bits().map(|few| where_both_slide(&few));
            few.filter(|few| matches!(few, Ok(None))).unwrap_or_else(|| where_both_slide(query))
        }
        _ => Ok(None),
    };
    if let Ok(Some(found)) = slides {
        return Ok(found);
    }
    let touches = match end {
        Some(Landmark::OverturningEnd) => at_physical_limit(query),
        Some(end) if !query.is_limited => {
            Ok((Mode::Overturning, at_end(end, query.weight, query.bits)?))
        }
        end => where_the_shoulder_ends(query, end.is_some()),
    };
    // What stays open about sliding is the reason where nothing else is found.
    touches.map_err(|open| slides.err().unwrap_or(open))
}

/// The purely sliding state of the friction, if a line of thrust lies inside the thickness there.
fn where_both_slide<E: Arithmetic>(query: &Query<E>) -> Result<Option<ModeAt<E>>, Undecided> {
    let start = start::widest_sliding(&friction(query));
    let at = query.root(Mode::Sliding.system_for_half_opening(query.weight), &start)?;
    let has_room = in_few_bits(&at, query.bits, |at, bits| {
        in_range(at)?;
        for condition in [Condition::Above(Unknown::Thrust), Condition::Compression] {
            let margin = Examined::new(query.weight, Mode::Sliding, at).margin(condition);
            require_condition(condition, &margin, Mode::Sliding)?;
        }
        require(&room_for_steepest(at), Condition::SteepestAboveShoulder.label())?;
        has_room(&Query { bits, given: at.clone(), ..*query }, at)
    })?;
    Ok(has_room.then_some((Mode::Sliding, at)))
}

/// The half opening has to be in its range, in which alone the lemma holds.
pub(super) fn in_range<E: Arithmetic>(at: &Configuration<E>) -> Result<(), Undecided> {
    let alpha = &at.half_opening.rad;
    require(alpha, Condition::Above(Unknown::HalfOpening).label())?;
    require(&(alpha.pi() - alpha), Condition::Below(Unknown::HalfOpening).label())
}

/// Tells whether the crown moment that puts the line of thrust on the intrados, at the thrust of `at`, leaves
/// room at the extrados of the crown and of the shoulder.
fn has_room<E: Arithmetic>(query: &Query<E>, at: &Configuration<E>) -> Result<bool, Undecided> {
    let joint = touched_joint(query, at)?;
    let question = "whether sliding or the thickness limits the half opening";
    // Beyond the shoulder nothing touches: the moment is least at the shoulder itself.
    let joint = match decide(&(at.half_opening.rad.clone() - &joint.rad), question, &[])? {
        true => joint,
        false => at.half_opening.clone(),
    };
    let moment = -contact::intrados_margin(query.weight, &joint, at, &at.thrust.int(0));
    let crown = contact::crown_moment(at) - &moment;
    let shoulder = contact::extrados_margin_at_shoulder(query.weight, at, &moment);
    Ok(decide(&crown, question, &[])? && decide(&shoulder, question, &[])?)
}

/// Joint where the moment about the intrados is least: the crown, or the joint where (5) holds.
fn touched_joint<E: Arithmetic>(
    query: &Query<E>,
    at: &Configuration<E>,
) -> Result<Angle<E>, Undecided> {
    let slope = contact::crown_slope(query.weight, at);
    let between = [Mode::OverturningSliding, Mode::RotationalSlidingRotational];
    if decide(&slope, "whether the intrados is touched at the crown", &between)? {
        return Ok(Angle::zero(&at.thrust));
    }
    let fixed = Query { given: at.clone(), ..query.clone() };
    let touched = fixed.root(System::tangent(query.weight), &[tangent_start(query, at)])?;
    let beta = &touched.rotation_joint.rad;
    require(beta, "a touching joint below the crown")?;
    // There beta cot(beta) falls, so that no other joint has this value.
    require(&(beta.pi() - beta), "a touching joint within half a turn")?;
    Ok(touched.rotation_joint)
}

/// `beta_r` by (5), a candidate.
fn tangent_start<E: Arithmetic>(query: &Query<E>, at: &Configuration<E>) -> E::Candidate {
    let ring = Ring::new(query.weight, &at.thickness);
    // (5) is linear in beta cot(beta), with the slope one.
    let without = thrust::tangency(&at.thrust.int(0), &ring).value();
    start::tangent_joint(&(at.thrust.clone() - without).candidate())
}

/// The half opening whose least thickness is the one given, below 2; `is_end` if it is exactly that of the end of
/// rotation, where nothing rotates any more.
fn where_the_shoulder_ends<E: Arithmetic>(
    query: &Query<E>,
    is_end: bool,
) -> Result<ModeAt<E>, Undecided> {
    let mut open: Option<Undecided> = None;
    for (mode, start) in query.by_few_bits(|query| candidates(query, is_end))? {
        match proved(query, mode, &start) {
            Ok(place) => return Ok(place),
            // A difference that is too small to tell says more than a root that is another one.
            Err(other) if other.gap.is_some() || open.is_none() => open = Some(other),
            Err(_) => {}
        }
    }
    Err(open.unwrap_or_else(Undecided::no_solution))
}

/// The modes that may be those of the shoulder that ends at the thickness, what seems so first.
fn candidates<E: Arithmetic>(
    query: &Query<E>,
    is_end: bool,
) -> Result<Vec<ModeStart<E>>, Undecided> {
    let beyond = contact::crown_slope(query.weight, &query.given);
    let question = "whether the arch is thicker than at the end of rotation";
    let between = [Mode::Rotational, Mode::Overturning];
    let rotates = !is_end && decide(&-beyond, question, &between)?;
    let slid = match query.friction() {
        Some(mu) => {
            let start = start::inner_sliding(&mu.candidate());
            Some(query.root(System::inner_sliding(query.weight), &start)?)
        }
        None => None,
    };
    let eta = query.given.thickness.candidate();
    let least = match rotates {
        true => {
            let start = start::rotational_with_thickness(query.weight, &eta);
            Some(query.root(System::touching(query.weight, true), &start)?)
        }
        false => None,
    };
    Ok(match (&least, &slid) {
        (None, None) => {
            let a = start::widest_touching(query.weight, eta.to_double(), 0.0, 0.0);
            vec![(Mode::Overturning, vec![eta.like(a)])]
        }
        (Some(least), Some(slid))
            if !decide(
                &(slid.thrust.clone() - &least.thrust),
                "whether an inner joint slides",
                &[Mode::Rotational, Mode::RotationalSliding],
            )? =>
        {
            rotating(query, least, Some(friction(query)))
        }
        (Some(least), None) => rotating(query, least, None),
        (_, Some(slid)) => vec![sliding_inside(query, slid)?],
    })
}

/// The root next to a start, proved to be the state of its arch.
fn proved<E: Arithmetic>(
    query: &Query<E>,
    mode: Mode,
    start: &[E::Candidate],
) -> Result<ModeAt<E>, Undecided> {
    let at = query.root(mode.system_for_half_opening(query.weight), start)?;
    let mode = match mode {
        Mode::RotationalSliding => by_the_higher_joint(&at)?,
        mode => mode,
    };
    in_range(&at)?;
    prove(query, mode, &at, query.is_limited)?;
    Ok((mode, at))
}

/// Hinges at haunch and crown fix the thrust: the shoulder is on its extrados or slides, whichever is sooner;
/// what seems so comes first.
fn rotating<E: Arithmetic>(
    query: &Query<E>,
    least: &Configuration<E>,
    friction: Option<E::Candidate>,
) -> Vec<ModeStart<E>> {
    let (beta, h) = (least.rotation_joint.rad.candidate(), least.thrust.candidate());
    let inside = start::widest_rotational(query.weight, &least.thickness.candidate(), &h);
    let slid = friction.map(|mu| start::widest_without_sliding(&h, &mu));
    let slides_first = slid.as_ref().is_some_and(|slid| slid.clone() - &inside < 0.0);
    let start = |alpha| vec![beta.clone(), alpha, h.clone()];
    let slid = slid.map(|slid| (Mode::SlidingRotational, start(slid)));
    let mut both: Vec<_> = slid.into_iter().chain([(Mode::Rotational, start(inside))]).collect();
    if !slides_first {
        both.reverse();
    }
    both
}

/// A sliding inner joint fixes the thrust: the intrados is touched at the crown or below.
fn sliding_inside<E: Arithmetic>(
    query: &Query<E>,
    slid: &Configuration<E>,
) -> Result<ModeStart<E>, Undecided> {
    let (h, joint) = (slid.thrust.candidate(), slid.sliding_joint.rad.candidate());
    let slope = contact::crown_slope(query.weight, slid);
    let between = [Mode::OverturningSliding, Mode::RotationalSlidingRotational];
    let at_crown = decide(&slope, "whether the intrados is touched at the crown", &between)?;
    let beta = match at_crown {
        true => h.int(0),
        false => tangent_start(query, slid),
    };
    let eta = slid.thickness.candidate().to_double();
    let alpha = start::widest_touching(query.weight, eta, h.to_double(), beta.to_double());
    let alpha = h.like(alpha);
    Ok(match at_crown {
        true => (Mode::OverturningSliding, vec![alpha, h, joint]),
        false => (Mode::RotationalSliding, vec![beta, alpha, h, joint]),
    })
}

/// The half opening from which no thickness up to 2 is enough.
fn at_physical_limit<E: Arithmetic>(query: &Query<E>) -> Result<ModeAt<E>, Undecided> {
    let (mode, start) = match query.friction() {
        Some(_) => {
            let start = start::inner_sliding(&friction(query));
            let slid = |query: &Query<E>| query.root(System::inner_sliding(query.weight), &start);
            query.by_few_bits(|query| sliding_inside(query, &slid(query)?))?
        }
        None => {
            let a = start::widest_touching(query.weight, 2.0, 0.0, 0.0);
            (Mode::Overturning, vec![query.alpha().like(a)])
        }
    };
    let at = query.root(mode.system_for_half_opening(query.weight), &start)?;
    in_range(&at)?;
    require(&-at.half_opening.cos.clone(), "a half opening above a right angle")?;
    let own = [Condition::Compression, Condition::IntradosAtCrown];
    let limited = [
        Condition::Above(Unknown::Thrust),
        Condition::Below(Unknown::Thrust),
        Condition::Below(Unknown::SlidingJoint),
        Condition::FrictionAtShoulder,
    ];
    let state = Examined::new(query.weight, mode, &at);
    let limited = limited.into_iter().filter(|_| query.is_limited);
    own.into_iter()
        .chain(limited)
        .try_for_each(|condition| require_condition(condition, &state.margin(condition), mode))?;
    drop(state);
    Ok((mode, at))
}

/// The friction, a candidate.
fn friction<E: Arithmetic>(query: &Query<E>) -> E::Candidate {
    query.given.friction.candidate()
}
