//! Figures: panels of labelled lines, as SVG and as PNG.
//!
//! | file | what it does |
//! |---|---|
//! | `scale` | where a value lies on an axis, and the ticks |
//! | `ink` | the colour, dashes and marker of a line |
//! | `text` | the width of a text, its lines, powers of ten |
//! | `spread` | labels pushed apart |
//! | `panel` | one panel: what it shows, the room it needs, how it is drawn |
//! | `canvas` | strokes, fills and texts as SVG |
//! | `png` | SVG as pixels |
//!
//! The text is the same whenever the figure is the same.

mod canvas;
mod ink;
mod panel;
mod png;
mod scale;
mod spread;
mod text;

use canvas::{Anchor, INK};
use ink::Inks;
use panel::{Drawn, Room};
pub use scale::Scale;

/// Panels in rows, under a title.
///
/// ```
/// use couplet::study::figure::{Axis, Figure, Kind, Line, Panel, Scale};
///
/// let points = vec![(1e-6, 1e-16), (1e-4, 1e-60), (1e-2, 1e-300)];
/// let panel = Panel {
///     title: "Landmark T".into(),
///     x: Axis { label: "time (s)".into(), scale: Scale::Log10 },
///     y: Axis { label: "relative error".into(), scale: Scale::Log10 },
///     lines: vec![Line { label: "Newton".into(), points, kind: Kind::Measured }],
/// };
/// let figure = Figure { title: "Error against time".into(), panels: vec![panel], columns: 1 };
/// assert!(figure.svg().starts_with("<svg "));
/// ```
#[derive(Clone, Debug)]
pub struct Figure {
    /// Above all panels; may be empty.
    pub title: String,
    /// Row by row.
    pub panels: Vec<Panel>,
    /// Panels in a row.
    pub columns: usize,
}

/// Lines over two axes.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Above the panel; may be empty.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Lines with one label look the same in all panels.
    pub lines: Vec<Line>,
}

/// What an axis shows.
#[derive(Clone, Debug)]
pub struct Axis {
    /// The quantity, with its unit.
    pub label: String,
    /// Where a value lies.
    pub scale: Scale,
}

/// Points with a label.
#[derive(Clone, Debug)]
pub struct Line {
    /// Written at the right end.
    pub label: String,
    /// In the order in which they are joined. A point without a place on the axes (a NaN, an infinity,
    /// what is not positive on a logarithmic scale) is a gap.
    pub points: Vec<(f64, f64)>,
    /// How they are joined.
    pub kind: Kind,
}

/// How the points of a line are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Straight, with markers at the points; where points are dense, at some of them.
    Measured,
    /// Straight, dashed and grey, without markers.
    Reference,
    /// A value holds until the next point; a few markers tell the lines apart.
    Steps,
}

/// Around the figure.
const MARGIN: f64 = 16.0;
/// Between columns, and between rows.
const BETWEEN: (f64, f64) = (30.0, 26.0);
/// Size of the title.
const TITLE: f64 = 22.0;

impl Figure {
    /// The figure as SVG.
    pub fn svg(&self) -> String {
        let inks = Inks::new(self.panels.iter().flat_map(|panel| &panel.lines));
        let drawn: Vec<Drawn> = self.panels.iter().map(|panel| Drawn::new(panel, &inks)).collect();
        let columns = self.columns.clamp(1, drawn.len().max(1));
        // What a column or a row shares, so that the frames are aligned.
        let shared = |members: &mut dyn Iterator<Item = &Drawn>| {
            members.map(|panel| panel.room).reduce(Room::join).unwrap_or_default()
        };
        let across: Vec<Room> =
            (0..columns).map(|k| shared(&mut drawn.iter().skip(k).step_by(columns))).collect();
        let down: Vec<Room> = drawn.chunks(columns).map(|row| shared(&mut row.iter())).collect();

        let inner = total(across.iter().map(|room| room.width()), BETWEEN.0);
        let title = text::wrap(&self.title, TITLE, inner.max(300.0));
        let widest = title.iter().map(|line| text::width(line, TITLE)).fold(inner, f64::max);
        let head = match title.len() {
            0 => 0.0,
            n => n as f64 * TITLE * text::LEADING + 14.0,
        };
        let inner_height = total(down.iter().map(|room| room.height()), BETWEEN.1);
        let size = (widest + 2.0 * MARGIN, head + inner_height + 2.0 * MARGIN);

        canvas::svg(size, |canvas| {
            canvas.lines(&title, (MARGIN, MARGIN), Anchor::Start, TITLE, INK);
            let mut top = MARGIN + head;
            for (row, high) in drawn.chunks(columns).zip(&down) {
                let mut left = MARGIN;
                for (panel, wide) in row.iter().zip(&across) {
                    panel.draw(canvas, (left + wide.left, top + high.top), high.frame);
                    left += wide.width() + BETWEEN.0;
                }
                top += high.height() + BETWEEN.1;
            }
        })
    }

    /// The figure as a PNG file, one pixel a unit of the SVG.
    pub fn png(&self) -> Vec<u8> {
        png::render(&self.svg())
    }
}

/// The sum of lengths with a gap between them.
fn total(lengths: impl ExactSizeIterator<Item = f64>, gap: f64) -> f64 {
    let gaps = gap * lengths.len().saturating_sub(1) as f64;
    lengths.sum::<f64>() + gaps
}

#[cfg(test)]
mod tests;
