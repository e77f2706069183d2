//! What a picture is drawn from: the proved curves of one weight.

use super::chain::Chain;
use super::plane::Plane;
use crate::arch::SelfWeight;
use crate::atlas::{Curve, End, Trace};
use crate::picture::Point;
use crate::problem::Landmark;

/// The curves of one weight.
pub(super) struct Sheet<'a> {
    /// The weight.
    pub weight: SelfWeight,
    /// Its curves, some or all.
    pub traces: Vec<&'a Trace>,
}

impl<'a> Sheet<'a> {
    /// One for each weight of some curves.
    pub(super) fn all(traces: &'a [Trace]) -> Vec<Self> {
        let of = |weight| {
            let traces: Vec<&Trace> =
                traces.iter().filter(|trace| trace.weight == weight).collect();
            (!traces.is_empty()).then_some(Self { weight, traces })
        };
        SelfWeight::ALL.into_iter().filter_map(of).collect()
    }

    /// A curve.
    pub(super) fn trace(&self, curve: Curve) -> Option<&'a Trace> {
        self.traces.iter().copied().find(|trace| trace.curve == curve)
    }

    /// A curve in a plane.
    pub(super) fn chain(&self, curve: Curve, plane: Plane) -> Option<Chain> {
        Chain::new(self.trace(curve)?, plane)
    }

    /// The landmarks that have a place in a plane.
    pub(super) fn landmarks(&self, plane: Plane) -> Vec<(Landmark, Point)> {
        let mut found: Vec<(Landmark, Point)> = Vec::new();
        for trace in &self.traces {
            for point in trace.points() {
                let Some(End::Landmark(landmark)) = point.end else { continue };
                let value = |axis: super::plane::Axis| {
                    Some(axis.shown(point.place.coordinate(axis.variable)?.mid().to_f64()))
                };
                let [x, y] = plane.axes().map(value);
                if let (Some(x), Some(y)) = (x, y)
                    && found.iter().all(|(known, _)| *known != landmark)
                {
                    found.push((landmark, (x, y)));
                }
            }
        }
        found
    }

    /// The largest half-width of a tube.
    pub(super) fn width(&self) -> f64 {
        self.traces.iter().map(|trace| trace.width()).fold(0.0, f64::max)
    }

    /// The curves that have pieces which are not proved.
    pub(super) fn open(&self) -> Vec<Curve> {
        let open = self.traces.iter().filter(|trace| trace.gaps().next().is_some());
        open.map(|trace| trace.curve).collect()
    }
}
