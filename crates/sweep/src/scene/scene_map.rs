//! A map that is asked for, by a command or by a scene, and its lines, each of which is proved once.

use super::computable::{Computable, Shared};
use crate::arch::SelfWeight;
use crate::atlas::{Border, Contour, Curve, Level, NoLevel, Trace};
use crate::problem::Landmark;
use crate::report::{Axes, MapAsked, Marked, Plane, View};
use std::fmt;

/// A line on the map.
#[derive(Clone, Debug, PartialEq)]
pub enum MapLine {
    /// A curve from landmark to landmark.
    Curve(Curve),
    /// The line of a half opening, a thickness or a friction.
    Level(Contour),
    /// The lines between asymmetric branches.
    Asymmetric,
}

/// Curves that are asked for.
#[derive(Clone, Debug)]
pub struct SceneMap {
    /// The curves and levels, each with its weight.
    pub lines: Vec<(SelfWeight, MapLine)>,
    /// The largest half-width of a tube.
    pub tolerance: f64,
    /// The landmarks that are shown beside.
    pub landmarks: Vec<(Landmark, SelfWeight)>,
    /// View that a picture of them shows.
    pub view: View,
    /// The axes of a map.
    pub axes: Axes,
    /// The arches that are marked in it.
    pub marks: Vec<Marked>,
    /// The command that asks for the same.
    pub command: String,
}

impl SceneMap {
    /// Map of what was found to go together: the curves and the contours that are named; all curves where nothing is,
    /// and in a map that is drawn the usual contours of its plane, in a page those of every plane.
    pub fn new(asked: MapAsked, command: String) -> Self {
        let plane = asked.plane();
        let view = if asked.lines { View::Lines } else { View::Map(plane) };
        let MapAsked { format, weights, curves, contours, lines, bare, asymmetric, axes, .. } =
            asked;
        let is_drawn = format.is_picture || format.is_page();
        let is_whole = curves.is_empty() && (is_drawn || contours.is_empty() && !asymmetric);
        let has_contours = is_drawn && is_whole && !lines && !bare;
        let planes = if format.is_page() { &Plane::ALL[..] } else { &[plane] };
        let contours = match has_contours && contours.is_empty() {
            true => planes.iter().flat_map(|plane| plane.contours()).collect(),
            false => contours,
        };
        let all = Curve::of_weights(&weights).into_iter();
        let all = all.filter(|(_, curve)| is_whole || curves.contains(curve));
        let all = all.map(|(weight, curve)| (weight, MapLine::Curve(curve)));
        let of_each = |weight: &SelfWeight| {
            let levels = contours.iter().cloned().map(MapLine::Level);
            let lines = levels.chain(asymmetric.then_some(MapLine::Asymmetric));
            lines.map(|line| (*weight, line)).collect::<Vec<_>>()
        };
        let lines = all.chain(weights.iter().flat_map(of_each)).collect();
        let shown = if format.is_page() { &weights[..] } else { &[] };
        let landmarks = shown.iter().flat_map(|w| Landmark::ALL.map(|landmark| (landmark, *w)));
        let (landmarks, tolerance) = (landmarks.collect(), axes.tolerance(asked.tolerance));
        Self { lines, tolerance, landmarks, view, axes, marks: asked.marks, command }
    }
}

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
    pub(super) fn piece(&self, shared: &Shared) -> Result<CurvePiece, NoLevel> {
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

    fn lines(&self) -> Vec<String> {
        vec![format!("{self}, in tubes of {:?}", self.tolerance)]
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
