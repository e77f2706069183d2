//! The one writer of SVG.

use super::color::{Color, WHITE};
use super::path::{Path, Point, Short};
use super::print::Print;
use super::text::LEADING;
use std::fmt::Write as _;

const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";
/// Height from the middle of small letters to the line on which they stand, in sizes of the font.
const MIDDLE: f64 = 0.28;
/// Width of the halo around a text that stands on lines, in sizes of the font.
const HALO: f64 = 0.25;

/// End of a text that is at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins there.
    Start,
    /// The middle of the text is there.
    Middle,
    /// The text ends there.
    End,
}

impl Anchor {
    /// Anchor of a text beside a place, so far across from what it names: away from it.
    pub fn beside(across: f64) -> Self {
        match across {
            x if x > 0.3 => Self::Start,
            x if x < -0.3 => Self::End,
            _ => Self::Middle,
        }
    }
}

/// Look of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Colour of the line.
    pub color: Color,
    /// Width of the line.
    pub width: f64,
    /// Lengths of strokes and gaps in turn; none for a whole line.
    pub dashes: &'static [f64],
}

impl Stroke {
    /// A whole line.
    pub const fn new(color: Color, width: f64) -> Self {
        Self { color, width, dashes: &[] }
    }
}

/// Slanted lines over a ground, so that areas differ without colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hatch {
    /// Colour between the lines.
    pub ground: Color,
    /// Colour of the lines.
    pub color: Color,
    /// Distance from one line to the next.
    pub gap: f64,
    /// Degrees, clockwise from lines that go up and down.
    pub turn: f64,
}

/// A rigid motion on the page: a rotation about a point, and then a shift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigid {
    /// Shift to the right and down.
    pub shift: Point,
    /// Clockwise.
    pub degrees: f64,
    /// Point that the body turns about.
    pub about: Point,
}

impl Rigid {
    fn moves(&self) -> String {
        format!("{} {}", Short(self.shift.0), Short(self.shift.1))
    }

    fn turns(&self) -> String {
        format!("{:.4} {} {}", self.degrees, Short(self.about.0), Short(self.about.1))
    }
}

/// Look of a text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Type {
    /// Size of the font.
    pub size: f64,
    /// Colour of the letters.
    pub color: Color,
    /// End of the text that is at its place.
    pub anchor: Anchor,
    /// Degrees, clockwise about its place; -90 reads upwards.
    pub turn: f64,
    /// The colour around the letters, where they stand on lines.
    pub halo: Option<Color>,
}

impl Type {
    /// A text along its line that begins at its place.
    pub const fn new(size: f64, color: Color) -> Self {
        Self { size, color, anchor: Anchor::Start, turn: 0.0, halo: None }
    }

    /// Type with another end at its place.
    pub const fn at(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    /// Turned by so many degrees.
    pub const fn turned(self, turn: f64) -> Self {
        Self { turn, ..self }
    }

    /// Type with a colour around the letters.
    pub const fn on(self, ground: Color) -> Self {
        Self { halo: Some(ground), ..self }
    }
}

/// A white page, and what is drawn on it, one element a line.
///
/// ```
/// use couplet_draw::picture::{Color, Path, Stroke, Svg};
///
/// let mut svg = Svg::new((40.0, 20.0), "A slope", "It falls.");
/// svg.group("slope", |svg| {
///     let path = Path::through([(0.0, 5.0), (40.0, 15.0)]);
///     svg.stroke(&path, Stroke::new(Color(0, 0, 0), 1.5));
/// });
/// assert!(svg.finish().contains(r##"<path d="M0 5L40 15" fill="none" stroke="#000000""##));
/// ```
#[derive(Clone, Debug)]
pub struct Svg {
    text: String,
    /// Clips and hatches so far: each has a number.
    named: usize,
}

impl Svg {
    /// An empty page; the title and the description are for those who do not see it.
    pub fn new(size: Point, title: &str, description: &str) -> Self {
        Self::printed(&Print::default(), (size.0.ceil(), size.1), title, description)
    }

    /// An empty page that is printed as asked for.
    pub fn printed(print: &Print, (width, height): Point, title: &str, description: &str) -> Self {
        let height = height.ceil();
        let [wide, high] = print.size((width, height));
        let font = print.font.as_ref().map_or(String::new(), |font| format!("'{}', ", font.name()));
        let mut svg = Self { text: String::new(), named: 0 };
        svg.write(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{wide}\" height=\"{high}\" \
             viewBox=\"0 0 {} {height}\" role=\"img\" font-family=\"{font}{FAMILY}\" \
             stroke-linejoin=\"round\">",
            Short(width)
        ));
        for (tag, words) in [("title", title), ("desc", description)] {
            if !words.is_empty() {
                svg.write(format_args!("<{tag}>{}</{tag}>", escaped(words)));
            }
        }
        svg.fill(&Path::rectangle((0.0, 0.0), (width, height)), WHITE);
        svg
    }

