//! One arch on the page: its outline, its lines, the joints at their limits, and the blocks as they fall.

use super::blocks::Blocks;
use super::forces::Lines;
use super::hull::Hull;
use super::line::{SketchedLine, across};
use super::look;
use super::scale::PageScale;
use crate::arch::mechanism::Contact;
use crate::picture::color::WHITE;
use crate::picture::{Path, Stroke, Svg};

/// An arch in doubles, in units of `r`.
#[derive(Clone, Debug, Default)]
pub struct ArchView<'a> {
    /// The half opening, rad.
    pub half_opening: f64,
    /// Radii of the intrados and the extrados.
    pub radii: [f64; 2],
    /// The lines of each thrust.
    pub lines: Vec<Lines<'a>>,
    /// True if these are the ends of a range, the least thrust first.
    pub is_standing: bool,
    /// True if the line of friction jumps at the crown.
    pub has_jump: bool,
    /// The joints at their limits, rad.
    pub marks: Vec<(Contact, f64)>,
    /// Blocks in which it falls.
    pub blocks: Option<Blocks>,
    /// The joints between stones of the right half, rad.
    pub stones: Vec<f64>,
    /// True if only the right half is drawn.
    pub half: bool,
    /// True if only the right half falls.
    pub falls_right: bool,
}

/// A joint nearer to the crown than this part of the half arch is the crown.
pub const CROWN: f64 = 1e-6;

impl ArchView<'_> {
    /// The halves that are drawn.
    fn sides(&self) -> &'static [f64] {
        if self.half { &[1.0] } else { &[1.0, -1.0] }
    }

    /// The halves on which it falls.
    fn falling(&self) -> &'static [f64] {
        if self.half || self.falls_right { &[1.0] } else { &[1.0, -1.0] }
    }

    /// Points of the right half that may be outside the arch: of its lines, and as it falls.
    pub fn outside(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let lines = self.lines.iter().flat_map(|of| of.all()).flat_map(SketchedLine::outside);
        let places = lines.flat_map(|part| part.places().collect::<Vec<_>>());
        self.blocks.iter().flat_map(Blocks::corners).chain(places)
    }

    /// The room that the arch takes, with its lines and as it falls.
    pub fn hull(&self) -> Hull {
        let ring = Hull::of_ring(self.half_opening, self.radii);
        let right = self.outside().fold(ring, Hull::with);
        // Whichever half falls.
        Hull { left: if self.half { -0.05 * self.radii[1] } else { -right.right }, ..right }
    }

    /// The stone, the forces between extremes, the blocks as they fall, and the outline.
    pub fn body(&self, svg: &mut Svg, scale: &PageScale) {
        svg.group("arch", |svg| {
            for side in self.sides() {
                svg.fill(&scale.sector([0.0, self.half_opening], self.radii, *side), look::STONE);
                // Where blocks move, their stones do.
                if !self.stones.is_empty() && (self.blocks.is_none() || self.falls_right) {
                    svg.stroke(&scale.joints(&self.stones, self.radii, *side), look::JOINT);
                }
            }
        });
        self.bands(svg, scale);
        if let Some(blocks) = &self.blocks {
            svg.group("mechanism", |svg| {
                blocks.draw(svg, scale, self.falling());
            });
        }
        svg.group("outline", |svg| svg.stroke(&self.outline(scale), look::OUTLINE));
    }

    /// Arrows from where the blocks were to where they are.
    pub fn arrows(&self, svg: &mut Svg, scale: &PageScale) {
        if let Some(blocks) = &self.blocks {
            svg.group("arrows", |svg| {
                self.falling().iter().for_each(|side| blocks.arrows(svg, scale, *side));
            });
        }
    }

    /// Once round the arch.
    fn outline(&self, scale: &PageScale) -> Path {
        let alpha = self.half_opening;
        let from = if self.half { 0.0 } else { -alpha };
        scale.sector([from, alpha], self.radii, 1.0)
    }

    /// Draws the bands between two lines of thrust.
    fn bands(&self, svg: &mut Svg, scale: &PageScale) {
        let lines: Vec<&SketchedLine> = self.lines.iter().flat_map(|of| of.thrust).collect();
        let [one, other] = lines[..] else { return };
        svg.group("between", |svg| {
            let edges = [one, other].map(|line| across(line.places(), self.half));
            let [there, back] = edges;
            let around = there.into_iter().chain(back.into_iter().rev());
            let around = around.map(|point| scale.at(point, 1.0));
            svg.tint(&Path::around(around), look::BAND, look::FAINT);
        });
    }

    fn along(&self, line: &SketchedLine, scale: &PageScale) -> Path {
        Path::through(across(line.places(), self.half).into_iter().map(|at| scale.at(at, 1.0)))
    }

    /// The lines of thrust and of friction.
    pub fn lines(&self, svg: &mut Svg, scale: &PageScale) {
        for (place, of) in self.lines.iter().enumerate() {
            let name = match (self.is_standing, place) {
                (true, 0) => "-least",
                (true, _) => "-largest",
                _ => "",
            };
            let [thrust, friction] = look::of_lines(place, of.thrust.len());
            let friction_outside = [(of.friction, look::PASSED)].into_iter();
            let outside =
                friction_outside.chain(of.thrust.iter().map(|line| (line, look::OUTSIDE)));
            let outside: Vec<(SketchedLine, Stroke)> = outside
                .flat_map(|(line, stroke)| {
                    let parts: Vec<_> = line.across(self.half).outside().collect();
                    parts.into_iter().map(move |part| (part, stroke))
                })
                .collect();
            if !outside.is_empty() {
                svg.group("outside", |svg| {
                    for (part, stroke) in &outside {
                        let places = part.places().map(|at| scale.at(at, 1.0));
                        svg.stroke(&Path::through(places), *stroke);
                    }
                });
            }
            svg.group(&format!("friction{name}"), |svg| {
                svg.stroke(&self.along(of.friction, scale), friction);
                if self.has_jump {
                    let [_, outer] = self.radii;
                    let ends = [1.0, outer].map(|radius| scale.polar(0.0, radius, 1.0));
                    svg.stroke(&Path::through(ends), friction);
                }
            });
            svg.group(&format!("thrust{name}"), |svg| {
                for line in of.thrust {
                    svg.stroke(&self.along(line, scale), thrust);
                }
            });
        }
    }

    /// The joints at their limits.
    pub fn marks(&self, svg: &mut Svg, scale: &PageScale) {
        let marks = on_sides(&self.marks, self.half_opening, self.falling());
        draw_marks(svg, scale, self.radii, &marks);
    }
}

