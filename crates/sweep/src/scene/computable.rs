//! Nodes of a plan: what each kind of work says of itself.

use super::shared::Shared;
use crate::claims::Claim;
use std::any::Any;

/// Result of a piece of work, of a type that its kind has.
pub(super) type Done = Box<dyn Any + Send + Sync>;

/// An arch takes about as long as a landmark of this many digits.
pub(super) const ARCH: usize = 200;
/// A claim, or a curve of the map, as long as one of this many.
pub(super) const LONG: usize = 10_000;

/// Node of a plan, which is computed once.
pub(super) trait Computable {
    /// Key of equal work of its kind, however its numbers are written.
    fn key(&self) -> String;

    /// The work, in digits of landmarks that take as long.
    fn size(&self) -> usize {
        ARCH
    }

    /// Number of times that it reports progress itself; without one the run reports it when it is done.
    fn ticks(&self) -> Option<u64> {
        None
    }

    /// Lines of a plan: the name, and what is computed.
    fn lines(&self) -> Vec<String>;

    /// Computes it.
    fn compute(&self, shared: &Shared, tick: &(dyn Fn() + Sync)) -> Done;
}

impl Computable for Claim {
    fn key(&self) -> String {
        self.id.to_owned()
    }

    fn size(&self) -> usize {
        LONG
    }

    fn lines(&self) -> Vec<String> {
        vec![format!("{}, {}", self.id, self.place)]
    }

    fn compute(&self, _: &Shared, _: &(dyn Fn() + Sync)) -> Done {
        Box::new(self.decide())
    }
}
