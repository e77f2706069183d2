//! The widest half opening that stands at a thickness and a friction.
//!
//! Either friction is used up inside and at the shoulder, whatever the thickness, or the thickness is the
//! least one of the half opening. The thrust and the touching joint do not see the half opening: they are
//! found first and tell the mode.

use crate::arch::{Configuration, Ring, Unknown, contact, thrust};
use crate::certify::Undecided;
use crate::certify::state::mode::prove;
use crate::certify::state::query::Query;
use crate::certify::undecided::{decide, require, require_condition};
use crate::number::{Angle, Ball, ExactNumber, Field, Real};
use crate::problem::{Arch, Condition, Examined, Mode, System, room_for_steepest};
use crate::solve::start;
use rug::Float;

/// A mode, and where its equations hold.
pub(in crate::certify::state) type Place = (Mode, Configuration<Ball>);

/// Above this friction no thickness in the range is limited by sliding at both places: a start only.
const ROUGH: f64 = 10.0;

/// What is given of an arch at a thickness; its half opening is asked for.
pub(in crate::certify::state) fn at_thickness(
    arch: &Arch,
    thickness: &ExactNumber,
    bits: u32,
) -> Query {
    let query = Query::new(arch, bits);
    let zero = Ball::integer(0, bits);
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

/// The widest half opening for the thickness and the friction of `query`, which has no half opening;
/// `is_limit` if the thickness is exactly 2.
pub(in crate::certify::state) fn widest(query: &Query, is_limit: bool) -> Result<Place, Undecided> {
    let slides = match query.friction() {
        Some(friction) if *friction.mid() < ROUGH => where_both_slide(query),
        _ => Ok(None),
    };
    if let Ok(Some(found)) = slides {
        return Ok(found);
    }
    let touches = match is_limit {
        true => at_physical_limit(query),
        false => where_the_shoulder_ends(query),
    };
    // What stays open about sliding is the reason where nothing else is found.
    touches.map_err(|open| slides.err().unwrap_or(open))
}

/// The purely sliding state of the friction, if a line of thrust lies inside the thickness there.
fn where_both_slide(query: &Query) -> Result<Option<Place>, Undecided> {
    let start = start::widest_sliding(&friction(query));
    let at = query.root(Mode::Sliding.system_for_half_opening(query.weight), &start)?;
    in_range(&at)?;
    for condition in [Condition::Above(Unknown::Thrust), Condition::Compression] {
        let margin = Examined::new(query.weight, Mode::Sliding, &at).margin(condition);
        require_condition(condition, &margin, Mode::Sliding)?;
    }
    require(&room_for_steepest(&at), Condition::SteepestAboveShoulder.label())?;
    Ok(has_room(query, &at)?.then_some((Mode::Sliding, at)))
}

/// The half opening has to be in its range, in which alone the lemma holds.
fn in_range(at: &Configuration<Ball>) -> Result<(), Undecided> {
    let alpha = &at.half_opening.rad;
    require(alpha, Condition::Above(Unknown::HalfOpening).label())?;
    require(&(alpha.pi() - alpha), Condition::Below(Unknown::HalfOpening).label())
}

/// Whether the crown moment that puts the line of thrust on the intrados, at the thrust of `at`, leaves room at
/// the extrados of the crown and of the shoulder.
fn has_room(query: &Query, at: &Configuration<Ball>) -> Result<bool, Undecided> {
    let joint = touched_joint(query, at)?;
    let question = "whether sliding or the thickness limits the half opening";
    // Beyond the shoulder nothing touches: the shoulder itself comes nearest.
    let joint = match decide(&(at.half_opening.rad.clone() - &joint.rad), question, &[])? {
        true => joint,
        false => at.half_opening.clone(),
    };
    let moment = -contact::intrados_margin(query.weight, &joint, at, &at.thrust.int(0));
    let crown = contact::crown_moment(at) - &moment;
    let shoulder = contact::extrados_margin_at_shoulder(query.weight, at, &moment);
    Ok(decide(&crown, question, &[])? && decide(&shoulder, question, &[])?)
}

/// Where the line of thrust comes nearest to the intrados: the crown, or the joint where (5) holds.
fn touched_joint(query: &Query, at: &Configuration<Ball>) -> Result<Angle<Ball>, Undecided> {
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
fn tangent_start(query: &Query, at: &Configuration<Ball>) -> Float {
    let ring = Ring::new(query.weight, &at.thickness);
    // (5) is linear in beta cot(beta), with the slope one.
    let without = thrust::tangency(&at.thrust.int(0), &ring).value();
    start::tangent_joint(&Float::with_val(query.bits, (at.thrust.clone() - without).mid()))
}

/// The half opening whose least thickness is the one given, below 2.
fn where_the_shoulder_ends(query: &Query) -> Result<Place, Undecided> {
    let beyond = contact::crown_slope(query.weight, &query.given);
    let question = "whether the arch is thicker than at the end of rotation";
    let rotates = decide(&-beyond, question, &[Mode::Rotational, Mode::Overturning])?;
    let slid = match query.friction() {
        Some(mu) => {
            let start = start::inner_sliding(&Float::with_val(query.bits, mu.mid()));
            Some(query.root(System::inner_sliding(query.weight), &start)?)
        }
        None => None,
    };
    let eta = Float::with_val(query.bits, query.given.thickness.mid());
    let least = match rotates {
        true => {
            let start = start::rotational_with_thickness(query.weight, &eta);
            Some(query.root(System::touching(query.weight, true), &start)?)
        }
        false => None,
    };
    let candidates = match (&least, &slid) {
        (None, None) => {
            let a = start::widest_touching(query.weight, eta.to_f64(), 0.0, 0.0);
            vec![(Mode::Overturning, vec![Float::with_val(query.bits, a)])]
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
    };
    let mut open: Option<Undecided> = None;
    for (mode, start) in candidates {
        match proved(query, mode, &start) {
            Ok(place) => return Ok(place),
            // A difference that is too small to tell says more than a root that is another one.
            Err(other) if other.gap.is_some() || open.is_none() => open = Some(other),
            Err(_) => {}
        }
    }
    Err(open.unwrap_or_else(|| Undecided::new("no candidate is found")))
}

/// The root next to a start, proved to be the state of its arch.
fn proved(query: &Query, mode: Mode, start: &[Float]) -> Result<Place, Undecided> {
    let at = query.root(mode.system_for_half_opening(query.weight), start)?;
    let mode = match mode {
        Mode::RotationalSliding => {
            let above = at.rotation_joint.rad.clone() - &at.sliding_joint.rad;
            let between = [Mode::RotationalSliding, Mode::RotationalSlidingRotational];
            let above = decide(&above, "which of the two inner joints is higher", &between)?;
            between[usize::from(!above)]
        }
        mode => mode,
    };
    in_range(&at)?;
    prove(query, mode, &at, query.is_limited)?;
    Ok((mode, at))
}

/// Hinges at haunch and crown fix the thrust: the shoulder is on its extrados or slides, whichever is sooner;
/// what seems so comes first.
fn rotating(
    query: &Query,
    least: &Configuration<Ball>,
    friction: Option<Float>,
) -> Vec<(Mode, Vec<Float>)> {
    let float = |x: &Ball| Float::with_val(query.bits, x.mid());
    let (beta, h) = (float(&least.rotation_joint.rad), float(&least.thrust));
    let inside = start::widest_rotational(query.weight, &float(&least.thickness), &h);
    let slid = friction.map(|mu| start::widest_without_sliding(&h, &mu));
    let slides_first = slid.as_ref().is_some_and(|slid| *slid < inside);
    let start = |alpha| vec![beta.clone(), alpha, h.clone()];
    let slid = slid.map(|slid| (Mode::SlidingRotational, start(slid)));
    let mut both: Vec<_> = slid.into_iter().chain([(Mode::Rotational, start(inside))]).collect();
    if !slides_first {
        both.reverse();
    }
    both
}

/// A sliding inner joint fixes the thrust: the intrados is touched at the crown or below.
fn sliding_inside(
    query: &Query,
    slid: &Configuration<Ball>,
) -> Result<(Mode, Vec<Float>), Undecided> {
    let (h, joint) = (slid.thrust.mid().clone(), slid.sliding_joint.rad.mid().clone());
    let slope = contact::crown_slope(query.weight, slid);
    let between = [Mode::OverturningSliding, Mode::RotationalSlidingRotational];
    let at_crown = decide(&slope, "whether the intrados is touched at the crown", &between)?;
    let beta = match at_crown {
        true => Float::new(query.bits),
        false => tangent_start(query, slid),
    };
    let eta = slid.thickness.mid().to_f64();
    let alpha = start::widest_touching(query.weight, eta, h.to_f64(), beta.to_f64());
    let alpha = Float::with_val(query.bits, alpha);
    Ok(match at_crown {
        true => (Mode::OverturningSliding, vec![alpha, h, joint]),
        false => (Mode::RotationalSliding, vec![beta, alpha, h, joint]),
    })
}

/// The half opening from which no thickness up to 2 is enough.
fn at_physical_limit(query: &Query) -> Result<Place, Undecided> {
    let (mode, start) = match query.friction() {
        Some(_) => {
            let start = start::inner_sliding(&friction(query));
            let slid = query.root(System::inner_sliding(query.weight), &start)?;
            sliding_inside(query, &slid)?
        }
        None => {
            let a = start::widest_touching(query.weight, 2.0, 0.0, 0.0);
            (Mode::Overturning, vec![Float::with_val(query.bits, a)])
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
fn friction(query: &Query) -> Float {
    Float::with_val(query.bits, query.given.friction.mid())
}
