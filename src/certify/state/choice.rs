//! Which mode an arch collapses in: every comparison decided, or the doubt.

use super::question::{Arch, Attempt, Doubt, Query, decide, require};
use crate::arch::{Configuration, SelfWeight, Unknown, contact, sliding, thrust};
use crate::certify::{CertifiedLandmark, Undecided};
use crate::number::{Angle, Ball, Enclosure, Magnitude, Ternary};
use crate::problem::{Equation, Landmark, Mode, tally};
use crate::problem::{conditions, inner_friction, room_for_steepest, shoulder_friction};
use crate::solve::start;
use rug::Float;
use std::sync::OnceLock;

/// What is certain of an arch.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It stands from a least thickness on.
    Stands(Box<State>),
    /// It does not stand at any thickness up to the physical limit 2.
    Falls(Fall),
}

/// Why no thickness is enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fall {
    /// The friction is below that of the purely sliding state.
    Sliding,
    /// It would have to be thicker than twice the radius.
    Thickness,
}

/// The state at the least thickness: enclosures, all proved.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct State {
    /// How it collapses.
    pub mode: Mode,
    /// `eta`.
    pub thickness: Ball,
    /// `h`.
    pub thrust: Ball,
    /// `beta_r`, rad; exactly zero at the crown.
    pub rotation_joint: Ball,
    /// `beta_s`, rad, if an inner joint slides.
    pub sliding_joint: Option<Ball>,
    /// The frictions at which the mode changes, if they are asked for.
    pub frictions: Option<Frictions<Ball>>,
}

/// The frictions between which a half opening has states that slide.
#[derive(Clone, Debug)]
pub struct Frictions<T> {
    /// The friction below which nothing stands.
    pub sliding: T,
    /// The friction from which collapse is purely rotational; `None` if no friction is enough.
    pub rotational: Option<T>,
}

/// What is asked of a state besides how thin the arch can be and how it falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Asked {
    /// Nothing: only what its proof needs is evaluated.
    Nothing,
    /// The frictions at which the mode changes.
    Frictions,
}

/// A purely rotational state.
struct Rotation {
    state: State,
    /// The frictions that the shoulder and an inner joint ask for, where friction matters.
    frictions: Option<[Ball; 2]>,
}

impl Arch {
    /// Proves the state with numbers of `bits` bits, at least one: 64 are enough for an ordinary arch,
    /// more are lost where [`Arch::bits_lost`] says so. The doubt is what these could not tell; more
    /// bits may.
    pub fn state(&self, bits: u32) -> Attempt<Outcome> {
        Query::new(self, bits).outcome(Asked::Frictions)
    }

    /// Proves the state without the frictions at which its mode changes: nothing is evaluated that its
    /// proof does not need.
    pub fn state_alone(&self, bits: u32) -> Attempt<Outcome> {
        Query::new(self, bits).outcome(Asked::Nothing)
    }

    /// The friction below which nothing stands at this half opening: that of the purely sliding state.
    pub fn sliding_friction(&self, bits: u32) -> Attempt<Ball> {
        Query::new(self, bits).pure_sliding()
    }
}

impl Query {
    /// The state, and why it is the one.
    ///
    /// A state that is admissible and the thinnest is a proof by itself. Whether the friction is below
    /// the purely sliding one, and where the half opening is beside those of `l` and `L`, is proved where
    /// it is the answer, or where a candidate says that there is no state.
    pub(super) fn outcome(&self, asked: Asked) -> Attempt<Outcome> {
        tally::working_bits(self.bits);
        let mut least_friction = None;
        if asked == Asked::Frictions || self.seems_to_slide() {
            let slides = self.pure_sliding()?;
            if self.falls_by_sliding(&slides)? {
                return Ok(Outcome::Falls(Fall::Sliding));
            }
            least_friction = Some(slides);
        }
        let found = self.state_above_sliding(asked);
        let is_proved = matches!(found, Ok(Found::State(..)));
        if !is_proved && least_friction.is_none() && self.friction.is_some() {
            // Too little friction would be the reason, and comes before any other.
            if self.falls_by_sliding(&self.pure_sliding()?)? {
                return Ok(Outcome::Falls(Fall::Sliding));
            }
        }
        match found? {
            Found::Falls => Ok(Outcome::Falls(Fall::Thickness)),
            Found::State(mut state, rotational) => {
                state.frictions = least_friction
                    .filter(|_| asked == Asked::Frictions)
                    .map(|sliding| Frictions { sliding, rotational });
                Ok(Outcome::Stands(state))
            }
        }
    }

