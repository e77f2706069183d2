//! The page of a picture: what is drawn, and its words below.

use super::color::INK;
use super::{Print, Svg, Type, text};
use std::io;

/// A page as it is printed.
#[derive(Clone, Copy, Debug)]
pub struct Page<'a> {
    /// Width in the units of the picture.
    pub width: f64,
    print: &'a Print,
}

impl<'a> Page<'a> {
    /// Room around what is drawn.
    pub const MARGIN: f64 = 20.0;
    /// Size of a heading.
    pub const TITLE: f64 = 19.0;
    /// Size of words below a heading, or beside a place.
    pub const LABEL: f64 = 16.0;
    /// Size of letters of legends and of what is said below.
    pub const SMALL: f64 = 15.0;

    /// A page as wide as this unless another width is asked for, which may be no less than `least`.
    pub fn new(print: &'a Print, own: f64, least: f64) -> io::Result<Self> {
        Ok(Self { width: print.room(own, least)?, print })
    }

    /// A page with room between its margins.
    pub fn with_room(print: &'a Print, own: f64, least: f64) -> io::Result<Self> {
        Self::new(print, own + 2.0 * Self::MARGIN, least + 2.0 * Self::MARGIN)
    }

    /// Room between the margins.
    pub fn room(&self) -> f64 {
        self.width - 2.0 * Self::MARGIN
    }

    /// The picture, with a title for those who do not see it: what is drawn, and from `foot` on the paragraphs.
    pub fn svg(
        &self,
        title: &str,
        words: &[String],
        foot: f64,
        draw: impl FnOnce(&mut Svg),
    ) -> Svg {
        let lines = self.print.caption(words, Self::SMALL, self.room());
        let height = foot + lines.len() as f64 * Self::SMALL * text::LEADING + Self::MARGIN;
        let mut svg = Svg::printed(self.print, (self.width, height), title, &words.join(" "));
        draw(&mut svg);
        if !lines.is_empty() {
            let (at, style) = ((Self::MARGIN, foot), Type::new(Self::SMALL, INK));
            svg.group("caption", |svg| svg.lines(&lines, at, style));
        }
        svg
    }
}
