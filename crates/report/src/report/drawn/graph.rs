//! Graphs below each other; neighbours over the same axis share its ticks.

use super::chain::{Chain, larger};
use super::plane::{FRICTION_LABEL, PlaneAxis, friction_ticks};
use super::spot::disc;
use crate::picture::color::{GRID, INK, WHITE};
use crate::picture::{Anchor, Color, Frame, FrameSide, Path, Point, Stroke, Svg, Type, text};

/// Graphs, a legend in one of them, and paragraphs below.
pub(super) struct Graphs {
    pub title: &'static str,
    pub panels: Vec<Graph>,
    /// Names of lines, and where they stand: in which panel, and how far from its left edge.
    pub legend: Vec<(String, Stroke)>,
    pub legend_at: (usize, f64),
    pub words: Vec<String>,
}

/// One graph.
pub(super) struct Graph {
    pub x: PlaneAxis,
    pub y: PlaneAxis,
    pub lines: Vec<GraphLine>,
    pub marks: Vec<Dot>,
}

/// A line.
pub(super) struct GraphLine {
    pub id: String,
    pub chain: Chain,
    pub stroke: Stroke,
}

/// A point with a name, which stands so far from it on the page.
pub(super) struct Dot {
    pub name: String,
    pub at: Point,
    pub away: Point,
    pub color: Color,
}

pub(super) const WIDTH: f64 = 700.0;
const LEFT: f64 = 92.0;
/// Space above, and where there is an axis of friction.
const TOP: f64 = 24.0;
const AXIS: f64 = 76.0;
const RIGHT: f64 = 40.0;
const BETWEEN: f64 = 26.0;
const BELOW: f64 = 80.0;
const MARGIN: f64 = 20.0;
/// Distance from the labels of ticks to that of their axis.
const NEXT: f64 = 24.0;
const LABEL: f64 = 18.0;
const TICK: f64 = 16.0;
const SMALL: f64 = 15.0;
/// Length of a sample in the legend.
const SAMPLE: f64 = 48.0;

/// Height of each of so many panels.
pub(super) fn height(panels: usize) -> f64 {
    if panels > 1 { 250.0 } else { 440.0 }
}

impl Graphs {
    /// The picture as SVG.
    pub(super) fn svg(&self) -> String {
        let height = height(self.panels.len());
        let is_friction = |panel: &Graph| panel.x.is_friction_angle();
        let top = if self.panels.first().is_some_and(is_friction) { AXIS } else { TOP };
        let mut next = top;
        let frame = |(k, panel): (usize, &Graph)| {
            let corner = (LEFT, next);
            next += height + if self.has_ticks(k) { BELOW } else { BETWEEN };
            Frame { corner, size: (WIDTH, height), x: panel.x.range, y: panel.y.range }
        };
        let frames: Vec<Frame> = self.panels.iter().enumerate().map(frame).collect();
        let bottom = frames.last().map_or(top, Frame::bottom);
        let width = LEFT + WIDTH + RIGHT;
        let wrapped = |words: &String| text::wrap(words, SMALL, width - 2.0 * MARGIN);
        let lines: Vec<String> = self.words.iter().flat_map(wrapped).collect();
        let all = bottom + BELOW + lines.len() as f64 * SMALL * text::LEADING + MARGIN;
        let mut svg = Svg::new((width, all), self.title, &self.words.join(" "));
        for (k, (panel, frame)) in self.panels.iter().zip(&frames).enumerate() {
            let letter = b"abcdefgh".get(k).filter(|_| self.panels.len() > 1);
            svg.group(&format!("panel-{k}"), |svg| panel.draw(svg, frame, self.has_ticks(k)));
            if k == 0 && is_friction(panel) {
                panel.friction(&mut svg, frame);
            }
            if let Some(letter) = letter {
                let name = format!("({})", char::from(*letter));
                let at = (frame.corner.0 + 12.0, frame.corner.1 + 18.0);
                svg.text(&name, at, Type::new(LABEL, INK).on(WHITE));
            }
        }
        if let Some(frame) = frames.get(self.legend_at.0) {
            svg.group("legend", |svg| self.legend(svg, frame));
        }
        svg.group("caption", |svg| {
            svg.lines(&lines, (MARGIN, bottom + BELOW), Type::new(SMALL, INK));
        });
        svg.finish()
    }

    /// Tells whether a panel has the ticks of its horizontal axis: it is the last over that.
    fn has_ticks(&self, k: usize) -> bool {
        self.panels.get(k + 1).is_none_or(|below| below.x != self.panels[k].x)
    }

    fn legend(&self, svg: &mut Svg, frame: &Frame) {
        for (k, (name, stroke)) in self.legend.iter().enumerate() {
            let (x, y) =
                (frame.corner.0 + self.legend_at.1, frame.corner.1 + 20.0 + 24.0 * k as f64);
            svg.stroke(&Path::through([(x, y), (x + SAMPLE, y)]), *stroke);
            svg.text(name, (x + SAMPLE + 10.0, y), Type::new(TICK, INK).on(WHITE));
        }
    }
}

impl Graph {
    /// Bounds on the distance of the lines that the panel shows from the truth, along each axis.
    pub(super) fn off(&self) -> [f64; 2] {
        let (x, y) = (self.x.range, self.y.range);
        let frame = Frame { corner: (0.0, 0.0), size: (1.0, 1.0), x, y };
        self.lines.iter().map(|line| line.chain.off(&frame)).fold([0.0; 2], larger)
    }

    /// The friction coefficient, above.
    fn friction(&self, svg: &mut Svg, frame: &Frame) {
        frame.ticks(svg, FrameSide::Top, &friction_ticks(&self.x), TICK);
        let at = (frame.corner.0 + WIDTH / 2.0, frame.corner.1 - 46.0);
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
        svg.clipped(&frame.outline(), |svg| {
            for line in &self.lines {
                svg.group(&line.id, |svg| line.chain.draw(svg, frame, line.stroke));
            }
        });
        svg.stroke(&frame.outline(), Stroke::new(INK, 1.2));
        frame.ticks(svg, FrameSide::Left, &y, TICK);
        let middle = Type::new(LABEL, INK).at(Anchor::Middle);
        let up = frame.corner.1 + frame.size.1 / 2.0;
        let widest = y.iter().map(|tick| text::width(&tick.label, TICK)).fold(0.0, f64::max);
        let off = (widest + NEXT).max(64.0);
        svg.text(self.y.label, (frame.corner.0 - off, up), middle.turned(-90.0));
        if has_ticks {
            frame.ticks(svg, FrameSide::Bottom, &x, TICK);
            let across = frame.corner.0 + WIDTH / 2.0;
            svg.text(self.x.label, (across, frame.bottom() + 49.0), middle);
        }
        for mark in &self.marks {
            let at = frame.at(mark.at);
            disc(svg, at);
            let anchor = if mark.away.0 < 0.0 { Anchor::End } else { Anchor::Start };
            let style = Type::new(LABEL, mark.color).at(anchor).on(WHITE);
            svg.text(&mark.name, (at.0 + mark.away.0, at.1 + mark.away.1), style);
        }
    }
}
