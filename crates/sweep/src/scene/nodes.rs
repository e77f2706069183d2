//! What is computed for a scene, piece by piece, and what is asked of each.

use super::schema::{Drawn, MapLine};
use crate::arch::SelfWeight;
use crate::atlas::Curve;
use crate::certify::state::Wanted;
use crate::certify::{CertifiedLandmark, quantities};
use crate::claims::Claim;
use crate::number::ExactNumber;
use crate::problem::{Arch, Landmark, Quantity};
use rug::Rational;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// The values of an arch of a given thickness that need more than its state.
pub(super) const RANGE_OF_THRUSTS: [Quantity; 4] = [
    Quantity::RequiredFriction,
    Quantity::FrictionSafety,
    Quantity::LeastThrust,
    Quantity::LargestThrust,
];

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

impl LandmarkNode {
    /// Asks for quantities, those that the landmark has.
    pub(super) fn ask(&mut self, asked: &[Quantity], digits: usize) {
        for quantity in quantities(self.landmark).filter(|quantity| asked.contains(quantity)) {
            if !self.asked.contains(&(quantity, digits)) {
                self.asked.push((quantity, digits));
            }
        }
    }

    pub(super) fn ticks(&self) -> u64 {
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

impl ArchNode<'_> {
    /// Asks for the state, or for what holds with a thickness, whose place is returned.
    pub(super) fn ask(
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