    /// Whether the friction seems to be below the purely sliding one: a candidate.
    fn seems_to_slide(&self) -> bool {
        self.friction.as_ref().is_some_and(|friction| {
            let [least, ..] = start::sliding(&Float::with_val(64, self.alpha()));
            *friction.mid() < least * 1.001f64
        })
    }

    /// The friction of the purely sliding state.
    fn pure_sliding(&self) -> Attempt<Ball> {
        if let Some(small) = self.small() {
            return Ok(small.pure_sliding()?.friction());
        }
        let slides = self.root(Mode::Sliding.system(), &start::sliding(&self.alpha()))?;
        require(&slides.friction, "a positive purely sliding friction", &[])?;
        let inside = slides.half_opening.rad.clone() - &slides.sliding_joint.rad;
        require(&inside, "the steepest joint above the shoulder", &[])?;
        Ok(slides.friction)
    }

    fn falls_by_sliding(&self, least_friction: &Ball) -> Attempt<bool> {
        let Some(friction) = &self.friction else { return Ok(false) };
        let margin = friction.clone() - least_friction;
        Ok(!decide(&margin, "whether the friction is enough to stand", &[Mode::Sliding])?)
    }

    /// The state, if the friction is above the purely sliding one; below it the answer is not to be used
    /// unless it is a state.
    fn state_above_sliding(&self, asked: Asked) -> Attempt<Found> {
        let rotation = match self.rotation_if_any(asked) {
            Err(doubt) if self.friction.is_some() => return self.beside_the_end(asked, doubt),
            rotation => rotation?,
        };
        let Some(rotation) = rotation else {
            return match &self.friction {
                Some(_) => self.inner_sliding(None),
                None => self.overturning(),
            };
        };
        let critical = rotation.friction();
        let (Some(friction), Some([shoulder, inner])) = (&self.friction, &rotation.frictions)
        else {
            return Ok(Found::State(Box::new(rotation.state), critical));
        };
        let margin = |critical: &Ball, mode| {
            decide(
                &(friction.clone() - critical),
                "whether the friction is enough for pure rotation",
                &[Mode::Rotational, mode],
            )
        };
        let holds_shoulder = margin(shoulder, Mode::SlidingRotational);
        let holds_inner = margin(inner, Mode::RotationalSliding);
        // Both can fail only below the purely sliding friction.
        match (holds_shoulder, holds_inner) {
            (Ok(true), Ok(true)) => Ok(Found::State(Box::new(rotation.state), critical)),
            (Ok(false), _) => self.shoulder_sliding(critical),
            (_, Ok(false)) => self.inner_sliding(critical),
            (Err(doubt), _) | (_, Err(doubt)) => Err(doubt),
        }
    }

    /// The state where these bits prove no rotation and cannot exclude one either, as next to the end of
    /// rotation. A sliding state that is proved is the answer all the same; what stays open is then only
    /// which friction, if any, would be enough for rotation.
    fn beside_the_end(&self, asked: Asked, doubt: Doubt) -> Attempt<Found> {
        match self.inner_sliding(None) {
            Ok(Found::State(state, _)) if asked == Asked::Frictions => {
                Err(Doubt { between: vec![state.mode], ..doubt })
            }
            Ok(found) => Ok(found),
            Err(_) => Err(doubt),
        }
    }

    /// The purely rotational state, unless the half opening is beyond the end of rotation.
    fn rotation_if_any(&self, asked: Asked) -> Attempt<Option<Rotation>> {
        if start::seems_to_rotate(self.weight, &self.alpha())
            && let Ok(rotation) = self.rotation(asked)
        {
            return Ok(Some(rotation));
        }
        let [end, _] = limits(self.weight, self.bits);
        let rotates = decide(
            &(end - &self.given.half_opening.rad),
            "whether the half opening is below that of the end of rotation",
            &[Mode::Rotational, Mode::Overturning],
        )?;
        if rotates { self.rotation(asked).map(Some) } else { Ok(None) }
    }

