//! The whole arch on the page, where its halves differ.

use super::blocks::Blocks;
use super::hull::Hull;
use super::line::SketchedLine;
use super::look;
use super::scale::PageScale;
use super::view::draw_marks;
use crate::arch::mechanism::Contact;
use crate::picture::{Path, Svg};

/// An arch in doubles, in units of `r`; joints are positive on the right.
#[derive(Clone, Debug, Default)]
pub struct WholeView {
    /// The half opening, rad.
    pub half_opening: f64,
    /// Radii of the intrados and the extrados.
    pub radii: [f64; 2],
    /// The line of thrust from the crown to the right and to the left.
    pub thrust: Option<[SketchedLine; 2]>,
    /// The line of friction, where that is limited.
    pub friction: Option<[SketchedLine; 2]>,
    /// The joints at their limits, rad.
    pub marks: Vec<(Contact, f64)>,
    /// Blocks in which it falls.
    pub blocks: Option<Blocks>,
    /// The joints between stones, rad.
    pub stones: Vec<f64>,
}

impl WholeView {
    /// The room that the arch takes, as it falls too.
    pub fn hull(&self) -> Hull {
        let corners = self.blocks.iter().flat_map(Blocks::corners);
        corners.fold(Hull::of_ring(self.half_opening, self.radii), Hull::with)
    }

    /// The arch at rest, the blocks as they fall, and the outline.
    pub fn body(&self, svg: &mut Svg, scale: &PageScale) {
        let outline = scale.sector([-self.half_opening, self.half_opening], self.radii, 1.0);
        svg.group("arch", |svg| svg.fill(&outline, look::STONE));
        if let Some(blocks) = &self.blocks {
            svg.group("mechanism", |svg| blocks.draw(svg, scale, &[1.0]));
        } else if !self.stones.is_empty() {
            svg.group("stones", |svg| {
                svg.stroke(&scale.joints(&self.stones, self.radii, 1.0), look::JOINT);
            });
        }
        svg.group("outline", |svg| svg.stroke(&outline, look::OUTLINE));
    }

    /// The lines of thrust and of friction.
    pub fn lines(&self, svg: &mut Svg, scale: &PageScale) {
        let of =
            [("friction", &self.friction, look::FRICTION), ("thrust", &self.thrust, look::THRUST)];
        for (name, halves, stroke) in of {
            let Some(halves) = halves else { continue };
            let points = Self::across(halves).into_iter().map(|point| scale.at(point, 1.0));
            svg.group(name, |svg| svg.stroke(&Path::through(points), stroke));
        }
    }

    /// Points of a line from the left springing to the right one.
    pub fn across([right, left]: &[SketchedLine; 2]) -> Vec<[f64; 2]> {
        let there = left.places().rev().map(|[x, y]| [-x, y]);
        let mut points: Vec<[f64; 2]> = there.chain(right.places()).collect();
        points.dedup();
        points
    }

    /// The joints at their limits.
    pub fn marks(&self, svg: &mut Svg, scale: &PageScale) {
        draw_marks(svg, scale, self.radii, &self.marks);
    }
}
