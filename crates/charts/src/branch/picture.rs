//! Branches as a picture: asymmetric solutions beside the least thickness, as graphs over friction.

use super::{BranchArch, BranchArches};
use crate::arch::asymmetric::AsymmetricMode;
use crate::atlas::{Branch, Coordinate, Level, Meeting};
use crate::caption::told;
use crate::chain::Chain;
use crate::graph::{Graph, GraphLine, Graphs, WIDTH, off, size};
use crate::picture::color::INK;
use crate::picture::room::span;
use crate::picture::{Color, Name, Point, Print, Stroke};
use crate::plane::{PlaneAxis, step};
use crate::report::words::{kind, model};
use std::io;

/// The least thickness.
const LEAST: Stroke = Stroke::new(INK, 1.4);

/// Look of a kind: by dashes too, so that grey is enough.
fn look(kind: AsymmetricMode) -> Stroke {
    let (color, width, dashes): (_, _, &[f64]) = match kind {
        AsymmetricMode::InnerSliding => (Color(0, 0x5A, 0x8C), 2.6, &[]),
        AsymmetricMode::ShoulderOpening => (Color(0xD5, 0x5E, 0), 2.6, &[9.0, 4.0]),
        AsymmetricMode::ShoulderSliding => (Color(0, 0x7A, 0x5A), 2.6, &[3.0, 3.0]),
    };
    Stroke { color, width, dashes }
}

/// A kind of mechanism, of either shoulder.
fn name(mode: AsymmetricMode) -> String {
    kind(mode).replacen("one ", "a ", 1)
}

/// The friction and the thickness of a point.
fn place(meeting: &Meeting) -> Option<Point> {
    let place = meeting.place();
    Some((place.friction?.mid().to_f64(), place.thickness?.mid().to_f64()))
}

/// An axis about a range of values, with room at its ends as shares of it.
fn axis(
    coordinate: Coordinate,
    label: &'static str,
    [least, most]: [f64; 2],
    room: [f64; 2],
) -> PlaneAxis {
    let range = [least - room[0] * (most - least), most + room[1] * (most - least)];
    let step = step(range, 5.0).unwrap_or(1.0);
    PlaneAxis::new(coordinate, label, range, step)
}

/// The branches of one half opening as SVG, that of each weight in a panel with its least thickness.
pub(crate) fn picture(all: &BranchArches, print: &Print) -> io::Result<String> {
    let found = all.arches.iter().filter_map(|arch| arch.found.as_ref().ok());
    let found: Vec<&(Branch, Level)> = found.collect();
    let Some((branch, _)) = found.first() else {
        let why = all.arches.first().and_then(|arch| arch.found.as_ref().err());
        let why = why.map_or_else(String::new, ToString::to_string);
        return Err(io::Error::other(format!("there is nothing to draw: {why}")));
    };
    let weight = |((branch, _), letter): (&&(Branch, Level), char)| match found.len() {
        1 => model(branch.weight),
        _ => format!("{} ({letter})", model(branch.weight)),
    };
    let weights: Vec<String> = found.iter().zip('a'..).map(weight).collect();
    let (half_opening, weights) = (&branch.half_opening, weights.join(" and "));
    let open: Vec<String> = all.arches.iter().flat_map(BranchArch::open).collect();
    let meetings = found.iter().flat_map(|(branch, _)| branch.meetings());
    let points: Vec<Point> = meetings.filter_map(place).collect();
    let across = span(points.iter().map(|point| point.0));
    let x = axis(Coordinate::Friction, "friction coefficient μ", across, [0.12, 0.3]);
    // Above there is room for the legend.
    let up = span(points.iter().map(|point| point.1));
    let y = axis(Coordinate::Thickness, "thickness to radius η = t/r", up, [0.15, 0.75]);
    let panels: Vec<Graph> =
        found.iter().map(|(branch, least)| panel(branch, least, x, y)).collect();
    let mut legend = vec![("least thickness, symmetric".to_owned(), LEAST)];
    for kind in AsymmetricMode::ALL {
        let has = |(branch, _): &&(Branch, Level)| {
            branch.stretches.iter().any(|(_, stretch)| stretch.kind == kind)
        };
        legend.extend(found.iter().any(has).then(|| (name(kind), look(kind))));
    }
    let told = told(&off(&panels), size(panels.len(), print)?);
    let title = "Asymmetric solutions of the complementarity problem without dilatancy";
    let open = match open.is_empty() {
        true => "and each state on the thick lines to be admissible, with a mechanism".to_owned(),
        false => format!("not proved: {}", open.join("; ")),
    };
    let first = x.range[0];
    let legend_at = (0, (20.0 + WIDTH * (across[0] - first) / (x.range[1] - first), 20.0));
    let words = vec![
        format!(
            "{title}, half opening {half_opening}, {weights}. On the thick lines an arch has an admissible state, and \
             also a motion in which friction takes what the weight gives; discs: where a line meets the least \
             thickness, and where the mechanism changes; upright: pure sliding, at any thickness from the least on. \
             {told}, {open}. With Milankovitch's weight there are no others; with Heyman's none at the frictions of \
             the line."
        ),
        format!("Command: {}", all.command),
    ];
    Graphs { title, panels, legend, legend_at, words }.svg(print)
}

fn panel(branch: &Branch, least: &Level, x: PlaneAxis, y: PlaneAxis) -> Graph {
    let axes = [x, y];
    let least = Chain::of_level(least, &axes);
    let least = least.map(|chain| GraphLine { id: "least".to_owned(), chain, stroke: LEAST });
    let parts = branch.stretches.iter().filter_map(|(_, stretch)| {
        let chain = Chain::of_pieces(stretch.section.pieces(), &stretch.section.ends()[0], &axes)?;
        Some(GraphLine { id: stretch.kind.name().to_owned(), chain, stroke: look(stretch.kind) })
    });
    let mark = |meeting: &Meeting| Some(Name::new("", place(meeting)?, (0.0, 0.0)));
    let marks = branch.meetings().filter_map(mark).collect();
    let lines = least.into_iter().chain(parts).collect();
    Graph { x, y, lines, marks, inset: None }
}
