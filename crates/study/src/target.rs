//! A problem next to a limit: its certified value, its condition, and where a search starts.

use super::Task;
use super::cases::arch;
use super::closed::{ClosedForm, RootBranch, trigonometric_at};
use super::condition::condition;
use super::enclosure::enclose_at;
use super::newton::newton;
use crate::arch::small::Scaled;
use crate::arch::{SelfWeight, Unknown, overturning};
use crate::certify::CertifiedLandmark;
use crate::certify::state::{Certify, Outcome, State};
use crate::number::{Ball, Dual, Real};
use crate::problem::{Landmark, Mode};
use crate::solve::{settle, start};
use rug::{Float, Rational};

pub(super) const WEIGHT: SelfWeight = SelfWeight::Milankovitch;

/// A problem on a rung, and which of its unknowns is looked at.
#[derive(Clone, Debug)]
pub(super) enum LimitTarget {
    /// A state; that of pure sliding is asked for its friction.
    State { mode: Mode, half_opening: Rational, friction: Option<Rational>, output: Unknown },
    /// The thin root of the cubic in `eta`.
    Closed { joint: Rational },
    /// (15) at `A = 2/3 +` the distance.
    Overturning { distance: Rational },
}

/// A state of a mode, looked at in one of its unknowns.
pub(super) fn state_target(
    mode: Mode,
    half_opening: Rational,
    friction: Option<Rational>,
    output: Unknown,
) -> Option<LimitTarget> {
    Some(LimitTarget::State { mode, half_opening, friction, output })
}

pub(super) fn rotational(half_opening: Rational, output: Unknown) -> Option<LimitTarget> {
    state_target(Mode::Rotational, half_opening, None, output)
}

pub(super) fn sliding(half_opening: Rational) -> Option<LimitTarget> {
    state_target(Mode::Sliding, half_opening, None, Unknown::Friction)
}

/// A variable of a landmark, to many places, less a distance.
pub(super) fn before(
    landmark: Landmark,
    unknown: Unknown,
    distance: &Rational,
) -> Option<Rational> {
    let refined = CertifiedLandmark::new(landmark, WEIGHT).ok()?.enclosure(640).ok()?;
    Some(refined.value(unknown)?.mid().to_rational()? - distance)
}

/// The state of an arch that stands, far beyond what is measured.
pub(super) fn reference(half_opening: &Rational, friction: Option<&Rational>) -> Option<State> {
    standing(arch(WEIGHT, half_opening, friction)?.state(1024).ok()?)
}

fn standing(outcome: Outcome) -> Option<State> {
    if let Outcome::Stands(state) = outcome { Some(*state) } else { None }
}

impl LimitTarget {
    /// The output in a certified enclosure, computed with `bits` bits; `None` if it is not proved.
    pub(super) fn enclosure(&self, bits: u32) -> Option<Ball> {
        match self {
            Self::State { mode: Mode::Sliding, half_opening, .. } => {
                arch(WEIGHT, half_opening, None)?.sliding_friction(bits).ok()
            }
            Self::State { half_opening, friction, output, mode } => {
                let arch = arch(WEIGHT, half_opening, friction.as_ref())?;
                let state = standing(arch.state_alone(bits).ok()?)?;
                state.value(*output).filter(|_| state.mode == *mode).cloned()
            }
            Self::Closed { joint } => {
                let centre = thin_root(joint, bits);
                Some(enclose_at::<Ball>(&self.problem()?, &[centre], bits)?.swap_remove(0))
            }
            Self::Overturning { distance } => Some(factored(&Ball::enclosing(distance, bits))),
        }
    }

    /// The equations as a problem for the methods of others.
    pub(super) fn problem(&self) -> Option<Task> {
        let weight = WEIGHT;
        Some(match self {
            Self::State { mode, half_opening, friction, .. } => {
                let (half_opening, friction) = (half_opening.clone(), friction.clone());
                let friction = friction.unwrap_or_default();
                Task::State { weight, mode: *mode, half_opening, friction }
            }
            Self::Closed { joint } => {
                Task::Cubic { form: ClosedForm::Thickness, weight, joint: joint.clone() }
            }
            Self::Overturning { .. } => return None,
        })
    }

