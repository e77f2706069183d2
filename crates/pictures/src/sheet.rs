//! Headings above the pictures of arches, a legend and words below.

use super::legend::Legend;
use crate::picture::color::INK;
use crate::picture::{Anchor, Page, Point, Svg, Type, text};

/// Lines above an arch, with their sizes.
pub(super) struct Headings(Vec<(String, f64)>);

/// Room of a line beyond its letters.
const LEADING: f64 = 6.0;
/// Room between a legend and what is said below it.
pub(super) const GAP: f64 = 16.0;

impl Headings {
    /// Lines of so much room at most.
    pub(super) fn of(words: impl IntoIterator<Item = (String, f64)>, room: f64) -> Self {
        let wrapped = |(words, size): (String, f64)| {
            text::wrap(&words, size, room).into_iter().map(move |line| (line, size))
        };
        Self(words.into_iter().flat_map(wrapped).collect())
    }

    /// Height of all lines.
    pub(super) fn height(&self) -> f64 {
        self.0.iter().map(|(_, size)| size + LEADING).sum()
    }

    /// Draws them below a place, which is above their middle.
    pub(super) fn draw(&self, svg: &mut Svg, (middle, mut y): Point) {
        for (line, size) in &self.0 {
            let high = size + LEADING;
            svg.text(line, (middle, y + high / 2.0), Type::new(*size, INK).at(Anchor::Middle));
            y += high;
        }
    }
}

/// A picture with a title for those who do not see it: what is drawn, from `bottom` on its legend, and words below.
pub(super) fn sheet(
    page: &Page,
    (title, words): (&str, &[String]),
    (legend, bottom): (&Legend, f64),
    draw: impl FnOnce(&mut Svg),
) -> String {
    let svg = page.svg(title, words, bottom + legend.height() + GAP, |svg| {
        draw(svg);
        legend.draw(svg, (Page::MARGIN, bottom), page.room());
    });
    svg.finish()
}
