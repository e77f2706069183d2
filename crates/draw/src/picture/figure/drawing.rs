//! Panels in rows, under a title.

use super::drawn::{Drawn, Room};
use super::ink::Inks;
use super::panel::Panel;
use crate::picture::color::INK;
use crate::picture::{Svg, Type, text};

/// Panels in rows, under a title.
///
/// ```
/// use couplet_draw::picture::figure::{Axis, Figure, Kind, PlottedLine, Panel, Scale};
///
/// let points = vec![(1e-6, 1e-16), (1e-4, 1e-60), (1e-2, 1e-300)];
/// let panel = Panel {
///     title: "Landmark T".into(),
///     x: Axis { label: "time (s)".into(), scale: Scale::Log10 },
///     y: Axis { label: "relative error".into(), scale: Scale::Log10 },
///     lines: vec![PlottedLine { label: "Newton".into(), points, kind: Kind::Measured }],
/// };
/// let figure = Figure { title: "Error against time".into(), panels: vec![panel], columns: 1 };
/// assert!(figure.svg().starts_with("<svg "));
/// ```
#[derive(Clone, Debug)]
pub struct Figure {
    /// Title above all panels; may be empty.
    pub title: String,
    /// Row by row.
    pub panels: Vec<Panel>,
    /// Panels in a row.
    pub columns: usize,
}

/// Around the figure.
const MARGIN: f64 = 16.0;
/// Distances between columns, and between rows.
const BETWEEN: (f64, f64) = (30.0, 26.0);
/// Size of the title.
const TITLE: f64 = 22.0;
/// Letters of the panels, where there are several and enough letters.
const LETTERS: &str = "abcdefghijklmnopqrstuvwxyz";

impl Figure {
    /// The figure as SVG.
    pub fn svg(&self) -> String {
        let inks = Inks::new(self.panels.iter().flat_map(|panel| &panel.lines));
        let letters = |k: usize| {
            LETTERS.get(k..=k).filter(|_| (2..=LETTERS.len()).contains(&self.panels.len()))
        };
        let panels = self.panels.iter().enumerate();
        let drawn: Vec<Drawn> =
            panels.map(|(k, panel)| Drawn::new(panel, letters(k), &inks)).collect();
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

        let mut svg = Svg::new(size, &self.title, "");
        svg.lines(&title, (MARGIN, MARGIN), Type::new(TITLE, INK));
        let mut top = MARGIN + head;
        for (row, high) in drawn.chunks(columns).zip(&down) {
            let mut left = MARGIN;
            for (panel, wide) in row.iter().zip(&across) {
                panel.draw(&mut svg, (left + wide.left, top + high.top), high.frame);
                left += wide.width() + BETWEEN.0;
            }
            top += high.height() + BETWEEN.1;
        }
        svg.finish()
    }

    /// The figure as a PNG file.
    #[cfg(feature = "plots")]
    pub fn png(&self) -> Vec<u8> {
        crate::picture::png::render(&self.svg())
    }
}

/// The sum of lengths with a gap between them.
fn total(lengths: impl ExactSizeIterator<Item = f64>, gap: f64) -> f64 {
    let gaps = gap * lengths.len().saturating_sub(1) as f64;
    lengths.sum::<f64>() + gaps
}
