//! The purely rotational, overturning and sliding states along the half opening: Figures 2 to 4 of the paper.

use super::caption::caption;
use super::chain::Chain;
use super::graph::{Dot, Graph, GraphLine, Graphs, WIDTH, height};
use super::look;
use super::plane::PlaneAxis;
use super::sheet::Sheet;
use crate::arch::{SelfWeight, Unknown};
use crate::atlas::{Coordinate, Curve, CurveEnd, Place, Trace};
use crate::certify::CertifiedLandmark;
use crate::number::Ball;
use crate::picture::color::INK;
use crate::picture::{Point, Stroke};
use crate::problem::Landmark;
use crate::report::words;

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

/// The purely sliding states, and those beyond the border point.
const SLIDING: Stroke = Stroke::new(INK, 1.6);
const BEYOND: Stroke = Stroke { color: INK, width: 1.6, dashes: &[3.0, 4.0] };
/// The tangent that two curves have in common.
const TANGENT: Stroke = Stroke { color: INK, width: 1.2, dashes: &[16.0, 5.0, 3.0, 5.0] };
/// Distance to which it is drawn, to each side, in degrees.
const FAR: f64 = 4.5;
/// Tolerance within which a point is on the foot of a panel.
const FOOT: f64 = 1e-9;

const OPENING: PlaneAxis =
    PlaneAxis::new(Coordinate::HalfOpening, "half opening α (°)", [0.0, 180.0], 20.0);
const VARIABLE: PlaneAxis =
    PlaneAxis::new(Coordinate::OpeningVariable, "A = α cot(α/2)", [0.0, 2.0], 0.2);
const THICKNESS: PlaneAxis = thickness_axis([0.0, 2.2], 0.5);
/// Axis where half arches overturn.
const WIDE: PlaneAxis = PlaneAxis { range: [146.0, 162.0], step: 2.0, ..OPENING };
const WIDE_VARIABLE: PlaneAxis = PlaneAxis { range: [0.4, 1.0], step: 0.1, ..VARIABLE };
const THICK: PlaneAxis = thickness_axis([0.8, 2.2], 0.2);
/// About the ends of rotation.
const NEAR: PlaneAxis = PlaneAxis { range: [143.0, 157.0], step: 2.0, ..OPENING };
const NEAR_THICKNESS: PlaneAxis = thickness_axis([0.6, 1.4], 0.2);

const fn thickness_axis(range: [f64; 2], step: f64) -> PlaneAxis {
    PlaneAxis::new(Coordinate::Thickness, "thickness η = t/r", range, step)
}

fn number(ball: &Ball) -> f64 {
    ball.mid().to_f64()
}

/// Place of a point on an axis, in the unit shown.
fn on(axis: &PlaneAxis, place: &Place) -> Option<f64> {
    let other = |ball: &Option<Ball>| Some(number(ball.as_ref()?) * axis.unit);
    match axis.coordinate {
        Coordinate::Thrust => other(&place.thrust),
        Coordinate::RotationJoint => other(&place.rotation_joint),
        _ => axis.place(place),
    }
}

impl Branches {
    /// The figure of both weights as SVG.
    pub(super) fn svg(self, sheets: &[Sheet], command: &str) -> String {
        let panels = match self {
            Self::Rotation => over_the_half_opening(sheets),
            Self::Overturning => [(WIDE_VARIABLE, Course::FallsOpposite), (WIDE, Course::Rises)]
                .map(|(x, course)| Graph {
                    x,
                    y: THICK,
                    lines: lines(sheets, &[Curve::Overturning], &[x, THICK]),
                    marks: marks(sheets, &ENDS[1..], &[x, THICK], course),
                })
                .into(),
            Self::Joined => joined(sheets),
        };
        let rotation = "Purely rotational and purely sliding states over the half opening";
        let overturning = "Thickness of purely overturning states over A and over the half opening";
        let joined = "Thickness of purely rotational and purely overturning states over A and over the half opening";
        let (title, curves, more, legend_at): (_, &[Curve], _, _) = match self {
            Self::Rotation => {
                let sliding = ("pure sliding, dotted beyond B".to_owned(), SLIDING);
                (rotation, &[Curve::Rotation], Some(sliding), (1, 60.0))
            }
            Self::Overturning => (overturning, &[Curve::Overturning], None, (0, 395.0)),
            Self::Joined => {
                let tangent = ("common tangent at ℓ".to_owned(), TANGENT);
                (joined, &[Curve::Rotation, Curve::Overturning], Some(tangent), (0, 340.0))
            }
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
                " Below, larger: at ℓ rotation and overturning have one slope, which the claims joining-heyman and \
                 joining-milankovitch of couplet prove decide."
            }
            _ => "",
        };
        let off = (&off(&panels)[..], (WIDTH, height(panels.len())));
        let words = caption(title, sheets, off, joins, command);
        Graphs { title, panels, legend, legend_at, words }.svg()
    }
}

