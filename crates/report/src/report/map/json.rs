//! JSON: the curves with their nodes, and the domains as loops of curves.

use super::Map;
use super::domains::domains;
use super::rows::{MapRow, weight_of};
use crate::atlas::{Border, Level, Part, Trace, Variable};
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
    let part = |part: &Part| {
        let mut fields = Fields::default();
        fields.add("mode", part.mode.label());
        fields.add("parameter", part.parameter().map(Variable::name));
        fields.add_list("nodes", MapRow::of_part(level, part).iter().map(node));
        fields
    };
    let given = |variable| (level.contour.variable() == variable).then(|| level.contour.given());
    let mut fields = Fields::default();
    fields.add("weight", level.weight.name());
    fields.add("half_opening", given(Variable::HalfOpening));
    fields.add("thickness", given(Variable::Thickness));
    fields.add("friction", given(Variable::FrictionAngle));
    fields.add_list("parts", level.parts.iter().map(part));
    fields
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
