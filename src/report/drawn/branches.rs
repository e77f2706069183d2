//! The purely rotational, overturning and sliding states along the half opening: Figures 2 to 4 of the paper.

use super::caption::proved;
use super::chain::{Chain, larger};
use super::graph::{Graphs, Line, Mark, Panel, WIDTH, height};
use super::look;
use super::plane::{Axis, DEGREES};
use super::sheet::Sheet;
use crate::arch::{SelfWeight, Unknown};
use crate::atlas::{Coordinate, Curve, End, Place, Trace};
use crate::certify::CertifiedLandmark;
use crate::number::Ball;
use crate::picture::color::INK;
use crate::picture::{Frame, Point, Stroke};
use crate::problem::Landmark;
use crate::report::words;

/// One of these figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branches {
    /// The rotational joint, the thickness and the thrust over the half opening.
    Rotation,
    /// The thickness over `A = alpha cot(alpha/2)`.
    OpeningVariable,
    /// The thickness over the half opening.
    Opening,
}

/// The purely sliding states, and those beyond the border point.
const SLIDING: Stroke = Stroke::new(INK, 1.6);
const BEYOND: Stroke = Stroke { color: INK, width: 1.6, dashes: &[3.0, 4.0] };
/// What is no further from the foot of a panel is on it.
const FOOT: f64 = 1e-9;

/// An axis of an angle in degrees, or of what else there is.
const fn axis(coordinate: Coordinate, label: &'static str, range: [f64; 2], step: f64) -> Axis {
    let unit = match coordinate {
        Coordinate::HalfOpening | Coordinate::RotationJoint => DEGREES,
        _ => 1.0,
    };
    Axis { coordinate, unit, label, range, step }
}

const OPENING: Axis = axis(Coordinate::HalfOpening, "half opening α (°)", [0.0, 180.0], 20.0);
const THICKNESS: Axis = axis(Coordinate::Thickness, "thickness η = t/r", [0.0, 2.2], 0.5);

fn number(ball: &Ball) -> f64 {
    ball.mid().to_f64()
}

fn opening(place: &Place) -> Option<f64> {
    Some(number(place.half_opening.as_ref()?).to_degrees())
}

fn opening_variable(place: &Place) -> Option<f64> {
    Some(Coordinate::OpeningVariable.drawn(number(place.half_opening.as_ref()?)))
}

fn thickness(place: &Place) -> Option<f64> {
    place.thickness.as_ref().map(number)
}

fn thrust(place: &Place) -> Option<f64> {
    place.thrust.as_ref().map(number)
}

fn rotation_joint(place: &Place) -> Option<f64> {
    Some(number(place.rotation_joint.as_ref()?).to_degrees())
}

type Read = fn(&Place) -> Option<f64>;

impl Branches {
    /// The figure of both weights as SVG.
    pub(super) fn svg(self, sheets: &[Sheet], command: &str) -> String {
        let (title, x, read_x): (&str, Axis, Read) = match self {
            Self::Rotation => (
                "Purely rotational and purely sliding states over the half opening",
                OPENING,
                opening,
            ),
            Self::OpeningVariable => (
                "Thickness of purely rotational and purely overturning states over A",
                axis(Coordinate::OpeningVariable, "A = α cot(α/2)", [0.0, 2.0], 0.2),
                opening_variable,
            ),
            Self::Opening => (
                "Thickness of purely rotational and purely overturning states over the half opening",
                OPENING,
                opening,
            ),
        };
        let course = if self == Self::Opening { Course::Rises } else { Course::FallsOpposite };
        let panels: Vec<Panel> = match self {
            Self::Rotation => {
                let joint = axis(Coordinate::RotationJoint, "joint βᵣ (°)", [0.0, 70.0], 10.0);
                let thick = axis(Coordinate::Thickness, "thickness η = t/r", [0.0, 1.1], 0.2);
                let push = axis(Coordinate::Thrust, "thrust h = H/(w r)", [0.0, 1.0], 0.2);
                let panel = |y, read, course| Panel {
                    y,
                    lines: lines(sheets, &[Curve::Rotation], &[x, y]),
                    marks: marks(sheets, &ENDS[..2], read_x, read, course),
                };
                let mut first = panel(joint, rotation_joint as Read, Course::Falls);
                first.marks.extend(widest(sheets));
                let mut last = panel(push, thrust as Read, Course::Falls);
                last.lines.extend(sliding(sheets, &[x, push]));
                vec![first, panel(thick, thickness as Read, Course::Rises), last]
            }
            Self::OpeningVariable | Self::Opening => vec![Panel {
                y: THICKNESS,
                lines: lines(sheets, &[Curve::Rotation, Curve::Overturning], &[x, THICKNESS]),
                marks: marks(sheets, &ENDS, read_x, thickness, course),
            }],
        };
        let names =
            sheets.iter().map(|sheet| (words::model(sheet.weight), look::of_weight(sheet.weight)));
        let pure = ("pure sliding, dotted beyond B".to_owned(), SLIDING);
        let legend = names.chain((self == Self::Rotation).then_some(pure)).collect();
        let legend_at = match self {
            Self::Rotation => (1, 60.0),
            Self::OpeningVariable => (0, 400.0),
            Self::Opening => (0, 30.0),
        };
        let sheets: Vec<&Sheet> = sheets.iter().collect();
        let proved = proved(&sheets, &off(x, &panels), (WIDTH, height(panels.len())));
        let words = vec![format!("{title}. {proved}"), format!("Command: {command}")];
        Graphs { title, x, panels, legend, legend_at, words }.svg()
    }
}

