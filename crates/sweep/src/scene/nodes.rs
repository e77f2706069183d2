//! Nodes of a plan: the work that a scene needs, and the questions to each piece of it.

use super::drawn::{DrawnArch, DrawnKey};
use super::same::ArchKey;
use super::schema::{MapLine, SceneSurvey};
use crate::arch::SelfWeight;
use crate::certify::state::Wanted;
use crate::certify::{CertifiedLandmark, quantities};
use crate::claims::Claim;
use crate::number::ExactNumber;
use crate::problem::{Arch, Landmark, Quantity};
use crate::report::SurveyedRows;
use rug::Rational;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fmt;

/// The values of an arch of a given thickness that need more than its state.
pub(super) const RANGE_OF_THRUSTS: [Quantity; 4] = [
    Quantity::RequiredFriction,
    Quantity::FrictionSafety,
    Quantity::LeastThrust,
    Quantity::LargestThrust,
];

/// A piece of work that is done once.
#[derive(Debug)]
pub enum Work<'s> {
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

/// Key of equal work, however its numbers are written.
#[derive(PartialEq, Eq, Hash)]
pub(super) enum WorkKey {
    Landmark(Landmark, SelfWeight),
    Arch(ArchKey),
    Claim(&'static str),
    /// The name of a curve and the bits of its tolerance.
    Curve(String, u64),
    Drawing(DrawnKey),
    /// The question, and what is asked, in words.
    Survey(String),
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
    /// True if printed numbers are compared with it.
    pub audited: bool,
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
    /// Places in the list of thicknesses, by thickness and digits.
    places: HashMap<(Rational, usize), usize>,
    /// True if a format asks for the errors of doubles, of which more is known with more bits.
    pub errors: bool,
}

/// A thickness of an arch, and what is asked.
#[derive(Debug)]
pub struct ThicknessNode {
    /// The thickness.
    pub thickness: ExactNumber,
    /// Significant digits.
    pub digits: usize,
    /// Question that is asked of it.
    pub wanted: Wanted,
}

/// All arches between two ends, and what is told of them.
#[derive(Clone, Copy, Debug)]
pub struct SurveyNode<'s> {
    /// The arches.
    pub survey: &'s SceneSurvey,
    /// Columns, if the arches are a box of which the cells of a table are told.
    pub rows: Option<&'s SurveyedRows>,
    /// Quantities that are told.
    pub quantities: &'s [Quantity],
    /// Significant digits.
    pub digits: usize,
}

/// A curve of the map, or a level.
#[derive(Debug)]
pub struct CurveNode {
    /// Line of the map.
    pub line: MapLine,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The largest half-width of a tube.
    pub tolerance: f64,
}

/// An arch takes about as long as a landmark of this many digits.
const ARCH: usize = 200;
/// A claim, or a curve of the map, as long as one of this many.
const LONG: usize = 10_000;

impl Work<'_> {
    /// The work, in digits of landmarks that take as long.
    pub(super) fn size(&self) -> usize {
        match self {
            Self::Landmark(node) => node.digits(),
            Self::Arch(node) => ARCH.max(node.digits()),
            Self::Drawing(_) | Self::Survey(_) => ARCH,
            Self::Claim(_) | Self::Curve(_) => LONG,
        }
    }

    /// Number of times that it reports progress.
    pub(super) fn ticks(&self) -> u64 {
        match self {
            Self::Landmark(LandmarkNode { asked, .. }) if asked.is_empty() => 0,
            Self::Landmark(node) => CertifiedLandmark::ticks_of(node.landmark, node.asked.len()),
            _ => 1,
        }
    }

    /// Words for one and for many of its kind, in the order in which kinds are counted.
    pub(super) const KINDS: [(&'static str, &'static str); 6] = [
        ("landmark", "landmarks"),
        ("arch", "arches"),
        ("claim", "claims"),
        ("curve", "curves"),
        ("drawn arch", "drawn arches"),
        ("range of arches", "ranges of arches"),
    ];

    /// Words for its kind.
    pub(super) fn kind(&self) -> (&'static str, &'static str) {
        Self::KINDS[match self {
            Self::Landmark(_) => 0,
            Self::Arch(_) => 1,
            Self::Claim(_) => 2,
            Self::Curve(_) => 3,
            Self::Drawing(_) => 4,
            Self::Survey(_) => 5,
        }]
    }
}

