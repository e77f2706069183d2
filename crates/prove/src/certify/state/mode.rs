//! Mode that an arch collapses in: every comparison decided, or the reason why not.

use super::inner::inner_state;
use super::query::Query;
use super::rotation::rotational_root;
use super::small::Small;
use super::state::{Fall, Frictions, Outcome, State};
use crate::arch::{Configuration, PerWeight, SelfWeight, contact, overturning, sliding, thrust};
use crate::certify::landmark::CertifiedLandmark;
use crate::number::{Angle, Ball};
use crate::problem::{
    Condition, Examined, Landmark, Mode, System, inner_friction, room_for_steepest,
    shoulder_friction, tally,
};
use crate::prover::Undecided;
use crate::prover::arithmetic::{Arithmetic, larger};
use crate::prover::decide::{decide, in_few_bits, require, require_condition};
use crate::solve::start::{self, Start};
use std::sync::OnceLock;

/// A purely rotational state.
struct RotationalState<E> {
    state: State<E>,
    /// The frictions that the shoulder and an inner joint ask for, if they are asked for.
    frictions: Option<[E; 2]>,
    /// Mode whose joint slides where the friction of the arch is not enough for pure rotation.
    slides: Result<Option<Mode>, Undecided>,
}

impl<E: Arithmetic> RotationalState<E> {
    /// The friction from which collapse is purely rotational: the larger of the two.
    fn friction(&self) -> Option<E> {
        let [shoulder, inner] = self.frictions.as_ref()?;
        Some(larger(shoulder.clone(), inner.clone()))
    }
}

/// Mode whose joint slides where a friction is not enough for pure rotation, by the frictions that the shoulder and an
/// inner joint ask for. Both can fail only below the purely sliding friction.
fn sliding_mode<E: Arithmetic>(friction: &E, asked: &[E; 2]) -> Result<Option<Mode>, Undecided> {
    let mut open = None;
    for (asked, mode) in asked.iter().zip([Mode::SlidingRotational, Mode::RotationalSliding]) {
        let question = "whether the friction is enough for pure rotation";
        match decide(&(friction.clone() - asked), question, &[Mode::Rotational, mode]) {
            Ok(true) => {}
            Ok(false) => return Ok(Some(mode)),
            Err(undecided) => open = open.or(Some(undecided)),
        }
    }
    open.map_or(Ok(None), Err)
}

/// Result where the friction is above the purely sliding one.
enum AboveSliding<E> {
    /// A state, and the friction from which collapse is purely rotational, if any is enough and it was
    /// asked for.
    State(Box<State<E>>, Option<E>),
    /// The arch would have to be thicker than twice the radius.
    Falls,
}

/// The state, and why it is the one.
///
/// A state that is admissible and the thinnest is a proof by itself. Whether the friction is below
/// the purely sliding one, and where the half opening is beside those of `l` and `L`, is proved where
/// it is the answer, or where a candidate suggests that there is no state. Without `frictions`, those at which the mode
/// changes, only what this proof needs is evaluated.
pub(super) fn outcome<E: Arithmetic>(
    query: &Query<E>,
    frictions: bool,
) -> Result<Outcome<E>, Undecided> {
    tally::working_bits(query.bits);
    let mut least_friction = None;
    if frictions || seems_to_slide(query) {
        let slides = pure_sliding(query)?;
        if falls_by_sliding(query, &slides)? {
            return Ok(Outcome::Falls(Fall::Sliding));
        }
        least_friction = Some(slides);
    }
    let found = state_above_sliding(query, frictions);
    let is_proved = matches!(found, Ok(AboveSliding::State(..)));
    if !is_proved && least_friction.is_none() && query.is_limited {
        // Too little friction would be the reason, and comes before any other.
        if falls_by_sliding(query, &pure_sliding(query)?)? {
            return Ok(Outcome::Falls(Fall::Sliding));
        }
    }
    match found? {
        AboveSliding::Falls => Ok(Outcome::Falls(Fall::Thickness)),
        AboveSliding::State(mut state, rotational) => {
            state.frictions = least_friction
                .filter(|_| frictions)
                .map(|sliding| Frictions { sliding, rotational });
            Ok(Outcome::Stands(state))
        }
    }
}

/// Tells whether the friction seems to be below the purely sliding one: a candidate.
fn seems_to_slide<E: Arithmetic>(query: &Query<E>) -> bool {
    query.friction().is_some_and(|friction| {
        let [least, ..] = start::sliding(&query.alpha().cut(64));
        friction.candidate() / (least.like(1.001) * least) < 1.0
    })
}

/// The friction of the purely sliding state.
pub(super) fn pure_sliding<E: Arithmetic>(query: &Query<E>) -> Result<E, Undecided> {
    if let Some(small) = Small::of(query) {
        return Ok(small.pure_sliding()?.friction());
    }
    Ok(sliding_root(query)?.friction)
}

