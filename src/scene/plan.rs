//! What a scene needs computed: each piece once, to the most digits that any item asks of it. The first
//! item that needs a piece waits for all of its digits.

use super::schema::{Drawn, MapLine, Scene, SceneArch, SceneMap, What};
use crate::arch::SelfWeight;
use crate::atlas::Curve;
use crate::certify::state::Wanted;
use crate::certify::{CertifiedLandmark, quantities};
use crate::claims::Claim;
use crate::number::{ExactNumber, Form};
use crate::problem::{Arch, Friction};
use crate::problem::{Landmark, Quantity};
use rug::Rational;
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

/// A landmark and what is asked of it.
#[derive(Debug)]
pub struct LandmarkNode {
    /// The landmark.
    pub landmark: Landmark,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Each quantity with each number of digits in which it is asked for.
    pub asked: Vec<(Quantity, usize)>,
    /// The digits of the certificates whose hashes the outputs name.
    pub certificates: BTreeSet<usize>,
    /// Whether printed numbers are compared with it.
    pub audited: bool,
    /// The items that take it.
    pub items: Vec<usize>,
}

/// An arch and what is asked of it.
#[derive(Debug)]
pub struct ArchNode<'s> {
    /// The arch.
    pub arch: &'s Arch,
    /// The digits in which its state is asked for, and whether with the frictions at which the mode
    /// changes.
    pub states: BTreeMap<usize, bool>,
    /// The thicknesses with which it is asked about.
    pub thicknesses: Vec<ThicknessNode>,
    /// Whether a format asks for the errors of doubles, of which more is known with more bits.
    pub errors: bool,
    /// The items that take it.
    pub items: Vec<usize>,
}

/// A thickness of an arch, and what is asked.
#[derive(Debug)]
pub struct ThicknessNode {
    /// The thickness.
    pub thickness: ExactNumber,
    /// Significant digits.
    pub digits: usize,
    /// How much is to be found out.
    pub wanted: Wanted,
}

/// A claim.
#[derive(Debug)]
pub struct ClaimNode {
    /// The claim.
    pub claim: Claim,
    /// The items that take it.
    pub items: Vec<usize>,
}

/// A curve of the map, or a level.
#[derive(Debug)]
pub struct CurveNode {
    /// Which.
    pub line: MapLine,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The largest half-width of a tube.
    pub tolerance: f64,
    /// The items that take it.
    pub items: Vec<usize>,
}

/// An arch that is drawn.
#[derive(Debug)]
pub struct DrawingNode {
    /// Which.
    pub drawn: Drawn,
    /// The items that take it.
    pub items: Vec<usize>,
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

/// What makes two arches the same, however they are written.
type ArchKey = (SelfWeight, Number, Option<(bool, Number)>);
type Number = (Rational, Form);

fn number(x: &ExactNumber) -> Number {
    (x.to_rational(), x.form())
}

fn arch_key(arch: &Arch) -> ArchKey {
    let friction = match arch.friction() {
        Friction::Infinite => None,
        Friction::Coefficient(mu) => Some((false, number(mu))),
        Friction::Angle(phi) => Some((true, number(phi))),
    };
    (arch.weight(), number(arch.half_opening()), friction)
}

/// What makes two drawn arches the same; no friction is read of one that slides.
fn drawn_key(drawn: &Drawn) -> (Option<Landmark>, Option<ArchKey>, Option<Rational>, bool) {
    let is_dilatant = drawn.is_dilatant();
    match drawn {
        Drawn::Least { arch, .. } => (None, Some(arch_key(arch)), None, is_dilatant),
        Drawn::Landmark { landmark, .. } => (Some(*landmark), None, None, is_dilatant),
        Drawn::Standing { arch, thickness } | Drawn::Sliding { arch, thickness, .. } => {
            (None, Some(arch_key(arch)), Some(thickness.to_rational()), is_dilatant)
        }
    }
}

/// The values of an arch of a given thickness that need more than its state.
pub(super) const RANGE_OF_THRUSTS: [Quantity; 4] = [
    Quantity::RequiredFriction,
    Quantity::FrictionSafety,
    Quantity::LeastThrust,
    Quantity::LargestThrust,
];

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

impl LandmarkNode {
    /// Asks for quantities, those that the landmark has.
    fn ask(&mut self, asked: &[Quantity], digits: usize) {
        for quantity in quantities(self.landmark).filter(|quantity| asked.contains(quantity)) {
            if !self.asked.contains(&(quantity, digits)) {
                self.asked.push((quantity, digits));
            }
        }
    }

    fn ticks(&self) -> u64 {
        match self.asked.len() {
            0 => 0,
            asked => CertifiedLandmark::ticks_of(self.landmark, asked),
        }
    }

    /// The most digits that are asked for.
    pub fn digits(&self) -> usize {
        self.asked.iter().map(|(_, digits)| *digits).max().unwrap_or(0)
    }
}

impl CurveNode {
    /// Its name, as in files.
    pub fn name(&self) -> String {
        let weight = self.weight.name();
        match &self.line {
            MapLine::Curve(curve) => format!("{curve} {weight}"),
            MapLine::Level(contour) => format!("{contour} {weight}"),
        }
    }

    /// The curve, if it is no level.
    pub fn curve(&self) -> Option<Curve> {
        if let MapLine::Curve(curve) = self.line { Some(curve) } else { None }
    }
}

impl ArchNode<'_> {
    /// Asks for the state, or for what holds with a thickness, whose place is returned.
    fn ask(
        &mut self,
        (node, thickness): (usize, Option<&ExactNumber>),
        quantities: &[Quantity],
        digits: usize,
        known: &mut HashMap<(usize, Rational, usize), usize>,
    ) -> Option<usize> {
        let Some(thickness) = thickness else {
            *self.states.entry(digits).or_default() |= quantities.iter().any(|q| q.is_friction());
            return None;
        };
        let wanted = match quantities.iter().any(|quantity| RANGE_OF_THRUSTS.contains(quantity)) {
            true => Wanted::Everything,
            false => Wanted::Standing,
        };
        let key = (node, thickness.to_rational(), digits);
        let place = *known.entry(key).or_insert_with(|| {
            let thickness = thickness.clone();
            self.thicknesses.push(ThicknessNode { thickness, digits, wanted });
            self.thicknesses.len() - 1
        });
        if wanted == Wanted::Everything {
            self.thicknesses[place].wanted = wanted;
        }
        Some(place)
    }

    /// What is asked, if it is one state that may share the proofs of its half opening: its digits, and whether the
    /// frictions at which the mode changes are.
    pub(super) fn shared(&self) -> Option<(usize, bool)> {
        let mut states = self.states.iter().map(|(digits, frictions)| (*digits, *frictions));
        let first = states.next().filter(|_| self.thicknesses.is_empty() && !self.errors);
        first.filter(|_| states.next().is_none())
    }

    /// Whether the frictions at which the mode changes are asked for.
    pub fn frictions(&self) -> bool {
        self.states.values().any(|frictions| *frictions)
    }

    /// The most digits that are asked for.
    pub fn digits(&self) -> usize {
        let states = self.states.keys().copied();
        states.chain(self.thicknesses.iter().map(|asked| asked.digits)).max().unwrap_or(1)
    }
}
