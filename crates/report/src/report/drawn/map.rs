//! The map of one weight: domains, lines, landmarks, and insets where they are close.

use super::asymmetric;
use super::canvas::Canvas;
use super::caption::{caption, of_levels};
use super::content::PlaneContent;
use super::inset::Inset;
use super::margin;
use super::mark::{self, Mark};
use super::names::Names;
use super::page::{Page, SIZE};
use super::plane::Plane;
use super::sheet::Sheet;
use crate::atlas::Coordinate;
use crate::picture::color::INK;
use crate::picture::room::Rectangle;
use crate::picture::{Anchor, Frame, Svg, Type};
use crate::problem::Mode;

/// The map of one weight, as a picture.
pub(super) struct MapPicture<'a> {
    /// Curves of the map.
    pub sheet: &'a Sheet<'a>,
    /// Canvas: what lies along the axes.
    pub canvas: Canvas,
    /// Arches that are marked in it.
    pub marks: &'a [Mark],
    /// The command that makes it.
    pub command: &'a str,
}

/// Sizes of fonts for modes and for landmarks.
const NAMES: [f64; 2] = [20.0, 19.0];
const INSET_NAMES: [f64; 2] = [16.0, 17.0];
const NOTHING: f64 = 17.0;

impl MapPicture<'_> {
    /// The picture as SVG.
    pub(super) fn svg(&self) -> String {
        let canvas = &self.canvas;
        let content = PlaneContent::new(self.sheet, canvas);
        let has_levels = !content.levels.is_empty();
        let (Page { frame, .. }, _) = Page::new(canvas, "", &[], has_levels);
        let ([x, y], [across, up]) = (canvas.axes, content.off(&frame));
        let (sheets, off) = (std::slice::from_ref(self.sheet), [(x, across), (y, up)]);
        let mut words =
            caption(canvas.plane.shows(), sheets, (&off, SIZE), &of_levels(sheets), self.command);
        if content.asymmetric.is_some() {
            words[0].push_str(&asymmetric::words(self.sheet.weight));
        }
        words.splice(1..1, mark::words(self.marks, canvas));
        let (page, mut svg) = Page::new(canvas, canvas.plane.shows(), &words, has_levels);
        let frame = &page.frame;
        svg.clipped(&frame.outline(), |svg| content.draw(svg, frame, ""));
        page.draw(&mut svg);
        if has_levels {
            svg.group("levels", |svg| margin::levels(svg, frame, canvas.plane, &content.levels));
        }
        let marks = mark::places(self.marks, canvas, frame);
        let legend = content.asymmetric.as_ref().map(|asymmetric| asymmetric.taken(frame));
        let taken: Vec<Rectangle> =
            marks.iter().map(|mark| mark::taken(mark.at)).chain(legend).collect();
        let mut insets = Inset::all(&content, canvas, frame, &taken);
        // No inset covers a mark.
        insets.retain(|inset| !marks.iter().any(|mark| inset.covers(mark.at)));
        let mut named = Vec::new();
        for inset in &insets {
            inset.draw(&mut svg, canvas, |svg, id| content.draw(svg, &inset.frame, id));
            let mut names = self.names(&content, &inset.frame, INSET_NAMES);
            let larger = mark::places(self.marks, canvas, &inset.frame);
            names.taken = larger.iter().map(|mark| mark::taken(mark.at)).collect();
            names.landmarks(&mut svg, inset.is_close());
            names.overturning(&mut svg);
            // This one is seen better in the map.
            let elsewhere = [&named[..], &[Mode::SlidingRotational]].concat();
            named.extend(names.modes(&mut svg, &elsewhere));
            mark::draw(&mut svg, &larger, inset.id());
        }
        insets.iter().for_each(|inset| inset.draw_guides(&mut svg, frame));
        let values = margin::upright(&mut svg, frame, canvas.plane, &content.levels);
        let mut names = self.names(&content, frame, NAMES);
        names.taken = insets.iter().map(Inset::taken).chain(taken).chain(values).collect();
        names.landmarks(&mut svg, false);
        if canvas.plane == Plane::ThicknessFriction {
            names.overturning(&mut svg);
        }
        names.modes(&mut svg, &named);
        if canvas.is_usual {
            self.say_where_nothing_stands(&mut svg, frame, legend.is_some());
        }
        if let Some(asymmetric) = &content.asymmetric {
            asymmetric.legend(&mut svg, frame);
        }
        mark::draw(&mut svg, &marks, "");
        svg.finish()
    }

    fn names<'a>(&self, content: &'a PlaneContent, frame: &'a Frame, sizes: [f64; 2]) -> Names<'a> {
        let is_mirrored = self.canvas.axes[0].coordinate == Coordinate::OpeningVariable;
        Names { content, plane: self.canvas.plane, frame, sizes, is_mirrored, taken: Vec::new() }
    }

    /// Well above a legend, which it is no title of.
    fn say_where_nothing_stands(&self, svg: &mut Svg, frame: &Frame, has_legend: bool) {
        let (at, turn) = match self.canvas.plane {
            Plane::ThicknessFriction => return,
            Plane::OpeningFriction if has_legend => ((145.0, 26.0), 0.0),
            Plane::OpeningFriction => ((140.0, 12.0), 0.0),
            Plane::OpeningThickness => ((161.0, 1.0), -90.0),
        };
        let style = Type::new(NOTHING, INK).at(Anchor::Middle).turned(turn);
        svg.text("nothing stands", frame.at(at), style);
    }
}
