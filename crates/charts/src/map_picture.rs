//! The map of one weight: domains, lines, landmarks, and insets where they are close.

use super::asymmetric;
use super::canvas::Canvas;
use super::caption::{caption, of_levels};
use super::content::PlaneContent;
use super::inset::Inset;
use super::margin;
use super::mark::{self, Mark, Placed};
use super::names::{Names, on_page};
use super::page::{BELOW, MapPage};
use super::plane::Plane;
use super::sheet::Sheet;
use super::spot;
use crate::picture::color::INK;
use crate::picture::labels::Labels;
use crate::picture::room::{Rectangle, about};
use crate::picture::{Anchor, Frame, Name, Print, Svg, Type, text};
use crate::problem::Mode;
use std::io;

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
const NOTHING_STANDS: &str = "nothing stands";

impl MapPicture<'_> {
    /// The picture as SVG.
    pub(super) fn svg(&self, print: &Print) -> io::Result<String> {
        let canvas = &self.canvas;
        let content = PlaneContent::new(self.sheet, canvas);
        let has_levels = !content.levels.is_empty();
        let page = MapPage::new(canvas, has_levels, print)?;
        let frame = &page.frame;
        let (sheets, off) = (std::slice::from_ref(self.sheet), content.off(frame));
        let mut words = caption(
            canvas.plane.shows(),
            sheets,
            (&off, frame.size),
            &of_levels(sheets),
            self.command,
        );
        if content.asymmetric.is_some() {
            words[0].push_str(&asymmetric::words(self.sheet.weight));
        }
        for said in mark::words(self.marks, canvas) {
            words[0] += &format!(" {}.", said.trim_end_matches('.'));
        }
        let marks = mark::places(self.marks, canvas, frame);
        let legend = content.asymmetric.as_ref().map(|_| asymmetric::legend_in(frame));
        let within = legend.filter(|_| !page.is_narrow());
        let taken: Vec<Rectangle> =
            marks.iter().map(|mark| mark::taken(mark.at)).chain(within).collect();
        let mut insets = Inset::all(&content, frame, &taken);
        // No inset covers a mark.
        insets.retain(|inset| !marks.iter().flat_map(Placed::points).any(|at| inset.covers(at)));
        let insets_down = Inset::down(&insets, frame);
        let legend_down = legend.filter(|_| page.is_narrow()).map_or(0.0, |[a, b]| b.1 - a.1);
        let mut svg = page.svg(canvas.plane.shows(), &words, insets_down + legend_down, |svg| {
            content.draw(svg, frame, "");
        });
        if has_levels {
            svg.group("levels", |svg| margin::levels(svg, frame, &content));
        }
        let mut named = Vec::new();
        for inset in &insets {
            inset.draw(&mut svg, canvas, |svg, id| content.draw(svg, &inset.frame, id));
            let mut names = self.names(&content, &inset.frame, INSET_NAMES);
            let larger = mark::places(self.marks, canvas, &inset.frame);
            names.labels.taken = larger.iter().map(|mark| mark::taken(mark.at)).collect();
            names.labels.lines.extend(larger.iter().flat_map(Placed::lines));
            names.landmarks(&mut svg, inset.is_close());
            names.overturning(&mut svg);
            // This one is seen better in the map.
            let elsewhere = [&named[..], &[Mode::SlidingRotational]].concat();
            named.extend(names.modes(&mut svg, &elsewhere));
            mark::draw(&mut svg, &larger, inset.id());
        }
        let parts = Inset::draw_parts(&insets, &mut svg, frame);
        let values = margin::upright(&mut svg, frame, &content);
        let mut names = self.names(&content, frame, NAMES);
        names.labels.taken = insets.iter().map(Inset::taken).chain(taken).chain(values).collect();
        names.labels.lines.extend(marks.iter().flat_map(Placed::lines));
        if canvas.is_usual {
            let said = self.say_where_nothing_stands(&mut svg, frame, legend.is_some());
            names.labels.taken.extend(said);
        }
        for Name { words, at, towards, .. } in &parts {
            let style = Type::new(INSET_NAMES[0], INK);
            spot::named(&mut svg, &mut names.labels, (words, *at), *towards, style);
        }
        names.landmarks(&mut svg, false);
        if canvas.plane == Plane::ThicknessFriction {
            names.overturning(&mut svg);
        }
        names.modes(&mut svg, &named);
        if let Some([_, (right, bottom)]) = legend {
            let down = if within.is_some() { 0.0 } else { BELOW + insets_down + legend_down };
            asymmetric::legend(&mut svg, (right, bottom + down));
        }
        mark::draw(&mut svg, &marks, "");
        Ok(svg.finish())
    }

    fn names<'a>(&self, content: &'a PlaneContent, frame: &'a Frame, sizes: [f64; 2]) -> Names<'a> {
        let chains = content.chains().chain(&content.edge);
        let lines = chains.map(|chain| on_page(chain, frame)).collect();
        let window = Some([frame.corner, (frame.right(), frame.bottom())]);
        let labels = Labels { lines, window, ..Labels::default() };
        Names { content, frame, sizes, labels }
    }

    /// Says it well above a legend, which it is no title of; the area that it takes.
    fn say_where_nothing_stands(
        &self,
        svg: &mut Svg,
        frame: &Frame,
        has_legend: bool,
    ) -> Option<Rectangle> {
        let (at, turn) = match self.canvas.plane {
            Plane::ThicknessFriction => return None,
            Plane::OpeningFriction if has_legend => ((145.0, 26.0), 0.0),
            Plane::OpeningFriction => ((132.0, 10.0), 0.0),
            Plane::OpeningThickness => ((161.0, 1.0), -90.0),
        };
        let style = Type::new(NOTHING, INK).at(Anchor::Middle).turned(turn);
        svg.text(NOTHING_STANDS, frame.at(at), style);
        let (long, high) = (text::width(NOTHING_STANDS, NOTHING) / 2.0, 0.6 * NOTHING);
        Some(about(frame.at(at), if turn == 0.0 { (long, high) } else { (high, long) }))
    }
}
