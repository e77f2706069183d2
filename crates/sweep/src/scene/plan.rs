//! What a scene needs computed: each piece once, to the most digits that any item asks of it. The first
//! item that needs a piece waits for all of its digits.

use super::nodes::{ArchNode, ClaimNode, CurveNode, DrawingNode, LandmarkNode};
use super::same::{ArchKey, arch_key, drawn_key};
use super::schema::{Drawn, MapLine, Scene, SceneArch, SceneMap, What};
use crate::arch::SelfWeight;
use crate::claims::Claim;
use crate::problem::{Landmark, Quantity};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// What is computed, and what each item takes from it.
#[derive(Debug)]
pub struct Plan<'s> {
    /// What was asked for.
    pub scene: &'s Scene,
    /// For each item, whether its output is complete, so that nothing is computed for it.
    pub complete: Vec<bool>,
    /// The landmarks, each once.
    pub landmarks: Vec<LandmarkNode>,
    /// The arches, each once.
    pub arches: Vec<ArchNode<'s>>,
    /// The claims, each once.
    pub claims: Vec<ClaimNode>,
    /// The curves of the map, each once.
    pub curves: Vec<CurveNode>,
    /// The arches that are drawn, each once.
    pub drawings: Vec<DrawingNode>,
    /// For each item, what it takes.
    pub needs: Vec<Needs>,
}

/// What an item takes: places in the lists of the plan.
#[derive(Debug, Default)]
pub struct Needs {
    /// Landmarks.
    pub landmarks: Vec<usize>,
    /// Arches, each with the place of its thickness if it has one.
    pub arches: Vec<(usize, Option<usize>)>,
    /// Claims.
    pub claims: Vec<usize>,
    /// Curves of the map.
    pub curves: Vec<usize>,
    /// Arches that are drawn.
    pub drawings: Vec<usize>,
}

/// An arch takes about as long as a landmark of this many digits.
const ARCH: usize = 200;
/// And a claim.
const CLAIM: usize = 10_000;
/// And a curve of the map.
const CURVE: usize = 10_000;
/// The digits of the landmarks on a page.
pub(super) const PAGE_DIGITS: usize = 15;

impl<'s> Plan<'s> {
    /// The plan of a scene, without the items whose outputs are complete.
    pub fn new(scene: &'s Scene, complete: Vec<bool>) -> Self {
        let mut plan = Self {
            scene,
            complete,
            landmarks: Vec::new(),
            arches: Vec::new(),
            claims: Vec::new(),
            curves: Vec::new(),
            drawings: Vec::new(),
            needs: Vec::new(),
        };
        let mut known = HashMap::new();
        let mut thicknesses = HashMap::new();
        for (index, item) in scene.items.iter().enumerate() {
            let mut needs = Needs::default();
            if !plan.complete.get(index).copied().unwrap_or(false) {
                match &item.what {
                    What::Constants { points, quantities, digits } => {
                        for &point in points {
                            let node = plan.landmark(point, index);
                            plan.landmarks[node].ask(quantities, *digits);
                            if item.format.has_certificates {
                                plan.landmarks[node].certificates.insert(*digits);
                            }
                            needs.landmarks.push(node);
                        }
                    }
                    What::Audit { points } => {
                        for &point in points {
                            let node = plan.landmark(point, index);
                            plan.landmarks[node].audited = true;
                            needs.landmarks.push(node);
                        }
                    }
                    What::Arches { arches, quantities, digits, .. } => {
                        for asked in arches {
                            let node = plan.arch(asked, index, &mut known);
                            plan.arches[node].errors |= item.format.has_errors;
                            let place = plan.arches[node].ask(
                                (node, asked.thickness.as_ref()),
                                quantities,
                                *digits,
                                &mut thicknesses,
                            );
                            needs.arches.push((node, place));
                        }
                    }
                    What::Claims { claims, .. } => {
                        needs.claims.extend(claims.iter().map(|claim| plan.claim(*claim, index)));
                    }
                    What::Drawing(drawing) => {
                        let arches = drawing.arches.iter();
                        needs.drawings.extend(arches.map(|(drawn, _)| plan.drawing(drawn, index)));
                    }
                    What::Map(map) | What::Figure(map) => {
                        for &point in &map.landmarks {
                            let node = plan.landmark(point, index);
                            plan.landmarks[node].ask(&Quantity::LANDMARK, PAGE_DIGITS);
                            needs.landmarks.push(node);
                        }
                        needs.curves.extend(
                            map.lines
                                .iter()
                                .map(|(weight, line)| plan.curve(*weight, line, map, index)),
                        );
                    }
                }
            }
            plan.needs.push(needs);
        }
        plan
    }

