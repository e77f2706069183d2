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
enum JointForm {
    Angle,
    Square,
}

impl JointForm {
    fn haunch<T: Real + Stumpff>(self, unknown: T) -> Haunch<T> {
        match self {
            Self::Angle => Haunch::from(&Angle::new(unknown)),
            Self::Square => Haunch::at_square(&unknown),
        }
    }
}

/// The root of (2), (4) and (5) next to `beta_r`, `eta`, proved to exist and to be unique in a box.
pub(super) fn rotational_root<E: Arithmetic>(
    query: &Query<E>,
    [beta, eta]: [E::Candidate; 2],
) -> Result<Configuration<E>, Undecided> {
    let exponent = beta.exponent_of_size().map_or(0, |exponent| 2 * exponent);
    let (joint, start) = match E::is_small(exponent, query.bits) {
        true => (JointForm::Square, [beta.square(), eta]),
        false => (JointForm::Angle, [beta, eta]),
    };
    let (root, sines) = E::rooted(&RotationEquations { query, joint }, query.bits, &start)?;
    let (angle, haunch) = match joint {
        JointForm::Angle => {
            let angle = E::angle(&sines, &root[0]);
            (angle.clone(), Haunch::from(&angle))
        }
        JointForm::Square => (E::angle(&sines, &root[0].sqrt()), joint.haunch(root[0].clone())),
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
