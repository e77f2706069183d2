//! A map that is asked for, by a command or by a scene.

use crate::arch::SelfWeight;
use crate::atlas::{Contour, Curve};
use crate::problem::Landmark;
use crate::report::{Axes, MapAsked, Marked, Plane, View};

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
