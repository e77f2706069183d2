//! Lines of the map: a curve, a level, or those between asymmetric branches.

use super::computable::{Computable, Done, LONG, Shared};
use super::scene_map::MapLine;
use crate::arch::SelfWeight;
use crate::atlas::{Border, Level, NoLevel, Trace};
use std::fmt;

/// A line of the map.
#[derive(Debug)]
pub(super) struct CurveNode {
    /// Line of the map.
    pub line: MapLine,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The largest half-width of a tube.
    pub tolerance: f64,
}

/// A proved line.
pub(super) enum CurvePiece {
    Curve(Box<Trace>),
    Level(Level),
    Borders(Vec<Border>),
}

impl CurveNode {
    /// Follows it from end to end.
    fn piece(&self, shared: &Shared) -> Result<CurvePiece, NoLevel> {
        let undecided = |error| NoLevel::Undecided(self.to_string(), error);
        Ok(match &self.line {
            MapLine::Curve(curve) => {
                let trace = Trace::new(*curve, self.weight, self.tolerance).map_err(undecided)?;
                CurvePiece::Curve(Box::new(trace))
            }
            MapLine::Level(contour) => {
                let lines = shared.lines(self.weight).map_err(undecided)?;
                CurvePiece::Level(Level::among(lines, self.weight, contour, self.tolerance)?)
            }
            MapLine::Asymmetric => {
                let borders = Border::all(self.weight, self.tolerance).map_err(undecided)?;
                CurvePiece::Borders(borders)
            }
        })
    }
}

impl Computable for CurveNode {
    fn key(&self) -> String {
        self.lines().concat()
    }

    fn size(&self) -> usize {
        LONG
    }

    fn lines(&self) -> Vec<String> {
        vec![format!("{self}, in tubes of {:?}", self.tolerance)]
    }

    fn compute(&self, shared: &Shared, _: &(dyn Fn() + Sync)) -> Done {
        Box::new(self.piece(shared))
    }
}

impl fmt::Display for CurveNode {
    /// Writes the name of the curve, as in files.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let weight = self.weight.name();
        match &self.line {
            MapLine::Curve(curve) => write!(f, "{curve} {weight}"),
            MapLine::Level(contour) => write!(f, "{contour} {weight}"),
            MapLine::Asymmetric => write!(f, "asymmetric {weight}"),
        }
    }
}
