//! Data of a picture: the proved curves of one weight.

use super::canvas::Canvas;
use super::chain::Chain;
use super::plane::Plane;
use crate::arch::SelfWeight;
use crate::atlas::{Border, Curve, CurveEnd, Level, Trace};
use crate::picture::Point;
use crate::problem::Landmark;

/// The curves of one weight.
#[derive(Clone)]
pub(super) struct Sheet<'a> {
    /// The weight.
    pub weight: SelfWeight,
    /// Curves of the weight, some or all.
    pub traces: Vec<&'a Trace>,
    /// Levels of the weight.
    pub levels: Vec<&'a Level>,
    /// Lines between asymmetric branches.
    pub borders: Vec<&'a Border>,
}

impl<'a> Sheet<'a> {
    /// Sheets, one for each weight of some curves.
    pub(super) fn all(
        traces: &'a [Trace],
        levels: &'a [Level],
        borders: &'a [Border],
    ) -> Vec<Self> {
        let of = |weight| {
            let traces: Vec<&Trace> =
                traces.iter().filter(|trace| trace.weight == weight).collect();
            let levels = levels.iter().filter(|level| level.weight == weight).collect();
            let borders = borders.iter().filter(|border| border.weight == weight).collect();
            (!traces.is_empty()).then_some(Self { weight, traces, levels, borders })
        };
        SelfWeight::ALL.into_iter().filter_map(of).collect()
    }

    /// Sheet with only the levels that are lines in a plane.
    pub(super) fn crossing(&self, plane: Plane) -> Self {
        let is_line = |level: &&&Level| plane.is_crossed_by(&level.contour);
        let levels = self.levels.iter().filter(is_line).copied().collect();
        Self { levels, ..self.clone() }
    }

    /// A curve.
    pub(super) fn trace(&self, curve: Curve) -> Option<&'a Trace> {
        self.traces.iter().copied().find(|trace| trace.curve == curve)
    }

    /// A curve on a canvas.
    pub(super) fn chain(&self, curve: Curve, canvas: &Canvas) -> Option<Chain> {
        Chain::of_trace(self.trace(curve)?, &canvas.axes)
    }

    /// The landmarks that have a place on a canvas.
    pub(super) fn landmarks(&self, canvas: &Canvas) -> Vec<(Landmark, Point)> {
        let mut found: Vec<(Landmark, Point)> = Vec::new();
        for point in self.traces.iter().flat_map(|trace| trace.points()) {
            let Some(CurveEnd::Landmark(landmark)) = point.end else { continue };
            let at = canvas.place(&point.place);
            let is_new = found.iter().all(|(known, _)| *known != landmark);
            found.extend(at.filter(|_| is_new).map(|at| (landmark, at)));
        }
        found
    }

    /// Place of a landmark on a canvas, if it has one.
    pub(super) fn landmark(&self, landmark: Landmark, canvas: &Canvas) -> Option<Point> {
        let mut all = self.landmarks(canvas).into_iter();
        all.find(|(of, _)| *of == landmark).map(|(_, at)| at)
    }

    /// The largest half-width of a tube.
    pub(super) fn width(&self) -> f64 {
        let of_levels = self.levels.iter().map(|level| level.width());
        self.traces.iter().map(|trace| trace.width()).chain(of_levels).fold(0.0, f64::max)
    }

    /// Names of what has pieces that are not proved.
    pub(super) fn open(&self) -> Vec<String> {
        let traces = self.traces.iter().filter(|trace| trace.gaps().next().is_some());
        let levels = self.levels.iter().filter(|level| level.has_gap());
        let curves = traces.map(|trace| trace.curve.to_string());
        curves.chain(levels.map(|level| level.contour.to_string())).collect()
    }
}
