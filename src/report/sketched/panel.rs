//! One arch: its outline, its lines, the joints at their limits, and the blocks as they fall.

use super::blocks::Blocks;
use super::caption::{label, title};
use super::dimensions::{self, Dimensions};
use super::look;
use super::metres::Metres;
use super::notation::{self, Notation};
use super::scale::Scale;
use super::{Sketched, Style};
use crate::arch::mechanism::Contact;
use crate::atlas::{Collapse, Line, Sketch, Subject};
use crate::picture::color::{GUIDE, INK, WHITE};
use crate::picture::{Anchor, Path, Point, Stroke, Svg, Type};

/// One arch with a mode in which it falls.
pub(super) struct Panel<'a> {
    pub sketch: &'a Sketch,
    pub collapse: Option<&'a Collapse>,
    pub blocks: Option<Blocks>,
    pub style: Style,
    /// What it measures, if it does.
    pub metres: Option<Metres>,
}

/// Sizes of fonts.
const TITLE: f64 = 19.0;
const LABEL: f64 = 16.0;
/// Above the picture there is room for the title; around it for names of joints.
pub(super) const HEAD: f64 = 48.0;
/// From the outermost point of a joint to its name, in units of the page.
const AWAY: f64 = 13.0;
/// A joint nearer to the crown than this part of the half arch is the crown.
const CROWN: f64 = 1e-6;

impl<'a> Panel<'a> {
    pub(super) fn all(drawn: &'a Sketched) -> Vec<Self> {
        let style = drawn.style;
        let panel = |(sketch, collapse): (&'a Sketch, Option<&'a Collapse>)| {
            let joints = stones(sketch, style.stones);
            let blocks = collapse.map(|collapse| {
                Blocks::new(sketch, collapse, style.amplitude, style.animate, &joints)
            });
            Self { sketch, collapse, blocks, style, metres: drawn.metres(sketch) }
        };
        drawn.panels().map(panel).collect()
    }