    /// The document.
    pub fn finish(mut self) -> String {
        self.text += "</svg>\n";
        self.text
    }

    fn write(&mut self, line: std::fmt::Arguments<'_>) {
        // A string takes everything.
        let _ = writeln!(self.text, "{line}");
    }

    /// Draws a group: what belongs together, under a name of its own.
    pub fn group(&mut self, id: &str, draw: impl FnOnce(&mut Self)) {
        self.write(format_args!("<g id=\"{}\">", escaped(id)));
        draw(self);
        self.write(format_args!("</g>"));
    }

    /// Draws what is seen within a path only.
    pub fn clipped(&mut self, within: &Path, draw: impl FnOnce(&mut Self)) {
        let name = self.name("clip");
        self.write(format_args!("<clipPath id=\"{name}\"><path d=\"{within}\"/></clipPath>"));
        self.write(format_args!("<g clip-path=\"url(#{name})\">"));
        draw(self);
        self.write(format_args!("</g>"));
    }

    fn name(&mut self, kind: &str) -> String {
        self.named += 1;
        format!("{kind}-{}", self.named)
    }

    /// A line.
    pub fn stroke(&mut self, path: &Path, Stroke { color, width, dashes }: Stroke) {
        let (mut dashed, width) = (String::new(), Short(width));
        if !dashes.is_empty() {
            let lengths: Vec<String> = dashes.iter().map(|x| Short(*x).to_string()).collect();
            dashed = format!(" stroke-dasharray=\"{}\"", lengths.join(" "));
        }
        self.write(format_args!(
            "<path d=\"{path}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\"{dashed}/>"
        ));
    }

    /// An area.
    pub fn fill(&mut self, path: &Path, color: Color) {
        self.write(format_args!("<path d=\"{path}\" fill=\"{color}\"/>"));
    }

    /// An area under slanted lines.
    pub fn hatch(&mut self, path: &Path, Hatch { ground, color, gap, turn }: Hatch) {
        let (name, middle, gap, turn) =
            (self.name("hatch"), Short(gap / 2.0), Short(gap), Short(turn));
        // The ground is below and not in the pattern, which is as long as a page: its seams would be seen.
        self.fill(path, ground);
        self.write(format_args!(
            "<pattern id=\"{name}\" width=\"{gap}\" height=\"1200\" patternUnits=\"userSpaceOnUse\" \
             patternTransform=\"rotate({turn})\"><path d=\"M{middle} 0V1200\" stroke=\"{color}\" \
             stroke-width=\"1.6\"/></pattern>"
        ));
        self.write(format_args!("<path d=\"{path}\" fill=\"url(#{name})\"/>"));
    }

    /// An area through which what is below can be seen; of a `share` of 1 nothing.
    pub fn tint(&mut self, path: &Path, color: Color, share: f64) {
        let share = Short(share);
        self.write(format_args!("<path d=\"{path}\" fill=\"{color}\" fill-opacity=\"{share}\"/>"));
    }

    /// Draws something at rest, moved; with `steps`, moving through them again and again, in so many seconds.
    /// Who does not know of animations sees it where it is moved to.
    pub fn moved(
        &mut self,
        to: Rigid,
        steps: &[Rigid],
        seconds: f64,
        draw: impl FnOnce(&mut Self),
    ) {
        let (moves, turns) = (to.moves(), to.turns());
        self.write(format_args!("<g transform=\"translate({moves}) rotate({turns})\">"));
        draw(self);
        let mut animate = |kind: &str, more: &str, values: Vec<String>| {
            self.write(format_args!(
                "<animateTransform attributeName=\"transform\" type=\"{kind}\"{more} dur=\"{}s\" \
                 repeatCount=\"indefinite\" values=\"{}\"/>",
                Short(seconds),
                values.join(";")
            ));
        };
        if !steps.is_empty() {
            animate("translate", "", steps.iter().map(Rigid::moves).collect());
            animate("rotate", " additive=\"sum\"", steps.iter().map(Rigid::turns).collect());
        }
        self.write(format_args!("</g>"));
    }

    /// A disc with a line around it.
    pub fn ring(&mut self, (x, y): Point, radius: f64, color: Color, line: Stroke) {
        let (x, y, radius, width) = (Short(x), Short(y), Short(radius), Short(line.width));
        self.write(format_args!(
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{color}\" stroke=\"{}\" stroke-width=\"{width}\"/>",
            line.color
        ));
    }

