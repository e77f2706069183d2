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
        let thrust_lines = || forces().flat_map(|of| &of.thrust_lines);
        let is_outside = |line: &SketchedLine| line.outside().next().is_some();
        let marked = |hinge: bool| {
            forces().flat_map(|of| &of.marks).any(|mark| mark.contact.is_hinge() == hinge)
        };
        let is_standing = drawn.sketches.iter().any(Sketch::stands);
        let is_there = thrust_lines().any(|line| line.points.len() > 1);
        let (least, several) =
            (is_standing && is_there, forces().any(|of| of.thrust_lines.len() > 1));
        let (both, extreme) = (least && forces().count() > 1, is_there && !is_standing && several);
        let [touched, used_up] = match is_standing {
            true => ["touches a face", "friction used up"],
            false => ["hinge", "joint that slides"],
        };
        let all = [
            (least, Line(look::THRUST), "line of thrust, least thrust"),
            (both, Line(look::LARGEST), "line of thrust, largest thrust"),
            (both, Band, "between them"),
            (extreme, Line(look::EXTREME), "extreme lines of thrust"),
            (extreme, Band, "all others"),
            (is_there && !least && !extreme, Line(look::THRUST), "line of thrust"),
            (both, Line(look::FRICTION), "line of friction, least thrust"),
            (both, Line(look::LARGEST_FRICTION), "line of friction, largest thrust"),
            (forces().next().is_some() && !both, Line(look::FRICTION), "line of friction"),
            (thrust_lines().any(is_outside), Line(look::OUTSIDE), "outside the arch"),
            (
                forces().any(|of| is_outside(&of.friction_line)),
                Line(look::PASSED),
                "friction passed",
            ),
            (marked(true), Hinge, touched),
            (marked(false), Sliding, used_up),
            (drawn.sketches.iter().any(|of| !of.collapses.is_empty()), Fallen, "as it falls"),
        ];
        Self::of_those(all, limit)
    }

    /// A legend of those entries that are there.
    pub(crate) fn of_those<const N: usize>(
        all: [(bool, LegendSample, &'static str); N],
        limit: f64,
    ) -> Self {
        let mut rows: Vec<Vec<(LegendSample, &'static str)>> = Vec::new();
        let mut room = 0.0;
        for (_, sample, name) in all.into_iter().filter(|(is_there, ..)| *is_there) {
            let wide = width(name) + BETWEEN;
            if room < wide {
                rows.push(Vec::new());
                room = limit + BETWEEN;
            }
            room -= wide;
            if let Some(row) = rows.last_mut() {
                row.push((sample, name));
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