/// Joints of a half on some sides, 1 for the right one and -1 for the left, so that those on the right are positive.
/// The crown is on the first side alone.
pub fn on_sides(marks: &[(Contact, f64)], half_opening: f64, sides: &[f64]) -> Vec<(Contact, f64)> {
    let both = |(contact, joint): &(Contact, f64)| {
        let count = if *joint < CROWN * half_opening { 1 } else { sides.len() };
        sides.iter().take(count).map(|side| (*contact, side * joint)).collect::<Vec<_>>()
    };
    marks.iter().flat_map(both).collect()
}

/// Draws joints at their limits, positive on the right, in an arch between two radii.
pub(super) fn draw_marks(
    svg: &mut Svg,
    scale: &PageScale,
    [inner, outer]: [f64; 2],
    marks: &[(Contact, f64)],
) {
    svg.group("sliding", |svg| {
        for (_, joint) in marks.iter().filter(|(contact, _)| !contact.is_hinge()) {
            let ends = [inner, outer].map(|radius| scale.polar(*joint, radius, 1.0));
            svg.stroke(&Path::through(ends), look::SLIDES);
        }
    });
    svg.group("hinges", |svg| {
        for (contact, joint) in marks.iter().filter(|(contact, _)| contact.is_hinge()) {
            let radius = if *contact == Contact::Extrados { outer } else { inner };
            svg.ring(scale.polar(*joint, radius, 1.0), look::HINGE_RADIUS, WHITE, look::HINGE);
        }
    });
}
