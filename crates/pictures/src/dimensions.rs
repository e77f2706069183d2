//! Around an arch that is measured: span, rise and thickness, and the reaction of a shoulder.

use super::beside::Beside;
use super::metres::{Loads, Metres};
use super::numbers::{in_full, told};
use crate::atlas::{Sketch, SketchedLine};
use crate::picture::color::{GUIDE, INK, WHITE};
use crate::picture::{Anchor, Name, Path, Point, Stroke, Svg, Type, text};
use crate::problem::measures::Circle;
use crate::sketch::{PageScale, arrow};

/// Space below, for the span; and for a force above it.
pub(super) const BELOW: f64 = 64.0;
pub(super) const FORCE: f64 = 46.0;
/// Digits of a size.
const DIGITS: usize = 4;

const LABEL: f64 = 15.0;
const LINE: Stroke = Stroke::new(INK, 1.0);
const EXTENDED: Stroke = Stroke::new(GUIDE, 0.8);
/// Distance from what is measured to its line, and of the line beyond.
const OFF: f64 = 13.0;
const OVER: f64 = 5.0;
/// The length of a force.
const ARROW: f64 = 62.0;
/// Distance from its head to the point on which it acts.
const NEAR: f64 = 6.5;

/// The sizes of an arch on the page.
pub(super) struct Dimensions<'a> {
    pub sketch: &'a Sketch,
    /// Only the right half is there.
    pub half: bool,
    pub metres: &'a Metres,
    pub scale: &'a PageScale,
    /// Left, right and low ends of what is shown, on the page.
    pub ends: [f64; 3],
}

/// A line with a head at each end and a text in its middle; beside it where it is too short.
fn measure(svg: &mut Svg, [from, to]: [Point; 2], text: &str, turn: f64) {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx.hypot(dy);
    let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
    let gap = text::width(text, LABEL) / 2.0 + 6.0;
    let has_room = length > 2.0 * gap + 30.0;
    let share = if has_room { gap / length } else { 0.0 };
    for (sign, end) in [(-1.0, from), (1.0, to)] {
        arrow(svg, (middle.0 + sign * share * dx, middle.1 + sign * share * dy), end);
    }
    // To the left of one that goes up and down, below one that does not.
    let off = if has_room { 0.0 } else { LABEL };
    let at = if turn == 0.0 { (middle.0, middle.1 + off) } else { (middle.0 - off, middle.1) };
    svg.text(text, at, Type::new(LABEL, INK).at(Anchor::Middle).turned(turn).on(WHITE));
}

/// Measures beside an arch.
pub(super) fn beside(
    (sketch, metres): (&Sketch, &Metres),
    half: bool,
    [left, right]: [f64; 2],
) -> Beside {
    let wide = |words: &str| text::width(words, LABEL) + 2.0 * OFF;
    let thick = OFF + wide(&thickness(metres));
    let force = match thrust(sketch, metres) {
        words if words.is_empty() => 0.0,
        words => wide(&words).max(ARROW + OFF),
    };
    let rise = 3.0 * OFF;
    match half {
        false => Beside { left: vec![(left, force + rise)], right: vec![(right, thick)] },
        true => Beside { left: vec![(left, thick + rise)], right: vec![(right, force)] },
    }
}

fn thickness(metres: &Metres) -> String {
    format!("t {}", told(metres, &metres.thickness, DIGITS))
}

/// The radius at which a shoulder bears the arch, the middle one of the lines that are drawn.
pub(super) fn pressed(sketch: &Sketch) -> Option<f64> {
    let lines = sketch.forces.iter().flat_map(|forces| &forces.thrust_lines);
    let radius = |line: &SketchedLine| Some(1.0 + line.thickness * line.points.last()?[1]);
    let radii: Vec<f64> = lines.filter_map(radius).collect();
    (!radii.is_empty()).then(|| radii.iter().sum::<f64>() / radii.len() as f64)
}

/// The thrust, or what it can be; nothing where no force is known.
pub(super) fn thrust(sketch: &Sketch, metres: &Metres) -> String {
    let forces = &sketch.forces;
    let Some(loads) = &metres.loads else { return String::new() };
    let size = |k: usize| forces.get(k).map(|of| in_full(&loads.thrust(&of.thrust), DIGITS));
    match (size(0), size(1)) {
        (Some(least), Some(largest)) => format!("H {least}–{largest} kN"),
        (Some(least), None) if sketch.stands() => format!("H ≥ {least} kN"),
        (Some(thrust), None) => format!("H {thrust} kN"),
        (None, _) => String::new(),
    }
}