/// The purely sliding state by the printed equations.
pub(super) fn sliding_root<E: Arithmetic>(query: &Query<E>) -> Result<Configuration<E>, Undecided> {
    let slides = query.root(Mode::Sliding.system(query.weight), &start::sliding(&query.alpha()))?;
    require(&slides.friction, "a positive purely sliding friction")?;
    let inside = slides.half_opening.rad.clone() - &slides.sliding_joint.rad;
    require(&inside, "the steepest joint above the shoulder")?;
    Ok(slides)
}

/// The thrust at which an inner joint slides, and that joint.
pub(super) fn steepest_root<E: Arithmetic>(
    query: &Query<E>,
) -> Result<Configuration<E>, Undecided> {
    let start = start::inner_sliding(&query.given.friction.candidate());
    query.root(System::inner_sliding(query.weight), &start)
}

fn falls_by_sliding<E: Arithmetic>(
    query: &Query<E>,
    least_friction: &E,
) -> Result<bool, Undecided> {
    let Some(friction) = query.friction() else { return Ok(false) };
    let margin = friction.clone() - least_friction;
    Ok(!decide(&margin, "whether the friction is enough to stand", &[Mode::Sliding])?)
}

/// The state, if the friction is above the purely sliding one; below it the answer is not to be used
/// unless it is a state.
fn state_above_sliding<E: Arithmetic>(
    query: &Query<E>,
    frictions: bool,
) -> Result<AboveSliding<E>, Undecided> {
    let rotation = match rotation_if_any(query, frictions) {
        Err(undecided) if query.is_limited => return beside_the_end(query, frictions, undecided),
        rotation => rotation?,
    };
    let Some(rotation) = rotation else {
        return match query.friction() {
            Some(_) => inner_sliding(query, None),
            None => overturning(query),
        };
    };
    let critical = rotation.friction();
    match rotation.slides? {
        None => Ok(AboveSliding::State(Box::new(rotation.state), critical)),
        Some(Mode::SlidingRotational) => shoulder_sliding(query, critical),
        Some(_) => inner_sliding(query, critical),
    }
}

/// The state where these bits prove no rotation and cannot exclude one either, as next to the end of
/// rotation. A sliding state that is proved is the answer all the same; what stays open is then only
/// which friction, if any, would be enough for rotation.
fn beside_the_end<E: Arithmetic>(
    query: &Query<E>,
    frictions: bool,
    undecided: Undecided,
) -> Result<AboveSliding<E>, Undecided> {
    match inner_sliding(query, None) {
        Ok(AboveSliding::State(state, _)) if frictions => Err(undecided.between(&[state.mode])),
        Ok(found) => Ok(found),
        Err(_) => Err(undecided),
    }
}

/// The purely rotational state, unless the half opening is beyond the end of rotation.
fn rotation_if_any<E: Arithmetic>(
    query: &Query<E>,
    frictions: bool,
) -> Result<Option<RotationalState<E>>, Undecided> {
    if start::seems_to_rotate(query.weight, &query.alpha())
        && let Ok(rotation) = rotation(query, frictions)
    {
        return Ok(Some(rotation));
    }
    let end = limit::<E>(Landmark::RotationEnd, query.weight, query.bits);
    let rotates = decide(
        &(end - &query.given.half_opening.rad),
        "whether the half opening is below that of the end of rotation",
        &[Mode::Rotational, Mode::Overturning],
    )?;
    if rotates { rotation(query, frictions).map(Some) } else { Ok(None) }
}

/// The purely rotational state, proved for unlimited friction.
fn rotation<E: Arithmetic>(
    query: &Query<E>,
    frictions: bool,
) -> Result<RotationalState<E>, Undecided> {
    let slides = |both: &[E; 2]| query.friction().map_or(Ok(None), |mu| sliding_mode(mu, both));
    if let Some(small) = Small::of(query) {
        let root = small.rotation()?;
        let both = (frictions || query.is_limited).then(|| root.frictions()).transpose()?;
        let slides = both.as_ref().map_or(Ok(None), slides);
        return Ok(RotationalState {
            state: root.into_state(Mode::Rotational),
            frictions: both,
            slides,
        });
    }
    let [beta, eta, _] = start::rotational(query.weight, &query.alpha());
    let at = rotational_root(query, [beta, eta])?;
    prove(query, Mode::Rotational, &at, false)?;
    if frictions || query.is_limited {
        in_few_bits(&at, query.bits, |at, _| {
            require(&room_for_steepest(at), "the steepest joint above the shoulder")
        })?;
    }
    let asked = |at: &Configuration<E>| [shoulder_friction(at), inner_friction(at)];
    let both = frictions.then(|| asked(&at));
    let slides = match &both {
        Some(both) => slides(both),
        // Only a sign is asked for.
        None if query.is_limited => {
            in_few_bits(&at, query.bits, |at, _| sliding_mode(&at.friction, &asked(at)))
        }
        None => Ok(None),
    };
    Ok(RotationalState { state: State::new(Mode::Rotational, at), frictions: both, slides })
}