    /// A disc.
    pub fn disc(&mut self, (x, y): Point, radius: f64, color: Color) {
        let (x, y, radius) = (Short(x), Short(y), Short(radius));
        self.write(format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{color}\"/>"));
    }

    /// A text whose small letters are centred at the height of its place.
    pub fn text(&mut self, text: &str, (x, y): Point, style: Type) {
        let Type { size, color, anchor, turn, halo } = style;
        let (sin, cos) = turn.to_radians().sin_cos();
        let (x, y) = (x - MIDDLE * size * sin, y + MIDDLE * size * cos);
        let mut more = String::new();
        match anchor {
            Anchor::Start => {}
            Anchor::Middle => more += " text-anchor=\"middle\"",
            Anchor::End => more += " text-anchor=\"end\"",
        }
        let (x, y) = (Short(x), Short(y));
        if turn != 0.0 {
            more += &format!(" transform=\"rotate({} {x} {y})\"", Short(turn));
        }
        if let Some(ground) = halo {
            let width = Short(HALO * size);
            more +=
                &format!(" paint-order=\"stroke\" stroke=\"{ground}\" stroke-width=\"{width}\"");
        }
        self.write(format_args!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" fill=\"{color}\"{more}>{}</text>",
            Short(size),
            escaped(text)
        ));
    }

    /// Lines of text below each other, the first with its upper edge at the place.
    pub fn lines(&mut self, lines: &[String], (x, y): Point, style: Type) {
        for (k, line) in lines.iter().enumerate() {
            self.text(line, (x, y + (k as f64 + 0.5) * style.size * LEADING), style);
        }
    }
}

/// A text as it may stand between tags and quotes.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::reading::texts;

    #[test]
    fn documents_are_well_formed_and_say_what_they_show() {
        let mut svg = Svg::new((99.5, 10.0), "<T> & \"S\"", "");
        let square = Path::rectangle((0.0, 0.0), (9.0, 9.0));
        let hatch = Hatch { ground: WHITE, color: Color(1, 2, 3), gap: 4.0, turn: 45.0 };
        svg.group("a\"b", |svg| {
            svg.clipped(&square, |svg| svg.hatch(&square, hatch));
            svg.clipped(&square, |svg| svg.disc((1.0, 2.0), 3.0, hatch.color));
        });
        svg.stroke(&square, Stroke { dashes: &[4.0, 2.5], ..Stroke::new(hatch.color, 1.0) });
        svg.lines(&["one".into(), "two".into()], (0.0, 0.0), Type::new(10.0, hatch.color));
        let text = svg.finish();
        assert!(text.starts_with("<svg ") && text.contains("width=\"100\" height=\"10\""));
        assert_eq!(texts(&text).unwrap(), ["&lt;T&gt; &amp; &quot;S&quot;", "one", "two"]);
        for part in ["url(#clip-1)", "url(#hatch-2)", "url(#clip-3)", "stroke-dasharray=\"4 2.5\""]
        {
            assert!(text.contains(part), "{text}");
        }
    }

    #[test]
    fn what_moves_is_seen_at_rest_too() {
        let at = |degrees| Rigid { shift: (1.0, -2.5), degrees, about: (5.0, 6.0) };
        let draw = |steps: &[Rigid]| {
            let mut svg = Svg::new((9.0, 9.0), "", "");
            svg.moved(at(-10.0), steps, 4.0, |svg| {
                svg.ring((1.0, 2.0), 3.0, WHITE, Stroke::new(WHITE, 1.0))
            });
            svg.finish()
        };
        let (still, moving) = (draw(&[]), draw(&[at(-10.0), at(0.0)]));
        let place = "<g transform=\"translate(1 -2.5) rotate(-10.0000 5 6)\">";
        assert!(still.contains(place) && !still.contains("animate"));
        assert!(moving.contains(place) && moving.matches("<animateTransform").count() == 2);
        assert!(moving.contains("additive=\"sum\"") && moving.contains("values=\"1 -2.5;1 -2.5\""));
        assert!(texts(&moving).is_some());
    }

    #[test]
    fn a_turned_text_has_its_middle_at_its_place() {
        let mut svg = Svg::new((9.0, 9.0), "", "");
        let style = Type::new(100.0, WHITE).at(Anchor::Middle);
        svg.text("up", (50.0, 50.0), style.turned(-90.0).on(WHITE));
        svg.text("along", (50.0, 50.0), style);
        let text = svg.finish();
        assert!(text.contains("x=\"78\" y=\"50\" ") && text.contains("rotate(-90 78 50)"));
        assert!(text.contains("x=\"50\" y=\"78\" ") && text.matches("paint-order").count() == 1);
    }
}
