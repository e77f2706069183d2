//! Proof of a purely rotational state, `[r,r,r]`, with the frictions that it asks for.
//!
//! **One equation.** For a joint `beta` let `eta` be the thickness and `h` the thrust at which (2), (4) and (5) hold
//! with one and the same moment of the weight, whatever that is: [`thrust::rotating`] and [`thrust::touching`]. The
//! rest is that the moment is the one of the weight, `fac_M(eta)`: with it (4) has the thrust `h` too. That is one
//! equation `F(beta) = 0`, and where it holds, (2), (4) and (5) do. A test has this in exact arithmetic.

use super::asking::{Asking, double};
use super::margins::{Thinnest, are_positive, in_doubles, of_haunch, of_state, steepest};
use super::piece::Proof;
use super::root::{Equation, is_within, known_if, root};
use super::sine::{Long, Sine};
use super::start::{self, Table, rotates};
use super::width::Width;
use crate::arch::contact::{self, Rates};
use crate::arch::{Configuration, Ring, SelfWeight, overturning, sliding, thrust};
use crate::number::{Angle, DoubleDoubleBall, Field, Product, SinePoint};

/// Proof of purely rotational states; the frictions that they ask for are enclosed in double-doubles if `EXACTLY`, and
/// the root is [finer](Equation::FINER) if the half openings are `NARROW`.
struct Rotation<'a, const EXACTLY: bool, const NARROW: bool> {
    weight: SelfWeight,
    table: &'a Table<2>,
}

/// Values of the proof: thickness, thrust, intrinsic thrust, `beta_r`, and the frictions that the shoulder and the
/// steepest joint ask for.
pub(super) type Rotating = [DoubleDoubleBall; 6];

/// Below this half opening, rad, the equation has too few digits of the joint in doubles.
const NARROW: f64 = 0.125;

/// Purely rotational states of half openings.
pub(super) fn rotating<const EXACTLY: bool>(
    (width, weight): (Width, SelfWeight),
    half_openings: &[[DoubleDoubleBall; 1]],
) -> Vec<Option<Rotating>> {
    let table = start::rotation(weight);
    let mut all = width.prove(&Rotation::<EXACTLY, false> { weight, table }, half_openings);
    let (mut narrow, all_places) = (Asking::default(), half_openings.iter().enumerate());
    let is_narrow = |(_, [alpha]): &(usize, &[DoubleDoubleBall; 1])| double(alpha) < NARROW;
    all_places.filter(is_narrow).for_each(|(place, alpha)| narrow.push(place, *alpha));
    let proof = || Rotation::<EXACTLY, true> { weight, table };
    narrow.each(width, proof, |place, _, found| all[place] = Some(found));
    all
}

/// Values that (2), (4) and (5) give to a joint.
struct RotationValues<T> {
    thickness: T,
    /// The thrust by (4).
    thrust: T,
    /// `F`: zero where the thrust by (2) and (5) is the same.
    residual: T,
}

#[inline(always)]
fn at_joint<T: Field>(
    weight: SelfWeight,
    opening_variable: &T,
    joint: &Angle<T>,
) -> RotationValues<T> {
    let ring = Ring::new(weight, &thrust::rotating(joint, opening_variable).value());
    let thrust = opening_variable.clone() - overturning::opening_variable(&ring).value();
    let excess = joint.rad.clone() / &joint.sin - joint.rad.int(1);
    let residual = thrust::touching(&joint.versine(), &excess, &ring).residual(&thrust);
    RotationValues { thickness: ring.thickness, thrust, residual }
}

/// The equation in the joint, for an opening variable.
struct RotationEquation<P, const NARROW: bool> {
    weight: SelfWeight,
    opening_variable: Long<P>,
}

impl<P: Product, const NARROW: bool> Equation<P, 2> for RotationEquation<P, NARROW> {
    const FINER: bool = NARROW;

    #[inline(always)]
    fn at<T: Sine<P>>(
        &self,
        number: impl Fn(&Long<P>) -> T + Copy,
        joint: &Angle<T>,
    ) -> (T, [T; 2]) {
        let a = number(&self.opening_variable);
        let RotationValues { thickness, thrust, residual } = at_joint(self.weight, &a, joint);
        (residual, [thickness, thrust])
    }
}

/// Margins of its own, but for those of friction.
#[inline(always)]
fn margins<T: Field>(at: &Configuration<T>, rates: &Rates<T>, steepest: &T) -> [T; 2] {
    [rates.shoulder.clone(), at.half_opening.rad.clone() - steepest]
}

