//! The one writer of SVG.

use super::color::{Color, GRID, INK, WHITE};
use super::labels::Labels;
use super::path::{Path, Point, Short};
use super::print::Print;
use super::room::{Rectangle, about, within};
use super::text::{LEADING, width};
use std::fmt::Write as _;

const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";
/// Height from the middle of small letters to the line on which they stand, in sizes of the font.
const MIDDLE: f64 = 0.28;
/// Half the height of a text, and what a ground has beside one that stands on lines, in sizes of the font.
const HALF: f64 = 0.55;
const BESIDE: f64 = 0.12;

/// End of a text that is at its place, by the number that it has in DXF.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins there.
    Start = 0,
    /// The middle of the text is there.
    Middle = 1,
    /// The text ends there.
    End = 2,
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
    fn of(&self, (x, y): Point) -> Point {
        let (sin, cos) = self.degrees.to_radians().sin_cos();
        let (dx, dy) = (x - self.about.0, y - self.about.1);
        (
            self.about.0 + self.shift.0 + cos * dx - sin * dy,
            self.about.1 + self.shift.1 + sin * dx + cos * dy,
        )
    }

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
    /// The ground of the letters, where they stand on lines.
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

    /// Type with a ground of its own.
    pub const fn on(self, ground: Color) -> Self {
        Self { halo: Some(ground), ..self }
    }
}

/// A name, the point that has it, and the direction in which it stands if it can.
#[derive(Clone, Debug)]
pub struct Name {
    /// The name.
    pub words: String,
    /// The point.
    pub at: Point,
    /// The direction from the point.
    pub towards: Point,
    /// Colour of the letters.
    pub color: Color,
}

impl Name {
    /// A name of a point.
    pub fn new(words: impl Into<String>, at: Point, towards: Point) -> Self {
        Self { words: words.into(), at, towards, color: INK }
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
    /// The names of groups so far, and those of the groups that are open.
    ids: [Vec<String>; 2],
    /// All that is seen: what names keep off.
    drawn: Labels,
    /// Where what is drawn is seen, and the motion of it.
    clip: Option<Rectangle>,
    motion: Option<Rigid>,
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
        let drawn = Labels { window: Some([(0.0, 0.0), (width, height)]), ..Labels::default() };
        let (text, ids) = (String::new(), [Vec::new(), Vec::new()]);
        let mut svg = Self { text, named: 0, ids, drawn, clip: None, motion: None };
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

    /// Draws a group: what belongs together, under a name of its own. Where that is taken, the name of the group around
    /// it stands before it.
    pub fn group(&mut self, id: &str, draw: impl FnOnce(&mut Self)) {
        let [known, open] = &mut self.ids;
        let around = open.last().map_or("", String::as_str);
        let id = if known.iter().any(|one| one == id) {
            format!("{around}-{id}")
        } else {
            id.to_owned()
        };
        known.push(id.clone());
        self.write(format_args!("<g id=\"{}\">", escaped(&id)));
        self.ids[1].push(id);
        draw(self);
        self.ids[1].pop();
        self.write(format_args!("</g>"));
    }

    /// The part of the page in which names stand from now on.
    pub fn window(&mut self, window: Rectangle) {
        self.drawn.window = Some(window);
    }

    /// Writes names beside their points, off all that is drawn so far and off each other; the type follows from where
    /// the middle of one is, and its ground is seen where the name stands on lines.
    pub fn names(&mut self, names: &[Name], style: impl Fn(Point) -> Type) {
        self.drawn.points.extend(names.iter().map(|name| name.at));
        for Name { words, at, towards, color } in names {
            let size = style(*at).size;
            let half = (width(words, size) / 2.0 + 2.0, HALF * size);
            let middle = self.drawn.beside(*at, half, *towards);
            let is_crossed = self.drawn.is_crossed(about(middle, half));
            let style = Type { color: *color, ..style(middle).at(Anchor::Middle) };
            self.text(words, middle, Type { halo: style.halo.filter(|_| is_crossed), ..style });
        }
    }

    /// Keeps names off an area from now on.
    pub fn take(&mut self, area: Rectangle) {
        self.drawn.taken.push(area);
    }

    /// Keeps names off a line, where it is seen.
    fn keep(&mut self, path: &Path) {
        let motion = self.motion;
        for line in path.points() {
            let line = line.into_iter().map(|at| motion.map_or(at, |motion| motion.of(at)));
            let line: Vec<Point> = line.collect();
            match self.clip {
                None => self.drawn.lines.push(line),
                Some(clip) => {
                    let parts = line.windows(2).map(|part| within(part, clip));
                    self.drawn.lines.extend(parts.filter(|part| part.len() > 1));
                }
            }
        }
    }

    /// Draws what is seen within a path only.
    pub fn clipped(&mut self, within: &Path, draw: impl FnOnce(&mut Self)) {
        let name = self.name("clip");
        self.write(format_args!("<clipPath id=\"{name}\"><path d=\"{within}\"/></clipPath>"));
        self.write(format_args!("<g clip-path=\"url(#{name})\">"));
        let around = std::mem::replace(&mut self.clip, hull(&within.points().concat()));
        draw(self);
        self.clip = around;
        self.write(format_args!("</g>"));
    }

    fn name(&mut self, kind: &str) -> String {
        self.named += 1;
        format!("{kind}-{}", self.named)
    }

    /// A line.
    pub fn stroke(&mut self, path: &Path, Stroke { color, width, dashes }: Stroke) {
        if color != GRID {
            self.keep(path);
        }
        let lengths: Vec<String> = dashes.iter().map(|x| Short(*x).to_string()).collect();
        let dashed = match dashes {
            [] => String::new(),
            _ => format!(" stroke-dasharray=\"{}\"", lengths.join(" ")),
        };
        let width = Short(width);
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
        let around = self.motion.replace(to);
        draw(self);
        self.motion = around;
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
        self.take(about((x, y), (radius, radius)));
        let (x, y, radius, width) = (Short(x), Short(y), Short(radius), Short(line.width));
        self.write(format_args!(
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{color}\" stroke=\"{}\" stroke-width=\"{width}\"/>",
            line.color
        ));
    }

    /// A disc.
    pub fn disc(&mut self, (x, y): Point, radius: f64, color: Color) {
        self.take(about((x, y), (radius, radius)));
        let (x, y, radius) = (Short(x), Short(y), Short(radius));
        self.write(format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{color}\"/>"));
    }

