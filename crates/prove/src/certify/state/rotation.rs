//! The purely rotational state: (2), (4) and (5) with the thrust eliminated.
//!
//! Next to the end of rotation the joint goes to the crown and the thrust falls like its fourth power. As
//! an unknown of its own the thrust would need twice the digits, and in the joint the equations have a
//! double root: there the square of the joint is the unknown, in which they are smooth.

use super::query::Query;
use crate::arch::haunch::Haunch;
use crate::arch::{Configuration, Ring, SelfWeight, Unknown, thrust};
use crate::number::{Angle, Enclosure, Field, Real, Stumpff};
use crate::problem::{Equation, tally};
use crate::prover::Undecided;
use crate::prover::arithmetic::Arithmetic;
use crate::prover::root::Form;
use crate::solve::start::Start;

/// The joint itself as the unknown, or its square.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum JointForm {
    Angle,
    Square,
}

impl JointForm {
    /// The unknown near a joint, at a precision of `bits` bits: the square where that is small.
    pub(super) fn near<E: Arithmetic>(beta: E::Candidate, bits: u32) -> (Self, E::Candidate) {
        let exponent = beta.exponent_of_size().map_or(0, |exponent| 2 * exponent);
        match E::is_small(exponent, bits) {
            true => (Self::Square, beta.square()),
            false => (Self::Angle, beta),
        }
    }

    pub(super) fn haunch<T: Real + Stumpff>(self, unknown: T) -> Haunch<T> {
        match self {
            Self::Angle => Haunch::from(&Angle::new(unknown)),
            Self::Square => Haunch::at_square(&unknown),
        }
    }

    /// The joint by the unknown, rad.
    pub(super) fn rad<T: Real>(self, unknown: &T) -> T {
        match self {
            Self::Angle => unknown.clone(),
            Self::Square => unknown.sqrt(),
        }
    }
}

/// The root of (2), (4) and (5) next to `beta_r`, `eta`, proved to exist and to be unique in a box.
pub(super) fn rotational_root<E: Arithmetic>(
    query: &Query<E>,
    [beta, eta]: [E::Candidate; 2],
) -> Result<Configuration<E>, Undecided> {
    let (joint, start) = JointForm::near::<E>(beta, query.bits);
    let equations = RotationEquations { query, joint };
    let (root, sines) = E::rooted(&equations, query.bits, &[start, eta])?;
    let angle = E::angle(&sines, &joint.rad(&root[0]));
    let haunch = match joint {
        JointForm::Angle => Haunch::from(&angle),
        JointForm::Square => joint.haunch(root[0].clone()),
    };
    let thrust = thrust_at(query.weight, &haunch, &root[1]);
    let at = Configuration { rotation_joint: angle, ..query.given.clone() };
    Ok(at.with(Unknown::Thickness, root[1].clone()).with(Unknown::Thrust, thrust))
}

fn thrust_at<T: Field>(weight: SelfWeight, haunch: &Haunch<T>, eta: &T) -> T {
    thrust::touching(&haunch.versine, &haunch.excess, &Ring::new(weight, eta)).value()
}

/// (4) and (5) for the joint or its square, and the thickness.
struct RotationEquations<'a, E> {
    query: &'a Query<E>,
    joint: JointForm,
}

impl<E> Form<E> for RotationEquations<'_, E> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> Vec<T> {
        let weight = self.query.weight;
        let [joint, eta] = [0, 1].map(|index| x[index].clone());
        let haunch = self.joint.haunch(joint);
        let thrust = thrust_at(weight, &haunch, &eta);
        let ring = Ring::new(weight, &eta);
        // The thrust is what (2) and (5) have in common.
        let used = [Equation::LowerThrust, Equation::Tangency, Equation::WholeThrust];
        used.into_iter().for_each(tally::equation);
        let tangency = thrust::tangency(&haunch.times_cotangent, &ring).residual(&thrust);
        let given = self.query.given.map_ref(number);
        let at = given.with(Unknown::Thickness, eta).with(Unknown::Thrust, thrust);
        vec![Equation::WholeThrust.residual(weight, &at), tangency]
    }

    /// Equation (2) follows: with the thrust that (2) and (5) have in common, it is a multiple of (5).
    fn is_regular<T: Enclosure + Stumpff>(&self, _number: impl Fn(&E) -> T, x: &[T]) -> bool {
        let ring = Ring::new(self.query.weight, &x[1]);
        let haunch = self.joint.haunch(x[0].clone());
        let lever = ring.extrados() - ring.intrados() * (x[1].int(1) - &haunch.versine);
        let divisors = [x[1].clone(), ring.intrados(), ring.extrados(), lever];
        haunch.excess.is_bounded() && divisors.iter().all(Enclosure::excludes_zero)
    }
}
