//! Square systems of the equations: named unknowns, named equations, and what is fixed.

use super::{Ring, SelfWeight, sliding, tally, thrust};
use crate::number::{Angle, Dual, Field, Real};

/// A variable of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unknown {
    /// `alpha`, in `(0, pi)`.
    HalfOpening,
    /// `beta_r`, in `[0, alpha]`.
    RotationJoint,
    /// `beta_s`, in `[0, 1/2]`.
    SlidingJoint,
    /// `eta`, in `(0, 2]`.
    Thickness,
    /// `h`, in `[0, 1)`.
    Thrust,
    /// `mu`, in `[0, inf]`.
    Friction,
}

impl Unknown {
    /// The name used in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::HalfOpening => "half_opening",
            Self::RotationJoint => "rotation_joint",
            Self::SlidingJoint => "sliding_joint",
            Self::Thickness => "thickness",
            Self::Thrust => "thrust",
            Self::Friction => "friction",
        }
    }

    /// Whether its sine and cosine are needed.
    pub fn is_angle(self) -> bool {
        matches!(self, Self::HalfOpening | Self::RotationJoint | Self::SlidingJoint)
    }
}

/// An equation of a system, named by its number in the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Equation {
    /// (2).
    LowerThrust,
    /// (3).
    UpperThrust,
    /// (4).
    WholeThrust,
    /// (5).
    Tangency,
    /// (5) in the limit `beta_r -> 0`, where `beta cot(beta) = 1`.
    TangencyAtCrown,
    /// `d/d eta` of (2) = (5), cleared of denominators: with (2) and (5) themselves it says that
    /// the thickness is a double root of the cubic (7), so that the radicand (12) is zero. The
    /// radicand itself would make the Jacobian singular there; this keeps the root simple.
    DoubleThickness,
    /// (17).
    ShoulderSliding,
    /// (18), at the joint given by [`Equation::Steepest`].
    InnerSliding,
    /// `beta_s² = h (1 - h)`, the other half of (18).
    Steepest,
}

impl Equation {
    /// All equations, in the order of the paper.
    pub const ALL: [Self; 9] = [
        Self::LowerThrust,
        Self::UpperThrust,
        Self::WholeThrust,
        Self::Tangency,
        Self::TangencyAtCrown,
        Self::DoubleThickness,
        Self::ShoulderSliding,
        Self::InnerSliding,
        Self::Steepest,
    ];