    /// A text whose small letters are centred at the height of its place.
    pub fn text(&mut self, text: &str, (x, y): Point, style: Type) {
        let Type { size, color, anchor, turn, halo } = style;
        let (sin, cos) = turn.to_radians().sin_cos();
        let (from, anchored) = match anchor {
            Anchor::Start => (0.0, ""),
            Anchor::Middle => (-0.5, " text-anchor=\"middle\""),
            Anchor::End => (-1.0, " text-anchor=\"end\""),
        };
        let corner = |(along, up): Point| (x + along * cos - up * sin, y + along * sin + up * cos);
        let (long, more, half) = (width(text, size), BESIDE * size, HALF * size);
        let (left, right) = (from * long - more, (from + 1.0) * long + more);
        let corners = [(left, -half), (right, -half), (right, half), (left, half)].map(corner);
        if let Some(ground) = halo {
            self.fill(&Path::around(corners), ground);
        }
        self.drawn.taken.extend(hull(&corners));
        let (x, y) = (x - MIDDLE * size * sin, y + MIDDLE * size * cos);
        let (x, y) = (Short(x), Short(y));
        let turned = match turn == 0.0 {
            true => String::new(),
            false => format!(" transform=\"rotate({} {x} {y})\"", Short(turn)),
        };
        self.write(format_args!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" fill=\"{color}\"{anchored}{turned}>{}</text>",
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

/// The rectangle about some points.
fn hull(points: &[Point]) -> Option<Rectangle> {
    let end = |pick: fn(f64, f64) -> f64| {
        points.iter().copied().reduce(|a, b| (pick(a.0, b.0), pick(a.1, b.1)))
    };
    Some([end(f64::min)?, end(f64::max)?])
}

/// A text as it may stand between tags and quotes.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::reading::{texts, trouble};

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

    /// A style sheet finds each group by its name.
    #[test]
    fn no_two_groups_have_one_name() {
        let mut svg = Svg::new((9.0, 9.0), "", "");
        for panel in ["panel-0", "panel-1"] {
            svg.group(panel, |svg| svg.group("thrust", |_| {}));
        }
        let text = svg.finish();
        for id in ["panel-0", "thrust", "panel-1", "panel-1-thrust"] {
            assert_eq!(text.matches(&format!("<g id=\"{id}\">")).count(), 1, "{id}");
        }
    }

    #[test]
    fn names_keep_off_all_that_is_drawn() {
        let mut svg = Svg::new((200.0, 100.0), "", "");
        let ink = Color(0, 0, 0);
        let turned = Rigid { shift: (0.0, 0.0), degrees: 90.0, about: (100.0, 50.0) };
        svg.moved(turned, &[], 1.0, |svg| {
            svg.stroke(&Path::through([(100.0, 30.0), (100.0, 0.0)]), Stroke::new(ink, 1.0));
        });
        svg.text("here", (70.0, 50.0), Type::new(16.0, ink).at(Anchor::Middle));
        let names = [
            Name::new("one", (100.0, 50.0), (1.0, 0.0)),
            Name::new("two", (100.0, 50.0), (-1.0, 0.0)),
        ];
        svg.names(&names, |_| Type::new(16.0, ink).on(WHITE));
        assert!(svg.drawn.taken.iter().all(|area| !svg.drawn.is_crossed(*area)));
        assert_eq!(trouble(&svg.finish()), None);
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
        assert!(text.contains("x=\"50\" y=\"78\" "));
        let ground = text.lines().filter(|line| line.contains("<path")).nth(1).unwrap();
        assert!(ground.starts_with("<path d=\"M-5 ") && ground.contains("fill=\"#ffffff\""));
    }
}
