//! The plan of a scene: each part of the work once, to the most digits that any item asks of it. The first
//! item that needs a part waits for all of its digits.

use super::arch_node::ArchNode;
use super::computable::Computable;
use super::drawn::DrawnArch;
use super::landmark_node::LandmarkNode;
use super::scene_map::CurveNode;
use super::schema::{Request, Scene, SceneArch, SceneItem};
use super::survey_node::SurveyNode;
use crate::arch::SelfWeight;
use crate::claims::Claim;
use crate::problem::{Landmark, Quantity};
use std::collections::HashMap;

/// Pieces that are computed, and what each item takes from it.
#[derive(Debug)]
pub struct Plan<'s> {
    /// Scene that was asked for.
    pub scene: &'s Scene,
    /// Flags of the items whose output is complete, so that nothing is computed for it.
    pub complete: Vec<bool>,
    /// Parts that are computed, each once.
    pub(super) parts: Vec<PlannedPart<'s>>,
    /// For each item, the places of the parts that it takes.
    pub(super) needs: Vec<Vec<usize>>,
    /// The places of the parts, by kind and key.
    places: HashMap<(&'static str, String), usize>,
}

/// A part of the work, and who takes it.
#[derive(Debug)]
pub(super) struct PlannedPart<'s> {
    /// The work of this part.
    pub work: Work<'s>,
    /// The first item that takes it, for which it is computed.
    pub first: usize,
    /// The last item that takes it, after which its result is dropped.
    pub last: usize,
}

/// A piece of work.
#[derive(Debug)]
pub(super) enum Work<'s> {
    /// A landmark.
    Landmark(LandmarkNode),
    /// An arch.
    Arch(ArchNode<'s>),
    /// A claim of the paper.
    Claim(Claim),
    /// A curve of the map.
    Curve(CurveNode),
    /// An arch that is drawn.
    Drawing(Box<DrawnArch>),
    /// All arches between two ends.
    Survey(SurveyNode<'s>),
}

impl<'s> Work<'s> {
    /// Words for one and for many of each kind, in the order in which kinds are counted.
    pub(super) const KINDS: [(&'static str, &'static str); 6] = [
        ("landmark", "landmarks"),
        ("arch", "arches"),
        ("claim", "claims"),
        ("curve", "curves"),
        ("drawn arch", "drawn arches"),
        ("range of arches", "ranges of arches"),
    ];

    /// Node that is computed, with the place of its kind.
    fn computed(&self) -> (usize, &(dyn Computable + 's)) {
        match self {
            Self::Landmark(node) => (0, node),
            Self::Arch(node) => (1, node),
            Self::Claim(claim) => (2, claim),
            Self::Curve(node) => (3, node),
            Self::Drawing(drawn) => (4, &**drawn),
            Self::Survey(node) => (5, node),
        }
    }

    /// Node that is computed.
    pub(super) fn of(&self) -> &(dyn Computable + 's) {
        self.computed().1
    }

    /// The work, in digits of landmarks that take as long.
    fn size(&self) -> usize {
        match self {
            Self::Landmark(node) => node.digits(),
            Self::Arch(node) => ARCH.max(node.digits()),
            Self::Claim(_) | Self::Curve(_) => LONG,
            Self::Drawing(_) | Self::Survey(_) => ARCH,
        }
    }

    /// Number of times that it reports progress.
    fn ticks(&self) -> u64 {
        if let Self::Landmark(node) = self { node.ticks() } else { 1 }
    }

    /// Words for its kind.
    pub(super) fn kind(&self) -> (&'static str, &'static str) {
        Self::KINDS[self.computed().0]
    }
}

/// An arch takes about as long as a landmark of this many digits.
const ARCH: usize = 200;
/// A claim, or a curve of the map, as long as one of this many.
const LONG: usize = 10_000;
/// The digits of the landmarks on a page.
pub(super) const PAGE_DIGITS: usize = 15;

impl<'s> Plan<'s> {
    /// The plan of a scene, without the items whose outputs are complete.
    pub fn new(scene: &'s Scene, complete: Vec<bool>) -> Self {
        let (parts, needs, places) = (Vec::new(), Vec::new(), HashMap::new());
        let mut plan = Self { scene, complete, parts, needs, places };
        for (index, item) in scene.items.iter().enumerate() {
            plan.needs.push(Vec::new());
            if !plan.complete.get(index).copied().unwrap_or(false) {
                plan.item(item);
            }
        }
        plan
    }

    /// Sizes of the parts, in digits of landmarks that take as long.
    pub fn sizes(&self) -> Vec<usize> {
        self.parts.iter().map(|part| part.work.size()).collect()
    }

    /// Number of times that the run reports progress.
    pub fn ticks(&self) -> u64 {
        self.parts.iter().map(|part| part.work.ticks()).sum()
    }

    /// Adds what an item takes, which is the last.
    fn item(&mut self, item: &'s SceneItem) {
        match &item.what {
            Request::Constants { points, quantities, digits } => {
                for &point in points {
                    self.landmark(point, |node| {
                        node.ask(quantities, *digits);
                        if item.format.has_certificates {
                            node.certificates.insert(*digits);
                        }
                    });
                }
            }
            Request::Audit { points } => {
                points.iter().for_each(|&point| self.landmark(point, |node| node.audited = true));
            }
            Request::Arches { arches, quantities, digits, .. } => {
                for SceneArch { arch, thickness, .. } in arches {
                    if let Work::Arch(node) = self.part(Work::Arch(ArchNode::new(arch))) {
                        node.errors |= item.format.has_errors;
                        let digits = item.format.proved_digits(*digits);
                        node.ask(thickness.as_ref(), quantities, digits);
                    }
                }
            }
            Request::Surveys { surveys, boxes, quantities, digits } => {
                let rows = boxes.as_ref().map(|boxes| &boxes.rows);
                for survey in surveys {
                    let node = SurveyNode { survey, rows, quantities, digits: *digits };
                    self.part(Work::Survey(node));
                }
            }
            Request::Claims { claims, .. } => {
                for claim in claims {
                    self.part(Work::Claim(*claim));
                }
            }
            Request::Drawing(drawing) => {
                for (drawn, _) in &drawing.arches {
                    self.part(Work::Drawing(Box::new(drawn.clone())));
                }
            }
            Request::Map(map) => {
                for &point in &map.landmarks {
                    self.landmark(point, |node| node.ask(&Quantity::LANDMARK, PAGE_DIGITS));
                }
                for (weight, line) in &map.lines {
                    let (line, weight, tolerance) = (line.clone(), *weight, map.tolerance);
                    self.part(Work::Curve(CurveNode { line, weight, tolerance }));
                }
            }
        }
    }

    /// A part that the item takes, added if it is not there.
    fn part(&mut self, work: Work<'s>) -> &mut Work<'s> {
        let (item, parts) = (self.needs.len() - 1, &mut self.parts);
        let place = *self.places.entry((work.kind().0, work.of().key())).or_insert_with(|| {
            parts.push(PlannedPart { work, first: item, last: item });
            parts.len() - 1
        });
        self.needs[item].push(place);
        parts[place].last = item;
        &mut parts[place].work
    }

    fn landmark(&mut self, point: (Landmark, SelfWeight), ask: impl FnOnce(&mut LandmarkNode)) {
        if let Work::Landmark(node) = self.part(Work::Landmark(LandmarkNode::new(point))) {
            ask(node);
        }
    }
}
