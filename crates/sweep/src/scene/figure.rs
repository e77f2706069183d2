//! Figures of the paper, asked for by a command or by a scene.

use super::drawn::{DrawnArch, Pose};
use super::scene_map::{MapLine, SceneMap};
use super::schema::{Request, SceneDrawing};
use crate::arch::SelfWeight;
use crate::atlas::Curve;
use crate::problem::{Landmark, Mode};
use crate::report::{Axes, Style, View, arches_of_figure};

/// Tolerance where a scene does not say how wide a tube may be.
pub(super) const TOLERANCE: f64 = 1e-4;

/// Request for a figure of the paper, of its usual weights and tolerance where none are named. `key` tells what who
/// asks calls an option, and `command` tells the command for these weights.
pub fn figure(
    number: usize,
    weights: Option<Vec<SelfWeight>>,
    tolerance: Option<f64>,
    key: fn(&str) -> String,
    command: impl FnOnce(&[SelfWeight]) -> String,
) -> Result<Request, String> {
    let view = View::of_figure(number);
    let is_of_one = view.is_none_or(|view| matches!(view, View::Map(_)));
    let usual = if is_of_one { &[SelfWeight::Milankovitch] } else { &SelfWeight::ALL[..] };
    let weights = weights.map_or(usual.to_vec(), in_order);
    let command = command(&weights);
    if is_of_one && weights.len() > 1 {
        return Err(format!("figure {number} shows one {}", key("weight")));
    }
    let Some(view) = view else {
        let message =
            format!("figure {number} has no curves of the map; leave out {}", key("tolerance"));
        return tolerance.map_or_else(|| arches(number, weights[0], command), |_| Err(message));
    };
    let tolerance = tolerance.unwrap_or(TOLERANCE);
    let contours = if let View::Map(plane) = view { plane.contours() } else { Vec::new() };
    let lines = |weight: &SelfWeight| {
        let curves = Curve::ALL.map(MapLine::Curve).into_iter();
        let all = curves.chain(contours.iter().cloned().map(MapLine::Level));
        all.map(|line| (*weight, line)).collect::<Vec<_>>()
    };
    let lines = weights.iter().flat_map(lines).collect();
    let (landmarks, axes, marks) = (Vec::new(), Axes::default(), Vec::new());
    Ok(Request::Map(SceneMap { lines, tolerance, landmarks, view, axes, marks, command }))
}

/// Arches of a figure.
fn arches(number: usize, weight: SelfWeight, command: String) -> Result<Request, String> {
    let shown = arches_of_figure(number).ok_or("a figure is a number from 1 to 12")?;
    let arch = |(landmark, modes): &(Landmark, &[Mode])| {
        let pose = Pose::Landmark(*landmark, weight);
        (DrawnArch { pose, stones: None, is_dilatant: false }, modes.to_vec())
    };
    let arches = shown.iter().map(arch).collect();
    let style = Style::of_figure(number);
    Ok(Request::Drawing(SceneDrawing { arches, style, measures: None, command }))
}

/// Word for weights of the map.
pub(super) fn weight_word(weights: &[SelfWeight]) -> String {
    if let [one] = weights { one.name() } else { "both" }.to_owned()
}

/// Weights in the order in which they are always shown.
pub(super) fn in_order(weights: Vec<SelfWeight>) -> Vec<SelfWeight> {
    SelfWeight::ALL.into_iter().filter(|weight| weights.contains(weight)).collect()
}
