//! Does what a plan says: one item after the other, the parts of an item on all cores.

use super::computable::{Done, Shared};
use super::cost::{Cost, measured};
use super::item_report::ItemReport;
use super::landmark_node::LandmarkPiece;
use super::plan::{Plan, Work};
use super::schema::{ItemKind, Request, Scene};
use crate::picture::Print;
use crate::report::Format;

/// A plan that is being carried out.
pub struct SceneRun<'p> {
    plan: &'p Plan<'p>,
    /// Results of the parts that are there, in the order of the plan.
    done: Vec<Option<Done>>,
    costs: Costs,
    shared: Shared,
}

/// Costs of the parts of a plan, in the order of the plan; nothing for a part that was not needed yet.
#[derive(Clone, Debug, Default)]
pub struct Costs(pub Vec<Option<Cost>>);

impl Costs {
    /// Sum of all costs.
    pub fn total(&self) -> Cost {
        self.0.iter().flatten().sum()
    }
}

impl<'p> SceneRun<'p> {
    /// Run of which nothing is computed yet.
    pub fn new(plan: &'p Plan<'p>) -> Self {
        let done = plan.parts.iter().map(|_| None).collect();
        let states = plan.parts.iter().filter_map(|part| match &part.work {
            Work::Arch(node) => node.shared(),
            _ => None,
        });
        let (costs, shared) = (Costs(vec![None; plan.parts.len()]), Shared::new(states));
        Self { plan, done, costs, shared }
    }

    /// Costs of the parts so far.
    pub fn costs(&self) -> &Costs {
        &self.costs
    }

    /// Computes what earlier items have not. Call in order: a part is dropped after its last use. `tick` is
    /// called [`Plan::ticks`] times in all.
    pub fn item(&mut self, index: usize, tick: &(dyn Fn() + Sync)) -> ItemReport {
        let parts = &self.plan.parts;
        for (part, done) in parts.iter().zip(&mut self.done) {
            if part.last < index {
                *done = None;
            }
        }
        let mut missing = self.plan.needs[index].clone();
        missing.retain(|place| self.done[*place].is_none());
        missing.sort_unstable();
        missing.dedup();
        let work = |place: &usize| computed(&parts[*place].work, &self.shared, tick);
        let results = measured(&missing, work);
        for (place, (result, cost)) in missing.into_iter().zip(results) {
            (self.done[place], self.costs.0[place]) = (Some(result), Some(cost));
        }
        ItemReport::new(self.plan, &self.done, index)
    }
}

/// Result of a part, of the type that its kind has.
fn computed(work: &Work, shared: &Shared, tick: &(dyn Fn() + Sync)) -> Done {
    let done: Done = match work {
        // It reports its progress itself.
        Work::Landmark(node) => return Box::new(LandmarkPiece::new(node, tick)),
        Work::Arch(node) => Box::new(node.piece(shared)),
        Work::Claim(claim) => Box::new(claim.decide()),
        Work::Curve(node) => Box::new(node.piece(shared)),
        Work::Drawing(drawn) => Box::new(drawn.sketch()),
        Work::Survey(node) => node.done(),
    };
    tick();
    done
}

/// The answer to one request, as that of a scene that asks for nothing else.
pub fn answered(kind: ItemKind, what: Request, how: (&'static Format, &Print)) -> ItemReport {
    let scene = Scene::one(kind, what, how);
    SceneRun::new(&Plan::new(&scene, vec![false])).item(0, &|| ())
}