impl LandmarkNode {
    /// Asks for quantities, those that the landmark has.
    pub(super) fn ask(&mut self, asked: &[Quantity], digits: usize) {
        for quantity in quantities(self.landmark).filter(|quantity| asked.contains(quantity)) {
            if !self.asked.contains(&(quantity, digits)) {
                self.asked.push((quantity, digits));
            }
        }
    }

    /// The most digits that are asked for.
    pub fn digits(&self) -> usize {
        self.asked.iter().map(|(_, digits)| *digits).max().unwrap_or(0)
    }
}

impl SurveyNode<'_> {
    /// Words that are the same for the same question.
    pub(super) fn key(&self) -> String {
        let Self { survey, rows, quantities, digits } = self;
        let names: Vec<&str> = quantities.iter().map(|of| of.name()).collect();
        let (options, weight) = (survey.asked.options(), survey.weight.name());
        let boxed = if rows.is_some() { " box" } else { "" };
        format!("{options} {weight} {} {digits}{boxed}", names.join(" "))
    }
}

impl<'s> ArchNode<'s> {
    pub(super) fn new(arch: &'s Arch) -> Self {
        let (states, thicknesses, places) = <(BTreeMap<_, _>, Vec<_>, HashMap<_, _>)>::default();
        Self { arch, states, thicknesses, places, errors: false }
    }

    /// Asks for the state, or for what holds with a thickness.
    pub(super) fn ask(
        &mut self,
        thickness: Option<&ExactNumber>,
        quantities: &[Quantity],
        digits: usize,
    ) {
        let Some(thickness) = thickness else {
            *self.states.entry(digits).or_default() |= quantities.iter().any(|q| q.is_friction());
            return;
        };
        let place = *self.places.entry((thickness.to_rational(), digits)).or_insert_with(|| {
            let (thickness, wanted) = (thickness.clone(), Wanted::Standing);
            self.thicknesses.push(ThicknessNode { thickness, digits, wanted });
            self.thicknesses.len() - 1
        });
        if quantities.iter().any(|quantity| RANGE_OF_THRUSTS.contains(quantity)) {
            self.thicknesses[place].wanted = Wanted::Everything;
        }
    }

    /// The place of a thickness that is asked about.
    pub(super) fn place(&self, thickness: &ExactNumber, digits: usize) -> Option<usize> {
        self.places.get(&(thickness.to_rational(), digits)).copied()
    }

    /// Digits that are asked, and whether the frictions at which the mode changes are.
    pub(super) fn shared(&self) -> Option<(usize, bool)> {
        let mut states = self.states.iter().map(|(digits, frictions)| (*digits, *frictions));
        let first = states.next().filter(|_| self.thicknesses.is_empty() && !self.errors);
        first.filter(|_| states.next().is_none())
    }

    /// Tells whether the frictions at which the mode changes are asked for.
    pub fn frictions(&self) -> bool {
        self.states.values().any(|frictions| *frictions)
    }

    /// The most digits that are asked for.
    pub fn digits(&self) -> usize {
        let states = self.states.keys().copied();
        states.chain(self.thicknesses.iter().map(|asked| asked.digits)).max().unwrap_or(1)
    }
}

impl fmt::Display for CurveNode {
    /// Writes the name of the curve, as in files.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let weight = self.weight.name();
        match &self.line {
            MapLine::Curve(curve) => write!(f, "{curve} {weight}"),
            MapLine::Level(contour) => write!(f, "{contour} {weight}"),
        }
    }
}