    /// The purely rotational state, proved for unlimited friction.
    fn rotation(&self, asked: Asked) -> Attempt<Rotation> {
        let friction_matters = asked == Asked::Frictions || self.friction.is_some();
        if let Some(small) = self.small() {
            let root = small.rotation()?;
            let frictions = if friction_matters { Some(root.frictions()?) } else { None };
            return Ok(Rotation { state: root.into_state(Mode::Rotational), frictions });
        }
        let [beta, eta, _] = start::rotational(self.weight, &self.alpha());
        let at = self.rotational_root([beta, eta])?;
        self.prove(Mode::Rotational, &at, false)?;
        let mut frictions = None;
        if friction_matters {
            require(&room_for_steepest(&at), "the steepest joint above the shoulder", &[])?;
            frictions = Some([shoulder_friction(&at), inner_friction(&at)]);
        }
        Ok(Rotation { state: State::new(Mode::Rotational, at), frictions })
    }

    fn shoulder_sliding(&self, rotational: Option<Ball>) -> Attempt<Found> {
        if let Some(small) = self.small() {
            let state = small.shoulder_sliding()?.into_state(Mode::SlidingRotational);
            return Ok(Found::State(Box::new(state), rotational));
        }
        let bound =
            sliding::shoulder_thrust(&self.given.half_opening, &self.given.friction).value();
        let thrust = if bound.is_bounded() {
            Float::with_val(self.bits, bound.mid())
        } else {
            // Near the purely sliding friction the two thrusts are close, and either is a good start.
            let [_, thrust, _] = start::sliding(&self.alpha());
            thrust
        };
        let start = start::rotational_with_thrust(self.weight, &thrust);
        let at = self.root(Mode::SlidingRotational.system(), &start)?;
        self.proved(Mode::SlidingRotational, at, rotational)
    }

    /// The purely overturning state, where there is one.
    fn overturning(&self) -> Attempt<Found> {
        let [_, limit] = limits(self.weight, self.bits);
        if !decide(
            &(limit - &self.given.half_opening.rad),
            "whether the half opening is below that of the end of overturning",
            &[Mode::Overturning],
        )? {
            return Ok(Found::Falls);
        }
        let at = self.root(Mode::Overturning.system(), &[self.overturning_start()])?;
        self.proved(Mode::Overturning, at, None)
    }

    fn inner_sliding(&self, rotational: Option<Ball>) -> Attempt<Found> {
        let friction = Float::with_val(self.bits, self.given.friction.mid());
        let [h, joint] = start::inner_sliding(&friction);
        let sliding = (
            &[Unknown::Thrust, Unknown::SlidingJoint][..],
            &[Equation::InnerSliding, Equation::Steepest][..],
        );
        let slid = self.root(sliding, &[h, joint])?;
        let margin = contact::margin_at_physical_limit(self.weight, &slid);
        if !decide(
            &margin,
            "whether the physical limit of the thickness is enough",
            &[Mode::OverturningSliding],
        )? {
            return Ok(Found::Falls);
        }
        let (h, joint) = (slid.thrust.mid(), slid.sliding_joint.rad.mid());
        let start = start::rotational_sliding(self.weight, self.alpha().to_f64(), h.to_f64());
        let float = |x: f64| Float::with_val(self.bits, x);
        let at_crown = || {
            let start = [float(start.thickness), h.clone(), joint.clone()];
            let at = self.root(Mode::OverturningSliding.system(), &start)?;
            let slope = contact::crown_slope(self.weight, &at);
            let between = [Mode::OverturningSliding, Mode::RotationalSlidingRotational];
            let nearest = decide(&slope, "whether the intrados is touched at the crown", &between)?;
            Ok((at, nearest))
        };
        if start.joint.is_none() {
            let (at, nearest) = at_crown()?;
            if nearest {
                return self.proved(Mode::OverturningSliding, at, rotational);
            }
        }
        let beta = float(start.joint.unwrap_or(1e-6));
        let start = [beta, float(start.thickness), h.clone(), joint.clone()];
        let (at, mode) = match self.root(Mode::RotationalSliding.system(), &start) {
            Ok(at) => {
                let above = at.rotation_joint.rad.clone() - &at.sliding_joint.rad;
                let between = [Mode::RotationalSliding, Mode::RotationalSlidingRotational];
                let above = decide(&above, "which of the two inner joints is higher", &between)?;
                (at, between[usize::from(!above)])
            }
            // Beside the line beta_r = 0 the joint may be at the crown after all.
            Err(doubt) => match at_crown()? {
                (at, true) => (at, Mode::OverturningSliding),
                (_, false) => return Err(doubt),
            },
        };
        self.proved(mode, at, rotational)
    }

