//! Panels in rows, under a title.

use super::drawn::{Drawn, FRAME, NARROW, Room};
use super::ink::Inks;
use super::panel::Panel;
use crate::picture::color::INK;
use crate::picture::{Page, Print, Type, text};
use std::io;

/// Panels in rows, under a title.
///
/// ```
/// use couplet_draw::picture::Print;
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
/// assert!(figure.svg(&Print::default()).unwrap().starts_with("<svg "));
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
const MARGIN: f64 = Page::MARGIN;
/// Distances between columns, and between rows.
const BETWEEN: (f64, f64) = (30.0, 26.0);
/// Size of the title.
const TITLE: f64 = 22.0;
/// Letters of the panels, where there are several and enough letters.
const LETTERS: &str = "abcdefghijklmnopqrstuvwxyz";

/// The panels in rows, with the room that a column and a row share, so that the frames are aligned.
struct Rows<'a> {
    drawn: Vec<Drawn<'a>>,
    across: Vec<Room>,
    down: Vec<Room>,
}

impl Rows<'_> {
    /// Width of the figure.
    fn width(&self) -> f64 {
        total(self.across.iter().map(Room::width), BETWEEN.0) + 2.0 * MARGIN
    }
}

impl Figure {
    /// The figure as SVG, as it is printed: of a width of its own with fewer panels in a row, where these have no room.
    pub fn svg(&self, print: &Print) -> io::Result<String> {
        self.captioned(print, &[])
    }

    /// The figure as SVG with words below.
    pub fn captioned(&self, print: &Print, words: &[String]) -> io::Result<String> {
        let most = self.columns.clamp(1, self.panels.len().max(1));
        let own = self.rows(most, FRAME.0);
        let title = if print.title { &self.title[..] } else { "" };
        let limit = (own.width() - 2.0 * MARGIN).max(300.0);
        let title_of = |limit: f64| text::wrap(title, TITLE, limit);
        let lines = title_of(limit);
        let natural = own.width().max(text::widest(&lines, TITLE) + 2.0 * MARGIN);
        let page = Page::new(print, natural.ceil(), self.rows(1, NARROW).width())?;
        let fitted = |columns: usize| {
            let missing = page.width - self.rows(columns, FRAME.0).width();
            let wide = FRAME.0 + missing / columns as f64;
            (columns == 1 || wide >= NARROW).then(|| self.rows(columns, wide))
        };
        let (rows, title) = match print.width {
            None => (own, lines),
            Some(_) => {
                let rows = (1..=most).rev().find_map(fitted).unwrap_or(own);
                (rows, title_of(page.room()))
            }
        };
        let head = match title.len() {
            0 => 0.0,
            n => n as f64 * TITLE * text::LEADING + 14.0,
        };
        let height = total(rows.down.iter().map(Room::height), BETWEEN.1);
        let foot = MARGIN + head + height + if words.is_empty() { 0.0 } else { MARGIN };
        let svg = page.svg(&self.title, words, foot, |svg| {
            svg.lines(&title, (MARGIN, MARGIN), Type::new(TITLE, INK));
            let mut top = MARGIN + head;
            for (row, high) in rows.drawn.chunks(rows.across.len()).zip(&rows.down) {
                let mut left = MARGIN;
                for (panel, wide) in row.iter().zip(&rows.across) {
                    panel.draw(svg, (left + wide.left, top + high.top), high.frame);
                    left += wide.width() + BETWEEN.0;
                }
                top += high.height() + BETWEEN.1;
            }
        });
        Ok(svg.finish())
    }

    /// The panels, so many in a row, each with a frame of a width.
    fn rows(&self, columns: usize, wide: f64) -> Rows<'_> {
        let inks = Inks::new(self.panels.iter().flat_map(|panel| &panel.lines));
        let letters = |k: usize| {
            LETTERS.get(k..=k).filter(|_| (2..=LETTERS.len()).contains(&self.panels.len()))
        };
        let panels = self.panels.iter().enumerate();
        let drawn: Vec<Drawn> =
            panels.map(|(k, panel)| Drawn::new(panel, letters(k), &inks, wide)).collect();
        let shared = |members: &mut dyn Iterator<Item = &Drawn>| {
            members.map(|panel| panel.room).reduce(Room::join).unwrap_or_default()
        };
        let across =
            (0..columns).map(|k| shared(&mut drawn.iter().skip(k).step_by(columns))).collect();
        let down = drawn.chunks(columns).map(|row| shared(&mut row.iter())).collect();
        Rows { drawn, across, down }
    }
}

/// The sum of lengths with a gap between them.
fn total(lengths: impl ExactSizeIterator<Item = f64>, gap: f64) -> f64 {
    let gaps = gap * lengths.len().saturating_sub(1) as f64;
    lengths.sum::<f64>() + gaps
}
