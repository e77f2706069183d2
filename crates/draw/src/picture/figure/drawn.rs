//! The room that a panel needs, and how it is drawn.

use super::ink::{Ink, Inks};
use super::panel::{Kind, Panel, PlottedLine};
use crate::picture::color::{GRID, GUIDE, INK};
use crate::picture::scale::{Ruler, Tick};
use crate::picture::spread::spread;
use crate::picture::{Anchor, Path, Point, Stroke, Svg, Type, text};

/// The frame around the lines, unless it must be higher or the figure has another width; and how narrow it may be.
pub(super) const FRAME: (f64, f64) = (360.0, 270.0);
pub(super) const NARROW: f64 = 150.0;
/// Sizes of fonts.
const HEADING: f64 = 18.0;
const LABEL: f64 = 17.0;
const TICK: f64 = 16.0;
const NAME: f64 = 16.0;
/// Distance between the frame and the labels of ticks.
const OFF: f64 = 7.0;
/// Beside the frame: the leader to a name, the sample before it.
const LEADER: f64 = 20.0;
const SAMPLE: f64 = 32.0;
/// Height of a name.
const NAME_HEIGHT: f64 = NAME * 1.25;
/// Markers of measured points, and of steps, at least so far apart.
const MARKERS: f64 = 15.0;
const STEP_MARKERS: f64 = 110.0;

/// A line that ends no further from the frame has a leader to its name.
const NEAR: f64 = 24.0;

/// Space that a panel needs: around its frame, and for it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Room {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
    /// Width and height of the frame.
    pub wide: f64,
    pub frame: f64,
}

impl Room {
    /// Enough for both.
    pub(super) fn join(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            right: self.right.max(other.right),
            top: self.top.max(other.top),
            bottom: self.bottom.max(other.bottom),
            wide: self.wide.max(other.wide),
            frame: self.frame.max(other.frame),
        }
    }

    /// Width from end to end.
    pub(super) fn width(&self) -> f64 {
        self.left + self.wide + self.right
    }

    /// Height from end to end.
    pub(super) fn height(&self) -> f64 {
        self.top + self.frame + self.bottom
    }
}

/// A panel, ready to be drawn.
pub(super) struct Drawn<'a> {
    lines: Vec<LineRuns<'a>>,
    x: Ruler,
    y: Ruler,
    title: Vec<String>,
    x_label: Vec<String>,
    y_label: Vec<String>,
    /// Space that it needs.
    pub room: Room,
}

/// A line as unbroken runs of places: on the axes, then on the canvas.
struct LineRuns<'a> {
    line: &'a PlottedLine,
    ink: Ink,
    runs: Vec<Vec<Point>>,
}

impl<'a> Drawn<'a> {
    /// Chooses the axes of a frame of a width and measures the texts; the letter stands before the title.
    pub(super) fn new(panel: &'a Panel, letter: Option<&str>, inks: &Inks, width: f64) -> Self {
        let lines: Vec<LineRuns> = panel
            .lines
            .iter()
            .map(|line| LineRuns { line, ink: inks.of(line), runs: runs(panel, line) })
            .collect();
        let named = lines.iter().filter(|trace| trace.line.is_named()).count();
        let frame = FRAME.1.max(named as f64 * NAME_HEIGHT);
        let places = || lines.iter().flat_map(|trace| trace.runs.iter().flatten());
        let wide = |tick: &Tick| text::width(&tick.label, TICK);
        let beside = |a: &Tick, b: &Tick| (wide(a) + wide(b)) / 2.0 + 14.0;
        let x = Ruler::new(panel.x.scale, places().map(|p| p.0), width, beside);
        let y = Ruler::new(panel.y.scale, places().map(|p| p.1), frame, |_, _| 1.7 * TICK);

        let names = text::widest(panel.lines.iter().map(|line| &line.label), NAME);
        let names = names + if lines.is_empty() { 0.0 } else { LEADER + SAMPLE + 6.0 };
        let overhang = |tick: Option<&Tick>| tick.map_or(0.0, wide) / 2.0;
        let right = names.max(overhang(x.ticks.last()));
        let letter = letter.map_or(String::new(), |letter| format!("({letter}) "));
        let title = text::wrap(&(letter + &panel.title), HEADING, width + right);
        let x_label = text::wrap(&panel.x.label, LABEL, width);
        let y_label = text::wrap(&panel.y.label, LABEL, frame);
        let stack = |lines: &[String], size: f64, gap: f64| match lines.len() {
            0 => 0.0,
            n => n as f64 * size * text::LEADING + gap,
        };
        let y_ticks = text::widest(y.ticks.iter().map(|tick| &tick.label), TICK);
        // A single word may be longer than the frame.
        let beyond = (text::widest(&x_label, LABEL) - width).max(0.0) / 2.0;
        let above = (text::widest(&y_label, LABEL) - frame).max(0.0) / 2.0;
        let room = Room {
            left: (OFF + y_ticks + stack(&y_label, LABEL, 6.0))
                .max(overhang(x.ticks.first()))
                .max(beyond),
            right: right.max(beyond).max(text::widest(&title, HEADING) - width),
            top: stack(&title, HEADING, 6.0).max(TICK / 2.0).max(above),
            bottom: (OFF + TICK * text::LEADING + stack(&x_label, LABEL, 0.0)).max(above),
            wide: width,
            frame,
        };
        Self { lines, x, y, title, x_label, y_label, room }
    }

