//! The parts of a plan, computed: a landmark, an arch. Each answers whatever any item asks of it.

use super::nodes::{ArchNode, CurveNode, LandmarkNode, SurveyNode, Work};
use super::plan::Plan;
use super::read_ranges::given;
use super::schema::MapLine;
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
use crate::report::{SurveyedArches, SurveyedCell};
use crate::surveyed::{ranges, surveyed};
use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, OnceLock};

/// Result of a part of a plan.
pub(super) enum WorkDone {
    Landmark(Box<Result<LandmarkPiece, Error>>),
    Arch(ArchPiece),
    Claim(Decision),
    Curve(Result<CurvePiece, NoLevel>),
    Drawing(Box<Result<Sketch, NoSketch>>),
    /// Answer about all arches between two ends, or why the question makes no sense.
    Survey(Result<Arc<SurveyedArches>, String>),
    /// Answer about a box, in the cells of a table.
    Cell(Result<Arc<SurveyedCell>, String>),
}

impl WorkDone {
    /// Computes a part; progress is reported as often as the part says.
    pub(super) fn new(work: &Work, shared: &Shared, tick: &(dyn Fn() + Sync)) -> Self {
        let done = match work {
            Work::Landmark(node) => {
                return Self::Landmark(Box::new(LandmarkPiece::new(node, tick)));
            }
            Work::Arch(node) => Self::Arch(ArchPiece::new(node, shared)),
            Work::Claim(claim) => Self::Claim(claim.decide()),
            Work::Curve(node) => Self::Curve(CurvePiece::new(node, shared)),
            Work::Survey(node) => match node.rows {
                None => Self::Survey(found(node).map(Arc::new)),
                Some(rows) => Self::Cell(found(node).map(|found| Arc::new(rows.cell(&found)))),
            },
            Work::Drawing(drawn) => Self::Drawing(Box::new(drawn.sketch())),
        };
        tick();
        done
    }
}

/// Answer about all arches between two ends.
fn found(node: &SurveyNode) -> Result<SurveyedArches, String> {
    let SurveyNode { survey, quantities, digits, rows } = node;
    let given = given(&survey.asked).map_err(|misfit| misfit.message)?;
    // What to measure better is told of a survey, not of each of its boxes.
    let proof = if rows.is_some() { ranges } else { surveyed };
    let found = proof(&survey.asked, &given, survey.weight, (quantities, *digits));
    found.map_err(|error| error.to_string())
}

/// A proved landmark.
pub(super) struct LandmarkPiece {
    /// The proof.
    pub point: CertifiedLandmark,
    /// Constants in the order in which they are asked for.
    constants: Vec<Constant>,
    /// The hash of its certificate, or why there is none, by the number of digits.
    pub certificates: BTreeMap<usize, Result<String, Error>>,
    /// Enclosures for the printed numbers, if they are asked for.
    pub enclosed: Option<Enclosed>,
}

/// A proved curve, or a level.
pub(super) enum CurvePiece {
    Curve(Box<Trace>),
    Level(Level),
}

/// Certain knowledge of an arch.
pub(super) struct ArchPiece {
    /// States by the number of digits.
    pub states: BTreeMap<usize, Result<Answer, Error>>,
    /// Thicknesses in the order in which they are asked for.
    pub thicknesses: Vec<Result<AssessmentDigits, Refused>>,
    /// The thicknesses of its asymmetric solutions, by the number of digits.
    pub asymmetric: BTreeMap<usize, Result<Vec<Figure>, Refused>>,
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

    /// Constants that an item asks for, in the order in which it is always shown, whoever asked first.
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

/// Proofs that parts of a plan share.
pub(super) struct Shared {
    /// Of arches, by what is asked of them.
    openings: HashMap<(usize, bool), SharedOpenings>,
    /// The lines between modes, of each weight that has levels.
    lines: [OnceLock<Result<Vec<Trace>, Undecided>>; 2],
}

impl Shared {
    /// Proofs of which nothing is proved yet.
    pub(super) fn new(plan: &Plan) -> Self {
        let asked = plan.parts.iter().filter_map(|part| match &part.work {
            Work::Arch(node) => node.shared(),
            _ => None,
        });
        let openings = asked
            .filter_map(|asked| {
                Some((asked, SharedOpenings::new(Balls::DoubleDoubles, asked.0, asked.1).ok()?))
            })
            .collect();
        Self { openings, lines: Default::default() }
    }

    fn lines(&self, weight: SelfWeight) -> Result<&[Trace], Undecided> {
        let lines = &self.lines[usize::from(weight == SelfWeight::Heyman)];
        lines.get_or_init(|| Level::lines(weight)).as_deref().map_err(Clone::clone)
    }
}

impl CurvePiece {
    /// Follows it from end to end.
    pub(super) fn new(node: &CurveNode, shared: &Shared) -> Result<Self, NoLevel> {
        let undecided = |error| NoLevel::Undecided(node.to_string(), error);
        Ok(match &node.line {
            MapLine::Curve(curve) => {
                let trace = Trace::new(*curve, node.weight, node.tolerance).map_err(undecided)?;
                Self::Curve(Box::new(trace))
            }
            MapLine::Level(contour) => {
                let lines = shared.lines(node.weight).map_err(undecided)?;
                Self::Level(Level::among(lines, node.weight, contour, node.tolerance)?)
            }
        })
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
            && let Some(openings) = shared.openings.get(&asked)
        {
            let states = BTreeMap::from([(asked.0, openings.state(node.arch))]);
            return Self { states, thicknesses: Vec::new(), asymmetric };
        }
        let inquiry = Inquiry::new(node.arch, node.digits(), node.frictions());
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