    /// The number in the paper, and what is special about it.
    pub fn label(self) -> &'static str {
        match self {
            Self::LowerThrust => "(2)",
            Self::UpperThrust => "(3)",
            Self::WholeThrust => "(4)",
            Self::Tangency => "(5)",
            Self::TangencyAtCrown => "(5) at beta_r -> 0",
            Self::DoubleThickness => "d/d eta of (2) = (5)",
            Self::ShoulderSliding => "(17)",
            Self::InnerSliding => "(18)",
            Self::Steepest => "beta_s^2 = h (1 - h)",
        }
    }

    /// The equation with its denominator cleared: zero where it holds.
    pub fn residual<T: Field>(self, weight: SelfWeight, at: &Configuration<T>) -> T {
        tally::equation(self);
        let ring = || Ring::new(weight, &at.thickness);
        match self {
            Self::LowerThrust => thrust::lower(&at.rotation_joint, &ring()).residual(&at.thrust),
            Self::UpperThrust => {
                thrust::upper(&at.half_opening, &at.rotation_joint, &ring()).residual(&at.thrust)
            }
            Self::WholeThrust => thrust::whole(&at.half_opening, &ring()).residual(&at.thrust),
            Self::Tangency => {
                thrust::tangency(&at.rotation_joint.times_cotangent(), &ring()).residual(&at.thrust)
            }
            Self::TangencyAtCrown => {
                thrust::tangency(&at.thrust.int(1), &ring()).residual(&at.thrust)
            }
            Self::DoubleThickness => {
                let eta = Dual::variable(at.thickness.clone(), 0);
                let joint = at.rotation_joint.clone().map(Dual::constant);
                let ring = Ring::new(weight, &eta);
                let tangency = thrust::tangency(&joint.times_cotangent(), &ring);
                thrust::lower(&joint, &ring).difference(&tangency).derivative(0)
            }
            Self::ShoulderSliding => {
                sliding::shoulder(&at.half_opening, &at.thrust).residual(&at.friction)
            }
            Self::InnerSliding => {
                sliding::inner(&at.sliding_joint, &at.thrust).residual(&at.friction)
            }
            Self::Steepest => sliding::steepest(&at.sliding_joint.rad, &at.thrust),
        }
    }

    /// The denominator that [`Equation::residual`] has cleared, if any: where it is not zero, the
    /// residual is zero exactly where the printed equation holds.
    pub fn denominator<T: Field>(self, weight: SelfWeight, at: &Configuration<T>) -> Option<T> {
        let ring = || Ring::new(weight, &at.thickness);
        let cotangent = at.thrust.int(1);
        Some(match self {
            Self::LowerThrust => thrust::lower(&at.rotation_joint, &ring()).denominator,
            Self::UpperThrust => {
                thrust::upper(&at.half_opening, &at.rotation_joint, &ring()).denominator
            }
            Self::WholeThrust => thrust::whole(&at.half_opening, &ring()).denominator,
            Self::Tangency | Self::TangencyAtCrown => {
                thrust::tangency(&cotangent, &ring()).denominator
            }
            Self::ShoulderSliding => sliding::shoulder(&at.half_opening, &at.thrust).denominator,
            Self::InnerSliding => sliding::inner(&at.sliding_joint, &at.thrust).denominator,
            Self::DoubleThickness | Self::Steepest => return None,
        })
    }
}

/// Values of all variables. One that a system neither solves for nor fixes is zero and is read by
/// none of its equations.
#[derive(Clone, Debug)]
pub struct Configuration<T> {
    /// `alpha`.
    pub half_opening: Angle<T>,
    /// `beta_r`.
    pub rotation_joint: Angle<T>,
    /// `beta_s`.
    pub sliding_joint: Angle<T>,
    /// `eta`.
    pub thickness: T,
    /// `h`.
    pub thrust: T,
    /// `mu`.
    pub friction: T,
}

impl<T: Real> Configuration<T> {
    /// The configuration with one variable given another value.
    pub fn with(mut self, unknown: Unknown, value: T) -> Self {
        match unknown {
            Unknown::HalfOpening => self.half_opening = Angle::new(value),
            Unknown::RotationJoint => self.rotation_joint = Angle::new(value),
            Unknown::SlidingJoint => self.sliding_joint = Angle::new(value),
            Unknown::Thickness => self.thickness = value,
            Unknown::Thrust => self.thrust = value,
            Unknown::Friction => self.friction = value,
        }
        self
    }

    /// All variables zero, "like" `like`.
    pub fn zero(like: &T) -> Self {
        let (angle, zero) = (Angle::zero(like), like.int(0));
        Self {
            half_opening: angle.clone(),
            rotation_joint: angle.clone(),
            sliding_joint: angle,
            thickness: zero.clone(),
            thrust: zero.clone(),
            friction: zero,
        }
    }
}

impl<T> Configuration<T> {
    /// The configuration with its values in another number.
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Configuration<U> {
        Configuration {
            half_opening: self.half_opening.map(&f),
            rotation_joint: self.rotation_joint.map(&f),
            sliding_joint: self.sliding_joint.map(&f),
            thickness: f(self.thickness),
            thrust: f(self.thrust),
            friction: f(self.friction),
        }
    }
}

/// What a system says of a variable that it does not solve for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fixed {
    /// An exact value.
    Integer(i32),
    /// Unbounded; no equation of the system reads it.
    Infinite,
    /// Equal to another variable.
    SameAs(Unknown),
}

