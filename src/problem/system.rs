//! Square systems of the equations: named unknowns, named equations, and what is fixed.

use super::Equation;
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::number::{Angle, Dual, Field, Real};

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
