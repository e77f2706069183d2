//! Does what a plan says: one item after the other, the pieces of an item on all cores.

use super::cost::{Cost, measured};
use super::item_report::ItemReport;
use super::pieces::{ArchPiece, CurvePiece, LandmarkPiece, Lines, Pieces, Shared, none, sketch};
use super::plan::Plan;

/// A plan that is being carried out.
pub struct Run<'p> {
    plan: &'p Plan<'p>,
    pieces: Pieces,
    costs: Costs,
    lines: Lines,
    shared: Shared,
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
    /// Curves of the map.
    pub curves: Vec<Option<Cost>>,
    /// Arches that are drawn.
    pub drawings: Vec<Option<Cost>>,
}

impl Costs {
    /// All of it.
    pub fn total(&self) -> Cost {
        let all = self.landmarks.iter().chain(&self.arches).chain(&self.claims);
        all.chain(&self.curves).chain(&self.drawings).flatten().sum()
    }
}

impl<'p> Run<'p> {
    /// Nothing is computed yet.
    pub fn new(plan: &'p Plan<'p>) -> Self {
        let costs = Costs {
            landmarks: none(&plan.landmarks),
            arches: none(&plan.arches),
            claims: none(&plan.claims),
            curves: none(&plan.curves),
            drawings: none(&plan.drawings),
        };
        let (pieces, shared) = (Pieces::new(plan), Shared::new(plan));
        Self { plan, pieces, costs, lines: Lines::default(), shared }
    }

    /// What the pieces cost so far.
    pub fn costs(&self) -> &Costs {
        &self.costs
    }

    /// Computes what earlier items have not. Call in order: an arch is dropped after its last use. `tick` is
    /// called [`Plan::ticks`] times in all.
    pub fn item(&mut self, index: usize, tick: &(dyn Fn() + Sync)) -> ItemReport {
        let (plan, needs) = (self.plan, &self.plan.needs[index]);
        let Self { pieces, costs, lines, shared, .. } = self;
        for (node, piece) in plan.arches.iter().zip(&mut pieces.arches) {
            if node.items.last().is_some_and(|last| *last < index) {
                *piece = None;
            }
        }
        fill(&needs.landmarks, &mut pieces.landmarks, &mut costs.landmarks, |place| {
            LandmarkPiece::new(&plan.landmarks[place], tick)
        });
        let arches: Vec<usize> = needs.arches.iter().map(|(place, _)| *place).collect();
        fill(&arches, &mut pieces.arches, &mut costs.arches, |place| {
            let piece = ArchPiece::new(&plan.arches[place], shared);
            tick();
            piece
        });
        fill(&needs.claims, &mut pieces.claims, &mut costs.claims, |place| {
            let decision = plan.claims[place].claim.decide();
            tick();
            decision
        });
        fill(&needs.curves, &mut pieces.curves, &mut costs.curves, |place| {
            let piece = CurvePiece::new(&plan.curves[place], lines);
            tick();
            piece
        });
        fill(&needs.drawings, &mut pieces.drawings, &mut costs.drawings, |place| {
            let piece = sketch(&plan.drawings[place].drawn);
            tick();
            piece
        });
        ItemReport::new(plan, pieces, index)
    }
}

/// Computes the places that are still empty.
fn fill<T: Send>(
    places: &[usize],
    pieces: &mut [Option<T>],
    costs: &mut [Option<Cost>],
    compute: impl Fn(usize) -> T + Sync,
) {
    let mut missing: Vec<usize> =
        places.iter().copied().filter(|place| pieces[*place].is_none()).collect();
    missing.sort_unstable();
    missing.dedup();
    let results = measured(&missing, |place| compute(*place));
    for (place, (result, cost)) in missing.into_iter().zip(results) {
        pieces[place] = Some(result);
        costs[place] = Some(cost);
    }
}
