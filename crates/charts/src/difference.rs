//! Difference between two weights in the lines between modes, as graphs over the friction angle.

use super::caption::told;
use super::chain::{Arc, Chain};
use super::graph::{Graph, GraphLine, Graphs, off, size};
use super::look::mark;
use super::plane::{DEGREES, Plane, PlaneAxis};
use crate::arch::SelfWeight;
use crate::atlas::{Coordinate, Difference, Divide, Step};
use crate::picture::color::INK;
use crate::picture::{Color, Name, Point, Print, Stroke};
use crate::problem::Landmark;
use crate::report::words;
use std::io;

/// The difference, from below all of them to above, and where most of them are.
const ALL: PlaneAxis = PlaneAxis::new(Coordinate::Thickness, "ηₘ − ηₕ", [-0.2, 1.0], 0.2);
const NEAR: PlaneAxis = PlaneAxis { range: [-0.08, 0.08], step: 0.02, ..ALL };

/// Look of a curve: by dashes too, so that grey is enough.
fn look(divide: Divide) -> Stroke {
    let (color, width, dashes): (_, _, &[f64]) = match divide {
        Divide::Shoulder => (Color(0, 0x5A, 0x8C), 2.2, &[]),
        Divide::Inner => (Color(0xD5, 0x5E, 0), 2.2, &[9.0, 4.0]),
        Divide::Joints => (Color(0, 0x7A, 0x5A), 2.0, &[3.0, 3.0]),
        Divide::Crown => (INK, 1.4, &[]),
    };
    Stroke { color, width, dashes }
}

fn name(divide: Divide) -> &'static str {
    match divide {
        Divide::Shoulder => "shoulder slides | turns, to B",
        Divide::Inner => "inner joint slides | crown turns, to ℓ",
        Divide::Joints => "[r,r,s] | [r,s,r], from S to ℓ",
        Divide::Crown => "[r,s,r] | [r,s], from J to ℓ",
    }
}

/// Bézier's arc of a step; the friction angle in degrees.
fn drawn(step: &Step) -> Arc {
    let third = (step.range[1] - step.range[0]) / 3.0;
    let phi = step.friction_angle;
    let ([from, to], [first, last]) = (phi.values, phi.slopes);
    let across = [from, from + third * first, to - third * last, to].map(|x| x * DEGREES);
    let up = step.handles();
    Arc {
        corners: [0, 1, 2, 3].map(|k| (across[k], up[k])),
        is_proved: true,
        off: [phi.off, step.difference.off],
    }
}

/// Place of a landmark of a weight on a curve.
fn place(difference: &Difference, chi: f64) -> Option<Point> {
    let is_over = |step: &&Step| (step.range[0]..=step.range[1]).contains(&chi);
    let step = difference.steps().iter().find(is_over)?;
    let [from, .., to] = drawn(step).corners;
    // It is at an end of a step, or as near to one as doubles are.
    Some(if chi - step.range[0] < step.range[1] - chi { from } else { to })
}

/// The landmarks of the panel of all or of the larger one, where there is room for their names.
fn marks(differences: &[Difference], is_larger: bool) -> Vec<Name> {
    let marks = |difference: &Difference| -> Vec<Name> {
        let dot = |(landmark, weight, chi): &(Landmark, SelfWeight, f64)| {
            let (name, away) = named((*landmark, *weight), difference.divide, is_larger)?;
            Some(Name::new(name, place(difference, *chi)?, away))
        };
        difference.landmarks().iter().filter_map(dot).collect()
    };
    differences.iter().flat_map(marks).collect()
}

/// The name of a landmark, and where it stands from there, off the lines; what is close to another has none.
fn named(
    (landmark, weight): (Landmark, SelfWeight),
    divide: Divide,
    is_larger: bool,
) -> Option<(String, Point)> {
    use {Divide as D, Landmark as L, SelfWeight as W};
    let (symbol, away) = match (landmark, divide, weight) {
        (L::Border, ..) if !is_larger => ("B", (-9.0, 9.0)),
        (L::Shift, D::Shoulder, _) if !is_larger => ("S, J", (-9.0, -5.0)),
        (L::Junction, D::Shoulder, _) if !is_larger => ("", (0.0, 0.0)),
        (L::Triple, D::Shoulder, _) if is_larger => ("T", (-9.0, -5.0)),
        (L::Triple, D::Inner, W::Heyman) if is_larger => ("T", (7.0, -13.0)),
        (L::Triple, D::Inner, W::Milankovitch) if is_larger => ("T", (-9.0, 13.0)),
        (L::Shift, D::Joints, _) if is_larger => ("S, J", (-9.0, 1.0)),
        (L::Junction, D::Crown, _) if is_larger => ("", (0.0, 0.0)),
        (L::RotationEnd, D::Crown, W::Heyman) => {
            return Some((words::symbol(landmark).to_owned(), (10.0, 0.0)));
        }
        _ => return None,
    };
    let of = mark(weight);
    let names = symbol.split(", ").filter(|name| !name.is_empty());
    Some((names.map(|name| format!("{name}{of}")).collect::<Vec<_>>().join(", "), away))
}

/// The graphs of all curves as SVG.
pub(crate) fn differences(
    differences: &[Difference],
    command: &str,
    print: &Print,
) -> io::Result<String> {
    let [x, _] = Plane::ThicknessFriction.axes();
    let line = |difference: &Difference| GraphLine {
        id: format!("difference-{}", difference.divide),
        chain: Chain(difference.steps().iter().map(drawn).collect()),
        stroke: look(difference.divide),
    };
    let panel = |(y, is_larger)| {
        let lines = differences.iter().map(line).collect();
        Graph { x, y, lines, marks: marks(differences, is_larger), inset: None }
    };
    let panels: Vec<Graph> = [(ALL, false), (NEAR, true)].map(panel).into();
    let title = "The thickness on the lines between the modes for Milankovitch-like self-weight less that for \
                 Heyman-like self-weight, at equal friction";
    let told = told(&off(&panels), size(panels.len(), print)?);
    let words = vec![
        format!(
            "{title}; below the same, larger. The landmarks of the two weights (ₕ, ₘ) are at different frictions; \
             between them one weight is on the next line already. {told}; nothing is left open."
        ),
        format!("Command: {command}"),
    ];
    let legend = Divide::ALL.map(|divide| (name(divide).to_owned(), look(divide))).to_vec();
    Graphs { title, panels, legend, legend_at: (0, (60.0, 20.0)), words }.svg(print)
}
