//! Graphs below each other; neighbours over the same axis share its ticks.

use super::chain::{Chain, larger};
use super::plane::{FRICTION_LABEL, PlaneAxis, friction_ticks};
use super::spot::disc;
use crate::picture::color::{GRID, INK, WHITE};
use crate::picture::{
    Anchor, Frame, FrameSide, Name, Page, Path, Point, Print, Stroke, Svg, Type, text,
};
use std::io;

/// Graphs, a legend in one of them, and paragraphs below.
pub(super) struct Graphs {
    pub title: &'static str,
    pub panels: Vec<Graph>,
    /// Names of lines, and where they stand: in which panel, and how far from its upper left corner.
    pub legend: Vec<(String, Stroke)>,
    pub legend_at: (usize, Point),
    pub words: Vec<String>,
}

/// One graph.
pub(super) struct Graph {
    pub x: PlaneAxis,
    pub y: PlaneAxis,
    pub lines: Vec<GraphLine>,
    /// Points, by their places on the axes, with their names.
    pub marks: Vec<Name>,
    /// A part of it, larger, and the places of two of its corners.
    pub inset: Option<Box<([Point; 2], Graph)>>,
}

/// A line.
pub(super) struct GraphLine {
    pub id: String,
    pub chain: Chain,
    pub stroke: Stroke,
}

/// Width of a panel, unless another is asked for, and the least.
pub(super) const WIDTH: f64 = 700.0;
const LEAST: f64 = 200.0;
const LEFT: f64 = 92.0;
/// Space above, and where there is an axis of friction.
const TOP: f64 = 24.0;
const AXIS: f64 = 76.0;
/// Space beside a panel.
const AROUND: f64 = LEFT + 40.0;
const BETWEEN: f64 = 26.0;
const BELOW: f64 = 80.0;
/// Distance from the labels of ticks to that of their axis.
const NEXT: f64 = 24.0;
const LABEL: f64 = 18.0;
const TICK: f64 = 16.0;
/// Ticks of an inset.
const SMALL_TICK: f64 = 14.0;
/// Length of a sample in the legend, and the height of its rows.
const SAMPLE: f64 = 48.0;
const ROW: f64 = 24.0;

/// Width and height of each of so many panels.
pub(super) fn size(panels: usize, print: &Print) -> io::Result<Point> {
    let width = print.room(WIDTH + AROUND, LEAST + AROUND)? - AROUND;
    Ok((width, if panels > 1 { 250.0 } else { f64::min(440.0, width) }))
}

/// Distance that the lines of panels may have from the truth, along each axis.
pub(super) fn off(panels: &[Graph]) -> Vec<(PlaneAxis, f64)> {
    let of_panel = |panel: &Graph| {
        let [across, up] = panel.off();
        [(panel.x, across), (panel.y, up)]
    };
    panels.iter().flat_map(of_panel).collect()
}

impl Graphs {
    /// The picture as SVG.
    pub(super) fn svg(&self, print: &Print) -> io::Result<String> {
        let size = size(self.panels.len(), print)?;
        let is_friction = |panel: &Graph| panel.x.is_friction_angle();
        let top = if self.panels.first().is_some_and(is_friction) { AXIS } else { TOP };
        let mut next = top;
        let frame = |(k, panel): (usize, &Graph)| {
            let corner = (LEFT, next);
            next += size.1 + if self.has_ticks(k) { BELOW } else { BETWEEN };
            Frame { corner, size, x: panel.x.range, y: panel.y.range }
        };
        let frames: Vec<Frame> = self.panels.iter().enumerate().map(frame).collect();
        let bottom = frames.last().map_or(top, Frame::bottom);
        // In a panel that is narrow a legend would lie on lines.
        let is_narrow = size.0 < WIDTH;
        let legend = if is_narrow { ROW * self.legend.len() as f64 } else { 0.0 };
        let foot = bottom + BELOW + legend;
        let page = Page::new(print, WIDTH + AROUND, LEAST + AROUND)?;
        let svg = page.svg(self.title, &self.words, foot, |svg| {
            for (k, (panel, frame)) in self.panels.iter().zip(&frames).enumerate() {
                let letter = b"abcdefgh".get(k).filter(|_| self.panels.len() > 1);
                svg.group(&format!("panel-{k}"), |svg| panel.draw(svg, frame, self.has_ticks(k)));
                if k == 0 && is_friction(panel) {
                    panel.friction(svg, frame);
                }
                if let Some(letter) = letter {
                    let name = format!("({})", char::from(*letter));
                    let at = (frame.corner.0 + 12.0, frame.corner.1 + 18.0);
                    svg.text(&name, at, Type::new(LABEL, INK).on(WHITE));
                }
            }
            let within = frames.get(self.legend_at.0).map(|frame| {
                let (_, (across, down)) = self.legend_at;
                (frame.corner.0 + across * size.0 / WIDTH, frame.corner.1 + down)
            });
            let at = if is_narrow { Some((Page::MARGIN, bottom + BELOW)) } else { within };
            if let Some(at) = at {
                svg.group("legend", |svg| self.legend(svg, at));
            }
        });
        Ok(svg.finish())
    }