    /// The place of the output among the unknowns.
    pub(super) fn index(&self) -> usize {
        match self {
            Self::State { mode, output, .. } => mode.system(WEIGHT).index(*output).unwrap_or(0),
            _ => 0,
        }
    }

    /// Start values of all unknowns as the product makes them, in numbers of `bits` bits.
    pub(super) fn start(&self, bits: u32) -> Option<Vec<Float>> {
        let number = |x: &Rational| Float::with_val(bits, x);
        Some(match self {
            Self::State { mode: Mode::Rotational, half_opening, .. } => {
                start::rotational(WEIGHT, &number(half_opening)).to_vec()
            }
            Self::State { mode: Mode::Sliding, half_opening, .. } => {
                start::sliding(&number(half_opening)).to_vec()
            }
            Self::State { mode, half_opening, friction, .. } => {
                // Next to the certified state: what is measured is the last digits.
                let state = reference(half_opening, friction.as_ref())?;
                let value = |&unknown| state.value(unknown).map(|x| x.mid().clone());
                let unknowns = mode.system(WEIGHT).unknowns.iter();
                let values: Option<Vec<Float>> = unknowns.map(value).collect();
                values?.iter().map(|x| Float::with_val(bits, x) * 1.0001f64).collect()
            }
            Self::Closed { joint } => vec![thin_root(joint, bits)],
            Self::Overturning { .. } => return None,
        })
    }

    /// `log10` of the condition number, from numbers of `bits` bits; minus infinity where the result does
    /// not depend on what is given.
    pub(super) fn condition(&self, bits: u32) -> Option<f64> {
        if let Self::Overturning { distance } = self {
            // What is given is A.
            let a = Float::with_val(bits, Rational::from((2, 3)) + distance);
            let eta = overturning::thickness(WEIGHT, &Dual::variable(a.clone(), 0));
            return Some((eta.derivative(0) * a / eta.value()).abs().log10().to_f64());
        }
        let problem = self.problem()?;
        let root = newton(&problem, &self.start(bits)?, bits)?.root;
        condition(&problem, &root, self.index())
    }

    /// The output by Newton's method on the equations in scaled variables, in numbers of `bits` bits.
    pub(super) fn scaled(&self, bits: u32) -> Option<Float> {
        let Self::State { mode: mode @ (Mode::Rotational | Mode::Sliding), half_opening, .. } =
            self
        else {
            return None;
        };
        let system = mode.system(WEIGHT);
        let alpha = Float::with_val(bits, half_opening);
        let y = alpha.clone().square();
        let start = match mode {
            Mode::Sliding => start::scaled_sliding(&y),
            _ => start::scaled_rotational(WEIGHT, &y),
        };
        let given = Scaled::new(&Dual::constant(y.clone()));
        let root = settle(start.to_vec(), |x| {
            let variables = system.unknowns.iter().zip(x).enumerate();
            let at = variables.fold(given.clone(), |at, (index, (&u, x))| {
                at.with(u, Dual::variable(x.clone(), index))
            });
            system.scaled_residuals(&at).unwrap_or_default()
        })?;
        let [first, second, _] = &root[..] else { return None };
        Some(match mode {
            Mode::Sliding => first.clone() * y * alpha,
            _ => second.clone() * y.square(),
        })
    }
}

/// The thin root of the cubic in `eta`, by its closed form.
fn thin_root(joint: &Rational, bits: u32) -> Float {
    trigonometric_at(ClosedForm::Thickness, RootBranch::Upper, joint, bits)
}

/// (15) with its radicand `9 (A - 2/3)(A + 2)`, from `x = A - 2/3`.
pub(super) fn factored<T: Real>(x: &T) -> T {
    let radicand = x.int(9) * x * &(x.ratio(8, 3) + x);
    x.int(2) + x.int(3) * x - radicand.sqrt()
}
