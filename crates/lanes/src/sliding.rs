//! Proofs of (18): the thrust at which an inner joint slides, and with (17) the purely sliding friction.
//!
//! Both have the inclination `chi` of the force on the inner joint as the unknown, and the equations of
//! [`cycloid`]. By (18) the friction angle grows with `chi`, and the thrust falls.
//!
//! **Too little friction.** Where the half opening is above the friction angle `phi`, `h - alpha cot(alpha - phi)`
//! falls as `chi` grows: the thrust falls, and the cotangent grows with `phi`. So it is positive exactly below the
//! purely sliding friction: there the least thrust that inner joints bear exceeds the largest that the shoulder bears.

use super::margins::are_positive;
use super::piece::Proof;
use super::root::{Equation, is_within, known_if, root};
use super::sine::{Long, Short, Sine, around};
use super::start::{FRICTIONS, SLIDES, Table, place_of_friction};
use crate::arch::{cycloid, sliding};
use crate::number::{Angle, Product, SinePoint};

/// Proof of the thrust at which an inner joint slides, and of the joint.
pub(super) struct Steepest<'a>(pub(super) &'a Table<2>);

/// `sin phi - mu cos phi`, with a point next to `phi`.
struct SteepestEquation<'a, P> {
    friction: Long<P>,
    at_friction: &'a SinePoint,
}

impl<P: Product> Equation<P, 2> for SteepestEquation<'_, P> {
    #[inline(always)]
    fn at<T: Sine<P>>(&self, number: impl Fn(&Long<P>) -> T + Copy, chi: &Angle<T>) -> (T, [T; 2]) {
        let phi = cycloid::friction_angle(chi).angle(self.at_friction);
        let residual = phi.sin - number(&self.friction) * phi.cos;
        (residual, [cycloid::thrust(chi), cycloid::joint(chi)])
    }
}

impl Proof<1, 2, 2> for Steepest<'_> {
    #[inline(always)]
    fn candidates(&self, [mu]: [f64; 1]) -> [f64; 2] {
        self.0.at(place_of_friction(mu))
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [friction]: [Long<P>; 1],
        [(chi, at_chi), (_, at_friction)]: [(f64, SinePoint); 2],
    ) -> [Long<P>; 2] {
        let equation = SteepestEquation { friction, at_friction: &at_friction };
        let found = root(&equation, (chi, &at_chi), 1);
        let is_proved = found.is_proved & is_within(friction.mid().hi(), FRICTIONS);
        found.values.map(|x| known_if(is_proved, x))
    }
}

/// The friction of a friction angle.
pub(super) struct Tangent;

impl Proof<1, 1, 1> for Tangent {
    #[inline(always)]
    fn candidates(&self, angle: [f64; 1]) -> [f64; 1] {
        angle
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [phi]: [Long<P>; 1],
        [(_, at_phi)]: [(f64, SinePoint); 1],
    ) -> [Long<P>; 1] {
        let Angle { sin, cos, .. } = phi.angle(&at_phi);
        let is_acute = are_positive(&[phi.in_doubles(), cos.in_doubles()])
            & is_within(phi.mid().hi(), [0.0, 2.0]);
        [known_if(is_acute, sin / cos)]
    }
}

/// Proof of the purely sliding friction.
pub(super) struct Sliding<'a>(pub(super) &'a Table<2>);

/// (17) at the inclination of the force on the shoulder, `psi = alpha - phi`, with a point next to it.
struct AtShoulder<'a, P> {
    half_opening: Angle<Long<P>>,
    at_inclination: &'a SinePoint,
}

impl<P: Product> Equation<P, 2> for AtShoulder<'_, P> {
    #[inline(always)]
    fn at<T: Sine<P>>(&self, number: impl Fn(&Long<P>) -> T + Copy, chi: &Angle<T>) -> (T, [T; 2]) {
        let Angle { rad, sin, cos } = &self.half_opening;
        let [rad, sin, cos] = [number(rad), number(sin), number(cos)];
        let psi = (rad - cycloid::friction_angle(chi)).angle(self.at_inclination);
        let thrust = cycloid::thrust(chi);
        let residual = cycloid::shoulder(&rad, &psi, &thrust);
        // The tangent of `alpha - psi`.
        let friction = (sin * psi.cos - cos * psi.sin) / (cos * psi.cos + sin * psi.sin);
        (residual, [friction, thrust])
    }
}

/// Values: the friction and the thrust.
impl Proof<1, 3, 2> for Sliding<'_> {
    #[inline(always)]
    fn candidates(&self, [alpha]: [f64; 1]) -> [f64; 3] {
        let [inside, at_shoulder] = self.0.at(alpha);
        [alpha, inside, at_shoulder]
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [alpha]: [Long<P>; 1],
        [(_, at_alpha), (chi, at_chi), (_, at_inclination)]: [(f64, SinePoint); 3],
    ) -> [Long<P>; 2] {
        let half_opening = alpha.angle(&at_alpha);
        let equation = AtShoulder { half_opening, at_inclination: &at_inclination };
        let found = root(&equation, (chi, &at_chi), 1);
        let [friction, _] = found.values;
        // The angles are those of a state where `phi` and `psi` are between zero and what they may be.
        let room = alpha - cycloid::joint(&found.domain).in_double_doubles();
        let is_proved = found.is_proved
            & are_positive(&[friction.in_doubles(), room.in_doubles()])
            & is_within(alpha.mid().hi(), SLIDES);
        found.values.map(|x| known_if(is_proved, x))
    }
}

/// Proof that an arch falls because its friction is too little, from the thrust at which an inner joint slides.
pub(super) struct Falling;

/// Values: the friction, where the arch falls.
impl Proof<3, 1, 1> for Falling {
    #[inline(always)]
    fn candidates(&self, [alpha, ..]: [f64; 3]) -> [f64; 1] {
        [alpha]
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [alpha, friction, thrust]: [Long<P>; 3],
        [(_, at_alpha)]: [(f64, SinePoint); 1],
    ) -> [Long<P>; 1] {
        let half_opening = around(&alpha.angle(&at_alpha), 0.0);
        let [mu, h]: [Short; 2] = [friction, thrust].map(|x| x.in_doubles());
        let largest = sliding::shoulder_thrust(&half_opening, &mu);
        let margins = [largest.denominator, largest.residual(&h)];
        [known_if(are_positive(&margins), friction)]
    }
}
