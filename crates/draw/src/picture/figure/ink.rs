//! The colour, dashes and marker of a line.

use super::panel::{Kind, PlottedLine};
use crate::picture::color::{Color, OKABE_ITO, WHITE};
use crate::picture::{Path, Point, Stroke, Svg};

/// Lengths of strokes and gaps in turn. None is a whole line.
const DASHES: [&[f64]; 5] = [&[], &[9.0, 3.0], &[15.0, 3.0, 3.0, 3.0], &[4.0, 2.5], &[18.0, 5.0]];
/// A disc, an open square, a triangle, an open diamond, a cross, a square, an open triangle and a ring.
const MARKERS: [Marker; 8] = [
    |svg, at, color| svg.disc(at, 4.2, color),
    |svg, at, color| open(svg, &outline(at, &square(3.6)), color),
    |svg, at, color| svg.fill(&outline(at, &triangle(5.6)), color),
    |svg, at, color| {
        let diamond = [(0.0, -5.2), (4.6, 0.0), (0.0, 5.2), (-4.6, 0.0)];
        open(svg, &outline(at, &diamond), color);
    },
    |svg, (x, y), color| {
        let mut cross = Path::through([(x - 3.8, y - 3.8), (x + 3.8, y + 3.8)]);
        cross.start((x - 3.8, y + 3.8));
        cross.line((x + 3.8, y - 3.8));
        svg.stroke(&cross, Stroke::new(color, 2.2));
    },
    |svg, at, color| svg.fill(&outline(at, &square(3.9)), color),
    |svg, at, color| open(svg, &outline(at, &triangle(-5.2)), color),
    |svg, at, color| {
        svg.disc(at, 4.8, color);
        svg.disc(at, 3.2, WHITE);
    },
];
/// References, in turn.
const REFERENCES: [&[f64]; 3] = [&[7.0, 5.0], &[2.0, 4.0], &[12.0, 4.0, 2.0, 4.0]];
const REFERENCE: Color = Color(0x77, 0x77, 0x77);

/// Draws a marker at a point.
type Marker = fn(&mut Svg, Point, Color);

/// Look of a line.
#[derive(Clone, Copy)]
pub(super) struct Ink {
    stroke: Stroke,
    marker: Option<Marker>,
    /// Phase from 0 to 1, different for lines that may lie on each other.
    pub phase: f64,
}

/// The ink of every label of a figure.
pub(super) struct Inks<'a> {
    references: Vec<&'a str>,
    others: Vec<&'a str>,
}

impl<'a> Inks<'a> {
    /// Inks, one for each label, in the order in which they come up.
    pub(super) fn new(lines: impl Iterator<Item = &'a PlottedLine>) -> Self {
        let mut inks = Self { references: Vec::new(), others: Vec::new() };
        for line in lines {
            let labels = match line.kind {
                Kind::Reference => &mut inks.references,
                _ => &mut inks.others,
            };
            if !labels.contains(&line.label.as_str()) {
                labels.push(&line.label);
            }
        }
        inks
    }

    /// Ink of a line of the figure.
    pub(super) fn of(&self, line: &PlottedLine) -> Ink {
        let turn = |labels: &[&str]| {
            labels.iter().position(|label| *label == line.label).expect("a line of the figure")
        };
        if line.kind == Kind::Reference {
            let dashes = REFERENCES[turn(&self.references) % REFERENCES.len()];
            let stroke = Stroke { color: REFERENCE, width: 1.8, dashes };
            return Ink { stroke, marker: None, phase: 0.0 };
        }
        // The lengths have no common factor: together they repeat after 280 lines.
        let turn = turn(&self.others);
        Ink {
            stroke: Stroke {
                color: OKABE_ITO[turn % OKABE_ITO.len()],
                width: match line.kind {
                    Kind::Bold => 4.4,
                    Kind::Spread => 1.0,
                    _ => 2.2,
                },
                dashes: DASHES[turn % DASHES.len()],
            },
            marker: Some(MARKERS[turn % MARKERS.len()]),
            phase: (turn as f64 * 0.618).fract(),
        }
    }
}

impl Ink {
    /// A line through points.
    pub(super) fn stroke(&self, svg: &mut Svg, points: &[Point]) {
        svg.stroke(&Path::through(points.iter().copied()), self.stroke);
    }

    /// The marker at a point, if the line has one.
    pub(super) fn mark(&self, svg: &mut Svg, at: Point) {
        if let Some(marker) = self.marker {
            marker(svg, at, self.stroke.color);
        }
    }

    /// The mark of a failure at a point.
    pub(super) fn fail(&self, svg: &mut Svg, (x, y): Point) {
        let color = self.stroke.color;
        svg.disc((x, y), 5.4, color);
        svg.disc((x, y), 4.0, WHITE);
        for slope in [-3.8, 3.8] {
            let cross = Path::through([(x - 3.8, y - slope), (x + 3.8, y + slope)]);
            svg.stroke(&cross, Stroke::new(color, 1.4));
        }
    }
}

/// Once round corners, which are told from a point.
fn outline((x, y): Point, corners: &[Point]) -> Path {
    Path::around(corners.iter().map(|(dx, dy)| (x + dx, y + dy)))
}

fn open(svg: &mut Svg, outline: &Path, color: Color) {
    svg.fill(outline, WHITE);
    svg.stroke(outline, Stroke::new(color, 1.6));
}

fn square(half: f64) -> [Point; 4] {
    [(-half, -half), (half, -half), (half, half), (-half, half)]
}

/// Triangle with the tip up; down for a negative size.
fn triangle(size: f64) -> [Point; 3] {
    [(0.0, -size), (0.9 * size, 0.6 * size), (-0.9 * size, 0.6 * size)]
}
