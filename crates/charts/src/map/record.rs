//! The record of a map: the curves with their nodes, and the domains as loops of curves.

use super::rows::{MapRow, weight_of};
use super::{Map, page, words};
use crate::atlas::{Border, Corner, DomainSide, Level, Trace, Variable, boundary};
use crate::picture::Print;
use crate::problem::Mode;
use crate::report::{Content, Format, Record, Reported, Tabular, parquet_rows};
use std::io;

impl Reported for Map {
    fn content() -> Content {
        Content(&[
            "table", "json", "csv", "csv2", "latex", "markdown", "parquet", "html", "svg", "png",
            "pdf",
        ])
    }

    fn records(&self) -> Vec<Record> {
        vec![of(self)]
    }

    /// A row for each node.
    fn tabular(&self) -> Tabular {
        Tabular::of_columns(MapRow::COLUMNS.iter(), MapRow::of_map(self))
    }

    fn summary(&self) -> Option<String> {
        Some(words::summary(self))
    }

    fn picture(&self, print: &Print) -> io::Result<String> {
        self.drawing.svg((&self.traces, &self.levels, &self.borders), print)
    }

    fn write_as(&self, format: &Format, out: &mut dyn io::Write) -> Option<io::Result<()>> {
        match format.name {
            "html" => Some(page::html(self, out)),
            "parquet" => Some(parquet(self, out)),
            _ => None,
        }
    }
}

/// The nodes of a map, in one group.
fn parquet(report: &Map, out: &mut dyn io::Write) -> io::Result<()> {
    let notes =
        [("schema", "couplet.map/1".to_owned()), ("tolerance", format!("{:?}", report.tolerance))];
    parquet_rows(&MapRow::COLUMNS, &MapRow::of_map(report), notes, out)
}

fn curve(trace: &Trace) -> Record {
    let [from, to] = trace.curve.ends().map(|end| end.to_string());
    let mut record = Record::default();
    record.add("weight", weight_of(trace.curve, trace.weight));
    record.add("curve", trace.curve.to_string());
    record.add("parameter", trace.curve.parameter().name());
    record.add("from", from);
    record.add("to", to);
    record.add("pieces", trace.pieces().count());
    record.add("widest_tube", trace.width());
    record.add("gaps", trace.gaps().map(|gap| gap.range().to_vec()).collect::<Vec<_>>());
    record.add_list("nodes", MapRow::of_trace(trace).iter().map(node));
    record
}

fn level(level: &Level) -> Record {
    let given = |variable| (level.contour.variable() == variable).then(|| level.contour.given());
    let mut record = Record::default();
    record.add("weight", level.weight.name());
    record.add("half_opening", given(Variable::HalfOpening));
    record.add("thickness", given(Variable::Thickness));
    record.add("friction", given(Variable::FrictionAngle));
    record.add_list("parts", parts(level));
    record
}

/// Parts of a level with their nodes.
pub(crate) fn parts(level: &Level) -> impl Iterator<Item = Record> {
    level.parts.iter().map(|part| {
        let mut record = Record::default();
        record.add("mode", part.mode.label());
        record.add("parameter", part.parameter().map(Variable::name));
        record.add_list("nodes", MapRow::of_part(level, part).iter().map(node));
        record
    })
}

fn border(border: &Border) -> Record {
    let mut record = Record::default();
    record.add("weight", border.weight.name());
    record.add("line", border.line.name());
    record.add("parameter", Variable::HalfOpening.name());
    record.add("pieces", border.section.pieces().count());
    record.add("widest_tube", border.section.width());
    record.add_list("nodes", MapRow::of_border(border).iter().map(node));
    record
}

/// The fields of a node, without what the curve says.
pub(crate) fn node(row: &MapRow) -> Record {
    let named_before = ["weight", "curve", "mode", "node"];
    let of_node = MapRow::COLUMNS.iter().filter(|(name, _)| !named_before.contains(name));
    of_node.map(|(name, column)| (*name, column.json(row))).collect()
}

fn corner(corner: Corner) -> String {
    match corner {
        Corner::End(end) => end.to_string(),
        Corner::RightBottom => "phi = pi/2, eta = 0".to_owned(),
        Corner::RightTop => "phi = pi/2, eta = 2".to_owned(),
        Corner::LeftTop => "phi = 0, eta = 2".to_owned(),
    }
}

fn side(side: DomainSide) -> Record {
    let mut record = Record::default();
    let [from, to] = side.ends().map(corner);
    let (curve, is_forward) = match side {
        DomainSide::Along(curve) => (Some(curve), true),
        DomainSide::Back(curve) => (Some(curve), false),
        DomainSide::Edge(..) => (None, true),
    };
    record.add("curve", curve.map(|curve| curve.to_string()));
    record.add("forward", is_forward);
    record.add("from", from);
    record.add("to", to);
    record
}

/// Each mode with the sides of its domain in the plane of friction angle and thickness.
fn domains() -> Vec<Record> {
    let domain = |mode: Mode| {
        let mut record = Record::default();
        record.add("mode", mode.label());
        record.add_list("boundary", boundary(mode).into_iter().map(side));
        record
    };
    Mode::ALL.into_iter().map(domain).collect()
}

/// The curves and the domains.
fn of(report: &Map) -> Record {
    let mut record = Record::of("couplet.map/1");
    words::say(report, &mut record);
    record.add("tolerance", report.tolerance);
    record.add_list("curves", report.traces.iter().map(curve));
    record.add_list("levels", report.levels.iter().map(level));
    record.add_list("asymmetric", report.borders.iter().map(border));
    record.add_list("domains", domains());
    record
}