fn shoulder_sliding<E: Arithmetic>(
    query: &Query<E>,
    rotational: Option<E>,
) -> Result<AboveSliding<E>, Undecided> {
    if let Some(small) = Small::of(query) {
        let state = small.shoulder_sliding()?.into_state(Mode::SlidingRotational);
        return Ok(AboveSliding::State(Box::new(state), rotational));
    }
    let bound = sliding::shoulder_thrust(&query.given.half_opening, &query.given.friction).value();
    let thrust = if bound.is_bounded() {
        bound.candidate()
    } else {
        // Near the purely sliding friction the two thrusts are close, and either is a good start.
        let [_, thrust, _] = start::sliding(&query.alpha());
        thrust
    };
    let start = start::rotational_with_thrust(query.weight, &thrust);
    let at = query.root(Mode::SlidingRotational.system(query.weight), &start)?;
    proved(query, Mode::SlidingRotational, at, rotational)
}

/// The purely overturning state, where there is one.
fn overturning<E: Arithmetic>(query: &Query<E>) -> Result<AboveSliding<E>, Undecided> {
    let end = limit::<E>(Landmark::OverturningEnd, query.weight, query.bits);
    if !decide(
        &(end - &query.given.half_opening.rad),
        "whether the half opening is below that of the end of overturning",
        &[Mode::Overturning],
    )? {
        return Ok(AboveSliding::Falls);
    }
    let at = query.root(Mode::Overturning.system(query.weight), &[overturning_start(query)])?;
    proved(query, Mode::Overturning, at, None)
}

fn inner_sliding<E: Arithmetic>(
    query: &Query<E>,
    rotational: Option<E>,
) -> Result<AboveSliding<E>, Undecided> {
    let slid = steepest_root(query)?;
    let margin = contact::margin_at_physical_limit(query.weight, &slid);
    if !decide(
        &margin,
        "whether the physical limit of the thickness is enough",
        &[Mode::OverturningSliding],
    )? {
        return Ok(AboveSliding::Falls);
    }
    let (mode, at) = inner_state(query, slid)?;
    proved(query, mode, at, rotational)
}

fn overturning_start<E: Arithmetic>(query: &Query<E>) -> E::Candidate {
    let alpha = query.alpha();
    let a = thrust::opening_variable(&Angle::new(alpha.to_double())).value();
    let eta = overturning::thickness(query.weight, &a);
    alpha.like(if eta.is_finite() { eta } else { 1.9 })
}

/// The state, with parts 2 and 3 of its proof.
fn proved<E: Arithmetic>(
    query: &Query<E>,
    mode: Mode,
    at: Configuration<E>,
    rotational: Option<E>,
) -> Result<AboveSliding<E>, Undecided> {
    prove(query, mode, &at, query.is_limited)?;
    Ok(AboveSliding::State(Box::new(State::new(mode, at)), rotational))
}

/// Parts 2 and 3 of the proof: the state is admissible, and none thinner is.
pub(super) fn prove<E: Arithmetic>(
    query: &Query<E>,
    mode: Mode,
    at: &Configuration<E>,
    is_limited: bool,
) -> Result<(), Undecided> {
    in_few_bits(at, query.bits, |at, _| {
        let at = at.map_ref(E::for_signs);
        let state = Examined::new(query.weight, mode, &at);
        // A root that fails one of them is not the state of the arch.
        Condition::of(mode, is_limited)
            .try_for_each(|condition| require_condition(condition, &state.margin(condition), mode))
    })
}

/// The half opening of `l` or of `L`, to at least `bits` bits where the numbers can have so many.
fn limit<E: Arithmetic>(landmark: Landmark, weight: SelfWeight, bits: u32) -> E {
    /// The bits of what is kept: the first are enough but for what is next to the limit.
    const KEPT: [u32; 2] = [256, 1024];
    type KeptBalls = PerWeight<OnceLock<Ball>>;
    static ROTATION: [KeptBalls; 2] = [const { none_kept() }; 2];
    static OVERTURNING: [KeptBalls; 2] = [const { none_kept() }; 2];
    const fn none_kept() -> KeptBalls {
        PerWeight { heyman: OnceLock::new(), milankovitch: OnceLock::new() }
    }
    tally::landmark();
    let at = |bits: u32| {
        let opening = |point: CertifiedLandmark| -> Result<Ball, Undecided> {
            Ok(point.enclosure(bits)?.configuration().half_opening.rad.clone())
        };
        CertifiedLandmark::new(landmark, weight).and_then(opening).unwrap_or(Ball::whole(bits))
    };
    let kept = if landmark == Landmark::RotationEnd { &ROTATION } else { &OVERTURNING };
    match KEPT.iter().zip(kept).find(|(kept, _)| bits <= **kept) {
        Some((most, kept)) => E::from_ball(kept.get(weight).get_or_init(|| at(*most)), bits),
        None => E::from_ball(&at(bits), bits),
    }
}
