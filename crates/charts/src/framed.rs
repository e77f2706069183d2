//! The map of one weight in one plane, for a page that shows any part of it at any size: the domains and lines as they
//! are drawn, and as data what stands around them, which the page places anew.

use super::canvas::Canvas;
use super::caption::{caption, of_levels};
use super::content::{PlaneContent, domain_id, level_id};
use super::inset;
use super::margin;
use super::mark::{self, Mark};
use super::page::SIZE;
use super::plane::Plane;
use super::sheet::Sheet;
use super::spot::away;
use crate::arch::SelfWeight;
use crate::picture::{Frame, Point, Svg};
use crate::problem::Mode;
use crate::report::words;
use serde::Serialize;

/// The map of one weight in one plane.
pub(crate) struct FramedMap {
    /// The weight.
    pub weight: SelfWeight,
    /// The plane.
    pub plane: Plane,
    /// Domains and lines as SVG, in a frame as large as the picture.
    pub svg: String,
    /// Data of the things around them.
    pub around: Surroundings,
    /// Caption: what is shown and how near that is to the truth, and the marks, each a paragraph.
    pub caption: Vec<String>,
}

/// Data of the things that a page has to place, all points and lengths in the units of the axes.
#[derive(Serialize)]
pub(crate) struct Surroundings {
    /// Labels of the axes, to the right and up.
    labels: [&'static str; 2],
    /// Ranges of the axes.
    ranges: [[f64; 2]; 2],
    /// Distance that a line may have from the truth along each axis.
    off: [f64; 2],
    /// Names of landmarks, with their places and the directions of the names in sizes of the font.
    landmarks: Vec<(&'static str, Point, Point)>,
    /// Parts that are shown larger.
    insets: Vec<[[f64; 2]; 2]>,
    /// Domains by the names of their groups.
    domains: Vec<(String, &'static str)>,
    /// Levels by the names of their groups.
    levels: Vec<(String, String)>,
    /// Label of the levels.
    levels_label: &'static str,
    /// Arches that are marked, with the ends of the strokes to the thicknesses that are given; or, where it says so,
    /// the corners of a box.
    marks: Vec<(Point, Option<Point>, bool)>,
}

impl FramedMap {
    /// The map of the curves of a weight in a plane.
    pub(super) fn new(sheet: &Sheet, plane: Plane, marks: &[Mark]) -> Self {
        let canvas = Canvas::usual(plane);
        let content = PlaneContent::new(sheet, &canvas);
        let [x, y] = &canvas.axes;
        let frame = Frame { corner: (0.0, 0.0), size: SIZE, x: x.range, y: y.range };
        let off = content.off(&frame);
        let sheets = std::slice::from_ref(sheet);
        let mut words = caption(plane.shows(), sheets, (&off, SIZE), &of_levels(sheets), "");
        words.truncate(1);
        words.extend(mark::words(marks, &canvas));
        let mut svg = Svg::new(SIZE, plane.shows(), "");
        content.draw(&mut svg, &frame, "");
        let around = Surroundings {
            labels: [x.label, y.label],
            ranges: [x.range, y.range],
            off: off.map(|(axis, off)| off * axis.unit),
            landmarks: content
                .landmarks
                .iter()
                .map(|(of, at)| (words::symbol(*of), *at, away(*of, plane)))
                .collect(),
            insets: inset::enlarged(&content),
            domains: Mode::ALL.map(|mode| (domain_id(mode), mode.label())).to_vec(),
            levels: content
                .levels
                .iter()
                .map(|(of, _)| (level_id(of), margin::shown(of, false)))
                .collect(),
            levels_label: plane.contour_label(),
            marks: mark::ends(marks, &canvas),
        };
        Self { weight: sheet.weight, plane, svg: svg.finish(), around, caption: words }
    }
}
