//! The root that is a landmark, to be proved in Coq.

use super::names::BITS;
use crate::arch::Configuration;
use crate::certify::{CertifiedLandmark, Undecided};
use crate::number::Ball;
use crate::problem::System;

/// A root of a system: where it is, and where there is no other.
pub(super) struct CoqRoot {
    /// The equations.
    pub system: System,
    /// Given values.
    pub given: Configuration<Ball>,
    /// The root, in the order of the unknowns.
    pub values: Vec<Ball>,
    /// A box about it of the shape in which Newton's method contracts.
    pub domain: Vec<Ball>,
}

impl CoqRoot {
    /// The root that is a landmark.
    pub(super) fn of_landmark(point: &CertifiedLandmark) -> Result<Self, Undecided> {
        let isolated = point.isolated();
        let system = *isolated.system();
        let refined = point.enclosure(BITS)?;
        let values = system.unknowns.iter().map(|&unknown| refined.value(unknown)).collect();
        let missing = || Undecided::new(format!("{} lacks a value", point.landmark().symbol()));
        let values: Vec<Ball> = Option::ok_or_else(values, missing)?;
        let given = Configuration::zero(&Ball::integer(0, BITS));
        Ok(Self { system, given, values, domain: isolated.domain().to_vec() })
    }
}