    /// The halves that are drawn.
    fn sides(&self) -> &'static [f64] {
        if self.style.half { &[1.0] } else { &[1.0, -1.0] }
    }

    /// Left and right ends in units of `r`, whichever half falls.
    fn widest(&self, right: f64) -> f64 {
        if self.style.half { -0.05 * self.sketch.radii()[1] } else { -right }
    }

    /// What it takes in units of `r` and around it on the page: left, right, below and above the centre.
    pub(super) fn extent(&self) -> [f64; 4] {
        let [inner, outer] = self.sketch.radii();
        let alpha = self.sketch.half_opening();
        let wide = if alpha > std::f64::consts::FRAC_PI_2 { outer } else { outer * alpha.sin() };
        let low = [inner, outer].map(|radius| radius * alpha.cos());
        let mut extent = [0.0, wide, low[0].min(low[1]), outer];
        let corners = self.blocks.iter().flat_map(Blocks::corners);
        for [x, y] in corners {
            extent = [0.0, extent[1].max(x), extent[2].min(y), extent[3].max(y)];
        }
        extent[0] = self.widest(extent[1]);
        extent
    }

    pub(super) fn draw(&self, svg: &mut Svg, scale: &Scale, at: (Point, f64)) {
        let sketch = self.sketch;
        let (alpha, radii) = (sketch.half_opening(), sketch.radii());
        // Where blocks move, their stones do.
        let joints = match &self.blocks {
            Some(_) if !self.style.notation => Vec::new(),
            _ => stones(sketch, self.style.stones),
        };
        let ((left, top), width) = at;
        let [heading, words] = match self.style.notation {
            true => notation::TITLE.map(str::to_owned),
            false => title(sketch, self.collapse),
        };
        let middle = left + width / 2.0;
        svg.text(&heading, (middle, top + 12.0), Type::new(TITLE, INK).at(Anchor::Middle));
        svg.text(&words, (middle, top + 36.0), Type::new(LABEL, INK).at(Anchor::Middle));
        svg.group("arch", |svg| {
            for side in self.sides() {
                svg.fill(&scale.sector([0.0, alpha], radii, *side), look::STONE);
                if !joints.is_empty() {
                    svg.stroke(&scale.joints(&joints, radii, *side), look::JOINT);
                }
            }
        });
        self.bands(svg, scale);
        if let Some(blocks) = &self.blocks {
            svg.group("mechanism", |svg| {
                self.style.sides().iter().for_each(|side| blocks.draw(svg, scale, *side));
            });
        }
        svg.group("outline", |svg| {
            svg.stroke(&self.outline(scale), look::OUTLINE);
        });
        if !self.style.notation {
            self.names(svg, scale);
        }
        if let Some(metres) = &self.metres {
            let [left, right, low, _] = self.extent();
            let ((x, low), right) = (scale.at([left, low], 1.0), scale.at([right, 0.0], 1.0).0);
            let half = self.style.half;
            Dimensions { sketch, half, metres, scale, ends: [x, right, low] }.draw(svg);
        }
        self.lines(svg, scale);
        self.marks(svg, scale);
        if self.style.notation {
            svg.group("notation", |svg| Notation { sketch, scale }.draw(svg));
        }
        if let Some(blocks) = self.blocks.as_ref().filter(|_| self.style.arrows) {
            svg.group("arrows", |svg| {
                self.style.sides().iter().for_each(|side| blocks.arrows(svg, scale, *side));
            });
        }
    }

    /// Once round the arch.
    fn outline(&self, scale: &Scale) -> Path {
        let (alpha, radii) = (self.sketch.half_opening(), self.sketch.radii());
        let from = if self.style.half { 0.0 } else { -alpha };
        scale.sector([from, alpha], radii, 1.0)
    }

    /// Between two lines of thrust.
    fn bands(&self, svg: &mut Svg, scale: &Scale) {
        let lines: Vec<&Line> =
            self.sketch.forces.iter().flat_map(|forces| &forces.thrust_lines).collect();
        let [one, other] = lines[..] else { return };
        svg.group("between", |svg| {
            for side in self.sides() {
                let there = one.places().map(|point| scale.at(point, *side));
                let back = other.places().rev().map(|point| scale.at(point, *side));
                svg.tint(&Path::around(there.chain(back)), look::BAND, look::FAINT);
            }
        });
    }

    fn along(&self, line: &Line, scale: &Scale) -> Path {
        let right = line.places().map(|point| scale.at(point, 1.0));
        if self.style.half {
            return Path::through(right);
        }
        let left = line.places().skip(1).rev().map(|point| scale.at(point, -1.0));
        Path::through(left.chain(right))
    }

    fn lines(&self, svg: &mut Svg, scale: &Scale) {
        let is_standing = matches!(self.sketch.subject, Subject::Standing { .. });
        for (place, forces) in self.sketch.forces.iter().enumerate() {
            let name = match (is_standing, place) {
                (true, 0) => "-least",
                (true, _) => "-largest",
                _ => "",
            };
            let (thrust, friction) = match (place, forces.thrust_lines.len()) {
                (0, 1) => (look::THRUST, look::FRICTION),
                (0, _) => (look::EXTREME, look::FRICTION),
                _ => (look::LARGEST, look::LARGEST_FRICTION),
            };
            svg.group(&format!("friction{name}"), |svg| {
                svg.stroke(&self.along(&forces.friction_line, scale), friction);
                if self.sketch.has_jump() {
                    let [_, outer] = self.sketch.radii();
                    let ends = [1.0, outer].map(|radius| scale.polar(0.0, radius, 1.0));
                    svg.stroke(&Path::through(ends), friction);
                }
            });
            svg.group(&format!("thrust{name}"), |svg| {
                for line in &forces.thrust_lines {
                    svg.stroke(&self.along(line, scale), thrust);
                }
            });
        }
    }

    /// The joints at their limits: in the mode of this panel, where there is one.
    pub(super) fn at_limit(&self) -> Vec<(Contact, f64)> {
        match self.collapse {
            Some(collapse) => collapse.joints_at_limit(),
            None => {
                let forces = self.sketch.forces.iter();
                forces.flat_map(|forces| forces.marks.iter().map(|mark| mark.place())).collect()
            }
        }
    }

    fn marks(&self, svg: &mut Svg, scale: &Scale) {
        let [inner, outer] = self.sketch.radii();
        let marks = self.at_limit();
        let crown = CROWN * self.sketch.half_opening();
        let sides = |joint: f64| if joint < crown { &[1.0][..] } else { self.style.sides() };
        svg.group("sliding", |svg| {
            for (_, joint) in marks.iter().filter(|(contact, _)| !contact.is_hinge()) {
                for side in sides(*joint) {
                    let ends = [inner, outer].map(|radius| scale.polar(*joint, radius, *side));
                    svg.stroke(&Path::through(ends), look::SLIDES);
                }
            }
        });
        svg.group("hinges", |svg| {
            for (contact, joint) in marks.iter().filter(|(contact, _)| contact.is_hinge()) {
                let radius = if *contact == Contact::Extrados { outer } else { inner };
                for side in sides(*joint) {
                    let at = scale.polar(*joint, radius, *side);
                    svg.ring(at, look::HINGE_RADIUS, WHITE, look::HINGE);
                }
            }
        });
    }

    /// The names of the joints, outside the arch: the rotational joint and the half opening on the right, the sliding joint on the
    /// left.
    fn names(&self, svg: &mut Svg, scale: &Scale) {
        let [_, outer] = self.sketch.radii();
        let alpha = self.sketch.half_opening();
        let beyond = |joint: f64, side: f64| {
            // Further out than the blocks there.
            let near = |[x, y]: &[f64; 2]| (x.atan2(*y) - joint).abs() < 0.3;
            let corners = self.blocks.iter().flat_map(Blocks::corners).filter(near);
            let out = corners.map(|[x, y]| x.hypot(y)).fold(outer, f64::max);
            let room = AWAY / scale.radius;
            let ends = [outer + 0.4 * room, out + 0.7 * room].map(|r| scale.polar(joint, r, side));
            (ends, scale.polar(joint, out + room, side))
        };
        let mut names: Vec<(f64, f64, String)> = Vec::new();
        for (contact, joint) in self.at_limit() {
            let is_inner = joint > CROWN * alpha && joint < (1.0 - CROWN) * alpha;
            let symbol = if contact.is_hinge() { "βᵣ" } else { "βₛ" };
            let side = if contact.is_hinge() || self.style.half { 1.0 } else { -1.0 };
            let text = label(symbol, joint);
            let known =
                names.iter_mut().find(|(known, _, _)| (*known - joint).abs() < CROWN * alpha);
            match known {
                _ if !is_inner => {}
                Some((_, _, name)) => *name = label("βᵣ = βₛ", joint),
                None => names.push((joint, side, text)),
            }
        }
        names.push((alpha, 1.0, label("α", alpha)));
        svg.group("names", |svg| {
            for (joint, side, name) in names {
                let (guide, at) = beyond(joint, side);
                svg.stroke(&Path::through(guide), Stroke::new(GUIDE, 1.0));
                let (across, down) = (side * joint.sin(), -joint.cos());
                let anchor = match across {
                    x if x > 0.3 => Anchor::Start,
                    x if x < -0.3 => Anchor::End,
                    _ => Anchor::Middle,
                };
                let at = (at.0 + 4.0 * across, at.1 + 9.0 * down);
                svg.text(&name, at, Type::new(LABEL, INK).at(anchor).on(WHITE));
            }
        });
    }
}

/// Room for the names of joints above and below.
pub(super) const ABOVE: f64 = 38.0;
/// And on both sides.
const SIDE: f64 = 104.0;

impl Panel<'_> {
    /// Room on both sides and below.
    pub(super) fn around(&self) -> [f64; 2] {
        match &self.metres {
            None if self.style.notation => [SIDE, ABOVE + notation::BELOW],
            None => [SIDE, ABOVE],
            Some(of) => {
                let is_wide = self.style.half || of.loads.is_some();
                let force = if of.loads.is_some() { dimensions::FORCE } else { 0.0 };
                let side = if is_wide { dimensions::SIDE } else { SIDE };
                [side, ABOVE + dimensions::BELOW + force]
            }
        }
    }
}

/// The joints between stones of the right half.
fn stones(sketch: &Sketch, number: Option<u32>) -> Vec<f64> {
    let Some(number) = number else { return Vec::new() };
    let alpha = sketch.half_opening();
    let joints = (1..number).map(|k| alpha * (2.0 * f64::from(k) / f64::from(number) - 1.0));
    joints.filter(|joint| *joint >= -CROWN * alpha).collect()
}
