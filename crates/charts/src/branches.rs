//! The purely rotational, overturning and sliding states along the half opening: Figures 2 to 4 of the paper.

use super::caption::caption;
use super::chain::Chain;
use super::graph::{Graph, GraphLine, Graphs, off, size};
use super::look::{self, mark};
use super::plane::PlaneAxis;
use super::sheet::Sheet;
use crate::arch::{SelfWeight, Unknown};
use crate::atlas::{Coordinate, Curve, CurveEnd, Place, rotation_end, rotation_start};
use crate::certify::CertifiedLandmark;
use crate::picture::color::INK;
use crate::picture::{Name, Point, Print, Stroke};
use crate::problem::Landmark;
use crate::report::words;
use std::cmp::Ordering::Equal;
use std::io;

/// One of these figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branches {
    /// The rotational joint, the thickness and the thrust over the half opening.
    Rotation,
    /// The thickness of overturning over `A = alpha cot(alpha/2)` and over the half opening.
    Overturning,
    /// Branches with rotation before it, and how they join.
    Joined,
}

/// The purely sliding states, those beyond the border point of one weight, and those beyond that of both.
const SLIDING: Stroke = Stroke::new(INK, 1.6);
const BETWEEN: Stroke = Stroke { color: INK, width: 1.6, dashes: &[9.0, 4.0] };
const BEYOND: Stroke = Stroke { color: INK, width: 1.6, dashes: &[3.0, 4.0] };
/// The tangent that two curves have in common.
const TANGENT: Stroke = Stroke { color: INK, width: 1.2, dashes: &[16.0, 5.0, 3.0, 5.0] };
/// Distance to which it is drawn, to each side, in degrees.
const FAR: f64 = 4.5;
/// Half-width of a tube near the end of rotation.
const NEAR_END: f64 = 1e-5;

const OPENING: PlaneAxis =
    PlaneAxis::new(Coordinate::HalfOpening, "half opening α (°)", [0.0, 180.0], 20.0);
const VARIABLE: PlaneAxis =
    PlaneAxis::new(Coordinate::OpeningVariable, "A = α cot(α/2)", [0.0, 2.0], 0.2);
const THICKNESS: PlaneAxis =
    PlaneAxis::new(Coordinate::Thickness, "thickness η = t/r", [0.0, 2.2], 0.5);
/// Axis where half arches overturn.
const WIDE: PlaneAxis = PlaneAxis { range: [146.0, 162.0], step: 2.0, ..OPENING };
const WIDE_VARIABLE: PlaneAxis = PlaneAxis { range: [0.4, 1.0], step: 0.1, ..VARIABLE };
const THICK: PlaneAxis = PlaneAxis { range: [0.8, 2.2], step: 0.2, ..THICKNESS };
/// About the ends of rotation.
const NEAR: PlaneAxis = PlaneAxis { range: [143.0, 157.0], step: 2.0, ..OPENING };
const NEAR_THICKNESS: PlaneAxis = PlaneAxis { range: [0.6, 1.4], step: 0.2, ..THICKNESS };

impl Branches {
    /// The figure of both weights as SVG.
    pub(super) fn svg(self, sheets: &[Sheet], command: &str, print: &Print) -> io::Result<String> {
        let (title, curves, panels, more, legend_at): (_, &[Curve], _, _, _) = match self {
            Self::Rotation => (
                "Purely rotational and purely sliding states over the half opening",
                &[Curve::Rotation],
                over_the_half_opening(sheets),
                sliding_parts(sheets)
                    .into_iter()
                    .map(|(_, name, stroke, _)| (name, stroke))
                    .collect(),
                (2, (16.0, 138.0)),
            ),
            Self::Overturning => (
                "Thickness of purely overturning states over A and over the half opening",
                &[Curve::Overturning],
                overturning(sheets),
                Vec::new(),
                (0, (395.0, 20.0)),
            ),
            Self::Joined => (
                "Thickness of purely rotational and purely overturning states over A and over the \
                 half opening",
                &[Curve::Rotation, Curve::Overturning],
                joined(sheets),
                vec![("common tangent at ℓ".to_owned(), TANGENT)],
                (0, (340.0, 20.0)),
            ),
        };
        let of_weight = |sheet: &Sheet, curve: Curve| {
            let name = format!("{curve}, {}-like", words::capital(sheet.weight.name()));
            (name, look_of(sheet.weight, curve))
        };
        let names =
            sheets.iter().flat_map(|sheet| curves.iter().map(move |c| of_weight(sheet, *c)));
        let legend = names.chain(more).collect();
        let joins = match self {
            Self::Joined => {
                " Below, larger: at ℓ rotation and overturning have one slope, which is proved."
            }
            _ => "",
        };
        let off = (&off(&panels)[..], size(panels.len(), print)?);
        let words = caption(title, sheets, off, joins, command);
        Graphs { title, panels, legend, legend_at, words }.svg(print)
    }
}

