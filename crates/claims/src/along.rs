//! Certified states on the curves of purely rotational and of purely sliding states, and statements on
//! whole ranges of half openings.
//!
//! On both curves all variables are monotone in the half opening: on the rotational one the thickness
//! grows and the thrust falls, on the sliding one the thrust falls and the friction grows. So the
//! states at the two ends of a range bound all states between.

use super::Checked;
use super::landmarks::certain_if;
use crate::arch::{Configuration, Ring, SelfWeight, overturning, sliding, statics, thrust};
use crate::certify::state::{Certify, Outcome, State};
use crate::certify::{CertifiedLandmark, Undecided};
use crate::number::{Angle, Ball, Dual, ExactNumber, Field, Real, Ternary};
use crate::problem::{Arch, Friction, Landmark, Mode, Quantity};
use crate::prover::halve::halve;
use rug::Rational;

/// Bits of the states.
const BITS: u32 = 128;
/// A range is halved so often at the most.
const DEPTH: u32 = 16;

/// A state, or all states of a range.
#[derive(Clone, Debug)]
pub(super) struct CurveStates {
    pub(super) weight: SelfWeight,
    pub(super) alpha: Angle<Ball>,
    pub(super) thrust: Ball,
    /// The thickness and the rotational joint, where there are such.
    rotation: Option<(Ball, Ball)>,
}

fn arch(weight: SelfWeight, alpha: &Rational) -> Checked<Arch> {
    let arch = Arch::new(weight, ExactNumber::from(alpha), Friction::Infinite);
    arch.map_err(|error| Undecided::new(error.to_string()))
}

/// An arch of a half opening and a friction that are given as text.
pub(super) fn parsed(weight: SelfWeight, alpha: &str, friction: &str) -> Checked<Arch> {
    let arch = Arch::parse(weight.name(), alpha, friction);
    arch.map_err(|error| Undecided::new(error.to_string()))
}

/// The state of an arch that stands.
pub(super) fn standing(outcome: Outcome) -> Checked<State> {
    match outcome {
        Outcome::Stands(state) => Ok(*state),
        Outcome::Falls(fall) => Err(Undecided::new(fall.reason())),
    }
}

/// A landmark's variables.
pub(super) fn landmark(landmark: Landmark, weight: SelfWeight) -> Checked<Configuration<Ball>> {
    Ok(CertifiedLandmark::new(landmark, weight)?.enclosure(BITS)?.configuration().clone())
}

/// A quantity at a landmark.
pub(super) fn quantity(
    landmark: Landmark,
    weight: SelfWeight,
    quantity: Quantity,
) -> Checked<Ball> {
    let value = CertifiedLandmark::new(landmark, weight)?.enclosure(BITS)?.quantity(quantity);
    value.ok_or_else(|| Undecided::new(format!("{quantity} at {landmark}, {weight}")))
}

impl CurveStates {
    /// The purely rotational state.
    pub(super) fn rotational(weight: SelfWeight, alpha: &Rational) -> Checked<Self> {
        let state = standing(arch(weight, alpha)?.state_alone(BITS)?)?;
        if state.mode != Mode::Rotational {
            return Err(Undecided::new(format!("the state of {alpha} is not purely rotational")));
        }
        Ok(Self {
            weight,
            alpha: Angle::new(Ball::enclosing(alpha, BITS)),
            thrust: state.thrust,
            rotation: Some((state.thickness, state.rotation_joint)),
        })
    }

    /// The purely sliding state, which does not depend on the weight.
    pub(super) fn sliding(alpha: &Rational) -> Checked<Self> {
        let weight = SelfWeight::Heyman;
        let friction = arch(weight, alpha)?.sliding_friction(BITS)?;
        let alpha = Angle::new(Ball::enclosing(alpha, BITS));
        let thrust = sliding::shoulder_thrust(&alpha, &friction).value();
        Ok(Self { weight, alpha, thrust, rotation: None })
    }

    /// A state that slides, of a landmark.
    pub(super) fn of_landmark(weight: SelfWeight, at: &Configuration<Ball>) -> Self {
        let (alpha, thrust) = (at.half_opening.clone(), at.thrust.clone());
        Self { weight, alpha, thrust, rotation: None }
    }

    /// States between two, all of them.
    pub(super) fn up_to(&self, other: &Self) -> Self {
        let rotation = match (&self.rotation, &other.rotation) {
            (Some(a), Some(b)) => Some((a.0.hull(&b.0), a.1.hull(&b.1))),
            _ => None,
        };
        Self {
            weight: self.weight,
            alpha: Angle::new(self.alpha.rad.hull(&other.alpha.rad)),
            thrust: self.thrust.hull(&other.thrust),
            rotation,
        }
    }

    /// The friction that the shoulder asks for, (17).
    pub(super) fn shoulder_friction(&self) -> Ball {
        sliding::shoulder(&self.alpha, &self.thrust).value()
    }

    /// The friction that an inner joint asks for, (18).
    pub(super) fn inner_friction(&self) -> Ball {
        sliding::inner(&self.sliding_joint(), &self.thrust).value()
    }

