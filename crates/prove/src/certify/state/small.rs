//! States of small half openings: the same proof in variables of order one, in which nothing cancels.
//!
//! Three modes are met there: pure rotation, sliding of the shoulder, and pure sliding. The equations and
//! margins are those of [`arch::small`], the printed ones divided by a power of the half opening.

use super::query::Query;
use super::state::State;
use crate::arch::small::{self, Scaled};
use crate::arch::{SelfWeight, Unknown};
use crate::number::{Enclosure, Real, Stumpff};
use crate::problem::{
    Condition, ExaminedSmall, Mode, scaled_inner_friction, scaled_room_for_steepest,
    scaled_shoulder_friction,
};
use crate::prover::Undecided;
use crate::prover::arithmetic::Arithmetic;
use crate::prover::decide::{require, require_condition};
use crate::prover::root::Form;
use crate::solve::start::{self, Start};

/// An arch of a small half opening at one precision.
pub(super) struct Small<E> {
    weight: SelfWeight,
    bits: u32,
    alpha: E,
    /// The half opening and, if finite, the friction.
    given: Scaled<E>,
    is_limited: bool,
}

/// The root of a mode's equations in scaled variables.
pub(super) struct SmallRoot<E> {
    pub at: Scaled<E>,
    alpha: E,
}

impl<E: Arithmetic> Small<E> {
    /// The arch in scaled variables, if its half opening is small.
    pub(super) fn of(query: &Query<E>) -> Option<Self> {
        let alpha = &query.given.half_opening.rad;
        let exponent = 2 * alpha.candidate().exponent_of_size()?;
        if !E::is_small(exponent, query.bits) {
            return None;
        }
        let y = alpha.square();
        let cube = y.clone() * alpha;
        let mut given = Scaled::new(&y);
        if let Some(friction) = query.friction() {
            given = given.with(Unknown::Friction, friction.clone() / cube);
        }
        let Query { weight, bits, is_limited, .. } = *query;
        Some(Self { weight, bits, alpha: alpha.clone(), given, is_limited })
    }

    /// The purely rotational state, proved for unlimited friction.
    pub(super) fn rotation(&self) -> Result<SmallRoot<E>, Undecided> {
        let start = start::scaled_rotational(self.weight, &self.candidate().opening.square);
        self.state(Mode::Rotational, start, false)
    }

    /// The state in which the shoulder slides.
    pub(super) fn shoulder_sliding(&self) -> Result<SmallRoot<E>, Undecided> {
        let start = start::scaled_shoulder_sliding(self.weight, &self.candidate());
        self.state(Mode::SlidingRotational, start, self.is_limited)
    }

    /// The purely sliding state.
    pub(super) fn pure_sliding(&self) -> Result<SmallRoot<E>, Undecided> {
        let start = start::scaled_sliding(&self.candidate().opening.square);
        let slides = self.root(Mode::Sliding, start)?;
        require(&slides.at.friction, "a positive purely sliding friction")?;
        let room = scaled_room_for_steepest(&slides.at);
        require(&room, Condition::SteepestAboveShoulder.label())?;
        Ok(slides)
    }

    fn candidate(&self) -> Scaled<E::Candidate> {
        self.given.clone().map(|x| x.candidate())
    }

    fn state(
        &self,
        mode: Mode,
        start: [E::Candidate; 3],
        is_limited: bool,
    ) -> Result<SmallRoot<E>, Undecided> {
        let root = self.root(mode, start)?;
        let no_form = || Undecided::new("the mode has no form for small half openings");
        let state = ExaminedSmall::new(self.weight, mode, &root.at).ok_or_else(no_form)?;
        Condition::of(mode, is_limited).try_for_each(|condition| {
            let margin = state.margin(condition).ok_or_else(no_form)?;
            require_condition(condition, &margin, mode)
        })?;
        drop(state);
        Ok(root)
    }

    fn root(&self, mode: Mode, start: [E::Candidate; 3]) -> Result<SmallRoot<E>, Undecided> {
        let equations = ScaledEquations { small: self, mode };
        let (root, _) = E::rooted_of_few(&equations, self.bits, &start)?;
        let at = equations.place(self.given.clone(), root);
        Ok(SmallRoot { at, alpha: self.alpha.clone() })
    }
}

/// The equations of a mode in scaled variables.
struct ScaledEquations<'a, E> {
    small: &'a Small<E>,
    mode: Mode,
}

impl<E> ScaledEquations<'_, E> {
    fn place<T: Stumpff>(&self, given: Scaled<T>, x: Vec<T>) -> Scaled<T> {
        let unknowns = self.mode.system(self.small.weight).unknowns;
        unknowns.iter().zip(x).fold(given, |at, (&unknown, x)| at.with(unknown, x))
    }
}