/// The joint, the thickness and the thrust of rotation, and the thrust of sliding.
fn over_the_half_opening(sheets: &[Sheet]) -> Vec<Graph> {
    let x = OPENING;
    let joint = PlaneAxis::new(Coordinate::RotationJoint, "joint βᵣ (°)", [0.0, 70.0], 10.0);
    let push = PlaneAxis::new(Coordinate::Thrust, "thrust h = H/(w r)", [0.0, 1.0], 0.2);
    let panel = |y, course| Graph {
        x,
        y,
        lines: lines(sheets, &[Curve::Rotation], &[x, y]),
        marks: marks(sheets, &ENDS[..2], &[x, y], course),
    };
    let mut first = panel(joint, Course::Falls);
    first.marks.extend(widest(sheets));
    let mut last = panel(push, Course::Falls);
    last.lines.extend(sliding(sheets, &[x, push]));
    vec![first, panel(thickness_axis([0.0, 1.1], 0.2), Course::Rises), last]
}

/// Rotation and overturning, over the opening variable, over the half opening, and near the points where they join.
fn joined(sheets: &[Sheet]) -> Vec<Graph> {
    let panel = |x, y, curves: &[Curve], course| Graph {
        x,
        y,
        lines: lines(sheets, &[Curve::Rotation, Curve::Overturning], &[x, y]),
        marks: marks(sheets, curves, &[x, y], course),
    };
    let mut near = panel(NEAR, NEAR_THICKNESS, &ENDS[1..2], Course::Rises);
    near.lines.extend(sheets.iter().filter_map(tangent));
    vec![
        panel(VARIABLE, THICKNESS, &ENDS, Course::FallsOpposite),
        panel(OPENING, THICKNESS, &ENDS, Course::Rises),
        near,
    ]
}

