//! The state in which an inner joint slides: that fixes the thrust, and (3) and (5) the rest.
//!
//! Next to the line `beta_r = 0` two roots of (3) and (5) meet at the crown, and a start value no longer tells
//! which mode it belongs to. There the crown is asked first: at the thickness of `[r,s]` the line of thrust
//! leaves the intrados at the crown, or crosses it and the joint is below. For that joint its square is the
//! unknown, in which the equations are smooth and the root is simple.

use super::query::Query;
use crate::arch::{Configuration, Ring, Unknown, contact, thrust};
use crate::number::{Angle, Enclosure, Field, Real, Stumpff};
use crate::problem::{Equation, Mode, tally};
use crate::prover::Undecided;
use crate::prover::arithmetic::Arithmetic;
use crate::prover::decide::decide;
use crate::prover::root::Form;
use crate::solve::start::{self, Start};

/// The state at the thrust and the sliding joint of `slid`, and its mode: parts 2 and 3 of the proof are left.
pub(super) fn inner_state<E: Arithmetic>(
    query: &Query<E>,
    slid: Configuration<E>,
) -> Result<(Mode, Configuration<E>), Undecided> {
    let (h, joint) = (slid.thrust.candidate(), slid.sliding_joint.rad.candidate());
    let start = start::rotational_sliding(query.weight, query.alpha().to_double(), h.to_double());
    let thickness = h.like(start.thickness);
    let at = match start.joint.filter(|_| !start.is_near_crown) {
        Some(beta) => {
            let start = [h.like(beta), thickness, h, joint];
            query.root(Mode::RotationalSliding.system(query.weight), &start)?
        }
        None => {
            let system = Mode::OverturningSliding.system(query.weight);
            let at = query.root(system, &[thickness, h, joint])?;
            let slope = contact::crown_slope(query.weight, &at);
            let between = [Mode::OverturningSliding, Mode::RotationalSlidingRotational];
            if decide(&slope, "whether the intrados is touched at the crown", &between)? {
                return Ok((Mode::OverturningSliding, at));
            }
            below_crown(query, slid, at.thickness.candidate())?
        }
    };
    Ok((by_the_higher_joint(&at)?, at))
}

/// The mode of a state with a hinge at the haunch and an inner joint that slides: which of the two is higher.
pub(super) fn by_the_higher_joint<E: Arithmetic>(at: &Configuration<E>) -> Result<Mode, Undecided> {
    let above = at.rotation_joint.rad.clone() - &at.sliding_joint.rad;
    let between = [Mode::RotationalSliding, Mode::RotationalSlidingRotational];
    let above = decide(&above, "which of the two inner joints is higher", &between)?;
    Ok(between[usize::from(!above)])
}

/// The root of (3) and (5) next to the crown, from the thickness there.
fn below_crown<E: Arithmetic>(
    query: &Query<E>,
    slid: Configuration<E>,
    thickness: E::Candidate,
) -> Result<Configuration<E>, Undecided> {
    let touching = TouchingEquations { query, slid: &slid };
    // From as good as zero one step of Newton's method leads next to the root.
    let square = thickness.int(1).shifted(-i64::from(query.bits));
    let root = E::root_near(&touching, query.bits, &[square, thickness])?;
    let at = slid.with(Unknown::RotationJoint, root[0].sqrt());
    Ok(at.with(Unknown::Thickness, root[1].clone()))
}

/// (3) and (5) for the square of the joint and the thickness, at a given thrust.
struct TouchingEquations<'a, E> {
    query: &'a Query<E>,
    slid: &'a Configuration<E>,
}

/// A joint by its square, as (3) sees it: `rad sin` is `beta sin(beta)`; and `beta cot(beta)`.
fn by_square<T: Stumpff>(u: &T) -> (Angle<T>, T) {
    let c = u.stumpff(2);
    let joint = Angle { rad: u.int(1), sin: u.clone() * &c[1], cos: c[0].clone() };
    (joint, c[0].clone() / &c[1])
}

impl<E> Form<E> for TouchingEquations<'_, E> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> Vec<T> {
        [Equation::UpperThrust, Equation::Tangency].into_iter().for_each(tally::equation);
        let given = self.slid.map_ref(number);
        let ring = Ring::new(self.query.weight, &x[1]);
        let (joint, times_cotangent) = by_square(&x[0]);
        let upper = thrust::upper(&given.half_opening, &joint, &ring);
        let tangency = thrust::tangency(&times_cotangent, &ring);
        [upper, tangency].map(|thrust| thrust.residual(&given.thrust)).into()
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> bool {
        let ring = Ring::new(self.query.weight, &x[1]);
        let (joint, times_cotangent) = by_square(&x[0]);
        let given = self.slid.map_ref(number);
        let arm = thrust::upper(&given.half_opening, &joint, &ring).denominator;
        times_cotangent.is_bounded() && [arm, ring.intrados()].iter().all(Enclosure::excludes_zero)
    }
}

#[cfg(test)]
mod tests {
    use crate::certify::state::Certify;
    use crate::problem::{Arch, Mode};

    /// Beside the line on which the touching joint reaches the crown one of its two modes is proved, however near.
    #[test]
    fn beside_the_crown_one_of_two_modes_is_proved() {
        for (weight, opening, friction) in [
            (
                "milankovitch",
                "2.58395207181244888981930883245091055381146624417878",
                "4.80190459023868686926760607580345040572957916923969",
            ),
            (
                "milankovitch",
                "2.58948618029010384773723241433712318098427878318040482567506",
                "10.9125116436940902176593486683915216429005575219581811086188",
            ),
            (
                "heyman",
                "2.64087107662887720359759229766854209397475429896903662824641",
                "4.61238742176220484010581288597484941880067326580894515400766",
            ),
            (
                "milankovitch",
                "2.58943198629017077291394021370933672805127975914269963594684073",
                "10.7000930976491106416631326645607606625732121310733982446276",
            ),
        ] {
            let arch = Arch::parse(weight, opening, friction).unwrap();
            let found = arch.least(30).unwrap_or_else(|open| panic!("{weight} {opening}: {open}"));
            assert!(
                [Mode::OverturningSliding, Mode::RotationalSlidingRotational].contains(&found.mode)
            );
        }
    }
}
