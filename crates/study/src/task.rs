//! Tasks that are computed: square systems of equations with exact parameters, over any number.

use super::closed::ClosedForm;
use crate::arch::{Configuration, SelfWeight, Unknown, cubic, thrust};
use crate::number::{Angle, Dual, Engine, Field, Real, rational_like};
use crate::problem::{Landmark, Mode};
use crate::prover::operator::Equations;
use rug::Rational;

/// A system of equations. Its parameters are exact, so that every method is given the same problem.
#[derive(Clone, Debug, PartialEq)]
pub enum Task {
    /// A root of one of the cubics (7) at a joint: `A`, `eta` or `h`.
    Cubic {
        /// The closed form.
        form: ClosedForm,
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

impl Task {
    /// The exact parameters, in numbers like `like`.
    pub fn parameters<T: Field>(&self, like: &T) -> Vec<T> {
        let given = match self {
            Self::Cubic { joint, .. } | Self::Radicand { joint, .. } => vec![joint],
            Self::HalfOpening { a } => vec![a],
            Self::Landmark { .. } => Vec::new(),
            Self::State { half_opening, friction, .. } => vec![half_opening, friction],
        };
        given.into_iter().map(|value| rational_like(like, value)).collect()
    }

    /// The residuals with their derivatives to the unknowns, at `x`.
    pub fn residuals<T: Real>(&self, x: &[T]) -> Vec<Dual<T>> {
        let parameters = self.parameters(&x[0]);
        self.equations(x, parameters.into_iter().map(Dual::constant).collect())
    }

    /// Residuals with the derivatives to the parameters after those to the unknowns.
    pub fn residuals_with_parameters<T: Real>(&self, x: &[T]) -> Vec<Dual<T>> {
        let parameters = self.parameters(&x[0]).into_iter().enumerate();
        let variables = parameters.map(|(k, a)| Dual::variable(a, x.len() + k)).collect();
        self.equations(x, variables)
    }

    fn equations<T: Real>(&self, x: &[T], parameters: Vec<Dual<T>>) -> Vec<Dual<T>> {
        let variable = Dual::variable(x[0].clone(), 0);
        let letters = || cubic::abbreviations(&Angle::new(parameters[0].clone()));
        let flag = |weight: SelfWeight| variable.int(weight.flag());
        match self {
            Self::Cubic { form, weight, .. } => {
                vec![form.cubic(&letters(), &flag(*weight), &variable)]
            }
            Self::Radicand { weight, .. } => {
                vec![variable.clone() - cubic::radicand(&letters(), &flag(*weight))]
            }
            Self::HalfOpening { .. } => {
                let alpha = Angle::new(x[0].clone()).variable(0);
                vec![thrust::opening_variable(&alpha).residual(&parameters[0])]
            }
            Self::Landmark { weight, landmark } => {
                let system = landmark.system(*weight);
                let given = Configuration::zero(&x[0]);
                system.residuals(&system.variables(&system.place(given, x)))
            }
            Self::State { weight, mode, .. } => {
                let given = Configuration::zero(&variable)
                    .with(Unknown::HalfOpening, parameters[0].clone())
                    .with(Unknown::Friction, parameters[1].clone());
                let system = mode.system(*weight);
                system.residuals(&system.place(given, &Dual::variables(x)))
            }
        }
    }
}

impl<E: Engine> Equations<E> for Task {
    fn residuals(&self, bits: u32, x: &[E]) -> Vec<E> {
        self.slopes(bits, x).into_iter().map(|r| r.value().clone()).collect()
    }

    fn slopes(&self, _bits: u32, x: &[E]) -> Vec<Dual<E>> {
        Task::residuals(self, x)
    }

    /// A denominator that may vanish leaves residuals without bounds, with which no box is proved.
    fn is_regular(&self, _bits: u32, _x: &[E]) -> bool {
        true
    }
}
