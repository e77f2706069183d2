//! Places of the names of landmarks.

use super::plane::Plane;
use crate::picture::color::{INK, WHITE};
use crate::picture::room::{Rectangle, about};
use crate::picture::{Anchor, Point, Svg, Type, text};
use crate::problem::Landmark;

/// Radius of a landmark's disc.
const RADIUS: f64 = 4.0;

/// A name beside its point.
pub(super) struct Spot {
    name: &'static str,
    middle: Point,
    size: f64,
}

/// Direction from a landmark to the middle of its name, in sizes of the font: away from the lines.
pub(super) fn away(landmark: Landmark, plane: Plane) -> Point {
    use Landmark as L;
    match (plane, landmark) {
        (Plane::ThicknessFriction, L::Triple) => (-0.9, -0.5),
        (Plane::ThicknessFriction, L::Shift) => (-0.9, 0.2),
        (Plane::ThicknessFriction, L::Junction) => (-0.9, -0.3),
        (Plane::ThicknessFriction, L::Border) => (-0.8, 0.8),
        (Plane::ThicknessFriction, L::RotationEnd) => (-0.7, 1.2),
        (Plane::ThicknessFriction, _) => (-1.0, 0.9),
        (Plane::OpeningFriction, L::RotationEnd) => (-0.5, -0.9),
        (Plane::OpeningFriction, L::OverturningEnd) => (0.5, -0.9),
        (Plane::OpeningFriction, _) => (0.9, 0.6),
        (Plane::OpeningThickness, L::Border) => (-0.5, -0.9),
        (Plane::OpeningThickness, L::OverturningEnd) => (0.5, -0.9),
        (Plane::OpeningThickness, L::Triple | L::RotationEnd) => (0.9, 0.6),
        (Plane::OpeningThickness, L::Shift) => (-0.9, 0.4),
        (Plane::OpeningThickness, _) => (-0.9, -0.4),
    }
}

impl Spot {
    /// The name of a landmark at a point of the page, as usual in a plane or on another side.
    pub(super) fn new(
        landmark: Landmark,
        name: &'static str,
        at: Point,
        (plane, mirrored): (Plane, Point),
        size: f64,
    ) -> Self {
        let (x, y) = away(landmark, plane);
        let (x, y) = (x * mirrored.0, y * mirrored.1);
        let far = 0.5 * (text::width(name, size) - text::width("T", size));
        let middle = (at.0 + x * size + far * x.signum() * f64::from(x != 0.0), at.1 + y * size);
        Self { name, middle, size }
    }

    /// Area that the spot takes of the page.
    pub(super) fn taken(&self) -> Rectangle {
        let half = (text::width(self.name, self.size) / 2.0 + 2.0, self.size * 0.55);
        about(self.middle, half)
    }

    /// Writes it.
    pub(super) fn draw(&self, svg: &mut Svg) {
        let style = Type::new(self.size, INK).at(Anchor::Middle).on(WHITE);
        svg.text(self.name, self.middle, style);
    }
}

/// The disc of a landmark.
pub(super) fn disc(svg: &mut Svg, at: Point) {
    svg.disc(at, RADIUS + 1.0, WHITE);
    svg.disc(at, RADIUS, INK);
}