impl<const EXACTLY: bool, const NARROW: bool> Proof<1, 3, 6> for Rotation<'_, EXACTLY, NARROW> {
    #[inline(always)]
    fn candidates(&self, [alpha]: [f64; 1]) -> [f64; 3] {
        let [joint, steepest] = self.table.at(alpha);
        [alpha, joint.sqrt(), steepest.sqrt()]
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [alpha]: [Long<P>; 1],
        [(_, at_alpha), (joint, at_joint), (_, at_steepest)]: [(f64, SinePoint); 3],
    ) -> [Long<P>; 6] {
        let Self { weight, .. } = *self;
        let half_opening = alpha.angle(&at_alpha);
        let opening_variable = thrust::opening_variable(&half_opening).value();
        let equation = RotationEquation::<P, NARROW> { weight, opening_variable };
        let found = root(&equation, (joint, &at_joint), 2);
        let [thickness, thrust] = found.values;
        let unlimited = Long::<P>::exact(f64::INFINITY.into());
        let at = in_doubles(&half_opening, [&thickness, &thrust, &unlimited], found.domain);
        let rates = contact::rates_of_rotation(&at);
        let (steepest, frictions) = match EXACTLY {
            true => {
                let (joint, inside) = steepest::<P, _>(&thrust, &at_steepest);
                let at_shoulder = sliding::shoulder(&half_opening, &thrust);
                (joint.rad.in_doubles(), [at_shoulder.value(), inside.value()])
            }
            false => {
                let (joint, inside) = steepest::<P, _>(&at.thrust, &at_steepest);
                let at_shoulder = sliding::shoulder(&at.half_opening, &at.thrust);
                (joint.rad, [at_shoulder, inside].map(|of| of.value().in_double_doubles()))
            }
        };
        let is_proved = found.is_proved
            & are_positive(&of_state(&at))
            & are_positive(&of_haunch(&at))
            & are_positive(&margins(&at, &rates, &steepest))
            & Thinnest::new(weight, &at, &rates).holds_unlimited()
            & is_within(alpha.mid().hi(), rotates(weight));
        let [at_shoulder, inside] = frictions;
        let all = [thickness, thrust, thickness * thrust, found.angle, at_shoulder, inside];
        all.map(|x| known_if(is_proved, x))
    }
}

#[cfg(test)]
mod tests {
    use super::super::margins::tests::{assert_are_all, configuration};
    use super::*;
    use couplet_check::problem::{Mode, inner_friction, shoulder_friction};
    use rug::Rational;

    /// Exact joints and half openings, of no state.
    fn exact() -> impl Iterator<Item = (Rational, Angle<Rational>)> {
        let angle = |rad: (i32, i32), sin: (i32, i32), cos: (i32, i32)| Angle {
            rad: rad.into(),
            sin: sin.into(),
            cos: cos.into(),
        };
        let joints = [
            angle((1, 1), (20, 29), (21, 29)),
            angle((2, 3), (5, 13), (12, 13)),
            angle((3, 2), (4, 5), (-3, 5)),
        ];
        let variables = [(3, 2), (9, 7), (1, 2)].map(Rational::from);
        variables.into_iter().flat_map(move |a| joints.clone().map(|joint| (a.clone(), joint)))
    }

    /// With the moment for which (4) holds, (2) and (5) hold; and the residual is what that moment leaves of that of
    /// the weight.
    #[test]
    fn the_residual_is_all_that_is_left() {
        for (a, joint) in exact() {
            for weight in SelfWeight::ALL {
                let eta = thrust::rotating(&joint, &a).value();
                let excess = joint.rad.clone() / &joint.sin - Rational::from(1);
                let ring =
                    |factor: Rational| Ring { thickness: eta.clone(), centroid_factor: factor };
                let h = thrust::touching(&joint.versine(), &excess, &ring(1.into())).value();
                let moment =
                    (a.clone() - &h) * (eta.clone() + Rational::from(2)) / Rational::from(2);
                let ring = ring(moment.clone());
                assert_eq!(thrust::lower(&joint, &ring).residual(&h), 0);
                assert_eq!(thrust::tangency(&joint.times_cotangent(), &ring).residual(&h), 0);
                let found = at_joint(weight, &a, &joint);
                assert_eq!(found.thickness, eta);
                let of_weight = Ring::new(weight, &eta).centroid_factor;
                let left = (moment - &of_weight) * Rational::from(4) * &eta
                    / (eta.clone() + Rational::from(2));
                assert_eq!(found.residual, left);
                assert_ne!(found.residual, 0);
                let other = Ring { centroid_factor: of_weight, ..ring };
                assert_ne!(thrust::lower(&joint, &other).residual(&h), 0, "false twin");
            }
        }
    }

    #[test]
    fn the_margins_are_those_of_all_conditions() {
        for (weight, at) in [
            (SelfWeight::Heyman, [140, 87, 0, 7, 70, 60]),
            (SelfWeight::Milankovitch, [290, 150, 0, 20, 10, 60]),
        ] {
            let at = configuration(at);
            let rates = contact::rates_of_rotation(&at);
            let steepest = sliding::steepest_joint(&at.thrust);
            let frictions = [shoulder_friction(&at), inner_friction(&at)];
            let frictions = frictions.map(|of| at.friction.clone() - of);
            let [state, haunch] = [of_state(&at).to_vec(), of_haunch(&at).to_vec()];
            let found =
                [state, haunch, margins(&at, &rates, &steepest).to_vec(), frictions.to_vec()];
            let thinnest = Thinnest::new(weight, &at, &rates);
            assert_are_all((weight, Mode::Rotational, true), &at, &found.concat(), &thinnest);
        }
    }
}
