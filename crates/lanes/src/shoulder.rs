//! Proof of a state in which the shoulder slides, `[s,r,r]`.
//!
//! (17) has the thrust. With it, (2) and (5) have one thickness at each joint, whatever the weight:
//! [`thrust::touched`]. What (5) leaves with the weight is one equation in the joint.

use super::margins::{Thinnest, are_positive, in_doubles, of_haunch, of_state, steepest};
use super::piece::Proof;
use super::root::{Equation, is_within, known_if, root};
use super::sine::{Long, Sine};
use super::start::{THRUSTS, Table};
use crate::arch::contact::{self, Rates};
use crate::arch::{Configuration, Ring, SelfWeight, sliding, thrust};
use crate::number::{Angle, Dekker, Field, Product, SinePoint};

/// Proof of states in which the shoulder slides.
pub(super) struct Shoulder<'a> {
    pub(super) weight: SelfWeight,
    pub(super) table: &'a Table<1>,
}

/// (5) at the thickness of (2) and (5), at a thrust.
struct ShoulderEquation<P> {
    weight: SelfWeight,
    thrust: Long<P>,
}

impl<P: Product> Equation<P, 1> for ShoulderEquation<P> {
    #[inline(always)]
    fn at<T: Sine<P>>(
        &self,
        number: impl Fn(&Long<P>) -> T + Copy,
        joint: &Angle<T>,
    ) -> (T, [T; 1]) {
        let h = number(&self.thrust);
        let excess = joint.rad / joint.sin - joint.rad.int(1);
        let thickness = thrust::touched(&joint.versine(), &excess, &h).value();
        let ring = Ring::new(self.weight, &thickness);
        (thrust::tangency(&joint.times_cotangent(), &ring).residual(&h), [thickness])
    }
}

/// Margins of its own, from the steepest joint and the friction that it asks for.
#[inline(always)]
fn margins<T: Field>(
    weight: SelfWeight,
    at: &Configuration<T>,
    rates: &Rates<T>,
    [steepest, inner]: [&T; 2],
) -> [T; 5] {
    [
        contact::extrados_margin_at_shoulder(weight, at, &contact::crown_moment(at)),
        at.half_opening.rad.clone() - steepest,
        at.friction.clone() - inner,
        rates.sliding.clone(),
        sliding::shoulder_thrust(&at.half_opening, &at.friction).denominator,
    ]
}

/// Values: thickness, thrust, intrinsic thrust and `beta_r`.
impl Proof<2, 3, 4> for Shoulder<'_> {
    #[inline(always)]
    fn candidates(&self, [alpha, mu]: [f64; 2]) -> [f64; 3] {
        let half_opening = Sine::<Dekker>::angle(alpha, &SinePoint::nearest(alpha));
        let h = sliding::shoulder_thrust(&half_opening, &mu).value();
        let [square] = self.table.at(h);
        [alpha, square.sqrt(), ((1.0 - h) * h).sqrt()]
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [alpha, friction]: [Long<P>; 2],
        [(_, at_alpha), (joint, at_joint), (_, at_steepest)]: [(f64, SinePoint); 3],
    ) -> [Long<P>; 4] {
        let Self { weight, .. } = *self;
        let half_opening = alpha.angle(&at_alpha);
        let thrust = sliding::shoulder_thrust(&half_opening, &friction).value();
        let found = root(&ShoulderEquation { weight, thrust }, (joint, &at_joint), 1);
        let [thickness] = found.values;
        let at = in_doubles(&half_opening, [&thickness, &thrust, &friction], found.domain);
        let rates = contact::rates_of_shoulder_sliding(&at);
        let (steepest, inner) = steepest::<P, _>(&at.thrust, &at_steepest);
        let is_proved = found.is_proved
            & are_positive(&of_state(&at))
            & are_positive(&of_haunch(&at))
            & are_positive(&margins(weight, &at, &rates, [&steepest.rad, &inner.value()]))
            & Thinnest::new(weight, &at, &rates).holds()
            & is_within(thrust.mid().hi(), THRUSTS);
        [thickness, thrust, thickness * thrust, found.angle].map(|x| known_if(is_proved, x))
    }
}

#[cfg(test)]
mod tests {
    use super::super::margins::tests::{assert_are_all, configuration};
    use super::*;
    use couplet_check::problem::{Mode, inner_friction};
    use rug::Rational;

    /// With the moment for which (5) holds at its thickness, (2) holds too.
    #[test]
    fn the_thickness_is_that_of_both_equations() {
        let joint = Angle {
            rad: Rational::from((2, 3)),
            sin: Rational::from((5, 13)),
            cos: Rational::from((12, 13)),
        };
        let excess = joint.rad.clone() / &joint.sin - Rational::from(1);
        for h in [(1, 3), (4, 5)].map(Rational::from) {
            let eta = thrust::touched(&joint.versine(), &excess, &h).value();
            let rise = Rational::from(1) + joint.times_cotangent() - &h;
            let moment = (Rational::from(2) - &eta) * rise / Rational::from(2);
            let ring =
                |eta: &Rational| Ring { thickness: eta.clone(), centroid_factor: moment.clone() };
            let holds = |ring: &Ring<Rational>| {
                let tangency = thrust::tangency(&joint.times_cotangent(), ring).residual(&h);
                (tangency == 0, thrust::lower(&joint, ring).residual(&h) == 0)
            };
            assert_eq!(holds(&ring(&eta)), (true, true));
            assert_eq!(holds(&ring(&(eta + Rational::from((1, 7))))), (false, false), "false twin");
        }
    }

    #[test]
    fn the_margins_are_those_of_all_conditions() {
        for at in [[171, 83, 0, 147, 39, 391], [140, 87, 0, 7, 70, 30]].map(configuration) {
            let weight = SelfWeight::Milankovitch;
            let rates = contact::rates_of_shoulder_sliding(&at);
            let (joint, inner) = (sliding::steepest_joint(&at.thrust), inner_friction(&at));
            let own = margins(weight, &at, &rates, [&joint, &inner]).to_vec();
            let found = [of_state(&at).to_vec(), of_haunch(&at).to_vec(), own].concat();
            let thinnest = Thinnest::new(weight, &at, &rates);
            assert_are_all((weight, Mode::SlidingRotational, true), &at, &found, &thinnest);
        }
    }
}