    /// Draws the panel with the upper left corner of its frame at `corner`.
    pub(super) fn draw(&self, svg: &mut Svg, (left, top): Point, height: f64) {
        let (right, bottom) = (left + self.room.wide, top + height);
        let at = |&(x, y): &Point| {
            (left + self.x.share(x) * self.room.wide, bottom - self.y.share(y) * height)
        };
        self.axes(svg, [left, right], [top, bottom]);

        let traces: Vec<LineRuns> = self.lines.iter().map(|trace| trace.map(at)).collect();
        let named: Vec<&LineRuns> = traces.iter().filter(|trace| trace.line.is_named()).collect();
        let names = names(&named, [top, bottom]);
        for (trace, name) in named.iter().zip(&names) {
            leader(svg, trace.end(), (right, *name));
        }
        // References and spreads below the measured, the bold above.
        let mut order: Vec<&LineRuns> = traces.iter().collect();
        order.sort_by_key(|trace| match trace.line.kind {
            Kind::Reference => 0,
            Kind::Spread => 1,
            Kind::Bold => 3,
            _ => 2,
        });
        for trace in &order {
            if !matches!(trace.line.kind, Kind::Points | Kind::Failures) {
                trace.runs.iter().for_each(|run| trace.ink.stroke(svg, &trace.joined(run)));
            }
        }
        for trace in order {
            for point in trace.markers() {
                match trace.line.kind {
                    Kind::Reference | Kind::Spread => {}
                    Kind::Failures => trace.ink.fail(svg, point),
                    _ => trace.ink.mark(svg, point),
                }
            }
        }
        for (trace, name) in named.into_iter().zip(names) {
            let start = right + LEADER;
            if trace.line.kind != Kind::Points {
                trace.ink.stroke(svg, &[(start, name), (start + SAMPLE, name)]);
            }
            trace.ink.mark(svg, (start + SAMPLE / 2.0, name));
            let place = (start + SAMPLE + 6.0, name);
            svg.text(&trace.line.label, place, Type::new(NAME, INK));
        }
    }

    fn axes(&self, svg: &mut Svg, [left, right]: [f64; 2], [top, bottom]: [f64; 2]) {
        let high = self.title.len() as f64 * HEADING * text::LEADING;
        svg.lines(&self.title, (left, top - 6.0 - high), Type::new(HEADING, INK));
        let mut line =
            |points: &[Point], stroke| svg.stroke(&Path::through(points.to_vec()), stroke);
        let (grid, tick) = (Stroke::new(GRID, 1.0), Stroke::new(INK, 1.0));
        for x in self.x.ticks.iter().map(|tick| left + self.x.share(tick.place) * (right - left)) {
            line(&[(x, top), (x, bottom)], grid);
            line(&[(x, bottom), (x, bottom + 4.0)], tick);
        }
        for y in self.y.ticks.iter().map(|tick| bottom - self.y.share(tick.place) * (bottom - top))
        {
            line(&[(left, y), (right, y)], grid);
            line(&[(left - 4.0, y), (left, y)], tick);
        }
        line(&[(left, top), (right, top), (right, bottom)], grid);
        line(&[(left, top), (left, bottom), (right, bottom)], Stroke::new(INK, 1.2));

        let style = Type::new(TICK, INK);
        for tick in &self.x.ticks {
            let x = left + self.x.share(tick.place) * (right - left);
            let place = (x, bottom + OFF + TICK * text::LEADING / 2.0);
            svg.text(&tick.label, place, style.at(Anchor::Middle));
        }
        for tick in &self.y.ticks {
            let y = bottom - self.y.share(tick.place) * (bottom - top);
            svg.text(&tick.label, (left - OFF, y), style.at(Anchor::End));
        }
        let style = Type::new(LABEL, INK).at(Anchor::Middle);
        let below = bottom + OFF + TICK * text::LEADING;
        svg.lines(&self.x_label, ((left + right) / 2.0, below), style);
        let widest = text::widest(self.y.ticks.iter().map(|tick| &tick.label), TICK);
        for (k, line) in self.y_label.iter().rev().enumerate() {
            let x = left - OFF - widest - 6.0 - (k as f64 + 0.5) * LABEL * text::LEADING;
            svg.text(line, (x, (top + bottom) / 2.0), style.turned(-90.0));
        }
    }
}

