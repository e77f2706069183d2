//! JSON: the curves with their nodes, and the domains as loops of curves.

use super::Map;
use super::domains::domains;
use super::rows::{COLUMNS, Column, Row, weight_of};
use crate::atlas::{Border, Level, Part, Trace, Variable};
use crate::report::fields::Fields;
use crate::report::json;
use serde::Serialize;
use serde_json::Value as Json;
use std::io;

#[derive(Serialize)]
struct MapFile {
    schema: &'static str,
    tolerance: f64,
    curves: Vec<CurveEntry>,
    levels: Vec<LevelEntry>,
    asymmetric: Vec<BorderEntry>,
    domains: Vec<Fields>,
}

#[derive(Serialize)]
struct CurveEntry {
    weight: Option<&'static str>,
    curve: String,
    parameter: &'static str,
    from: String,
    to: String,
    pieces: usize,
    widest_tube: f64,
    gaps: Vec<[f64; 2]>,
    nodes: Vec<Fields>,
}

impl CurveEntry {
    fn new(trace: &Trace) -> Self {
        let [from, to] = trace.curve.ends().map(|end| end.to_string());
        Self {
            weight: weight_of(trace),
            curve: trace.curve.to_string(),
            parameter: trace.curve.parameter().name(),
            from,
            to,
            pieces: trace.pieces().count(),
            widest_tube: trace.width(),
            gaps: trace.gaps().map(|gap| gap.range()).collect(),
            nodes: Row::of_trace(trace).iter().map(node).collect(),
        }
    }
}

#[derive(Serialize)]
struct LevelEntry {
    weight: &'static str,
    half_opening: Option<String>,
    thickness: Option<String>,
    friction: Option<String>,
    parts: Vec<PartEntry>,
}

#[derive(Serialize)]
struct PartEntry {
    mode: &'static str,
    parameter: Option<&'static str>,
    nodes: Vec<Fields>,
}

impl LevelEntry {
    fn new(level: &Level) -> Self {
        let part = |part: &Part| PartEntry {
            mode: part.mode.label(),
            parameter: part.parameter().map(Variable::name),
            nodes: Row::of_part(level, part).iter().map(node).collect(),
        };
        let given =
            |variable| (level.contour.variable() == variable).then(|| level.contour.given());
        Self {
            weight: level.weight.name(),
            half_opening: given(Variable::HalfOpening),
            thickness: given(Variable::Thickness),
            friction: given(Variable::FrictionAngle),
            parts: level.parts.iter().map(part).collect(),
        }
    }
}

#[derive(Serialize)]
struct BorderEntry {
    weight: &'static str,
    line: String,
    parameter: &'static str,
    pieces: usize,
    widest_tube: f64,
    nodes: Vec<Fields>,
}

impl BorderEntry {
    fn new(border: &Border) -> Self {
        Self {
            weight: border.weight.name(),
            line: border.line.name(),
            parameter: Variable::HalfOpening.name(),
            pieces: border.section.pieces().count(),
            widest_tube: border.section.width(),
            nodes: Row::of_border(border).iter().map(node).collect(),
        }
    }
}

/// An infinite number is the text `inf`.
fn number(x: f64) -> Json {
    if x.is_finite() { x.into() } else { "inf".into() }
}

/// What the rows say of a node, without what the curve says.
pub(in crate::report) fn node(row: &Row) -> Fields {
    let of_node =
        COLUMNS.iter().filter(|(name, _)| !["weight", "curve", "mode", "node"].contains(name));
    let field = |(name, column): &(&'static str, Column)| {
        let value: Option<Json> = match column {
            Column::Text(cell) => cell(row).map(Json::from),
            Column::Double(cell) => cell(row).map(number),
            Column::Integer(cell) => cell(row).map(Json::from),
            Column::Truth(cell) => cell(row).map(Json::from),
        };
        (*name, value.unwrap_or_default())
    };
    of_node.map(field).collect()
}

/// The curves and the domains.
pub(in crate::report) fn json(report: &Map, out: &mut dyn io::Write) -> io::Result<()> {
    let file = MapFile {
        schema: "couplet.map/1",
        tolerance: report.tolerance,
        curves: report.traces.iter().map(CurveEntry::new).collect(),
        levels: report.levels.iter().map(LevelEntry::new).collect(),
        asymmetric: report.borders.iter().map(BorderEntry::new).collect(),
        domains: domains(),
    };
    json::write(&file, out)
}
