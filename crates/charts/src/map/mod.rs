//! The curves of the map, `couplet.map/1`: a summary for a person, their nodes, and a page to point at. Fields may be
//! added, none changes its meaning.

mod difference;
mod page;
mod point;
mod policy;
mod record;
mod rows;
mod words;

pub use difference::MapDifferences;
pub use point::MapPoint;

pub(super) use record::{node, parts};
pub(super) use rows::MapRow;

use crate::atlas::{Border, Level, Trace};
use crate::drawing::Drawing;
use crate::report::Answer;

/// The curves of the map, each proved piece by piece.
#[derive(Debug)]
pub struct Map {
    /// The half-width of a tube that was asked for.
    pub tolerance: f64,
    /// The curves.
    pub traces: Vec<Trace>,
    /// The lines of half openings.
    pub levels: Vec<Level>,
    /// The lines between asymmetric branches.
    pub borders: Vec<Border>,
    /// The landmarks, for a page.
    pub landmarks: Vec<Answer>,
    /// Way in which a picture shows them.
    pub drawing: Drawing,
}

impl Map {
    /// The curves and the levels of which not every piece is proved.
    pub fn open(&self) -> Vec<String> {
        let curves = self.traces.iter().filter(|trace| trace.gaps().next().is_some());
        let curves = curves.map(|trace| format!("{}, {}", trace.curve, trace.weight.name()));
        let levels = self.levels.iter().filter(|level| level.has_gap());
        let levels = levels.map(|level| level.contour.to_string());
        let borders = self.borders.iter().filter(|border| border.section.has_gap());
        let borders = borders.map(|of| format!("{}, {}", of.line.name(), of.weight.name()));
        curves
            .chain(levels)
            .chain(borders)
            .map(|name| format!("{name}: not every piece is proved"))
            .collect()
    }
}
