//! Proof of a state in which an inner joint slides, `[r,r,s]` or `[r,s,r]`, from the thrust and the joint of (18).
//!
//! With that thrust, (3) and (5) have one thickness at each joint, whatever the weight: [`thrust::touched_below`].
//! What (5) leaves with the weight is one equation in the joint.

use super::margins::{Thinnest, are_positive, in_doubles, of_haunch, of_state};
use super::piece::Proof;
use super::root::{Equation, known_if, newton, root};
use super::sine::{Long, Sine};
use super::start::StartPlane;
use crate::arch::contact::{self, Rates};
use crate::arch::{Configuration, Ring, SelfWeight, sliding, thrust};
use crate::number::{Angle, Dekker, Field, Product, SinePoint};

/// Proof of states in which an inner joint slides.
pub(super) struct Inner<'a> {
    pub(super) weight: SelfWeight,
    pub(super) plane: &'a StartPlane,
}

/// (5) at the thickness of (3) and (5), at a thrust.
struct InnerEquation<P> {
    weight: SelfWeight,
    half_opening: Angle<Long<P>>,
    thrust: Long<P>,
}

impl<P: Product> Equation<P, 1> for InnerEquation<P> {
    #[inline(always)]
    fn at<T: Sine<P>>(
        &self,
        number: impl Fn(&Long<P>) -> T + Copy,
        joint: &Angle<T>,
    ) -> (T, [T; 1]) {
        let Angle { rad, sin, cos } = &self.half_opening;
        let half_opening = Angle { rad: number(rad), sin: number(sin), cos: number(cos) };
        let h = number(&self.thrust);
        let (times_sine, times_cotangent) = (joint.rad * joint.sin, joint.times_cotangent());
        let of_joint = [&joint.cos, &times_sine, &times_cotangent];
        let thickness = thrust::touched_below(&half_opening, of_joint, &h).value();
        let ring = Ring::new(self.weight, &thickness);
        (thrust::tangency(&times_cotangent, &ring).residual(&h), [thickness])
    }
}

/// Margins of its own, but for the order of the joints.
#[inline(always)]
fn margins<T: Field>(weight: SelfWeight, at: &Configuration<T>, rates: &Rates<T>) -> [T; 4] {
    [
        contact::crown_moment(at) - contact::shoulder_moment(weight, at),
        at.half_opening.rad.clone() - &at.sliding_joint.rad,
        at.friction.clone() - sliding::shoulder(&at.half_opening, &at.thrust).value(),
        rates.sliding.clone(),
    ]
}

/// Values: thickness, intrinsic thrust and `beta_r`.
impl Proof<4, 2, 3> for Inner<'_> {
    #[inline(always)]
    fn candidates(&self, [alpha, _, h, _]: [f64; 4]) -> [f64; 2] {
        // The plane alone is not near enough for a point to reach the root.
        let exact = |x: f64| Long::<Dekker>::exact(x.into());
        let at_alpha: Angle<f64> = Sine::<Dekker>::angle(alpha, &SinePoint::nearest(alpha));
        let half_opening = at_alpha.map(exact);
        let equation = InnerEquation { weight: self.weight, half_opening, thrust: exact(h) };
        let mut joint = self.plane.at(alpha, h).sqrt();
        for _ in 0..3 {
            (joint, _) = newton(&equation, joint, &SinePoint::nearest(joint));
        }
        [alpha, joint]
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [alpha, friction, thrust, slides]: [Long<P>; 4],
        [(_, at_alpha), (joint, at_joint)]: [(f64, SinePoint); 2],
    ) -> [Long<P>; 3] {
        let Self { weight, .. } = *self;
        let half_opening = alpha.angle(&at_alpha);
        let equation = InnerEquation { weight, half_opening, thrust };
        let found = root(&equation, (joint, &at_joint), 1);
        let ([thickness], half_opening) = (found.values, &equation.half_opening);
        let mut at = in_doubles(half_opening, [&thickness, &thrust, &friction], found.domain);
        at.sliding_joint.rad = slides.in_doubles();
        let rates = contact::rates_of_inner_sliding(&at);
        let is_proved = found.is_proved
            & are_positive(&of_state(&at))
            & are_positive(&of_haunch(&at))
            & are_positive(&margins(weight, &at, &rates))
            & Thinnest::new(weight, &at, &rates).holds();
        [thickness, thickness * thrust, found.angle].map(|x| known_if(is_proved, x))
    }
}

#[cfg(test)]
mod tests {
    use super::super::margins::tests::{assert_are_all, configuration};
    use super::*;
    use couplet_check::problem::Mode;
    use rug::Rational;

    /// With the moment for which (5) holds at its thickness, (3) holds too.
    #[test]
    fn the_thickness_is_that_of_both_equations() {
        let angle = |rad: (i32, i32), sin: (i32, i32), cos: (i32, i32)| Angle {
            rad: Rational::from(rad),
            sin: Rational::from(sin),
            cos: Rational::from(cos),
        };
        let (alpha, joint) = (angle((12, 5), (4, 5), (-3, 5)), angle((2, 3), (5, 13), (12, 13)));
        let (times_sine, k) = (joint.rad.clone() * &joint.sin, joint.times_cotangent());
        for h in [(1, 9), (4, 5)].map(Rational::from) {
            let of_joint = [&joint.cos, &times_sine, &k];
            let eta = thrust::touched_below(&alpha, of_joint, &h).value();
            let moment =
                (Rational::from(2) - &eta) * (Rational::from(1) + &k - &h) / Rational::from(2);
            let ring =
                |eta: &Rational| Ring { thickness: eta.clone(), centroid_factor: moment.clone() };
            let holds = |ring: &Ring<Rational>| {
                let upper = thrust::upper(&alpha, &joint, ring).residual(&h);
                (thrust::tangency(&k, ring).residual(&h) == 0, upper == 0)
            };
            assert_eq!(holds(&ring(&eta)), (true, true));
            assert_eq!(holds(&ring(&(eta + Rational::from((1, 7))))), (false, false), "false twin");
        }
    }

    #[test]
    fn the_margins_are_those_of_all_conditions_but_one() {
        let cases = [
            (Mode::RotationalSliding, [250, 95, 30, 70, 10, 160]),
            (Mode::RotationalSlidingRotational, [255, 10, 27, 90, 8, 160]),
            (Mode::RotationalSliding, [280, 150, 30, 70, 10, 30]),
        ];
        for (mode, at) in cases {
            let (weight, at) = (SelfWeight::Milankovitch, configuration(at));
            let rates = contact::rates_of_inner_sliding(&at);
            let order = at.rotation_joint.rad.clone() - &at.sliding_joint.rad;
            let order = if mode == Mode::RotationalSliding { order } else { -order };
            let own = margins(weight, &at, &rates).to_vec();
            let found =
                [of_state(&at).to_vec(), of_haunch(&at).to_vec(), own, vec![order]].concat();
            let thinnest = Thinnest::new(weight, &at, &rates);
            assert_are_all((weight, mode, true), &at, &found, &thinnest);
        }
    }
}
