//! The printed equations of a system, with what is given.

use super::root::Form;
use crate::arch::Configuration;
use crate::number::{Ball, Enclosure, Real, Stumpff};
use crate::problem::System;

/// A system with what is given.
pub(super) struct Posed<'a> {
    pub system: &'a System,
    pub given: &'a Configuration<Ball>,
}

impl Form for Posed<'_> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&Ball) -> T, x: &[T]) -> Vec<T> {
        self.system.residuals(&self.system.place(self.given.map_ref(number), x))
    }

    fn is_regular(&self, x: &[Ball]) -> bool {
        let at = self.system.place(self.given.clone(), x);
        self.system.denominators(&at).iter().all(Enclosure::excludes_zero)
    }
}
