//! A value for each variable, and what follows from them.

use super::variable::Variable;
use crate::arch::asymmetric::{Asymmetric, AsymmetricMode};
use crate::arch::flat::Flat;
use crate::arch::haunch::Haunch;
use crate::arch::joint::Grip;
use crate::arch::whole::Forces;
use crate::arch::{Ring, SelfWeight, cycloid, thrust};
use crate::number::{Angle, Real, Stumpff};
use std::cell::OnceCell;

/// A value for each variable; one that a form does not know is zero and is read by none of its laws.
#[derive(Clone, Debug)]
pub(super) struct VariableValues<T> {
    pub half_opening: T,
    pub friction_angle: T,
    pub inclination: Angle<T>,
    pub joint_square: T,
    pub haunch: Haunch<T>,
    pub thickness: T,
    pub ratio: T,
    pub opening_ratio: T,
    pub joint_ratio: T,
    pub thrust: T,
    pub vertical_force: T,
    pub crown_moment: T,
    pub crown_hinge: T,
    pub whole: WholeState<T>,
}

/// Spot as an asymmetric state of the whole arch, worked out when one of its laws asks.
#[derive(Clone, Debug)]
pub(super) struct WholeState<T> {
    state: OnceCell<Asymmetric<T>>,
    crown: OnceCell<[T; 2]>,
    haunch: OnceCell<[T; 2]>,
}

impl<T> Default for WholeState<T> {
    fn default() -> Self {
        Self { state: OnceCell::new(), crown: OnceCell::new(), haunch: OnceCell::new() }
    }
}

impl<T: Real + Stumpff> VariableValues<T> {
    /// Spot as a flat arch that turns at the haunch.
    pub(super) fn flat(&self) -> Flat<T> {
        Flat {
            opening: self.opening_ratio.clone(),
            joint: self.joint_ratio.clone(),
            square: self.joint_square.clone(),
            functions: self.joint_square.stumpff(4),
            thickness: self.thickness.clone(),
        }
    }
}

impl<T: Real> VariableValues<T> {
    /// The value of a variable.
    pub(super) fn get(&self, variable: Variable) -> &T {
        match variable {
            Variable::HalfOpening => &self.half_opening,
            Variable::FrictionAngle => &self.friction_angle,
            Variable::Inclination => &self.inclination.rad,
            Variable::JointSquare => &self.joint_square,
            Variable::Thickness => &self.thickness,
            Variable::Ratio => &self.ratio,
            Variable::OpeningRatio => &self.opening_ratio,
            Variable::JointRatio => &self.joint_ratio,
            Variable::VerticalForce => &self.vertical_force,
            Variable::CrownMoment => &self.crown_moment,
            Variable::CrownHinge => &self.crown_hinge,
        }
    }

    /// Spot as an asymmetric state of the whole arch: the haunch is the rotational joint.
    pub(super) fn asymmetric(&self) -> &Asymmetric<T> {
        self.whole.state.get_or_init(|| self.new_asymmetric())
    }

    /// Distance of the line of thrust from the extrados next to the crown, and the slope of that.
    pub(super) fn at_crown(&self, weight: SelfWeight) -> &[T; 2] {
        self.whole
            .crown
            .get_or_init(|| self.asymmetric().crown(&Ring::new(weight, &self.thickness)))
    }

    /// Distance of the line of thrust from the intrados at the left haunch, and the slope of that.
    pub(super) fn at_haunch(&self, weight: SelfWeight) -> &[T; 2] {
        self.whole
            .haunch
            .get_or_init(|| self.asymmetric().haunch(&Ring::new(weight, &self.thickness)))
    }

    /// Quantity that is zero where a kind of mechanism closes, of those that have one equation for it.
    pub(super) fn closing(&self, kind: AsymmetricMode, weight: SelfWeight) -> T {
        self.asymmetric().closing(kind, weight).swap_remove(0)
    }

    fn new_asymmetric(&self) -> Asymmetric<T> {
        let (sin, cos) = self.friction_angle.sin_cos();
        let sliding = cycloid::joint(&self.inclination) - &self.vertical_force;
        Asymmetric {
            half_opening: Angle::new(self.half_opening.clone()),
            grip: Grip { shear: cos, normal: sin },
            thickness: self.thickness.clone(),
            forces: Forces {
                thrust: self.thrust.clone(),
                moment: self.crown_moment.clone(),
                vertical: self.vertical_force.clone(),
            },
            crown_hinge: Angle::new(self.crown_hinge.clone()),
            haunch: Angle::new(self.joint_square.sqrt()),
            sliding_joint: Angle::new(sliding),
        }
    }

    /// The inclination of the force on a shoulder that slides.
    pub(super) fn shoulder_inclination(&self) -> Angle<T> {
        Angle::new(self.half_opening.clone() - &self.friction_angle)
    }

    pub(super) fn upper(&self, weight: SelfWeight) -> crate::arch::Quotient<T> {
        let ring = Ring::new(weight, &self.thickness);
        let moment = ring.intrados() * &self.haunch.times_sine;
        let half_opening = Angle::new(self.half_opening.clone());
        thrust::upper_about(&half_opening, moment, &self.haunch.cosine, &ring)
    }
}