    fn overturning_start(&self) -> Float {
        let alpha = self.alpha().to_f64();
        let a = thrust::opening_variable(&Angle::new(alpha)).value();
        let eta = crate::arch::overturning::thickness(self.weight, &a);
        Float::with_val(self.bits, if eta.is_finite() { eta } else { 1.9 })
    }

    /// The state, with parts 2 and 3 of its proof.
    fn proved(
        &self,
        mode: Mode,
        at: Configuration<Ball>,
        rotational: Option<Ball>,
    ) -> Attempt<Found> {
        self.prove(mode, &at, self.friction.is_some())?;
        Ok(Found::State(Box::new(State::new(mode, at)), rotational))
    }

    /// Parts 2 and 3 of the proof: the state is admissible, and none thinner is.
    fn prove(&self, mode: Mode, at: &Configuration<Ball>, limited: bool) -> Attempt<()> {
        // A root that fails one of them is not the state of the arch.
        let friction = self.friction.as_ref().filter(|_| limited);
        conditions(self.weight, mode, at, friction)
            .iter()
            .try_for_each(|(margin, question)| require(margin, question, &[mode]))
    }
}

/// What is found where the friction is above the purely sliding one.
enum Found {
    /// A state, and the friction from which collapse is purely rotational, if any is enough and it was
    /// asked for.
    State(Box<State>, Option<Ball>),
    /// It would have to be thicker than twice the radius.
    Falls,
}

impl State {
    /// A state without the frictions at which its mode changes.
    fn new(mode: Mode, at: Configuration<Ball>) -> Self {
        let slides = matches!(
            mode,
            Mode::RotationalSliding | Mode::RotationalSlidingRotational | Mode::OverturningSliding
        );
        Self {
            mode,
            thickness: at.thickness,
            thrust: at.thrust,
            rotation_joint: at.rotation_joint.rad,
            sliding_joint: slides.then_some(at.sliding_joint.rad),
            frictions: None,
        }
    }
}

impl Rotation {
    /// The friction from which collapse is purely rotational: the larger of the two.
    fn friction(&self) -> Option<Ball> {
        let [shoulder, inner] = self.frictions.as_ref()?;
        Some(match shoulder.is_less_than(inner) {
            Ternary::True => inner.clone(),
            Ternary::False => shoulder.clone(),
            Ternary::Undecided => hull(shoulder, inner),
        })
    }
}

/// A ball that holds two that differ by little.
pub(super) fn hull(a: &Ball, b: &Ball) -> Ball {
    let gap = a.clone() - b;
    a.clone().widened(Magnitude::upper(gap.mid()).plus(gap.rad())).widened(b.rad())
}

/// The half openings of `l` and `L`, to at least `bits` bits.
fn limits(weight: SelfWeight, bits: u32) -> [Ball; 2] {
    static CACHED: [OnceLock<[Ball; 2]>; 2] = [OnceLock::new(), OnceLock::new()];
    const ENOUGH: u32 = 1024;
    tally::landmark();
    let at = |bits: u32| {
        [Landmark::RotationEnd, Landmark::OverturningEnd].map(|landmark| {
            let opening = |point: CertifiedLandmark| -> Result<Ball, Undecided> {
                Ok(point.enclosure(bits)?.configuration().half_opening.rad)
            };
            CertifiedLandmark::new(landmark, weight).and_then(opening).unwrap_or(Ball::whole(bits))
        })
    };
    if bits > ENOUGH {
        return at(bits);
    }
    CACHED[weight.flag() as usize]
        .get_or_init(|| at(ENOUGH))
        .clone()
        .map(|x| x.with_precision(bits))
}
