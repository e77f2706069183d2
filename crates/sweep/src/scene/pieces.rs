//! The pieces of a plan, computed: a landmark, an arch. Each answers whatever any item asks of it.

use super::nodes::{ArchNode, CurveNode, LandmarkNode};
use super::plan::Plan;
use super::schema::{Drawn, MapLine};
use crate::arch::SelfWeight;
use crate::atlas::{Level, NoLevel, NoSketch, Sketch, Trace};
use crate::certify::batch::SharedOpenings;
use crate::certify::state::{Answer, AssessmentDigits, Balls, Figure, Inquiry};
use crate::certify::{
    CertifiedLandmark, Constant, Enclosed, Error, Refused, Undecided, asymmetric_thicknesses,
    fingerprint,
};
use crate::claims::Decision;
use crate::judge::enclosed;
use crate::problem::Quantity;
use std::collections::{BTreeMap, HashMap};
use std::sync::OnceLock;

/// The pieces of a plan, in its order; nothing for what is not computed yet.
pub(super) struct Pieces {
    /// Landmarks.
    pub landmarks: Vec<Option<Result<LandmarkPiece, Error>>>,
    /// Arches.
    pub arches: Vec<Option<ArchPiece>>,
    /// Claims.
    pub claims: Vec<Option<Decision>>,
    /// Curves of the map.
    pub curves: Vec<Option<Result<CurvePiece, NoLevel>>>,
    /// Arches that are drawn.
    pub drawings: Vec<Option<Result<Sketch, NoSketch>>>,
}

/// A proved landmark.
pub(super) struct LandmarkPiece {
    /// The proof.
    pub point: CertifiedLandmark,
    /// In the order in which they are asked for.
    constants: Vec<Constant>,
    /// The hash of its certificate, or why there is none, by the number of digits.
    pub certificates: BTreeMap<usize, Result<String, Error>>,
    /// For the printed numbers, if they are asked for.
    pub enclosed: Option<Enclosed>,
}

/// A proved curve, or a level.
pub(super) enum CurvePiece {
    Curve(Box<Trace>),
    Level(Level),
}

/// What is certain of an arch.
pub(super) struct ArchPiece {
    /// By the number of digits.
    pub states: BTreeMap<usize, Result<Answer, Error>>,
    /// In the order in which they are asked for.
    pub thicknesses: Vec<Result<AssessmentDigits, Refused>>,
    /// The thicknesses of its asymmetric solutions, by the number of digits.
    pub asymmetric: BTreeMap<usize, Result<Vec<Figure>, Refused>>,
}

/// A result for each piece, none of them there yet.
pub(super) fn none<T, U>(pieces: &[T]) -> Vec<Option<U>> {
    pieces.iter().map(|_| None).collect()
}

impl Pieces {
    /// Nothing is computed yet.
    pub(super) fn new(plan: &Plan) -> Self {
        Self {
            landmarks: none(&plan.landmarks),
            arches: none(&plan.arches),
            claims: none(&plan.claims),
            curves: none(&plan.curves),
            drawings: none(&plan.drawings),
        }
    }
}

impl LandmarkPiece {
    /// Isolates the landmark and refines it once, to the most digits that are asked for.
    pub(super) fn new(node: &LandmarkNode, tick: &(dyn Fn() + Sync)) -> Result<Self, Error> {
        let point = CertifiedLandmark::new(node.landmark, node.weight)?;
        let constants = match node.asked.as_slice() {
            [] => Vec::new(),
            asked => point.constants_of_with(asked, tick)?,
        };
        let certificates =
            node.certificates.iter().map(|&digits| (digits, fingerprint(&point, digits))).collect();
        let enclosed = if node.audited { Some(enclosed(&point)?) } else { None };
        Ok(Self { point, constants, certificates, enclosed })
    }

    /// What one item asks for, in the order in which it is always shown, whoever asked first.
    pub(super) fn constants(
        &self,
        node: &LandmarkNode,
        quantities: &[Quantity],
        digits: usize,
    ) -> Vec<Constant> {
        let all = node.asked.iter().zip(&self.constants);
        let mine = all.filter(|((quantity, of), _)| quantities.contains(quantity) && *of == digits);
        let mut constants: Vec<Constant> = mine.map(|(_, constant)| constant.clone()).collect();
        constants.sort_by_key(|one| Quantity::LANDMARK.iter().position(|of| *of == one.quantity));
        constants
    }
}

