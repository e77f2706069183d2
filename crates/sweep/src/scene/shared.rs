//! Proofs that pieces of work share.

use super::plan::Plan;
use super::work::Work;
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
    /// Proofs of which nothing is proved yet.
    pub(super) fn new(plan: &Plan) -> Self {
        let openings = plan.parts.iter().filter_map(|part| {
            let Work::Arch(node) = &part.work else { return None };
            let asked @ (digits, frictions) = node.shared()?;
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