    /// Tells whether a panel has the ticks of its horizontal axis: it is the last over that.
    fn has_ticks(&self, k: usize) -> bool {
        self.panels.get(k + 1).is_none_or(|below| below.x != self.panels[k].x)
    }

    fn legend(&self, svg: &mut Svg, (x, top): Point) {
        for (k, (name, stroke)) in self.legend.iter().enumerate() {
            let y = top + ROW * k as f64;
            svg.stroke(&Path::through([(x, y), (x + SAMPLE, y)]), *stroke);
            svg.text(name, (x + SAMPLE + 10.0, y), Type::new(TICK, INK).on(WHITE));
        }
    }
}

impl Graph {
    /// Bounds on the distance of the lines that the panel shows from the truth, along each axis.
    fn off(&self) -> [f64; 2] {
        let (x, y) = (self.x.range, self.y.range);
        let frame = Frame { corner: (0.0, 0.0), size: (1.0, 1.0), x, y };
        let inset = self.inset.iter().map(|inset| inset.1.off());
        let lines = self.lines.iter().map(|line| line.chain.off(&frame));
        lines.chain(inset).fold([0.0; 2], larger)
    }

    /// The friction coefficient, above.
    fn friction(&self, svg: &mut Svg, frame: &Frame) {
        frame.ticks(svg, FrameSide::Top, &friction_ticks(&self.x), TICK);
        let at = (frame.corner.0 + frame.size.0 / 2.0, frame.corner.1 - 46.0);
        svg.text(FRICTION_LABEL, at, Type::new(LABEL, INK).at(Anchor::Middle));
    }

    fn draw(&self, svg: &mut Svg, frame: &Frame, has_ticks: bool) {
        let (x, y) = (self.x.ticks(self.x.range, None), self.y.ticks(self.y.range, None));
        let (left, top) = frame.corner;
        let upright = x.iter().map(|tick| frame.at((tick.place, 0.0)).0);
        let upright = upright.map(|x| [(x, top), (x, frame.bottom())]);
        let level = y.iter().map(|tick| frame.at((0.0, tick.place)).1);
        for ends in upright.chain(level.map(|y| [(left, y), (frame.right(), y)])) {
            svg.stroke(&Path::through(ends), Stroke::new(GRID, 1.0));
        }
        self.plot(svg, frame, "");
        frame.ticks(svg, FrameSide::Left, &y, TICK);
        let middle = Type::new(LABEL, INK).at(Anchor::Middle);
        let up = frame.corner.1 + frame.size.1 / 2.0;
        let widest = text::widest(y.iter().map(|tick| &tick.label), TICK);
        let off = (widest + NEXT).max(64.0);
        svg.text(self.y.label, (frame.corner.0 - off, up), middle.turned(-90.0));
        if has_ticks {
            frame.ticks(svg, FrameSide::Bottom, &x, TICK);
            let across = frame.corner.0 + frame.size.0 / 2.0;
            svg.text(self.x.label, (across, frame.bottom() + 49.0), middle);
        }
        if let Some(inset) = &self.inset {
            let ([a, b], graph) = &**inset;
            let (low, high) = (frame.at(*a), frame.at(*b));
            let (corner, size) = ((low.0, high.1), (high.0 - low.0, low.1 - high.1));
            graph.draw_inset(svg, &Frame { corner, size, x: graph.x.range, y: graph.y.range });
        }
        self.names(svg, frame);
    }

    /// Draws it as an inset: its lines, few ticks and its names.
    fn draw_inset(&self, svg: &mut Svg, frame: &Frame) {
        let (left, bottom) = (frame.corner.0 - 2.6 * SMALL_TICK, frame.bottom() + 1.8 * SMALL_TICK);
        svg.fill(&Path::rectangle((left, frame.corner.1), (frame.right(), bottom)), WHITE);
        self.plot(svg, frame, "inset-");
        let (x, y) = (self.x.ticks(self.x.range, None), self.y.ticks(self.y.range, None));
        frame.ticks(svg, FrameSide::Bottom, &x, SMALL_TICK);
        frame.ticks(svg, FrameSide::Left, &y, SMALL_TICK);
        self.names(svg, frame);
    }

    /// The lines in their frame; `of` sets the names of the groups of an inset apart.
    fn plot(&self, svg: &mut Svg, frame: &Frame, of: &str) {
        svg.clipped(&frame.outline(), |svg| {
            for GraphLine { id, chain, stroke } in &self.lines {
                svg.group(&format!("{of}{id}"), |svg| chain.draw(svg, frame, *stroke));
            }
        });
        svg.stroke(&frame.outline(), Stroke::new(INK, 1.2));
    }

    /// The points with their names, off all that is drawn.
    fn names(&self, svg: &mut Svg, frame: &Frame) {
        svg.window([frame.corner, (frame.right(), frame.bottom())]);
        let seen = || self.marks.iter().filter(|mark| frame.shows(mark.at));
        seen().for_each(|mark| disc(svg, frame.at(mark.at)));
        let named = seen().filter(|mark| !mark.words.is_empty());
        let named = named.map(|mark| Name { at: frame.at(mark.at), ..mark.clone() });
        svg.names(&named.collect::<Vec<_>>(), |_| Type::new(LABEL, INK).on(WHITE));
    }
}