/// The tangent of a weight at the end of rotation: that with which overturning begins.
fn tangent(sheet: &Sheet) -> Option<GraphLine> {
    let chain = along(sheet.trace(Curve::Overturning)?, &[NEAR, NEAR_THICKNESS])?;
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

/// Distance that lines may have from the truth, along each axis.
fn off(panels: &[Graph]) -> Vec<(PlaneAxis, f64)> {
    let of_panel = |panel: &Graph| {
        let [across, up] = panel.off();
        [(panel.x, across), (panel.y, up)]
    };
    panels.iter().flat_map(of_panel).collect()
}

fn along(trace: &Trace, axes: &[PlaneAxis; 2]) -> Option<Chain> {
    Chain::of_pieces(trace.pieces(), &trace.points().first()?.place, axes)
}

fn lines(sheets: &[Sheet], curves: &[Curve], axes: &[PlaneAxis; 2]) -> Vec<GraphLine> {
    let line = |sheet: &Sheet, curve: &Curve| {
        let chain = along(sheet.trace(*curve)?, axes)?;
        let id = format!("{}-{curve}", sheet.weight.name());
        Some(GraphLine { id, chain, stroke: look_of(sheet.weight, *curve) })
    };
    sheets.iter().flat_map(|sheet| curves.iter().filter_map(move |c| line(sheet, c))).collect()
}

/// The thrust of purely sliding states, up to the first border point and beyond.
fn sliding(sheets: &[Sheet], axes: &[PlaneAxis; 2]) -> Vec<GraphLine> {
    let border = sheets.iter().filter_map(|sheet| {
        let trace = sheet.trace(Curve::Limit)?;
        on(&OPENING, &trace.points().first()?.place)
    });
    let border = border.fold(f64::INFINITY, f64::min);
    let trace = sheets.first().and_then(|sheet| sheet.trace(Curve::Sliding));
    let Some(chain) = trace.and_then(|trace| along(trace, axes)) else { return Vec::new() };
    let [before, after] = chain.split(border);
    let line = |id: &str, chain, stroke| GraphLine { id: id.into(), chain, stroke };
    vec![line("sliding", before, SLIDING), line("sliding-beyond", after, BEYOND)]
}

/// Curves that end at T, and at the ends of rotation and overturning.
const ENDS: [Curve; 3] =
    [Curve::Line(crate::problem::Line::RotationShoulder), Curve::Rotation, Curve::Overturning];

/// The landmarks at the ends of some curves.
fn marks(sheets: &[Sheet], curves: &[Curve], [x, y]: &[PlaneAxis; 2], course: Course) -> Vec<Dot> {
    let mark = |sheet: &Sheet, curve: Curve| {
        let point = sheet.trace(curve)?.points().pop()?;
        let Some(CurveEnd::Landmark(landmark)) = point.end else { return None };
        let at = (on(x, &point.place)?, on(y, &point.place)?);
        Some(named(landmark, sheet.weight, at, course))
    };
    sheets.iter().flat_map(|sheet| curves.iter().filter_map(move |c| mark(sheet, *c))).collect()
}

/// Where the rotational joint is widest.
fn widest(sheets: &[Sheet]) -> Vec<Dot> {
    let mark = |sheet: &Sheet| {
        let landmark = Landmark::WidestJoint;
        let refined = CertifiedLandmark::new(landmark, sheet.weight).ok()?.enclosure(64).ok()?;
        let degrees = |unknown| Some(number(&refined.value(unknown)?).to_degrees());
        let at = (degrees(Unknown::HalfOpening)?, degrees(Unknown::RotationJoint)?);
        let mark = named(landmark, sheet.weight, at, Course::Falls);
        // The two are next to each other on top.
        let away = if sheet.weight == SelfWeight::Heyman { (4.0, -12.0) } else { (-6.0, 16.0) };
        Some(Dot { away, ..mark })
    };
    sheets.iter().filter_map(mark).collect()
}

/// Course of a line, and which weight's is the upper one.
#[derive(Clone, Copy)]
enum Course {
    /// Upwards, Milankovitch's above.
    Rises,
    /// Downwards, Heyman's above.
    Falls,
    /// Downwards, Milankovitch's above.
    FallsOpposite,
}

/// The name of a landmark beside its line, away from that of the other weight.
fn named(landmark: Landmark, weight: SelfWeight, at: Point, course: Course) -> Dot {
    let away =
        match (weight, course) {
            (SelfWeight::Milankovitch, Course::Rises) => (-9.0, -8.0),
            (SelfWeight::Heyman, Course::Rises) => (9.0, 10.0),
            (SelfWeight::Milankovitch, Course::Falls)
            | (SelfWeight::Heyman, Course::FallsOpposite) => (-9.0, 12.0),
            (SelfWeight::Heyman, Course::Falls)
            | (SelfWeight::Milankovitch, Course::FallsOpposite) => (8.0, -12.0),
        };
    // At the foot of a panel, a hair above or below it, there is room above only.
    let away = if at.1.abs() < FOOT { (away.0, -14.0) } else { away };
    Dot { name: words::symbol(landmark).to_owned(), at, away, color: look::of_weight(weight).color }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tangent with which overturning begins is the one with which rotation ends, over A and over the half opening.
    #[test]
    fn rotation_and_overturning_have_one_slope_where_they_join() {
        for weight in SelfWeight::ALL {
            let traces = [Curve::Rotation, Curve::Overturning]
                .map(|of| Trace::new(of, weight, 1e-5).unwrap());
            for x in [OPENING, VARIABLE] {
                let [rotation, overturning] =
                    traces.each_ref().map(|trace| along(trace, &[x, THICKNESS]).unwrap());
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