/// The heights of the names: each at the end of its line, or as near as the others allow; those of
/// lines without a point last.
fn names(traces: &[&LineRuns], [top, bottom]: [f64; 2]) -> Vec<f64> {
    let key = |trace: &LineRuns| {
        let points = || trace.runs.iter().flatten();
        // Where lines end together, that one first which was above the other.
        let mean = points().map(|p| p.1).sum::<f64>() / points().count().max(1) as f64;
        (trace.end().map_or(bottom, |point| point.1), mean)
    };
    let mut order: Vec<(usize, (f64, f64))> =
        traces.iter().map(|trace| key(trace)).enumerate().collect();
    order.sort_by(|(_, a), (_, b)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let ends: Vec<f64> = order.iter().map(|(_, key)| key.0).collect();
    let half = NAME_HEIGHT / 2.0;
    let places = spread(&ends, NAME_HEIGHT, top + half, bottom - half);
    let mut names = vec![0.0; traces.len()];
    for ((k, _), place) in order.into_iter().zip(places) {
        names[k] = place;
    }
    names
}

impl LineRuns<'_> {
    /// Trace with its places elsewhere.
    fn map(&self, at: impl Fn(&(f64, f64)) -> (f64, f64)) -> Self {
        let runs = self.runs.iter().map(|run| run.iter().map(&at).collect()).collect();
        Self { runs, ..*self }
    }

    /// The right end on the canvas; of several points there, the last.
    fn end(&self) -> Option<Point> {
        self.runs.iter().flatten().copied().max_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// The corners of a run.
    fn joined(&self, run: &[Point]) -> Vec<Point> {
        if self.line.kind != Kind::Steps {
            return run.to_vec();
        }
        let held = run.windows(2).flat_map(|pair| [pair[0], (pair[1].0, pair[0].1)]);
        held.chain(run.last().copied()).collect()
    }

    /// Places of the markers.
    fn markers(&self) -> Vec<Point> {
        let far = |(a, b): (f64, f64), (c, d): (f64, f64)| (c - a).hypot(d - b);
        let mut markers: Vec<Point> = Vec::new();
        for run in self.runs.iter().rev() {
            if self.line.kind == Kind::Steps && run.len() > 1 {
                let mut ahead = STEP_MARKERS * (0.15 + 0.7 * self.ink.phase);
                for pair in self.joined(run).windows(2) {
                    let way = far(pair[0], pair[1]);
                    while ahead < way {
                        let share = ahead / way;
                        let along = |a: f64, b: f64| a + share * (b - a);
                        markers.push((along(pair[0].0, pair[1].0), along(pair[0].1, pair[1].1)));
                        ahead += STEP_MARKERS;
                    }
                    ahead -= way;
                }
            } else {
                // From the end, which so always has one.
                let all = matches!(self.line.kind, Kind::Points | Kind::Failures);
                for &point in run.iter().rev() {
                    if all || markers.last().is_none_or(|&last| far(last, point) >= MARKERS) {
                        markers.push(point);
                    }
                }
            }
        }
        markers
    }
}

/// Draws a leader from the end of a line to its name, where the line reaches the frame. Through the panel a
/// leader would look like data; there the sample before the name has to do.
fn leader(svg: &mut Svg, end: Option<Point>, (right, name): Point) {
    if let Some((x, y)) = end.filter(|(x, _)| right - x < NEAR) {
        let path = Path::through([(x, y), (right, y), (right + LEADER - 3.0, name)]);
        svg.stroke(&path, Stroke::new(GUIDE, 1.0));
    }
}

/// The places of a line's points, broken where a point has none.
fn runs(panel: &Panel, line: &PlottedLine) -> Vec<Vec<Point>> {
    let place = |&(x, y): &Point| Some((panel.x.scale.place(x)?, panel.y.scale.place(y)?));
    let places: Vec<_> = line.points.iter().map(place).collect();
    places
        .split(Option::is_none)
        .filter(|run| !run.is_empty())
        .map(|run| run.iter().flatten().copied().collect())
        .collect()
}