/// The lines between modes, of each weight that has levels.
#[derive(Default)]
pub(super) struct Lines([OnceLock<Result<Vec<Trace>, Undecided>>; 2]);

impl Lines {
    fn of(&self, weight: SelfWeight) -> Result<&[Trace], Undecided> {
        let found =
            self.0[usize::from(weight == SelfWeight::Heyman)].get_or_init(|| Level::lines(weight));
        found.as_deref().map_err(Clone::clone)
    }
}

impl CurvePiece {
    /// Follows it from end to end.
    pub(super) fn new(node: &CurveNode, lines: &Lines) -> Result<Self, NoLevel> {
        let undecided = |error| NoLevel::Undecided(node.name(), error);
        Ok(match &node.line {
            MapLine::Curve(curve) => {
                let trace = Trace::new(*curve, node.weight, node.tolerance).map_err(undecided)?;
                Self::Curve(Box::new(trace))
            }
            MapLine::Level(contour) => {
                let lines = lines.of(node.weight).map_err(undecided)?;
                Self::Level(Level::among(lines, node.weight, contour, node.tolerance)?)
            }
        })
    }
}

/// What the arches of a plan share, by what is asked of them.
pub(super) struct Shared(HashMap<(usize, bool), SharedOpenings>);

impl Shared {
    /// Nothing is proved yet.
    pub(super) fn new(plan: &Plan) -> Self {
        let openings = |(digits, frictions)| {
            let of = SharedOpenings::new(Balls::DoubleDoubles, digits, frictions);
            Some(((digits, frictions), of.ok()?))
        };
        Self(plan.arches.iter().filter_map(ArchNode::shared).filter_map(openings).collect())
    }
}

impl ArchPiece {
    /// Proves the state once, and what is asked of each thickness. A state alone shares the proofs of its half opening.
    pub(super) fn new(node: &ArchNode, shared: &Shared) -> Self {
        let of_thicknesses = node.thicknesses.iter().map(|asked| asked.digits);
        let asymmetric = node.states.keys().copied().chain(of_thicknesses);
        let asymmetric =
            asymmetric.map(|digits| (digits, asymmetric_thicknesses(node.arch, digits))).collect();
        if let Some(asked) = node.shared()
            && let Some(openings) = shared.0.get(&asked)
        {
            let states = BTreeMap::from([(asked.0, openings.state(node.arch))]);
            return Self { states, thicknesses: Vec::new(), asymmetric };
        }
        let mut inquiry = Inquiry::new(node.arch, node.digits(), node.frictions());
        let states = node.states.iter();
        let states = states
            .map(|(&digits, &frictions)| (digits, inquiry.state(digits, frictions)))
            .collect();
        let thicknesses = node
            .thicknesses
            .iter()
            .map(|asked| inquiry.assess(&asked.thickness, asked.digits, asked.wanted))
            .collect();
        Self { states, thicknesses, asymmetric }
    }
}

/// What is drawn of an arch.
pub(super) fn sketch(drawn: &Drawn) -> Result<Sketch, NoSketch> {
    match drawn {
        Drawn::Least { arch, stones: Some(stones), is_dilatant } => {
            Sketch::least_of_stones(arch, *stones, *is_dilatant)
        }
        Drawn::Least { arch, stones: None, is_dilatant } => Sketch::least(arch, *is_dilatant),
        Drawn::Landmark { landmark, weight, is_dilatant } => {
            Sketch::landmark(*landmark, *weight, *is_dilatant)
        }
        Drawn::Standing { arch, stones: Some(stones), thickness } => {
            Sketch::standing_of_stones(arch, *stones, thickness)
        }
        Drawn::Standing { arch, stones: None, thickness } => Sketch::standing(arch, thickness),
        Drawn::Sliding { arch, thickness, is_dilatant } => {
            Sketch::sliding(arch, thickness, *is_dilatant)
        }
    }
}
