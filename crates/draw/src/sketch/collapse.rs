//! A mode of collapse: joints, rates, twists, the balance of power.

use crate::arch::mechanism::{Contact, Mechanism, Twist};
use crate::arch::{Configuration, Ring, SelfWeight};
use crate::number::{Drawable, Ternary, says};
use crate::problem::Mode;

/// Motion in which an arch falls in a mode, with rates that are proved to be positive.
#[derive(Clone, Debug)]
pub struct Collapse<T> {
    /// The mode.
    pub mode: Mode,
    /// Joints and rates of the mechanism; the first free rate is one.
    pub mechanism: Mechanism<T>,
    /// The twists of the blocks, from the shoulder.
    pub twists: Vec<Twist<T>>,
    /// Speed with which the crown goes down.
    pub crown_drop: T,
    /// The power of the weight of the half arch, in `w r`.
    pub power: T,
    /// Power that friction takes of it.
    pub friction_power: T,
    /// True if sliding joints open too.
    pub is_dilatant: bool,
}

/// Part of a mechanism that these enclosures do not tell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoCollapse {
    /// Not every rate is proved to be positive.
    Rates(Mode),
    /// The blocks do not fit together, or the weight works by another amount than friction takes.
    Balance(Mode),
    /// The weight is not proved to work by more than friction takes.
    Drive(Mode),
}

says!(NoCollapse {
    Self::Rates(mode) => "the rates of {mode}";
    Self::Balance(mode) => "the balance of {mode}";
    Self::Drive(mode) => "whether the weight drives {mode}";
});

impl<T: Drawable> Collapse<T> {
    /// Contact and place (rad) of each joint that gives way; a crown that opens along its whole joint is none.
    pub fn joints_at_limit(&self) -> Vec<(Contact, f64)> {
        let joints = self.mechanism.joints.iter().chain(self.mechanism.crown_hinge());
        joints.map(|joint| (joint.contact, joint.at.rad.double())).collect()
    }

    /// The mechanism of a mode in its state, with certain signs and a balance that is not refuted.
    pub fn new(
        weight: SelfWeight,
        mode: Mode,
        at: &Configuration<T>,
        is_dilatant: bool,
    ) -> Result<Self, NoCollapse> {
        let found = Self::moving(weight, mode, at, is_dilatant)?;
        match found.excess().overlaps(&at.thrust.int(0)) {
            true => Ok(found),
            false => Err(NoCollapse::Balance(mode)),
        }
    }

    /// The mechanism of a mode in an arch that falls, with certain signs: the rates are positive, and the weight
    /// works by more than friction takes at the thrust at which a joint slides. With dilatancy the rates are the
    /// multipliers of the conditions at the joints, in which thrust and crown moment drop out, and are positive too:
    /// so these conditions contradict each other, whatever the thrust and the crown moment are.
    pub fn driven(
        weight: SelfWeight,
        mode: Mode,
        at: &Configuration<T>,
        is_dilatant: bool,
    ) -> Result<Self, NoCollapse> {
        let found = Self::moving(weight, mode, at, is_dilatant)?;
        let multipliers = Self::moving(weight, mode, at, true)?;
        let drives = |of: &Self| of.excess().is_positive() == Ternary::True;
        match drives(&found) && drives(&multipliers) {
            true => Ok(found),
            false => Err(NoCollapse::Drive(mode)),
        }
    }

    /// Power of the weight that friction does not take.
    pub fn excess(&self) -> T {
        self.power.clone() - &self.friction_power
    }

    /// Blocks that fit together, at positive rates.
    fn moving(
        weight: SelfWeight,
        mode: Mode,
        at: &Configuration<T>,
        is_dilatant: bool,
    ) -> Result<Self, NoCollapse> {
        let none = at.thrust.int(0);
        let dilatancy = if is_dilatant { at.friction.clone() } else { none.clone() };
        let mechanism = match at.crown_hinge.rad.is_positive() {
            Ternary::True => mode.mechanism(at, &dilatancy).below_keystone(),
            _ => mode.mechanism(at, &dilatancy),
        };
        let joints = || mechanism.joints.iter().chain(&mechanism.crown);
        if joints().any(|joint| joint.rate.is_positive() != Ternary::True) {
            return Err(NoCollapse::Rates(mode));
        }
        let ring = Ring::new(weight, &at.thickness);
        let (power, twists) = (mechanism.power(&ring), mechanism.twists(&at.thickness));
        let friction_power = match is_dilatant {
            true => none.clone(),
            false => mechanism.friction_power(&at.thrust, &at.friction),
        };
        if !mechanism.gap(&at.thickness).iter().all(|x| x.overlaps(&none)) {
            return Err(NoCollapse::Balance(mode));
        }
        let top = [none.clone(), none];
        let crown_drop = twists.last().map_or(top[0].clone(), |twist| {
            let [_, up] = twist.at(&top);
            -up
        });
        Ok(Self { mode, mechanism, twists, crown_drop, power, friction_power, is_dilatant })
    }
}
