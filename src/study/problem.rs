//! What is computed: square systems of equations with exact parameters, over any number.

use crate::arch::{
    Configuration, Landmark, Mode, Point, SelfWeight, System, Unknown, cubic, thrust,
};
use crate::number::{Angle, Dual, Field, Real, rational_like};
use rug::Rational;

/// A system of equations. Its parameters are exact, so that every method is given the same problem.
#[derive(Clone, Debug, PartialEq)]
pub enum Problem {
    /// A root of the second cubic (7) at a joint: `eta`.
    Thickness {
        /// The self-weight model.
        weight: SelfWeight,
        /// `beta`, rad.
        joint: Rational,
    },
    /// A root of the first cubic (7) at a joint: `A`.
    OpeningVariable {
        /// The self-weight model.
        weight: SelfWeight,
        /// `beta`, rad.
        joint: Rational,
    },
    /// A root of the third cubic (7) at a joint: `h`.
    Thrust {
        /// The self-weight model.
        weight: SelfWeight,
        /// `beta`, rad.
        joint: Rational,
    },
    /// The value of the radicand (12) at a joint.
    Radicand {
        /// The self-weight model.
        weight: SelfWeight,
        /// `beta`, rad.
        joint: Rational,
    },
    /// `alpha` with the given `A`.
    HalfOpening {
        /// `A`.
        a: Rational,
    },
    /// The unknowns of a landmark.
    Landmark {
        /// The self-weight model.
        weight: SelfWeight,
        /// The landmark.
        landmark: Landmark,
    },
    /// The unknowns of a state of the given mode.
    State {
        /// The self-weight model.
        weight: SelfWeight,
        /// The mode.
        mode: Mode,
        /// `alpha`, rad.
        half_opening: Rational,
        /// `mu`; not read by modes without sliding.
        friction: Rational,
    },
}

impl Problem {
    /// The names of what is solved for.
    pub fn unknowns(&self) -> Vec<&'static str> {
        match self {
            Self::Thickness { .. } => vec!["thickness"],
            Self::OpeningVariable { .. } => vec!["A"],
            Self::Thrust { .. } => vec!["thrust"],
            Self::Radicand { .. } => vec!["radicand"],
            Self::HalfOpening { .. } => vec!["half_opening"],
            Self::Landmark { weight, landmark } => names(landmark.system(*weight).unknowns),
            Self::State { mode, .. } => names(mode.system().0),
        }
    }

    /// The residuals with their derivatives to the unknowns, at `x`.
    pub fn residuals<T: Real>(&self, x: &[T]) -> Vec<Dual<T>> {
        let constant = |value: &Rational| rational_like(&x[0], value);
        let variable = Dual::variable(x[0].clone(), 0);
        // The joint is a parameter: a constant for the derivatives.
        let letters = |joint: &Rational| {
            cubic::abbreviations(&Angle::new(constant(joint)).map(Dual::constant))
        };
        let flag = |weight: SelfWeight| variable.int(weight.flag());
        match self {
            Self::Thickness { weight, joint } => {
                vec![cubic::in_thickness(&letters(joint), &flag(*weight), &variable)]
            }
            Self::OpeningVariable { weight, joint } => {
                vec![cubic::in_opening_variable(&letters(joint), &flag(*weight), &variable)]
            }
            Self::Thrust { weight, joint } => {
                vec![cubic::in_thrust(&letters(joint), &flag(*weight), &variable)]
            }
            Self::Radicand { weight, joint } => {
                vec![variable.clone() - cubic::radicand(&letters(joint), &flag(*weight))]
            }
            Self::HalfOpening { a } => {
                let alpha = Angle::new(x[0].clone()).variable(0);
                vec![thrust::opening_variable(&alpha).residual(&Dual::constant(constant(a)))]
            }
            Self::Landmark { weight, landmark } => {
                let system: System = landmark.system(*weight);
                system.residuals(&Point::new(&system, x).variables())
            }
            Self::State { weight, mode, half_opening, friction } => {
                let (unknowns, equations) = mode.system();
                let given = Configuration::zero(&x[0])
                    .with(Unknown::HalfOpening, constant(half_opening))
                    .with(Unknown::Friction, constant(friction))
                    .map(Dual::constant);
                let at = unknowns.iter().zip(x).enumerate().fold(given, |at, (index, (&u, x))| {
                    at.with(u, Dual::variable(x.clone(), index))
                });
                equations.iter().map(|equation| equation.residual(*weight, &at)).collect()
            }
        }
    }
}

fn names(unknowns: &[Unknown]) -> Vec<&'static str> {
    unknowns.iter().map(|unknown| unknown.name()).collect()
}
