//! Meetings of two kinds, or of a kind and the symmetric states.

use super::super::crossing::Crossing;
use super::super::law::Law;
use super::super::place::Place;
use super::kind::closing;
use crate::arch::asymmetric::AsymmetricMode;

/// Meeting of two kinds, or of a kind and the symmetric states.
#[derive(Clone, Debug)]
pub struct Meeting {
    pub(super) crossing: Crossing,
    /// The kind whose equation holds there besides; `None` in a symmetric state.
    pub(super) other: Option<AsymmetricMode>,
}

impl Meeting {
    /// The quantities.
    pub fn place(&self) -> Place {
        self.crossing.place()
    }

    /// Tells whether the meeting is a symmetric state.
    pub fn is_symmetric(&self) -> bool {
        self.other.is_none()
    }

    /// Tells whether an equation holds there.
    pub(super) fn has(&self, law: Law) -> bool {
        self.other.is_some_and(|other| closing(other) == law)
            || self.crossing.form.laws.contains(&law)
    }
}
