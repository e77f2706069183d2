//! The printed equations of a system, with what is given.

use super::Undecided;
use super::arithmetic::Arithmetic;
use super::operator::Form;
use crate::arch::Configuration;
use crate::number::{Enclosure, Real, Stumpff};
use crate::problem::System;

/// A system with what is given.
pub(crate) struct Posed<'a, E> {
    pub system: &'a System,
    pub given: &'a Configuration<E>,
}

impl<E: Arithmetic> Posed<'_, E> {
    /// All variables at the root next to start values, proved to exist and to be unique in a box.
    pub(crate) fn root(
        &self,
        bits: u32,
        start: &[E::Candidate],
    ) -> Result<Configuration<E>, Undecided> {
        let (root, sines) = E::rooted_of_few(self, bits, start)?;
        Ok(self.system.place_with(self.given.clone(), &root, |_, rad| E::angle(&sines, rad)))
    }
}

impl<E> Form<E> for Posed<'_, E> {
    fn at<T: Real + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> Vec<T> {
        self.system.residuals(&self.system.place(self.given.map_ref(number), x))
    }

    fn is_regular<T: Enclosure + Stumpff>(&self, number: impl Fn(&E) -> T, x: &[T]) -> bool {
        let at = self.system.place(self.given.map_ref(number), x);
        self.system.denominators(&at).iter().all(Enclosure::excludes_zero)
    }

    fn angles(&self) -> Vec<usize> {
        let unknowns = self.system.unknowns.iter().enumerate();
        unknowns.filter(|(_, unknown)| unknown.is_angle()).map(|(index, _)| index).collect()
    }
}