/// Load on a shoulder, in words.
pub(super) fn reaction(loads: &Loads) -> String {
    format!("V {} kN", in_full(&loads.reaction, DIGITS))
}

impl Dimensions<'_> {
    /// The measures; names that have still to find their places.
    pub(super) fn draw(&self, svg: &mut Svg) -> Vec<Name> {
        let mut names = Vec::new();
        svg.group("dimensions", |svg| {
            self.span(svg);
            self.rise(svg);
            names.push(self.thickness(svg));
        });
        if self.metres.loads.is_some() {
            svg.group("reaction", |svg| names.extend(self.reaction(svg)));
        }
        names
    }

    /// A springing point of the circle that is measured.
    fn springing(&self, side: f64) -> Point {
        self.scale.polar(self.sketch.half_opening(), self.metres.share, side)
    }

    fn span(&self, svg: &mut Svg) {
        let [_, _, low] = self.ends;
        let loaded = if self.metres.loads.is_some() { FORCE } else { 0.0 };
        let y = low + BELOW - 18.0 + loaded;
        let right = self.springing(1.0);
        let left = if self.half { (self.scale.center.0, low) } else { self.springing(-1.0) };
        for (x, from) in [left, right] {
            svg.stroke(&Path::through([(x, from + OVER), (x, y + OVER)]), EXTENDED);
        }
        let at = match self.metres.circle {
            Circle::Centreline => "",
            circle => &format!(" at the {}", circle.name()),
        };
        let half = if self.half { "half of the " } else { "" };
        let text = format!("{half}span {}{at}", told(self.metres, &self.metres.span, DIGITS));
        measure(svg, [(left.0, y), (right.0, y)], &text, 0.0);
    }

    fn rise(&self, svg: &mut Svg) {
        let [left, _, _] = self.ends;
        let side = if self.half { 1.0 } else { -1.0 };
        // Beyond a force at the shoulder, or beyond the thickness at the crown.
        let beside = beside((self.sketch, self.metres), self.half, [0.0; 2]);
        let x = left - beside.left[0].1 + LABEL + OVER;
        let (crown, springing) =
            (self.scale.polar(0.0, self.metres.share, 1.0), self.springing(side));
        for (to, y) in [crown, springing] {
            svg.stroke(&Path::through([(x - OVER, y), (to, y)]), EXTENDED);
        }
        let text = format!("rise {}", told(self.metres, &self.metres.rise, DIGITS));
        measure(svg, [(x, crown.1), (x, springing.1)], &text, -90.0);
    }

    /// Beyond the right shoulder; of a half arch beyond its crown, as forces are at the shoulder.
    fn thickness(&self, svg: &mut Svg) -> Name {
        let sketch = self.sketch;
        let joint = if self.half { 0.0 } else { sketch.half_opening() };
        let (down, across) = joint.sin_cos();
        let sign = if self.half { -1.0 } else { 1.0 };
        let beyond = |(x, y): Point, by: f64| (x + sign * by * across, y + sign * by * down);
        let ends = sketch.radii().map(|radius| self.scale.polar(joint, radius, 1.0));
        for end in ends {
            svg.stroke(&Path::through([beyond(end, 3.0), beyond(end, OFF + OVER)]), EXTENDED);
        }
        let ends = ends.map(|end| beyond(end, OFF));
        let middle = ((ends[0].0 + ends[1].0) / 2.0, (ends[0].1 + ends[1].1) / 2.0);
        svg.stroke(&Path::through(ends), LINE);
        ends.iter().for_each(|end| arrow(svg, middle, *end));
        Name::new(thickness(self.metres), middle, (sign * across, sign * down))
    }

    /// The reaction of the ground on the left shoulder, or on that of the half arch.
    fn reaction(&self, svg: &mut Svg) -> Vec<Name> {
        let Some(loads) = &self.metres.loads else { return Vec::new() };
        let side = if self.half { 1.0 } else { -1.0 };
        let alpha = self.sketch.half_opening();
        let Some(radius) = pressed(self.sketch) else { return Vec::new() };
        let (x, y) = self.scale.polar(alpha, radius, side);
        let aside = self.scale.polar(alpha, self.sketch.radii()[1], side).0;
        let aside = if side < 0.0 { aside.min(x) } else { aside.max(x) };
        arrow(svg, (aside + side * ARROW, y), (x + side * NEAR, y));
        arrow(svg, (x, y + ARROW), (x, y + NEAR));
        let reaction = reaction(loads);
        vec![
            Name::new(
                thrust(self.sketch, self.metres),
                (aside + side * ARROW / 2.0, y),
                (side, 2.0),
            ),
            Name::new(reaction, (x, y + ARROW), (side, -0.1)),
        ]
    }
}
