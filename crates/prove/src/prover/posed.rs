//! The printed equations of a system, with what is given.

use super::root::Form;
use crate::arch::Configuration;
use crate::number::{Enclosure, Real, Stumpff};
use crate::problem::System;

/// A system with what is given.
pub(crate) struct Posed<'a, E> {
    pub system: &'a System,
    pub given: &'a Configuration<E>,
}

impl<E> Form<E> for Posed<'_, E> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> Vec<T> {
        self.system.residuals(&self.system.place(self.given.map_ref(number), x))
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> bool {
        let at = self.system.place(self.given.map_ref(number), x);
        self.system.denominators(&at).iter().all(Enclosure::excludes_zero)
    }
}
