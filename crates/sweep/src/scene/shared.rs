//! Proofs that pieces of work share.

use crate::arch::SelfWeight;
use crate::atlas::{Level, Trace};
use crate::certify::Undecided;
use crate::certify::batch::SharedOpenings;
use crate::certify::state::Balls;
use std::collections::HashMap;
use std::sync::OnceLock;

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
