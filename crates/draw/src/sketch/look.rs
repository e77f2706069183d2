//! Colours and lines: those of Okabe and Ito, told apart without colour by width, dashes and shade.

use crate::picture::color::INK;
use crate::picture::{Color, Stroke};

/// The arch at rest.
pub const STONE: Color = Color(0xF1, 0xEF, 0xEA);
/// The edge of the arch at rest.
pub const OUTLINE: Stroke = Stroke::new(INK, 1.8);
/// Joints between stones.
pub(crate) const JOINT: Stroke = Stroke::new(Color(0xB8, 0xB4, 0xAA), 0.9);

const RED: Color = Color(0xC4, 0x3E, 0x00);
const BLUE: Color = Color(0x00, 0x5A, 0x9C);
const GREEN: Color = Color(0x00, 0x7A, 0x5A);

/// The line of thrust, or that of the least thrust.
pub const THRUST: Stroke = Stroke::new(RED, 2.6);
/// The line of the largest thrust.
pub const LARGEST: Stroke = Stroke { color: RED, width: 2.6, dashes: &[11.0, 4.0] };
/// An end of the band of several.
pub const EXTREME: Stroke = Stroke::new(RED, 1.3);
/// Between two lines of thrust.
pub const BAND: Color = RED;
/// The line of friction, or that of the least thrust.
pub const FRICTION: Stroke = Stroke { color: BLUE, width: 1.9, dashes: &[6.0, 3.0] };
/// The line of friction under the largest thrust.
pub const LARGEST_FRICTION: Stroke = Stroke { color: BLUE, width: 1.9, dashes: &[2.0, 2.6] };
/// The lines of thrust and of friction under the first thrust, of so many lines, or under the largest.
pub fn of_lines(place: usize, lines: usize) -> [Stroke; 2] {
    match (place, lines) {
        (0, 1) => [THRUST, FRICTION],
        (0, _) => [EXTREME, FRICTION],
        _ => [LARGEST, LARGEST_FRICTION],
    }
}
/// Below a line of thrust where it is outside the arch.
pub const OUTSIDE: Stroke = Stroke::new(Color(0xF4, 0xB9, 0x8F), 9.0);
/// Below a line of friction where that is passed.
pub const PASSED: Stroke = Stroke::new(Color(0xA9, 0xC8, 0xE6), 9.0);
/// A joint that slides.
pub const SLIDES: Stroke = Stroke::new(BLUE, 5.0);
/// A hinge.
pub const HINGE: Stroke = Stroke::new(INK, 1.9);
/// Radius of a hinge on the page, in points.
pub const HINGE_RADIUS: f64 = 5.2;
/// The blocks as they fall.
pub const FALLEN: Color = GREEN;
/// The edge of a block as it falls.
pub const FALLEN_EDGE: Stroke = Stroke::new(GREEN, 1.5);
pub(crate) const FALLEN_JOINT: Stroke = Stroke::new(GREEN, 0.6);
pub(crate) const ARROW: Stroke = Stroke::new(INK, 1.3);
/// Opacity of a tint: the less, the more is seen through it.
pub const SHEER: f64 = 0.22;
/// Opacity of a faint tint.
pub const FAINT: f64 = 0.14;