    fn landmark(&mut self, (landmark, weight): (Landmark, SelfWeight), item: usize) -> usize {
        let is_it = |node: &LandmarkNode| (node.landmark, node.weight) == (landmark, weight);
        let place = self.landmarks.iter().position(is_it).unwrap_or_else(|| {
            self.landmarks.push(LandmarkNode {
                landmark,
                weight,
                asked: Vec::new(),
                certificates: BTreeSet::new(),
                audited: false,
                items: Vec::new(),
            });
            self.landmarks.len() - 1
        });
        self.landmarks[place].items.push(item);
        place
    }

    fn arch(
        &mut self,
        asked: &'s SceneArch,
        item: usize,
        known: &mut HashMap<ArchKey, usize>,
    ) -> usize {
        let place = *known.entry(arch_key(&asked.arch)).or_insert_with(|| {
            self.arches.push(ArchNode {
                arch: &asked.arch,
                states: BTreeMap::new(),
                thicknesses: Vec::new(),
                errors: false,
                items: Vec::new(),
            });
            self.arches.len() - 1
        });
        let items = &mut self.arches[place].items;
        if items.last() != Some(&item) {
            items.push(item);
        }
        place
    }

    fn claim(&mut self, claim: Claim, item: usize) -> usize {
        let is_it = |node: &ClaimNode| node.claim.id == claim.id;
        let place = self.claims.iter().position(is_it).unwrap_or_else(|| {
            self.claims.push(ClaimNode { claim, items: Vec::new() });
            self.claims.len() - 1
        });
        self.claims[place].items.push(item);
        place
    }

    fn curve(&mut self, weight: SelfWeight, line: &MapLine, map: &SceneMap, item: usize) -> usize {
        let is_it = |node: &CurveNode| {
            (node.weight, node.tolerance, &node.line) == (weight, map.tolerance, line)
        };
        let place = self.curves.iter().position(is_it).unwrap_or_else(|| {
            let (line, tolerance) = (line.clone(), map.tolerance);
            self.curves.push(CurveNode { line, weight, tolerance, items: Vec::new() });
            self.curves.len() - 1
        });
        self.curves[place].items.push(item);
        place
    }

    fn drawing(&mut self, drawn: &Drawn, item: usize) -> usize {
        let is_same = |node: &DrawingNode| {
            let is_one = std::mem::discriminant(&node.drawn) == std::mem::discriminant(drawn);
            is_one
                && node.drawn.weight() == drawn.weight()
                && drawn_key(&node.drawn) == drawn_key(drawn)
        };
        let place = self.drawings.iter().position(is_same).unwrap_or_else(|| {
            self.drawings.push(DrawingNode { drawn: drawn.clone(), items: Vec::new() });
            self.drawings.len() - 1
        });
        self.drawings[place].items.push(item);
        place
    }

    /// The work, in digits of landmarks that take as long.
    pub fn size(&self) -> usize {
        let landmarks: usize = self.landmarks.iter().map(LandmarkNode::digits).sum();
        let arches: usize = self.arches.iter().map(|node| ARCH.max(node.digits())).sum();
        let drawings = ARCH * self.drawings.len();
        landmarks + arches + drawings + CLAIM * self.claims.len() + CURVE * self.curves.len()
    }

    /// How often the run reports progress.
    pub fn ticks(&self) -> u64 {
        let landmarks = self.landmarks.iter().map(LandmarkNode::ticks).sum::<u64>();
        landmarks + {
            let others =
                [self.arches.len(), self.claims.len(), self.curves.len(), self.drawings.len()];
            others.iter().sum::<usize>() as u64
        }
    }
}
