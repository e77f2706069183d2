//! Which mode an arch collapses in: every comparison decided, or the doubt.

use super::question::{Arch, Attempt, Query, decide, require};
use crate::arch::{
    Configuration, Equation, Landmark, Mode, SelfWeight, Unknown, contact, sliding, thrust,
};
use crate::certify::{CertifiedLandmark, Undecided};
use crate::check::{conditions, inner_friction};
use crate::number::{Angle, Ball, Enclosure, Magnitude, Ternary};
use crate::solve::start_state;
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
    /// The friction below which nothing stands at this half opening.
    pub sliding_friction: Ball,
    /// The friction from which collapse is purely rotational; `None` if no friction is enough.
    pub rotational_friction: Option<Ball>,
}

/// A purely rotational state with the frictions it asks for.
struct Rotation {
    at: Configuration<Ball>,
    shoulder: Ball,
    inner: Ball,
}

impl Arch {
    /// Proves the state with numbers of `bits` bits, at least one: 64 are enough for an ordinary arch,
    /// more are lost where [`Arch::bits_lost`] says so. The doubt is what these could not tell; more
    /// bits may.
    pub fn state(&self, bits: u32) -> Attempt<Outcome> {
        Query::new(self, bits).outcome()
    }
}

impl Query {
    fn outcome(&self) -> Attempt<Outcome> {
        let slides = self.root(Mode::Sliding.system(), &start_state::sliding(&self.alpha()))?;
        require(&slides.friction, "a positive purely sliding friction", &[])?;
        let inside = slides.half_opening.rad.clone() - &slides.sliding_joint.rad;
        require(&inside, "the steepest joint above the shoulder", &[])?;
        let least_friction = slides.friction.clone();
        if let Some(friction) = &self.friction {
            let between = [Mode::Sliding];
            let margin = friction.clone() - &least_friction;
            if !decide(&margin, "whether the friction is enough to stand", &between)? {
                return Ok(Outcome::Falls(Fall::Sliding));
            }
        }
        let [end, limit] = limits(self.weight, self.bits);
        let alpha = &self.given.half_opening.rad;
        let rotates = decide(
            &(end - alpha),
            "whether the half opening is below that of the end of rotation",
            &[Mode::Rotational, Mode::Overturning],
        )?;
        let rotation = if rotates { Some(self.rotation()?) } else { None };
        let frictions = |rotation: Option<&Rotation>| {
            (least_friction.clone(), rotation.map(Rotation::friction))
        };
        match (&rotation, &self.friction) {
            (Some(rotation), None) => {
                Ok(stands(Mode::Rotational, rotation.at.clone(), frictions(Some(rotation))))
            }
            (None, None) => {
                if !decide(
                    &(limit - alpha),
                    "whether the half opening is below that of the end of overturning",
                    &[Mode::Overturning],
                )? {
                    return Ok(Outcome::Falls(Fall::Thickness));
                }
                let at = self.root(Mode::Overturning.system(), &[self.overturning_start()])?;
                self.proved(Mode::Overturning, at, frictions(None))
            }
            (Some(rotation), Some(friction)) => {
                let frictions = frictions(Some(rotation));
                let margin = |critical: &Ball, mode| {
                    decide(
                        &(friction.clone() - critical),
                        "whether the friction is enough for pure rotation",
                        &[Mode::Rotational, mode],
                    )
                };
                let holds_shoulder = margin(&rotation.shoulder, Mode::SlidingRotational);
                let holds_inner = margin(&rotation.inner, Mode::RotationalSliding);
                // Both can fail only below the purely sliding friction, which is excluded above.
                match (holds_shoulder, holds_inner) {
                    (Ok(true), Ok(true)) => {
                        Ok(stands(Mode::Rotational, rotation.at.clone(), frictions))
                    }
                    (Ok(false), _) => self.shoulder_sliding(&slides, frictions),
                    (_, Ok(false)) => self.inner_sliding(frictions),
                    (Err(doubt), _) | (_, Err(doubt)) => Err(doubt),
                }
            }
            (None, Some(_)) => self.inner_sliding(frictions(None)),
        }
    }

    /// The purely rotational state, proved for unlimited friction.
    fn rotation(&self) -> Attempt<Rotation> {
        let start = start_state::rotational(self.weight, &self.alpha());
        let at = self.root(Mode::Rotational.system(), &start)?;
        self.prove(Mode::Rotational, &at, false)?;
        let shoulder = sliding::shoulder(&at.half_opening, &at.thrust).value();
        let inner = inner_friction(&at);
        Ok(Rotation { at, shoulder, inner })
    }

    fn shoulder_sliding(
        &self,
        slides: &Configuration<Ball>,
        frictions: (Ball, Option<Ball>),
    ) -> Attempt<Outcome> {
        let bound =
            sliding::shoulder_thrust(&self.given.half_opening, &self.given.friction).value();
        // Near the purely sliding friction the two thrusts are close, and either is a good start.
        let thrust = if bound.is_bounded() { bound } else { slides.thrust.clone() };
        let thrust = Float::with_val(self.bits, thrust.mid());
        let start = start_state::rotational_with_thrust(self.weight, &thrust);
        let at = self.root(Mode::SlidingRotational.system(), &start)?;
        self.proved(Mode::SlidingRotational, at, frictions)
    }

    fn inner_sliding(&self, frictions: (Ball, Option<Ball>)) -> Attempt<Outcome> {
        let friction = Float::with_val(self.bits, self.given.friction.mid());
        let [h, joint] = start_state::inner_sliding(&friction);
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
            return Ok(Outcome::Falls(Fall::Thickness));
        }
        let (h, joint) = (slid.thrust.mid(), slid.sliding_joint.rad.mid());
        let start = start_state::rotational_sliding(self.weight, self.alpha().to_f64(), h.to_f64());
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
                return self.proved(Mode::OverturningSliding, at, frictions);
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
        self.proved(mode, at, frictions)
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
        frictions: (Ball, Option<Ball>),
    ) -> Attempt<Outcome> {
        self.prove(mode, &at, self.friction.is_some())?;
        Ok(stands(mode, at, frictions))
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

fn stands(
    mode: Mode,
    at: Configuration<Ball>,
    (sliding_friction, rotational_friction): (Ball, Option<Ball>),
) -> Outcome {
    let slides = matches!(
        mode,
        Mode::RotationalSliding | Mode::RotationalSlidingRotational | Mode::OverturningSliding
    );
    Outcome::Stands(Box::new(State {
        mode,
        thickness: at.thickness,
        thrust: at.thrust,
        rotation_joint: at.rotation_joint.rad,
        sliding_joint: slides.then_some(at.sliding_joint.rad),
        sliding_friction,
        rotational_friction,
    }))
}

impl Rotation {
    /// The friction from which collapse is purely rotational: the larger of the two.
    fn friction(&self) -> Ball {
        match self.shoulder.is_less_than(&self.inner) {
            Ternary::True => self.inner.clone(),
            Ternary::False => self.shoulder.clone(),
            Ternary::Undecided => hull(&self.shoulder, &self.inner),
        }
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