/// A panel of some curves, with the landmarks at the ends of some.
fn panel(
    sheets: &[Sheet],
    [x, y]: [PlaneAxis; 2],
    curves: &[Curve],
    (ends, course): (&[Curve], Course),
) -> Graph {
    let (lines, marks) = (lines(sheets, curves, &[x, y]), marks(sheets, ends, &[x, y], course));
    Graph { x, y, lines, marks, inset: None }
}

/// The joint, the thickness and the thrust of rotation, and the thrust of sliding, each with an inset where the two
/// weights differ.
fn over_the_half_opening(sheets: &[Sheet]) -> Vec<Graph> {
    let joint = PlaneAxis::new(Coordinate::RotationJoint, "joint βᵣ (°)", [0.0, 70.0], 10.0);
    let push = PlaneAxis::new(Coordinate::Thrust, "thrust h = H/(w r)", [0.0, 1.0], 0.2);
    let thickness = PlaneAxis { range: [0.0, 1.1], step: 0.2, ..THICKNESS };
    let of = |[x, y]: [PlaneAxis; 2], course| {
        let mut graph = panel(sheets, [x, y], &[Curve::Rotation], (&ENDS[..2], course));
        match y.coordinate {
            Coordinate::RotationJoint => graph.lines = joints(sheets, graph.lines, &[x, y]),
            Coordinate::Thrust => {
                graph.lines.extend(sliding(sheets, &[x, y]));
                graph.marks.extend(border_marks(sheets, &y));
            }
            _ => {}
        }
        graph
    };
    // The corners of each inset, and what it shows.
    let mut panels = [
        (joint, FALLS, [(82.0, 9.0), (136.0, 40.0)], [136.0, 154.0], ([0.0, 70.0], 20.0)),
        (thickness, RISES, [(42.0, 0.36), (104.0, 1.02)], [130.0, 155.0], ([0.4, 1.05], 0.2)),
        (push, FALLS, [(126.0, 0.59), (177.0, 0.96)], [130.0, 162.0], ([0.0, 0.2], 0.1)),
    ]
    .map(|(y, course, corners, across, (up, step))| {
        let larger = PlaneAxis { range: up, step, ..y };
        let axes = [PlaneAxis { range: across, step: 5.0, ..OPENING }, larger];
        let mut graph = of([OPENING, y], course);
        // What the inset names is only a disc in the panel.
        graph.marks.iter_mut().for_each(|mark| mark.words.clear());
        Graph { inset: Some(Box::new((corners, of(axes, course)))), ..graph }
    });
    panels[0].marks.extend(widest(sheets));
    panels.into()
}

/// The joint: over the half opening, near the origin by its ratio to that, and near the end over itself.
fn joints(sheets: &[Sheet], whole: Vec<GraphLine>, axes: &[PlaneAxis; 2]) -> Vec<GraphLine> {
    let near_ends = |sheet: &Sheet| {
        let trace = sheet.trace(Curve::Rotation)?;
        let start = rotation_start(trace, NEAR_END).ok()?;
        let start = Chain::of_pieces(start.pieces(), &start.ends()[0], axes)?;
        Some([start, Chain::over_joint(&rotation_end(trace, NEAR_END).ok()?)?])
    };
    let joined = |(line, sheet): (GraphLine, &Sheet)| {
        let Some([start, end]) = near_ends(sheet) else { return line };
        let Some(([_, from], [_, to])) = start.ends().zip(end.ends()) else { return line };
        let [before, _] = line.chain.split(to.0);
        let [_, middle] = before.split(from.0);
        let chain = Chain([start.0, middle.0, end.reversed().0].concat());
        GraphLine { chain, ..line }
    };
    whole.into_iter().zip(sheets).map(joined).collect()
}

/// Overturning, over the opening variable and over the half opening.
fn overturning(sheets: &[Sheet]) -> Vec<Graph> {
    [(WIDE_VARIABLE, FALLS_OPPOSITE), (WIDE, RISES)]
        .map(|(x, course)| panel(sheets, [x, THICK], &[Curve::Overturning], (&ENDS[1..], course)))
        .into()
}