    fn sliding_joint(&self) -> Angle<Ball> {
        Angle::new((self.thrust.clone() * (self.thrust.int(1) - &self.thrust)).sqrt())
    }

    /// `-d mu_is/dh = beta_s/N(beta_s)²`.
    fn inner_slope(&self) -> Ball {
        let joint = self.sliding_joint();
        joint.rad.clone() / statics::normal_force(&joint, &self.thrust).square()
    }

    /// The half opening and the thrust as functions of a parameter with the slopes given.
    fn moving(&self, alpha: Ball, thrust: Ball) -> (Angle<Dual<Ball>>, Dual<Ball>) {
        (moving(self.alpha.clone(), &alpha), Dual::with_derivative(self.thrust.clone(), 0, thrust))
    }

    /// Along rotation, `d/d eta` of the friction of the shoulder less that of an inner joint.
    pub(super) fn friction_gap_slope(&self) -> Checked<Ball> {
        let (thickness, joint) =
            self.rotation.clone().ok_or_else(|| Undecided::new("no rotational state"))?;
        let ring = Ring::new(self.weight, &Dual::variable(thickness, 0));
        let joint = Angle::new(joint).map(Dual::constant);
        // (2) is stationary in the joint, so that its partial derivative is the whole.
        let by_thickness = thrust::lower(&joint, &ring).value().derivative(0);
        let opening = overturning::opening_variable(&ring).value().derivative(0) + &by_thickness;
        let Angle { rad, sin, .. } = &self.alpha;
        let alpha = -(opening * self.alpha.versine() / (rad.clone() - sin));
        let (alpha, thrust) = self.moving(alpha, by_thickness.clone());
        let shoulder = sliding::shoulder(&alpha, &thrust).value().derivative(0);
        Ok(shoulder + self.inner_slope() * by_thickness)
    }

    /// Along sliding, `d/d alpha` of a function of the half opening and the thrust.
    pub(super) fn slope_along_sliding(
        &self,
        value: impl Fn(&Angle<Dual<Ball>>, &Dual<Ball>) -> Dual<Ball>,
    ) -> Ball {
        let (alpha, h) = (&self.alpha.rad, &self.thrust);
        let normal = statics::normal_force(&self.alpha, h).square();
        let by_alpha = (alpha.square() + h.square() - h) / &normal;
        let by_thrust = alpha.clone() / normal + self.inner_slope();
        let (alpha, thrust) = self.moving(alpha.int(1), -(by_alpha / by_thrust));
        value(&alpha, &thrust).derivative(0)
    }
}

/// An angle as a function of a parameter, of which it has this slope.
pub(super) fn moving<T: Field>(angle: Angle<T>, slope: &T) -> Angle<Dual<T>> {
    let dual = |value, slope| Dual::with_derivative(value, 0, slope);
    let Angle { rad, sin, cos } = angle;
    let (up, down) = (cos.clone() * slope, -(sin.clone() * slope));
    Angle { rad: dual(rad, slope.clone()), sin: dual(sin, up), cos: dual(cos, down) }
}

/// Tells whether `holds` is proved on all purely sliding states of a range.
pub(super) fn on_sliding(
    range: (&Rational, &Rational),
    holds: impl Fn(&CurveStates) -> Ternary,
) -> Checked<Ternary> {
    on_all(range, &CurveStates::sliding, &|a, b| holds(&a.up_to(b)))
}

/// Tells whether `holds` is proved on `[low, high]`, where it is asked with the states at the ends of a range
/// and has to speak for all states between.
pub(super) fn on_all(
    (low, high): (&Rational, &Rational),
    state: &dyn Fn(&Rational) -> Checked<CurveStates>,
    holds: &dyn Fn(&CurveStates, &CurveStates) -> Ternary,
) -> Checked<Ternary> {
    let at = |x: &Rational| -> Checked<_> { Ok((x.clone(), state(x)?)) };
    let halves = |[left, right]: &[(Rational, CurveStates); 2]| {
        let middle = at(&(Rational::from(&left.0 + &right.0) / 2)).ok()?;
        Some([[left.clone(), middle.clone()], [middle, right.clone()]])
    };
    let proof = |[left, right]: &[(Rational, CurveStates); 2]| {
        holds(&left.1, &right.1).is_proved().then_some(()).ok_or(())
    };
    Ok(certain_if(halve([at(low)?, at(high)?], DEPTH, halves, proof).is_ok()))
}

/// Multiples of `1/scale` around a value, a little apart from it.
pub(super) fn around(value: &Ball, scale: i32) -> Checked<(Rational, Rational)> {
    let low = multiple(value, scale)?;
    Ok((Rational::from((low - 1, scale)), Rational::from((low + 2, scale))))
}

/// A multiple of `1/scale` close below a value.
pub(super) fn below(value: &Ball, scale: i32) -> Checked<Rational> {
    Ok(Rational::from((multiple(value, scale)? - 1, scale)))
}

fn multiple(value: &Ball, scale: i32) -> Checked<i32> {
    let scaled = (value.clone() * value.int(scale)).lower();
    let integer = scaled.floor().to_integer().and_then(|n| n.to_i32());
    integer.ok_or_else(|| Undecided::new("an unbounded landmark"))
}
