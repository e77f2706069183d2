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
use crate::picture::{Frame, Svg};
use crate::problem::Mode;
use crate::report::{Record, words};
use serde_json::json;

/// The map of one weight in one plane.
pub(crate) struct FramedMap {
    /// The weight.
    pub weight: SelfWeight,
    /// The plane.
    pub plane: Plane,
    /// Domains and lines as SVG, in a frame as large as the picture.
    pub svg: String,
    /// Data of the things around them that a page has to place, all points and lengths in the units of the axes.
    pub around: Record,
    /// Caption: what is shown and how near that is to the truth, and the marks, each a paragraph.
    pub caption: Vec<String>,
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
        let landmarks = content.landmarks.iter();
        let landmarks = landmarks.map(|(of, at)| json!([words::symbol(*of), at, away(*of, plane)]));
        let levels = content.levels.iter();
        let levels = levels.map(|(of, _)| json!([level_id(of), margin::shown(of, false)]));
        let domains = Mode::ALL.map(|mode| json!([domain_id(mode), mode.label()]));
        let mut around = Record::default();
        around.add("labels", json!([x.label, y.label]));
        around.add("ranges", json!([x.range, y.range]));
        // Distance that a line may have from the truth along each axis.
        around.add("off", json!(off.map(|(axis, off)| off * axis.unit)));
        // Their places, and the directions of their names in sizes of the font.
        around.add("landmarks", landmarks.collect::<Vec<_>>());
        let larger = inset::parts(&content).into_iter().map(|(_, part)| json!(part));
        around.add("insets", larger.collect::<Vec<_>>());
        // By the names of their groups.
        around.add("domains", domains.to_vec());
        around.add("levels", levels.collect::<Vec<_>>());
        around.add("levels_label", plane.contour_label());
        around.add("marks", json!(mark::ends(marks, &canvas)));
        Self { weight: sheet.weight, plane, svg: svg.finish(), around, caption: words }
    }
}
