//! Milankovitch's thickness less Heyman's along the dividing curves, `couplet.map_difference/1`.

use super::rows::{lower, upper};
use crate::atlas::{Difference, DifferencePoint, Step};
use crate::difference;
use crate::number::Ball;
use crate::picture::Print;
use crate::picture::text::number;
use crate::problem::Line;
use crate::report::Column::{Double, Integer, Made, Text};
use crate::report::{Content, NamedColumn, Record, Reported, Tabular};
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
    divide: &'static str,
    index: usize,
    point: &'a DifferencePoint,
    step: Option<&'a Step>,
}

impl DifferenceNode<'_> {
    /// The columns of a node. Bounds are rounded outward. Between two nodes the difference is as near as `tube` to the
    /// cubic in the parameter from `begins` to `ends` with these rates at its ends; the friction angle is `chi - sin
    /// chi cos chi`.
    const COLUMNS: [NamedColumn<Self>; 20] = [
        ("divide", Text(|row| Some(row.divide))),
        ("node", Integer(|row| Some(row.index as u64))),
        ("line_heyman", Made(|row| Some(row.step?.lines[0].to_string()))),
        ("line_milankovitch", Made(|row| Some(row.step?.lines[1].to_string()))),
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
    let divide = difference.divide.name();
    let nodes = difference.points().iter().zip(steps).enumerate();
    nodes.map(move |(index, (point, step))| DifferenceNode { divide, index, point, step })
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

const PROVED: &str = "proved: for each friction angle between these, here rounded, the difference is in the tube, and \
                      between its least and its most";

impl Reported for MapDifferences {
    fn content() -> Content {
        Content::DRAWN_RECORDS
    }

    fn records(&self) -> Vec<Record> {
        let mut record = Record::of("couplet.map_difference/1");
        record.say(format!(
            "Thickness of Milankovitch's weight less that of Heyman's at equal friction, along the dividing curves,\n\
             in tubes of a half-width of at most {:?}\n",
            self.tolerance
        ));
        record.say("divide    from    to      least    most     pieces  widest   lines");
        record.add("tolerance", self.tolerance);
        record.add_list("differences", self.differences.iter().map(entry));
        record.say(format!("\n{PROVED}"));
        vec![record]
    }

    fn summary(&self) -> Option<String> {
        let (curves, width) = (self.differences.len(), self.tolerance);
        Some(format!("{curves} curves, in tubes of a half-width of at most {width:?}; {PROVED}"))
    }

    fn tabular(&self) -> Tabular {
        let rows = self.differences.iter().flat_map(rows);
        Tabular::of_columns(DifferenceNode::COLUMNS.iter(), rows)
    }

    fn picture(&self, print: &Print) -> io::Result<String> {
        difference::differences(&self.differences, &self.command, print)
    }
}

fn entry(difference: &Difference) -> Record {
    let points = difference.points();
    let end = |point: Option<&DifferencePoint>| {
        point.map(|point| degrees(&point.friction_angle)).unwrap_or_default()
    };
    let [from, to] = [points.first(), points.last()].map(end);
    let [least, most] = difference.bounds();
    let mut record = Record::default();
    record.say(format!(
        "{:<8}  {from:<6}  {to:<6}  {}  {}  {:<6}  {}  {}",
        difference.divide,
        outward(least, false),
        outward(most, true),
        difference.steps().len(),
        no_less(difference.width()),
        lines(difference).join(", "),
    ));
    record.add("divide", difference.divide.name());
    record.add("lines", lines(difference));
    record.add("parameter", "inclination");
    record.add("pieces", difference.steps().len());
    record.add("widest_tube", difference.width());
    record.add("least", least);
    record.add("most", most);
    let node = |row: DifferenceNode| -> Record {
        // Its curve and its place say the rest.
        let of_node = DifferenceNode::COLUMNS.iter().skip(2);
        of_node.map(|(name, column)| (*name, column.json(&row))).collect()
    };
    record.add_list("nodes", rows(difference).map(node));
    record
}
