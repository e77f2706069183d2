//! Legend in a row below the arches.

use super::Sketched;
use crate::atlas::{Sketch, SketchedLine};
use crate::picture::color::{GUIDE, INK, WHITE};
use crate::picture::{Color, Page, Path, Point, Stroke, Svg, Type, text};
use crate::sketch::look;

/// An entry: a sample and its name.
pub(crate) enum LegendSample {
    Line(Stroke),
    Band,
    /// An area of the colour of a band, of an edge and an opacity.
    Shade(Stroke, f64),
    /// An area of a colour.
    Area(Color),
    Hinge,
    Sliding,
    Fallen,
}

use LegendSample::{Band, Fallen, Hinge, Line, Sliding};

/// The legend of a page of some width.
pub(crate) struct Legend {
    rows: Vec<Vec<(LegendSample, &'static str)>>,
}

const SAMPLE: f64 = 34.0;
const GAP: f64 = 8.0;
const BETWEEN: f64 = 26.0;
const ROW: f64 = 25.0;

fn width(name: &str) -> f64 {
    SAMPLE + GAP + text::width(name, Page::SMALL)
}

impl Legend {
    pub(super) fn new(drawn: &Sketched, limit: f64) -> Self {
        let forces = || drawn.sketches.iter().flat_map(|sketch| &sketch.forces);
        let is_standing = drawn.sketches.iter().any(Sketch::stands);
        let mut entries: Vec<(LegendSample, &'static str)> = match (is_standing, forces().count()) {
            (_, 0) => Vec::new(),
            _ if !forces().flat_map(|of| &of.thrust_lines).any(|line| line.points.len() > 1) => {
                vec![(Line(look::FRICTION), "line of friction")]
            }
            (true, 1) => vec![
                (Line(look::THRUST), "line of thrust, least thrust"),
                (Line(look::FRICTION), "line of friction"),
            ],
            (true, _) => vec![
                (Line(look::THRUST), "line of thrust, least thrust"),
                (Line(look::LARGEST), "line of thrust, largest thrust"),
                (Band, "between them"),
                (Line(look::FRICTION), "line of friction, least thrust"),
                (Line(look::LARGEST_FRICTION), "line of friction, largest thrust"),
            ],
            _ if forces().any(|forces| forces.thrust_lines.len() > 1) => vec![
                (Line(look::EXTREME), "extreme lines of thrust"),
                (Band, "all others"),
                (Line(look::FRICTION), "line of friction"),
            ],
            _ => vec![
                (Line(look::THRUST), "line of thrust"),
                (Line(look::FRICTION), "line of friction"),
            ],
        };
        let is_outside = |line: &SketchedLine| line.outside().next().is_some();
        if forces().flat_map(|forces| &forces.thrust_lines).any(is_outside) {
            entries.push((Line(look::OUTSIDE), "outside the arch"));
        }
        if forces().map(|forces| &forces.friction_line).any(is_outside) {
            entries.push((Line(look::PASSED), "friction passed"));
        }
        let marks = || forces().flat_map(|forces| &forces.marks);
        if marks().any(|mark| mark.contact.is_hinge()) {
            entries.push((Hinge, if is_standing { "touches a face" } else { "hinge" }));
        }
        if marks().any(|mark| !mark.contact.is_hinge()) {
            let name = if is_standing { "friction used up" } else { "joint that slides" };
            entries.push((Sliding, name));
        }
        if drawn.sketches.iter().any(|sketch| !sketch.collapses.is_empty()) {
            entries.push((Fallen, "as it falls"));
        }
        Self::of(entries, limit)
    }

    /// A legend of those entries that are there.
    pub(crate) fn of_those<const N: usize>(
        all: [(bool, LegendSample, &'static str); N],
        limit: f64,
    ) -> Self {
        let there = all.into_iter().filter(|(is, ..)| *is);
        Self::of(there.map(|(_, sample, name)| (sample, name)).collect(), limit)
    }

    /// A legend of entries.
    fn of(entries: Vec<(LegendSample, &'static str)>, limit: f64) -> Self {
        let mut rows: Vec<Vec<(LegendSample, &'static str)>> = Vec::new();
        let mut room = 0.0;
        for entry in entries {
            let wide = width(entry.1) + BETWEEN;
            if room < wide {
                rows.push(Vec::new());
                room = limit + BETWEEN;
            }
            room -= wide;
            if let Some(row) = rows.last_mut() {
                row.push(entry);
            }
        }
        Self { rows }
    }

    pub(crate) fn height(&self) -> f64 {
        self.rows.len() as f64 * ROW
    }

    /// Draws each row in the middle of a width, from a point downwards.
    pub(crate) fn draw(&self, svg: &mut Svg, (left, top): Point, limit: f64) {
        svg.group("legend", |svg| {
            for (row, y) in self.rows.iter().zip(0..) {
                let wide: f64 = row.iter().map(|(_, name)| width(name) + BETWEEN).sum();
                let mut x = left + (limit - wide + BETWEEN) / 2.0;
                let y = top + (f64::from(y) + 0.5) * ROW;
                for (sample, name) in row {
                    sample.draw(svg, (x, y));
                    svg.text(name, (x + SAMPLE + GAP, y), Type::new(Page::SMALL, INK));
                    x += width(name) + BETWEEN;
                }
            }
        });
    }
}

impl LegendSample {
    fn draw(&self, svg: &mut Svg, (x, y): Point) {
        let (right, middle) = (x + SAMPLE, x + SAMPLE / 2.0);
        let area = Path::rectangle((x, y - 7.0), (right, y + 7.0));
        match self {
            Self::Line(stroke) => svg.stroke(&Path::through([(x, y), (right, y)]), *stroke),
            Self::Band => svg.tint(&area, look::BAND, look::FAINT),
            Self::Area(color) => {
                svg.fill(&area, *color);
                svg.stroke(&area, Stroke::new(GUIDE, 0.8));
            }
            Self::Shade(edge, share) => {
                svg.tint(&area, look::BAND, *share);
                for y in [y - 7.0, y + 7.0] {
                    svg.stroke(&Path::through([(x, y), (right, y)]), *edge);
                }
            }
            Self::Hinge => svg.ring((middle, y), look::HINGE_RADIUS, WHITE, look::HINGE),
            Self::Sliding => {
                svg.stroke(&Path::through([(middle, y - 9.0), (middle, y + 9.0)]), look::SLIDES);
            }
            Self::Fallen => {
                svg.tint(&area, look::FALLEN, look::SHEER);
                svg.stroke(&area, look::FALLEN_EDGE);
            }
        }
    }
}