/// As many equations as unknowns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct System {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// What is solved for, in order.
    pub unknowns: &'static [Unknown],
    /// What has to hold.
    pub equations: &'static [Equation],
    /// What is known beforehand.
    pub fixed: &'static [(Unknown, Fixed)],
}

/// Values of the unknowns of a system, in its order; angles with sine and cosine.
#[derive(Clone, Debug)]
pub struct Point<T> {
    values: Vec<T>,
    angles: Vec<Option<Angle<T>>>,
}

impl<T: Field> Point<T> {
    /// The values with their angles as `angle` makes them (given the index and the value).
    pub fn with_angles(
        system: &System,
        values: &[T],
        angle: impl Fn(usize, &T) -> Angle<T>,
    ) -> Self {
        let angles = system
            .unknowns
            .iter()
            .zip(values)
            .enumerate()
            .map(|(index, (unknown, value))| unknown.is_angle().then(|| angle(index, value)))
            .collect();
        Self { values: values.to_vec(), angles }
    }

    /// Every value as an unknown of a [`Dual`] number.
    pub fn variables(&self) -> Point<Dual<T>> {
        let values = self.values.iter().cloned().enumerate();
        let angles = self.angles.iter().enumerate();
        Point {
            values: values.map(|(index, value)| Dual::variable(value, index)).collect(),
            angles: angles
                .map(|(index, angle)| angle.as_ref().map(|angle| angle.variable(index)))
                .collect(),
        }
    }

    fn value(&self, index: usize) -> T {
        self.values[index].clone()
    }

    fn angle(&self, index: usize) -> Option<Angle<T>> {
        self.angles[index].clone()
    }
}

impl<T: Real> Point<T> {
    /// The values with sines and cosines computed.
    pub fn new(system: &System, values: &[T]) -> Self {
        Self::with_angles(system, values, |_, rad| Angle::new(rad.clone()))
    }
}

impl System {
    /// What the system knows of a variable that is not one of its unknowns.
    pub fn fixed_value(&self, unknown: Unknown) -> Option<Fixed> {
        self.fixed.iter().find(|(name, _)| *name == unknown).map(|(_, fixed)| *fixed)
    }

    /// The place of a variable among the unknowns.
    pub fn index(&self, unknown: Unknown) -> Option<usize> {
        self.unknowns.iter().position(|name| *name == unknown)
    }

    /// All variables at a point.
    pub fn configuration<T: Field>(&self, point: &Point<T>) -> Configuration<T> {
        let zero = point.values[0].int(0);
        let number = |unknown| match (self.index(unknown), self.fixed_value(unknown)) {
            (Some(index), _) => point.value(index),
            (None, Some(Fixed::Integer(n))) => zero.int(n),
            _ => zero.clone(),
        };
        let angle = |unknown| {
            let name = match self.fixed_value(unknown) {
                Some(Fixed::SameAs(other)) => other,
                _ => unknown,
            };
            self.index(name)
                .and_then(|index| point.angle(index))
                .unwrap_or_else(|| Angle::zero(&zero))
        };
        Configuration {
            half_opening: angle(Unknown::HalfOpening),
            rotation_joint: angle(Unknown::RotationJoint),
            sliding_joint: angle(Unknown::SlidingJoint),
            thickness: number(Unknown::Thickness),
            thrust: number(Unknown::Thrust),
            friction: number(Unknown::Friction),
        }
    }

    /// The residuals of the equations, in order.
    pub fn residuals<T: Field>(&self, point: &Point<T>) -> Vec<T> {
        let at = self.configuration(point);
        self.equations.iter().map(|equation| equation.residual(self.weight, &at)).collect()
    }

    /// The denominators that the residuals have cleared.
    pub fn denominators<T: Field>(&self, point: &Point<T>) -> Vec<T> {
        let at = self.configuration(point);
        self.equations
            .iter()
            .filter_map(|equation| equation.denominator(self.weight, &at))
            .collect()
    }
}