/// Rotation and overturning, over the opening variable, over the half opening, and near the points where they join.
fn joined(sheets: &[Sheet]) -> Vec<Graph> {
    let panel = |axes, marks| panel(sheets, axes, &[Curve::Rotation, Curve::Overturning], marks);
    let mut near = panel([NEAR, NEAR_THICKNESS], (&ENDS[1..2], RISES));
    near.lines.extend(sheets.iter().filter_map(tangent));
    let [first, second] = [(VARIABLE, FALLS_OPPOSITE), (OPENING, RISES)]
        .map(|(x, course)| panel([x, THICKNESS], (&ENDS[..], course)));
    vec![first, second, near]
}

/// The tangent of a weight at the end of rotation: that with which overturning begins.
fn tangent(sheet: &Sheet) -> Option<GraphLine> {
    let chain = Chain::of_trace(sheet.trace(Curve::Overturning)?, &[NEAR, NEAR_THICKNESS])?;
    let [(x, y), (across, up), ..] = chain.0.first()?.corners;
    let slope = (up - y) / (across - x);
    let end = |far: f64| (x + far, y + far * slope);
    let id = format!("{}-tangent", sheet.weight.name());
    Some(GraphLine { id, chain: Chain::straight(end(-FAR), end(FAR)), stroke: TANGENT })
}

/// Look of a curve of a weight: overturning is told from rotation by its dashes.
fn look_of(weight: SelfWeight, curve: Curve) -> Stroke {
    let stroke = look::of_weight(weight);
    match (curve, weight) {
        (Curve::Overturning, SelfWeight::Heyman) => {
            Stroke { dashes: &[2.0, 3.5], width: 3.0, ..stroke }
        }
        (Curve::Overturning, SelfWeight::Milankovitch) => {
            Stroke { dashes: &[12.0, 3.0, 2.0, 3.0], width: 3.0, ..stroke }
        }
        _ => stroke,
    }
}

fn lines(sheets: &[Sheet], curves: &[Curve], axes: &[PlaneAxis; 2]) -> Vec<GraphLine> {
    let line = |sheet: &Sheet, curve: &Curve| {
        let chain = Chain::of_trace(sheet.trace(*curve)?, axes)?;
        let id = format!("{}-{curve}", sheet.weight.name());
        Some(GraphLine { id, chain, stroke: look_of(sheet.weight, *curve) })
    };
    sheets.iter().flat_map(|sheet| curves.iter().filter_map(move |c| line(sheet, c))).collect()
}

/// Where thickness 2 is not enough from on, of each weight: `B`, the first one first.
fn borders(sheets: &[Sheet]) -> Vec<(SelfWeight, Place)> {
    let of = |sheet: &Sheet| {
        let start = sheet.trace(Curve::Limit)?.points().swap_remove(0);
        Some((sheet.weight, start.place))
    };
    let mut all: Vec<(SelfWeight, Place)> = sheets.iter().filter_map(of).collect();
    all.sort_by(|(_, a), (_, b)| OPENING.place(a).partial_cmp(&OPENING.place(b)).unwrap_or(Equal));
    all
}

/// `B` of each weight on the line of purely sliding states.
fn border_marks(sheets: &[Sheet], push: &PlaneAxis) -> Vec<Name> {
    let mark = |(weight, place): (SelfWeight, Place)| {
        let at = (OPENING.place(&place)?, push.place(&place)?);
        Some(named(Landmark::Border, weight, at, RISES, sheets.len() > 1))
    };
    borders(sheets).into_iter().filter_map(mark).collect()
}

/// Parts of purely sliding states, as far as the border points of the weights and beyond each: the group and the name
/// of each, and where it ends.
fn sliding_parts(sheets: &[Sheet]) -> Vec<(&'static str, String, Stroke, Option<f64>)> {
    let borders = borders(sheets);
    let parts = match borders[..] {
        [(one, _), (other, _)] => vec![
            ("sliding-between", format!("beyond B{}", mark(one)), BETWEEN),
            ("sliding-beyond", format!("beyond B{} too", mark(other)), BEYOND),
        ],
        _ => vec![("sliding-beyond", "beyond B".to_owned(), BEYOND)],
    };
    let parts = [("sliding", "pure sliding".to_owned(), SLIDING)].into_iter().chain(parts);
    let ends = borders.iter().map(|(_, place)| OPENING.place(place)).chain(std::iter::repeat(None));
    parts.zip(ends).map(|((id, name, stroke), end)| (id, name, stroke, end)).collect()
}

