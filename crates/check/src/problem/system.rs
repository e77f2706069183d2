//! Square systems of the equations: named unknowns, named equations, and what is fixed.

use super::{Equation, tally};
use crate::arch::small::Scaled;
use crate::arch::{Configuration, SelfWeight, Unknown};
use crate::number::{Angle, Dual, Field, Real};

/// Fixed value of a variable that a system does not solve for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fixed {
    /// An exact value; for an angle it is zero.
    Integer(i32),
    /// Unbounded; no equation of the system reads it.
    Infinite,
    /// Equal to another variable.
    SameAs(Unknown),
}

/// As many equations as unknowns. Variables that are neither unknown nor fixed are given, as the half
/// opening and the friction of an arch are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct System {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Unknowns that are solved for, in order.
    pub unknowns: &'static [Unknown],
    /// Equations that have to hold.
    pub equations: &'static [Equation],
    /// Variables that are known beforehand, whatever is given.
    pub fixed: &'static [(Unknown, Fixed)],
}

/// The system of a weight by names: what is solved for; the equations; and what is fixed.
macro_rules! system {
    ($weight:expr; $($unknown:ident)+; $($equation:ident)+; $($fixed:ident = $known:ident$(($of:expr))?),*) => {
        $crate::problem::System {
            weight: $weight,
            unknowns: &[$($crate::arch::Unknown::$unknown),+],
            equations: &[$($crate::problem::Equation::$equation),+],
            fixed: &[$(($crate::arch::Unknown::$fixed, $crate::problem::Fixed::$known$(($of))?)),*],
        }
    };
}
pub(super) use system;

impl System {
    /// The thrust at which an inner joint just slides, at a given friction.
    pub fn inner_sliding(weight: SelfWeight) -> Self {
        system!(weight; Thrust SlidingJoint; InnerSliding Steepest;)
    }

    /// The thrust at which the line of thrust touches the intrados at a given thickness: the least, on
    /// the extrados at the crown, or the largest, on the extrados at the shoulder.
    pub fn touching(weight: SelfWeight, is_least: bool) -> Self {
        match is_least {
            true => system!(weight; RotationJoint Thrust; LowerThrust Tangency;),
            false => system!(weight; RotationJoint Thrust; UpperThrust Tangency;),
        }
    }

    /// The joint at which the line of thrust is tangent to the intrados at a given thickness and thrust.
    pub fn tangent(weight: SelfWeight) -> Self {
        system!(weight; RotationJoint; Tangency;)
    }

    /// Value that the system gives a variable that is not one of its unknowns.
    pub fn fixed_value(&self, unknown: Unknown) -> Option<Fixed> {
        self.fixed.iter().find(|(name, _)| *name == unknown).map(|(_, fixed)| *fixed)
    }

    /// The place of a variable among the unknowns.
    pub fn index(&self, unknown: Unknown) -> Option<usize> {
        self.unknowns.iter().position(|name| *name == unknown)
    }

    /// Tells whether the system solves for a variable or fixes it.
    pub fn knows(&self, unknown: Unknown) -> bool {
        self.index(unknown).is_some() || self.fixed_value(unknown).is_some()
    }

    /// The place of the unknown that a variable is, or is equal to.
    fn source(&self, unknown: Unknown) -> Option<usize> {
        match self.fixed_value(unknown) {
            Some(Fixed::SameAs(other)) => self.index(other),
            _ => self.index(unknown),
        }
    }

    /// All variables: the unknowns have `values`, in order, with sines and cosines computed; what is
    /// neither unknown nor fixed is as `given`.
    pub fn place<T: Real>(&self, given: Configuration<T>, values: &[T]) -> Configuration<T> {
        self.place_with(given, values, |_, rad| Angle::new(rad.clone()))
    }

    /// Places the values of the unknowns with angles as `angle` makes them, given the place of the unknown
    /// and its value.
    pub fn place_with<T: Field>(
        &self,
        given: Configuration<T>,
        values: &[T],
        angle: impl Fn(usize, &T) -> Angle<T>,
    ) -> Configuration<T> {
        let unknowns = self.unknowns.iter().zip(values).enumerate();
        let angles: Vec<Option<Angle<T>>> = unknowns
            .map(|(index, (unknown, value))| unknown.is_angle().then(|| angle(index, value)))
            .collect();
        given.map_each(
            |unknown, given| match (self.source(unknown), self.fixed_value(unknown)) {
                (Some(index), _) => angles[index].clone().unwrap_or(given),
                (None, Some(Fixed::Integer(_))) => Angle::zero(&given.rad),
                _ => given,
            },
            |unknown, given| match (self.source(unknown), self.fixed_value(unknown)) {
                (Some(index), _) => values[index].clone(),
                (None, Some(Fixed::Integer(n))) => given.int(n),
                _ => given,
            },
        )
    }

    /// All variables at a point, each unknown as a variable of dual numbers.
    pub fn variables<T: Field>(&self, at: &Configuration<T>) -> Configuration<Dual<T>> {
        at.clone().map_each(
            |unknown, angle| match self.source(unknown) {
                Some(index) => angle.variable(index),
                None => angle.map(Dual::constant),
            },
            |unknown, value| match self.source(unknown) {
                Some(index) => Dual::variable(value, index),
                None => Dual::constant(value),
            },
        )
    }

    /// The values of the unknowns, in order.
    pub fn values<T: Clone>(&self, at: &Configuration<T>) -> Vec<T> {
        self.unknowns.iter().map(|&unknown| at.value(unknown).clone()).collect()
    }

    /// The residuals of the equations, in order.
    pub fn residuals<T: Field>(&self, at: &Configuration<T>) -> Vec<T> {
        let residual = |equation: &Equation| {
            tally::equation(*equation);
            equation.residual(self.weight, at)
        };
        self.equations.iter().map(residual).collect()
    }

    /// The residuals in scaled variables; `None` if an equation has no such form.
    pub fn scaled_residuals<T: Field>(&self, at: &Scaled<T>) -> Option<Vec<T>> {
        let residual = |equation: &Equation| {
            tally::equation(*equation);
            equation.scaled_residual(self.weight, at)
        };
        self.equations.iter().map(residual).collect()
    }

    /// The denominators that the residuals have cleared.
    pub fn denominators<T: Field>(&self, at: &Configuration<T>) -> Vec<T> {
        self.equations.iter().filter_map(|equation| equation.denominator(self.weight, at)).collect()
    }
}
