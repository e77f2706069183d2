//! Places of the names of landmarks.

use super::canvas::Canvas;
use super::plane::Plane;
use crate::atlas::Coordinate;
use crate::picture::color::{INK, WHITE};
use crate::picture::labels::Labels;
use crate::picture::room::{Rectangle, about};
use crate::picture::{Anchor, Point, Svg, Type, text};
use crate::problem::Landmark;

/// Radius of a landmark's disc.
const RADIUS: f64 = 4.0;

/// Direction from a landmark to its name: away from the lines.
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

/// Direction from a landmark to its name on a canvas, whose first axis runs the other way where it shows `A`.
pub(super) fn towards(landmark: Landmark, canvas: &Canvas) -> Point {
    let (x, y) = away(landmark, canvas.plane);
    let is_mirrored = canvas.axes[0].coordinate == Coordinate::OpeningVariable;
    (if is_mirrored { -x } else { x }, y)
}

/// Writes a name beside its point, off what is there already.
pub(super) fn named(
    svg: &mut Svg,
    labels: &mut Labels,
    (name, at): (&str, Point),
    towards: Point,
    style: Type,
) {
    let half = (text::width(name, style.size) / 2.0 + 2.0, 0.55 * style.size);
    let middle = labels.beside(at, half, towards);
    svg.text(name, middle, style.at(Anchor::Middle).on(WHITE));
}

/// The disc of a landmark.
pub(super) fn disc(svg: &mut Svg, at: Point) {
    svg.disc(at, RADIUS + 1.0, WHITE);
    svg.disc(at, RADIUS, INK);
}

/// Area that the disc takes.
pub(super) fn taken(at: Point) -> Rectangle {
    about(at, (RADIUS, RADIUS))
}
