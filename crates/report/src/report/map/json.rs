//! JSON: the curves with their nodes, and the domains as loops of curves.

use super::Map;
use super::rows::{MapRow, weight_of};
use crate::atlas::{Border, Corner, DomainSide, Level, Trace, Variable, boundary};
use crate::problem::Mode;
use crate::report::fields::Fields;
use crate::report::json;
use std::io;

fn curve(trace: &Trace) -> Fields {
    let [from, to] = trace.curve.ends().map(|end| end.to_string());
    let mut fields = Fields::default();
    fields.add("weight", weight_of(trace));
    fields.add("curve", trace.curve.to_string());
    fields.add("parameter", trace.curve.parameter().name());
    fields.add("from", from);
    fields.add("to", to);
    fields.add("pieces", trace.pieces().count());
    fields.add("widest_tube", trace.width());
    fields.add("gaps", trace.gaps().map(|gap| gap.range().to_vec()).collect::<Vec<_>>());
    fields.add_list("nodes", MapRow::of_trace(trace).iter().map(node));
    fields
}

fn level(level: &Level) -> Fields {
    let given = |variable| (level.contour.variable() == variable).then(|| level.contour.given());
    let mut fields = Fields::default();
    fields.add("weight", level.weight.name());
    fields.add("half_opening", given(Variable::HalfOpening));
    fields.add("thickness", given(Variable::Thickness));
    fields.add("friction", given(Variable::FrictionAngle));
    fields.add_list("parts", parts(level));
    fields
}

/// Parts of a level with their nodes.
pub(in crate::report) fn parts(level: &Level) -> impl Iterator<Item = Fields> {
    level.parts.iter().map(|part| {
        let mut fields = Fields::default();
        fields.add("mode", part.mode.label());
        fields.add("parameter", part.parameter().map(Variable::name));
        fields.add_list("nodes", MapRow::of_part(level, part).iter().map(node));
        fields
    })
}

fn border(border: &Border) -> Fields {
    let mut fields = Fields::default();
    fields.add("weight", border.weight.name());
    fields.add("line", border.line.name());
    fields.add("parameter", Variable::HalfOpening.name());
    fields.add("pieces", border.section.pieces().count());
    fields.add("widest_tube", border.section.width());
    fields.add_list("nodes", MapRow::of_border(border).iter().map(node));
    fields
}

/// Fields of the rows on a node, without what the curve says.
pub(in crate::report) fn node(row: &MapRow) -> Fields {
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

fn side(side: DomainSide) -> Fields {
    let mut fields = Fields::default();
    let [from, to] = side.ends().map(corner);
    let (curve, is_forward) = match side {
        DomainSide::Along(curve) => (Some(curve), true),
        DomainSide::Back(curve) => (Some(curve), false),
        DomainSide::Edge(..) => (None, true),
    };
    fields.add("curve", curve.map(|curve| curve.to_string()));
    fields.add("forward", is_forward);
    fields.add("from", from);
    fields.add("to", to);
    fields
}

/// Each mode with the sides of its domain in the plane of friction angle and thickness.
fn domains() -> Vec<Fields> {
    let domain = |mode: Mode| {
        let mut fields = Fields::default();
        fields.add("mode", mode.label());
        fields.add_list("boundary", boundary(mode).into_iter().map(side));
        fields
    };
    Mode::ALL.into_iter().map(domain).collect()
}

/// The curves and the domains.
pub(in crate::report) fn json(report: &Map, out: &mut dyn io::Write) -> io::Result<()> {
    let mut file = Fields::of("couplet.map/1");
    file.add("tolerance", report.tolerance);
    file.add_list("curves", report.traces.iter().map(curve));
    file.add_list("levels", report.levels.iter().map(level));
    file.add_list("asymmetric", report.borders.iter().map(border));
    file.add_list("domains", domains());
    json::write(&file, out)
}
