//! Nodes of a plan: what each kind of work says of itself, what it is computed to, and the proofs that they share.

use crate::arch::SelfWeight;
use crate::atlas::{Level, Trace};
use crate::certify::Undecided;
use crate::certify::batch::SharedOpenings;
use crate::certify::state::Balls;
use crate::claims::Claim;
use std::any::Any;
use std::collections::HashMap;
use std::sync::OnceLock;

/// Result of a piece of work, of a type that its kind has.
pub(super) type Done = Box<dyn Any + Send + Sync>;

/// Node of a plan, which is computed once.
pub(super) trait Computable {
    /// Key of equal work of its kind, however its numbers are written.
    fn key(&self) -> String;

    /// Lines of a plan: the name, and what is computed.
    fn lines(&self) -> Vec<String>;
}

impl Computable for Claim {
    fn key(&self) -> String {
        self.id.to_owned()
    }

    fn lines(&self) -> Vec<String> {
        vec![format!("{}, {}", self.id, self.place)]
    }
}

/// Proofs that pieces of work share.
pub(super) struct Shared {
    /// Of arches, by the digits of their state and whether the frictions at which the mode changes are asked for.
    pub openings: HashMap<(usize, bool), SharedOpenings>,
    /// The lines between modes, of each weight that has levels.
    lines: [OnceLock<Result<Vec<Trace>, Undecided>>; 2],
}

impl Shared {
    /// Proofs of which nothing is proved yet, for states that are asked so.
    pub(super) fn new(states: impl Iterator<Item = (usize, bool)>) -> Self {
        let openings = states.filter_map(|asked @ (digits, frictions)| {
            let all = SharedOpenings::new(Balls::DoubleDoubles, digits, frictions);
            Some((asked, all.ok()?))
        });
        Self { openings: openings.collect(), lines: Default::default() }
    }

    /// The lines between modes.
    pub(super) fn lines(&self, weight: SelfWeight) -> Result<&[Trace], Undecided> {
        let lines = &self.lines[usize::from(weight == SelfWeight::Heyman)];
        lines.get_or_init(|| Level::lines(weight)).as_deref().map_err(Clone::clone)
    }
}
