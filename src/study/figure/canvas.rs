//! Strokes, fills and texts as SVG.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// The colour of text and frames.
pub(super) const INK: RGBColor = RGBColor(0x22, 0x22, 0x22);

/// The backend rounds to integers: it gets a canvas so many times as large.
const FINE: f64 = 10.0;
/// The backend divides the sizes of fonts by this.
const FONT: f64 = 1.24;
const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

/// Which end of a text is at its place.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// Draws in units of the finished figure.
pub(super) struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

/// What `content` draws on a white page.
pub(super) fn svg((width, height): (f64, f64), content: impl FnOnce(&Canvas)) -> String {
    let (width, height) = (width.ceil(), height.ceil());
    let (fine_width, fine_height) = ((width * FINE) as u32, (height * FINE) as u32);
    let mut text = String::new();
    let backend = SVGBackend::with_string(&mut text, (fine_width, fine_height));
    let canvas = Canvas { area: backend.into_drawing_area() };
    canvas.area.fill(&WHITE).expect(STRING);
    content(&canvas);
    canvas.area.present().expect(STRING);
    drop(canvas);
    let (_, body) = text.split_once('>').expect("the backend opens the document");
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {fine_width} {fine_height}\" stroke-linejoin=\"round\">{body}"
    )
}

const STRING: &str = "a string takes everything";

impl Canvas<'_> {
    /// A line through points.
    pub(super) fn stroke(&self, points: &[(f64, f64)], color: RGBColor, width: f64) {
        let style = color.stroke_width((width * FINE).round() as u32);
        let points: Vec<_> = points.iter().map(fine).collect();
        self.area.draw(&PathElement::new(points, style)).expect(STRING);
    }

    /// An area within points.
    pub(super) fn fill(&self, points: &[(f64, f64)], color: RGBColor) {
        let points: Vec<_> = points.iter().map(fine).collect();
        self.area.draw(&Polygon::new(points, color.filled())).expect(STRING);
    }

    /// A disc.
    pub(super) fn disc(&self, centre: (f64, f64), radius: f64, color: RGBColor) {
        let radius = (radius * FINE).round() as i32;
        self.area.draw(&Circle::new(fine(&centre), radius, color.filled())).expect(STRING);
    }

    /// A text whose small letters are centred at the height of `at`.
    pub(super) fn text(
        &self,
        text: &str,
        at: (f64, f64),
        anchor: Anchor,
        size: f64,
        color: RGBColor,
    ) {
        self.write(text, at, anchor, size, color, FontTransform::None);
    }

    /// A text that reads upwards, its middle at `at`.
    pub(super) fn upwards(&self, text: &str, at: (f64, f64), size: f64, color: RGBColor) {
        self.write(text, at, Anchor::Middle, size, color, FontTransform::Rotate270);
    }

    /// Lines of text below each other, the first with its upper edge at `at`.
    pub(super) fn lines(
        &self,
        lines: &[String],
        at: (f64, f64),
        anchor: Anchor,
        size: f64,
        color: RGBColor,
    ) {
        for (k, line) in lines.iter().enumerate() {
            let y = at.1 + (k as f64 + 0.5) * size * super::text::LEADING;
            self.text(line, (at.0, y), anchor, size, color);
        }
    }

    fn write(
        &self,
        text: &str,
        at: (f64, f64),
        anchor: Anchor,
        size: f64,
        color: RGBColor,
        turned: FontTransform,
    ) {
        let horizontal = match anchor {
            Anchor::Start => HPos::Left,
            Anchor::Middle => HPos::Center,
            Anchor::End => HPos::Right,
        };
        let style = (FAMILY, size * FINE * FONT)
            .into_font()
            .color(&color)
            .pos(Pos::new(horizontal, VPos::Center))
            .transform(turned);
        self.area.draw(&Text::new(text, fine(&at), style)).expect(STRING);
    }
}

fn fine(&(x, y): &(f64, f64)) -> (i32, i32) {
    ((x * FINE).round() as i32, (y * FINE).round() as i32)
}
