//! Does what a plan says: one item after the other, the pieces of an item on all cores.

use super::cost::{Cost, measured};
use super::found::Found;
use super::pieces::{ArchFound, LandmarkFound};
use super::plan::Plan;
use crate::certify::Undecided;
use crate::claims::Decision;

/// A plan that is being carried out.
pub struct Run<'p> {
    pub(super) plan: &'p Plan<'p>,
    pub(super) landmarks: Vec<Option<Result<LandmarkFound, Undecided>>>,
    pub(super) arches: Vec<Option<ArchFound>>,
    pub(super) claims: Vec<Option<Decision>>,
    costs: Costs,
}

/// What each piece of a plan cost, in the order of the plan; nothing for what was not needed yet.
#[derive(Clone, Debug, Default)]
pub struct Costs {
    /// Landmarks.
    pub landmarks: Vec<Option<Cost>>,
    /// Arches.
    pub arches: Vec<Option<Cost>>,
    /// Claims.
    pub claims: Vec<Option<Cost>>,
}

impl Costs {
    /// All of it.
    pub fn total(&self) -> Cost {
        self.landmarks.iter().chain(&self.arches).chain(&self.claims).flatten().sum()
    }
}

/// A result for each piece, none of them there yet.
fn none<T, U>(pieces: &[T]) -> Vec<Option<U>> {
    pieces.iter().map(|_| None).collect()
}

impl<'p> Run<'p> {
    /// Nothing is computed yet.
    pub fn new(plan: &'p Plan<'p>) -> Self {
        let costs = Costs {
            landmarks: none(&plan.landmarks),
            arches: none(&plan.arches),
            claims: none(&plan.claims),
        };
        Self {
            plan,
            landmarks: none(&plan.landmarks),
            arches: none(&plan.arches),
            claims: none(&plan.claims),
            costs,
        }
    }

    /// What the pieces cost so far.
    pub fn costs(&self) -> &Costs {
        &self.costs
    }

    /// Computes what an item needs and no item before it has needed. The items are asked for in their
    /// order; an arch that none of those to come needs is forgotten. `tick` is called [`Plan::ticks`]
    /// times in all.
    pub fn item(&mut self, index: usize, tick: &(dyn Fn() + Sync)) -> Found<'_> {
        for (node, found) in self.plan.arches.iter().zip(&mut self.arches) {
            if node.items.last().is_some_and(|last| *last < index) {
                *found = None;
            }
        }
        let (plan, needs) = (self.plan, &self.plan.needs[index]);
        fill(&needs.landmarks, &mut self.landmarks, &mut self.costs.landmarks, |place| {
            LandmarkFound::new(&plan.landmarks[place], tick)
        });
        let arches: Vec<usize> = needs.arches.iter().map(|(place, _)| *place).collect();
        fill(&arches, &mut self.arches, &mut self.costs.arches, |place| {
            let found = ArchFound::new(&plan.arches[place]);
            tick();
            found
        });
        fill(&needs.claims, &mut self.claims, &mut self.costs.claims, |place| {
            let decision = plan.claims[place].claim.decide();
            tick();
            decision
        });
        self.found(index)
    }
}

/// Computes what is not there yet of some places.
fn fill<T: Send>(
    places: &[usize],
    found: &mut [Option<T>],
    costs: &mut [Option<Cost>],
    compute: impl Fn(usize) -> T + Sync,
) {
    let mut missing: Vec<usize> =
        places.iter().copied().filter(|place| found[*place].is_none()).collect();
    missing.sort_unstable();
    missing.dedup();
    let results = measured(&missing, |place| compute(*place));
    for (place, (result, cost)) in missing.into_iter().zip(results) {
        found[place] = Some(result);
        costs[place] = Some(cost);
    }
}