/// How far lines may be from the truth, along each axis.
fn off(x: Axis, panels: &[Panel]) -> Vec<(Axis, f64)> {
    let of_panel = |panel: &Panel| {
        let frame = Frame { corner: (0.0, 0.0), size: (1.0, 1.0), x: x.range, y: panel.y.range };
        let chains = panel.lines.iter().map(|line| &line.chain);
        let [across, up] = chains.map(|chain| chain.off(&frame)).fold([0.0; 2], larger);
        [(x, across), (panel.y, up)]
    };
    panels.iter().flat_map(of_panel).collect()
}

fn along(trace: &Trace, axes: &[Axis; 2]) -> Option<Chain> {
    Chain::of_pieces(trace.pieces(), &trace.points().first()?.place, axes)
}

fn lines(sheets: &[Sheet], curves: &[Curve], axes: &[Axis; 2]) -> Vec<Line> {
    let line = |sheet: &Sheet, curve: &Curve| {
        let chain = along(sheet.trace(*curve)?, axes)?;
        let id = format!("{}-{curve}", sheet.weight.name());
        Some(Line { id, chain, stroke: look::of_weight(sheet.weight) })
    };
    sheets.iter().flat_map(|sheet| curves.iter().filter_map(move |c| line(sheet, c))).collect()
}

/// The thrust of purely sliding states, up to the first border point and beyond.
fn sliding(sheets: &[Sheet], axes: &[Axis; 2]) -> Vec<Line> {
    let border = sheets.iter().filter_map(|sheet| {
        let trace = sheet.trace(Curve::Limit)?;
        opening(&trace.points().first()?.place)
    });
    let border = border.fold(f64::INFINITY, f64::min);
    let trace = sheets.first().and_then(|sheet| sheet.trace(Curve::Sliding));
    let Some(chain) = trace.and_then(|trace| along(trace, axes)) else { return Vec::new() };
    let [before, after] = chain.split(border);
    let line = |id: &str, chain, stroke| Line { id: id.into(), chain, stroke };
    vec![line("sliding", before, SLIDING), line("sliding-beyond", after, BEYOND)]
}

/// Curves that end at T, and at the ends of rotation and overturning.
const ENDS: [Curve; 3] =
    [Curve::Line(crate::problem::Line::RotationShoulder), Curve::Rotation, Curve::Overturning];

/// The landmarks at the ends of some curves.
fn marks(sheets: &[Sheet], curves: &[Curve], x: Read, y: Read, course: Course) -> Vec<Mark> {
    let mark = |sheet: &Sheet, curve: Curve| {
        let point = sheet.trace(curve)?.points().pop()?;
        let Some(End::Landmark(landmark)) = point.end else { return None };
        let at = (x(&point.place)?, y(&point.place)?);
        Some(named(landmark, sheet.weight, at, course))
    };
    sheets.iter().flat_map(|sheet| curves.iter().filter_map(move |c| mark(sheet, *c))).collect()
}

/// Where the rotational joint is widest.
fn widest(sheets: &[Sheet]) -> Vec<Mark> {
    let mark = |sheet: &Sheet| {
        let landmark = Landmark::WidestJoint;
        let refined = CertifiedLandmark::new(landmark, sheet.weight).ok()?.enclosure(64).ok()?;
        let degrees = |unknown| Some(number(&refined.value(unknown)?).to_degrees());
        let at = (degrees(Unknown::HalfOpening)?, degrees(Unknown::RotationJoint)?);
        let mark = named(landmark, sheet.weight, at, Course::Falls);
        // The two are next to each other on top.
        let away = if sheet.weight == SelfWeight::Heyman { (4.0, -12.0) } else { (-6.0, 16.0) };
        Some(Mark { away, ..mark })
    };
    sheets.iter().filter_map(mark).collect()
}

/// How a line runs, and which weight's is the upper one.
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
fn named(landmark: Landmark, weight: SelfWeight, at: Point, course: Course) -> Mark {
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
    Mark {
        name: words::symbol(landmark).to_owned(),
        at,
        away,
        color: look::of_weight(weight).color,
    }
}
