//! Proofs of the lines of thrust that touch the intrados at a thickness: of the least thrust, (2) and (5), and of the
//! largest, (3) and (5).
//!
//! One equation each. (2) and (5) have one thrust at each joint, whatever the weight, [`thrust::touching`], and what
//! (5) leaves with the weight is the equation. Below the joint it is what (3) leaves with the thrust of (5). Which
//! signs make the thrusts bounds is not looked at here.

use super::piece::Proof;
use super::root::{Equation, is_within, known_if, newton, root};
use super::sine::{Long, Sine};
use super::start::{self, Table};
use crate::arch::{Ring, SelfWeight, thrust};
use crate::number::{Angle, Dekker, Product, SinePoint};

/// Proof of the touching joint and the least thrust.
pub(super) struct Above<'a> {
    pub(super) weight: SelfWeight,
    pub(super) table: &'a Table<1>,
}

/// (5) at the thrust of (2) and (5), at a thickness.
struct AboveJoint<P> {
    weight: SelfWeight,
    thickness: Long<P>,
}

impl<P: Product> Equation<P, 1> for AboveJoint<P> {
    #[inline(always)]
    fn at<T: Sine<P>>(
        &self,
        number: impl Fn(&Long<P>) -> T + Copy,
        joint: &Angle<T>,
    ) -> (T, [T; 1]) {
        let ring = Ring::new(self.weight, &number(&self.thickness));
        let excess = joint.rad / joint.sin - joint.rad.int(1);
        let h = thrust::touching(&joint.versine(), &excess, &ring).value();
        (thrust::tangency(&joint.times_cotangent(), &ring).residual(&h), [h])
    }
}

/// Values: `beta_r` and the thrust.
impl Proof<1, 1, 2> for Above<'_> {
    #[inline(always)]
    fn candidates(&self, [eta]: [f64; 1]) -> [f64; 1] {
        self.table.at(start::place_of_thickness(eta)).map(f64::sqrt)
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [thickness]: [Long<P>; 1],
        [(joint, at_joint)]: [(f64, SinePoint); 1],
    ) -> [Long<P>; 2] {
        let equation = AboveJoint { weight: self.weight, thickness };
        let found = root(&equation, (joint, &at_joint), 1);
        let [h] = found.values;
        let place = start::place_of_thickness(thickness.mid().hi());
        let is_proved = found.is_proved & is_within(place, start::touches_above(self.weight));
        [found.angle, h].map(|x| known_if(is_proved, x))
    }
}

/// Proof of the touching joint and the largest thrust.
pub(super) struct Below<'a> {
    pub(super) weight: SelfWeight,
    pub(super) table: &'a Table<3>,
}

/// (3) at the thrust of (5), at a thickness.
struct BelowJoint<P> {
    weight: SelfWeight,
    half_opening: Angle<Long<P>>,
    thickness: Long<P>,
}

impl<P: Product> Equation<P, 1> for BelowJoint<P> {
    #[inline(always)]
    fn at<T: Sine<P>>(
        &self,
        number: impl Fn(&Long<P>) -> T + Copy,
        joint: &Angle<T>,
    ) -> (T, [T; 1]) {
        let Angle { rad, sin, cos } = &self.half_opening;
        let half_opening = Angle { rad: number(rad), sin: number(sin), cos: number(cos) };
        let ring = Ring::new(self.weight, &number(&self.thickness));
        let h = thrust::tangency(&joint.times_cotangent(), &ring).value();
        (thrust::upper(&half_opening, joint, &ring).residual(&h), [h])
    }
}

impl Below<'_> {
    /// The square of the joint next to that of a half opening and a thickness: it falls from that of rotation to the
    /// crown. Not positive where the crown is touched.
    pub(super) fn square(&self, [alpha, eta]: [f64; 2]) -> f64 {
        let [square, rotates, at_crown] = self.table.at(alpha);
        square * (at_crown - eta) / (at_crown - rotates)
    }
}

/// Values: `beta_r` and the thrust.
impl Proof<2, 2, 2> for Below<'_> {
    #[inline(always)]
    fn candidates(&self, [alpha, eta]: [f64; 2]) -> [f64; 2] {
        let exact = |x: f64| Long::<Dekker>::exact(x.into());
        let at_alpha: Angle<f64> = Sine::<Dekker>::angle(alpha, &SinePoint::nearest(alpha));
        let (half_opening, thickness) = (at_alpha.map(exact), exact(eta));
        let equation = BelowJoint { weight: self.weight, half_opening, thickness };
        let mut joint = self.square([alpha, eta]).sqrt();
        for _ in 0..4 {
            (joint, _) = newton(&equation, joint, &SinePoint::nearest(joint));
        }
        [alpha, joint]
    }

    #[inline(always)]
    fn prove<P: Product>(
        &self,
        [alpha, thickness]: [Long<P>; 2],
        [(_, at_alpha), (joint, at_joint)]: [(f64, SinePoint); 2],
    ) -> [Long<P>; 2] {
        let half_opening = alpha.angle(&at_alpha);
        let equation = BelowJoint { weight: self.weight, half_opening, thickness };
        let found = root(&equation, (joint, &at_joint), 1);
        let [h] = found.values;
        let is_proved = found.is_proved & is_within(alpha.mid().hi(), start::rotates(self.weight));
        [found.angle, h].map(|x| known_if(is_proved, x))
    }
}