impl<E: Clone> Form<E> for ScaledEquations<'_, E> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> Vec<T> {
        let system = self.mode.system(self.small.weight);
        let at = self.place(self.small.given.clone().map(|x| number(&x)), x.to_vec());
        // An equation without a scaled form would leave none, and nothing would be proved.
        system.scaled_residuals(&at).unwrap_or_default()
    }

    /// (2), (4) and (5) have no denominator that can vanish for half openings below a right angle and
    /// thicknesses below 2; those of (17) and (18) are looked at.
    fn is_regular<T: Enclosure + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> bool {
        let at = self.place(self.small.given.clone().map(|x| number(&x)), x.to_vec());
        let inner = || small::inner(&at).denominator.excludes_zero();
        small::shoulder(&at).denominator.excludes_zero() && (self.mode != Mode::Sliding || inner())
    }
}

impl<E: Arithmetic> SmallRoot<E> {
    /// `mu`.
    pub(super) fn friction(&self) -> E {
        self.unscaled(&self.at.friction)
    }

    /// The frictions that the shoulder and an inner joint ask for.
    pub(super) fn frictions(&self) -> Result<[E; 2], Undecided> {
        let room = scaled_room_for_steepest(&self.at);
        require(&room, Condition::SteepestAboveShoulder.label())?;
        let frictions = [scaled_shoulder_friction(&self.at), scaled_inner_friction(&self.at)];
        Ok(frictions.map(|m| self.unscaled(&m)))
    }

    /// The state, without the frictions at which its mode changes.
    pub(super) fn into_state(self, mode: Mode) -> State<E> {
        State {
            mode,
            thickness: small::thickness(&self.at),
            thrust: small::rest(&self.at).rest_to_one(),
            rotation_joint: self.at.rotation.square.sqrt() * &self.alpha,
            sliding_joint: None,
            frictions: None,
        }
    }

    fn unscaled(&self, m: &E) -> E {
        m.clone() * &self.at.opening.square * &self.alpha
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Ball, Field, Magnitude};
    use crate::problem::{Arch, Examined};

    /// The power of the half opening by which a condition was divided.
    fn power(condition: Condition, mode: Mode) -> i32 {
        match condition {
            Condition::Above(Unknown::Thickness) | Condition::ExtradosAtShoulder => 4,
            Condition::FrictionInside | Condition::FrictionAtShoulder => 3,
            Condition::Below(Unknown::Thrust) | Condition::Weight | Condition::NoneThinner => 2,
            Condition::SlidesTheRightWay if mode == Mode::SlidingRotational => 2,
            Condition::ShoulderBoundsThrust => 1,
            _ => 0,
        }
    }

    /// Each condition is the printed one over a power of the half opening; those on the joints have the
    /// same sign, as they are differences of squares here.
    #[test]
    fn the_conditions_are_the_printed_ones() {
        for weight in SelfWeight::ALL {
            // Between alpha³/12 and alpha³/6 the shoulder slides.
            for (friction, mode) in
                [("1", Mode::Rotational), ("12/100000000", Mode::SlidingRotational)]
            {
                let arch = Arch::parse(weight.name(), "1/100", friction).unwrap();
                let query: Query = Query::new(&arch, 256);
                let small = Small::of(&query).unwrap();
                let root = match mode {
                    Mode::Rotational => small.rotation().unwrap(),
                    _ => small.shoulder_sliding().unwrap(),
                };
                let scaled_at = root.at.clone();
                let scaled = ExaminedSmall::new(weight, mode, &scaled_at).unwrap();
                let state = root.into_state(mode);
                let system = mode.system(weight);
                let value = |&unknown: &Unknown| state.value(unknown).unwrap().clone();
                let values: Vec<Ball> = system.unknowns.iter().map(value).collect();
                let at = system.place(query.given.clone(), &values);
                let printed = Examined::new(weight, mode, &at);
                let limited = Condition::of(mode, true);
                // Only the slope of the mechanism's weight is the same with and without a limit.
                for condition in limited.chain([Condition::GrowsWithThrust]) {
                    let margin = printed.margin(condition);
                    let other = scaled.margin(condition).unwrap();
                    let is_joint = matches!(
                        condition,
                        Condition::Above(Unknown::RotationJoint)
                            | Condition::Below(Unknown::RotationJoint)
                            | Condition::SteepestAboveShoulder
                    );
                    if is_joint {
                        assert_eq!(margin.is_positive(), other.is_positive(), "{condition:?}");
                        continue;
                    }
                    let alpha = &query.given.half_opening.rad;
                    let unscaled = (0..power(condition, mode)).fold(other, |x, _| x * alpha);
                    let difference = unscaled - &margin;
                    let size = Magnitude::upper(difference.mid());
                    assert!(difference.overlaps(&margin.int(0)), "{mode:?} {condition:?}");
                    // Not because nothing is known.
                    let known = Magnitude::upper(margin.mid()).shifted(-60);
                    assert!(size < known && difference.rad() < known, "{mode:?} {condition:?}");
                }
            }
        }
    }
}
