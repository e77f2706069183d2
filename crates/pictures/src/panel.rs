//! One arch with its heading, the names of its joints, and its measures.

use super::beside::Beside;
use super::caption::{between, title};
use super::dimensions::{self, Dimensions};
use super::joints::named;
use super::metres::Metres;
use super::notation::{self, ArchNotation};
use super::numbers::label;
use super::sheet::Headings;
use super::{Sketched, Style, at_limit};
use crate::atlas::{Collapse, Forces, Sketch};
use crate::picture::color::{GUIDE, INK, WHITE};
use crate::picture::{Name, Page, Path, Print, Stroke, Svg, Type, text};
use crate::sketch::{ArchView, Blocks, Hull, PageScale};

/// One arch with a mode in which it falls.
pub(super) struct ModePanel<'a> {
    pub sketch: &'a Sketch,
    pub collapse: Option<&'a Collapse>,
    pub view: ArchView<'a>,
    pub style: Style,
    /// Measures of the arch, if it has any.
    pub metres: Option<Metres>,
    /// Frictions between which it collapses so, where that is told.
    pub between: Option<String>,
}

/// Distance from the outermost point of a joint to its name, in units of the page.
const AWAY: f64 = 13.0;

impl<'a> ModePanel<'a> {
    pub(super) fn all(drawn: &'a Sketched) -> Vec<Self> {
        let style = drawn.style;
        let panel = |(place, (sketch, collapse)): (usize, (&'a Sketch, Option<&'a Collapse>))| {
            let view = view(sketch, collapse, style);
            let (metres, between) = (drawn.metres(sketch), between(drawn, place));
            Self { sketch, collapse, view, style, metres, between }
        };
        drawn.panels().enumerate().map(panel).collect()
    }

    /// The heading, and what it means, in a panel of a width.
    pub(super) fn headings(&self, width: f64, print: &Print) -> Headings {
        let [heading, words] = match self.style.notation {
            _ if !print.title => return Headings::of([], width),
            true => notation::TITLE.map(str::to_owned),
            false => title(self.sketch, self.collapse),
        };
        let words = self.between.clone().unwrap_or(words);
        Headings::of([(heading, Page::TITLE), (words, Page::LABEL)], width)
    }

    pub(super) fn draw(&self, svg: &mut Svg, scale: &PageScale) {
        let sketch = self.sketch;
        self.view.body(svg, scale);
        let Hull { left, right, low, .. } = self.view.hull();
        let mut names = match &self.metres {
            Some(metres) => {
                let ((x, low), right) = (scale.at([left, low], 1.0), scale.at([right, 0.0], 1.0).0);
                let half = self.style.half;
                Dimensions { sketch, half, metres, scale, ends: [x, right, low] }.draw(svg)
            }
            None => Vec::new(),
        };
        self.view.lines(svg, scale);
        self.view.marks(svg, scale);
        if self.style.arrows {
            self.view.arrows(svg, scale);
        }
        if self.style.notation {
            return svg.group("notation", |svg| ArchNotation { sketch, scale }.draw(svg));
        }
        svg.group("names", |svg| {
            for NamedPoint { name, joint, from, to, side } in self.named() {
                let [guide, end] = [from, to]
                    .map(|(radius, more)| scale.polar(joint, radius + more / scale.radius, side));
                svg.stroke(&Path::through([guide, end]), Stroke::new(GUIDE, 1.0));
                names.push(Name::new(name, end, (side * joint.sin(), -joint.cos())));
            }
            svg.names(&names, |_| Type::new(Page::LABEL, INK).on(WHITE));
        });
    }

    /// The names of the joints, outside the arch: the rotational joint and the half opening on the right, the
    /// sliding joint on the left.
    fn named(&self) -> Vec<NamedPoint> {
        let [_, outer] = self.sketch.radii();
        let alpha = self.sketch.half_opening();
        let out = |joint: f64| {
            // Further out than the blocks there.
            let near = |[x, y]: &[f64; 2]| (x.atan2(*y) - joint).abs() < 0.3;
            self.view.outside().filter(near).map(|[x, y]| x.hypot(y)).fold(outer, f64::max)
        };
        let side = |turns: bool| if turns || self.style.half { 1.0 } else { -1.0 };
        let names = named(self.sketch, &self.view.marks).into_iter();
        let names = names.map(|of| (of.at, side(of.turns), of.name));
        let named = |(joint, side, name)| {
            let (from, to) = ((outer, 0.4 * AWAY), (out(joint), 0.7 * AWAY));
            NamedPoint { name, joint, from, to, side }
        };
        names.chain([(alpha, 1.0, label("α", alpha))]).map(named).collect()
    }
}

/// A joint with its name, and the guide to that: radii in units of `r`, and how far beyond them on the page.
struct NamedPoint {
    name: String,
    joint: f64,
    from: (f64, f64),
    to: (f64, f64),
    /// 1 on the right, -1 on the left.
    side: f64,
}

/// Room for the names of joints above and below.
pub(super) const ABOVE: f64 = 38.0;
/// Room for the smallest of names beside the arch.
const LEAST: f64 = 10.0;

impl ModePanel<'_> {
    /// Room below.
    pub(super) fn under(&self) -> f64 {
        match &self.metres {
            None if self.style.notation => ABOVE + notation::BELOW,
            None => ABOVE,
            Some(of) if of.loads.is_some() => ABOVE + dimensions::BELOW + dimensions::FORCE,
            Some(_) => ABOVE + dimensions::BELOW,
        }
    }

    /// Names and measures beside the arch.
    pub(super) fn beside(&self) -> Beside {
        let Hull { left, right, .. } = self.view.hull();
        let arch = Beside { left: vec![(left, LEAST)], right: vec![(right, LEAST)] };
        let measures = self.metres.as_ref().map(|metres| {
            dimensions::beside((self.sketch, metres), self.style.half, [left, right])
        });
        let all = arch.and(measures.unwrap_or_default());
        if self.style.notation {
            return all.and(ArchNotation::beside(self.sketch));
        }
        let name = |NamedPoint { name, joint, to: (radius, more), side, .. }: NamedPoint| {
            let across = side * joint.sin();
            Beside::name(across, radius * across, text::width(&name, Page::LABEL) + 2.0 * more)
        };
        self.named().into_iter().map(name).fold(all, Beside::and)
    }
}

/// View of an arch, in the mode of its panel where there is one.
fn view<'a>(sketch: &'a Sketch, collapse: Option<&Collapse>, style: Style) -> ArchView<'a> {
    let stones = sketch.stone_joints();
    ArchView {
        half_opening: sketch.half_opening(),
        radii: sketch.radii(),
        lines: sketch.forces.iter().map(Forces::lines).collect(),
        is_standing: sketch.stands(),
        has_jump: sketch.has_jump(),
        marks: at_limit(sketch, collapse),
        blocks: collapse.map(|collapse| {
            Blocks::new(collapse, &sketch.at, style.amplitude, style.animate, &stones)
        }),
        stones,
        half: style.half,
        falls_right: style.notation,
    }
}