/// The thrust of purely sliding states, by parts.
fn sliding(sheets: &[Sheet], axes: &[PlaneAxis; 2]) -> Vec<GraphLine> {
    let trace = sheets.first().and_then(|sheet| sheet.trace(Curve::Sliding));
    let Some(mut rest) = trace.and_then(|trace| Chain::of_trace(trace, axes)) else {
        return Vec::new();
    };
    let line = |(id, _, stroke, end): (&str, _, _, Option<f64>)| {
        let whole = std::mem::take(&mut rest);
        let [chain, after] = match end {
            Some(end) => whole.split(end),
            None => [whole, Chain::default()],
        };
        rest = after;
        GraphLine { id: id.into(), chain, stroke }
    };
    sliding_parts(sheets).into_iter().map(line).collect()
}

/// Curves that end at T, and at the ends of rotation and overturning.
const ENDS: [Curve; 3] =
    [Curve::Line(crate::problem::Line::RotationShoulder), Curve::Rotation, Curve::Overturning];

/// The landmarks at the ends of some curves.
fn marks(sheets: &[Sheet], curves: &[Curve], [x, y]: &[PlaneAxis; 2], course: Course) -> Vec<Name> {
    let mark = |sheet: &Sheet, curve: Curve| {
        let point = sheet.trace(curve)?.points().pop()?;
        let Some(CurveEnd::Landmark(landmark)) = point.end else { return None };
        let at = (x.place(&point.place)?, y.place(&point.place)?);
        Some(named(landmark, sheet.weight, at, course, sheets.len() > 1))
    };
    sheets.iter().flat_map(|sheet| curves.iter().filter_map(move |c| mark(sheet, *c))).collect()
}

/// Where the rotational joint is widest.
fn widest(sheets: &[Sheet]) -> Vec<Name> {
    let mark = |sheet: &Sheet| {
        let landmark = Landmark::WidestJoint;
        let refined = CertifiedLandmark::new(landmark, sheet.weight).ok()?.enclosure(64).ok()?;
        let degrees = |unknown| Some(refined.value(unknown)?.mid().to_f64().to_degrees());
        let at = (degrees(Unknown::HalfOpening)?, degrees(Unknown::RotationJoint)?);
        let mark = named(landmark, sheet.weight, at, FALLS, sheets.len() > 1);
        // The two are next to each other on top.
        let towards = if sheet.weight == SelfWeight::Heyman { (4.0, -12.0) } else { (-6.0, 16.0) };
        Some(Name { towards, ..mark })
    };
    sheets.iter().filter_map(mark).collect()
}

/// Directions from the line of Milankovitch's weight and from that of Heyman's, each away from the other.
type Course = [Point; 2];
/// Upwards, Milankovitch's above.
const RISES: Course = [(-1.0, -0.9), (0.9, 1.0)];
/// Downwards, Heyman's above.
const FALLS: Course = [(-0.8, 1.2), (0.8, -1.2)];
/// Downwards, Milankovitch's above.
const FALLS_OPPOSITE: Course = [(0.8, -1.2), (-0.8, 1.2)];

/// The name of a landmark, of its weight where there are several, away from the line of the other.
fn named(
    landmark: Landmark,
    weight: SelfWeight,
    at: Point,
    [of_milankovitch, of_heyman]: Course,
    is_of_several: bool,
) -> Name {
    let away = match weight {
        SelfWeight::Milankovitch => of_milankovitch,
        SelfWeight::Heyman => of_heyman,
    };
    let symbol = words::symbol(landmark);
    let name = match is_of_several && landmark != Landmark::OverturningEnd {
        true => format!("{symbol}{}", mark(weight)),
        false => symbol.to_owned(),
    };
    Name { color: look::of_weight(weight).color, ..Name::new(name, at, away) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::atlas::Trace;

    /// The tangent with which overturning begins is the one with which rotation ends, over A and over the half opening.
    #[test]
    fn rotation_and_overturning_have_one_slope_where_they_join() {
        for weight in SelfWeight::ALL {
            let traces = [Curve::Rotation, Curve::Overturning]
                .map(|of| Trace::new(of, weight, 1e-5).unwrap());
            for x in [OPENING, VARIABLE] {
                let [rotation, overturning] =
                    traces.each_ref().map(|trace| Chain::of_trace(trace, &[x, THICKNESS]).unwrap());
                let slope = |(x, y): Point, (u, v): Point| (v - y) / (u - x);
                let [.., before, end] = rotation.0.last().unwrap().corners;
                let [start, after, ..] = overturning.0.first().unwrap().corners;
                assert!((end.0 - start.0).abs() < 1e-9 && (end.1 - start.1).abs() < 1e-9);
                let [one, other] = [slope(before, end), slope(start, after)];
                assert!((one / other - 1.0).abs() < 1e-3, "{weight:?} {one} {other}");
            }
        }
    }
}
