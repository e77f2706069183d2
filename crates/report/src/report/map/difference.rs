//! Milankovitch's thickness less Heyman's along the dividing curves: for a person, CSV, and JSON
//! (`couplet.map_difference/1`).

use super::rows::{lower, upper};
use crate::atlas::{Difference, DifferencePoint, Step};
use crate::number::Ball;
use crate::picture::text::number;
use crate::problem::Line;
use crate::report::column::Column::{Double, Text};
use crate::report::column::NamedColumn;
use crate::report::fields::Fields;
use crate::report::{csv, json};
use std::io;

/// The differences along all dividing curves.
#[derive(Debug)]
pub struct MapDifferences {
    /// The half-width of a tube that was asked for.
    pub tolerance: f64,
    /// Each curve.
    pub differences: Vec<Difference>,
    /// The command that makes it, for a caption.
    pub command: String,
}

/// A node with the step that begins there; behind the last node there is none.
struct DifferenceNode<'a> {
    point: &'a DifferencePoint,
    step: Option<&'a Step>,
    /// The lines of each weight on it.
    lines: Option<[String; 2]>,
}

impl DifferenceNode<'_> {
    /// The columns of a node. Bounds are rounded outward. Between two nodes the difference is as near as `tube` to the
    /// cubic in the parameter from `begins` to `ends` with these rates at its ends; the friction angle is `chi - sin
    /// chi cos chi`.
    const COLUMNS: [NamedColumn<Self>; 18] = [
        ("line_heyman", Text(|row| Some(&row.lines.as_ref()?[0]))),
        ("line_milankovitch", Text(|row| Some(&row.lines.as_ref()?[1]))),
        ("parameter", Double(|row| Some(row.point.parameter))),
        ("friction_angle_lower", Double(|row| lower(Some(&row.point.friction_angle)))),
        ("friction_angle_upper", Double(|row| upper(Some(&row.point.friction_angle)))),
        ("friction_lower", Double(|row| lower(Some(&row.point.friction)))),
        ("friction_upper", Double(|row| upper(Some(&row.point.friction)))),
        ("thickness_heyman_lower", Double(|row| lower(Some(&row.point.thickness[0])))),
        ("thickness_heyman_upper", Double(|row| upper(Some(&row.point.thickness[0])))),
        ("thickness_milankovitch_lower", Double(|row| lower(Some(&row.point.thickness[1])))),
        ("thickness_milankovitch_upper", Double(|row| upper(Some(&row.point.thickness[1])))),
        ("difference_lower", Double(|row| lower(Some(&row.point.difference)))),
        ("difference_upper", Double(|row| upper(Some(&row.point.difference)))),
        ("begins", Double(|row| Some(row.step?.difference.values[0]))),
        ("begins_rate", Double(|row| Some(row.step?.difference.slopes[0]))),
        ("ends", Double(|row| Some(row.step?.difference.values[1]))),
        ("ends_rate", Double(|row| Some(row.step?.difference.slopes[1]))),
        ("tube", Double(|row| Some(row.step?.difference.off))),
    ];
}

fn rows(difference: &Difference) -> impl Iterator<Item = DifferenceNode<'_>> {
    let steps = difference.steps().iter().map(Some).chain([None]);
    difference.points().iter().zip(steps).map(|(point, step)| {
        let lines = step.map(|step| step.lines.each_ref().map(Line::to_string));
        DifferenceNode { point, step, lines }
    })
}

/// The lines of a curve, in order.
fn lines(difference: &Difference) -> Vec<String> {
    difference.divide.lines().iter().map(Line::to_string).collect()
}

/// Degrees of a friction angle, for a person.
fn degrees(phi: &Ball) -> String {
    format!("{}°", number(phi.mid().to_f64().to_degrees(), 1))
}

/// A bound of the difference to four decimals, rounded outward.
fn outward(bound: f64, is_upper: bool) -> String {
    let units = bound * 1e4;
    let whole = if is_upper { (units + 1e-9).ceil() } else { (units - 1e-9).floor() };
    format!("{:+.4}", whole / 1e4 + 0.0)
}

/// A width to two digits, rounded up.
fn no_less(width: f64) -> String {
    let text = format!("{width:.1e}");
    // A tenth more is more by two units of the last digit at least.
    match text.parse::<f64>() {
        Ok(shown) if shown >= width => text,
        _ => format!("{:.1e}", width * 1.1),
    }
}

pub(in crate::report) fn table(report: &MapDifferences, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(
        out,
        "Thickness of Milankovitch's weight less that of Heyman's at equal friction, along the dividing curves,\n\
         in tubes of a half-width of at most {:?}\n",
        report.tolerance
    )?;
    writeln!(out, "divide    from    to      least    most     pieces  widest   lines")?;
    for difference in &report.differences {
        let points = difference.points();
        let end = |point: Option<&DifferencePoint>| {
            point.map(|point| degrees(&point.friction_angle)).unwrap_or_default()
        };
        let [from, to] = [points.first(), points.last()].map(end);
        let [least, most] = difference.bounds();
        writeln!(
            out,
            "{:<8}  {from:<6}  {to:<6}  {}  {}  {:<6}  {}  {}",
            difference.divide,
            outward(least, false),
            outward(most, true),
            difference.steps().len(),
            no_less(difference.width()),
            lines(difference).join(", "),
        )?;
    }
    writeln!(
        out,
        "\nproved: for each friction angle between these, here rounded, the difference is in the tube, and between \
         its least and its most"
    )
}

pub(in crate::report) fn csv(report: &MapDifferences, out: &mut dyn io::Write) -> io::Result<()> {
    let names = DifferenceNode::COLUMNS.iter().map(|(name, _)| *name);
    let header = ["divide", "node"].into_iter().chain(names).map(str::to_owned).collect();
    let rows = report.differences.iter().flat_map(|difference| {
        rows(difference).enumerate().map(|(node, row)| {
            let cells = DifferenceNode::COLUMNS.iter().map(|(_, column)| column.text(&row));
            [difference.divide.to_string(), node.to_string()].into_iter().chain(cells).collect()
        })
    });
    csv::write(std::iter::once(header).chain(rows), out)
}

pub(in crate::report) fn json(report: &MapDifferences, out: &mut dyn io::Write) -> io::Result<()> {
    let node = |row: DifferenceNode| -> Fields {
        DifferenceNode::COLUMNS.iter().map(|(name, column)| (*name, column.json(&row))).collect()
    };
    let entry = |difference: &Difference| {
        let [least, most] = difference.bounds();
        let mut fields = Fields::default();
        fields.add("divide", difference.divide.name());
        fields.add("lines", lines(difference));
        fields.add("parameter", "inclination");
        fields.add("pieces", difference.steps().len());
        fields.add("widest_tube", difference.width());
        fields.add("least", least);
        fields.add("most", most);
        fields.add_list("nodes", rows(difference).map(node));
        fields
    };
    let mut file = Fields::of("couplet.map_difference/1");
    file.add("tolerance", report.tolerance);
    file.add_list("differences", report.differences.iter().map(entry));
    json::write(&file, out)
}
