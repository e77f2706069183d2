//! Look of the modes and the weights.

use crate::arch::SelfWeight;
use crate::picture::color::INK;
use crate::picture::{Color, Hatch, Path, Stroke, Svg};
use crate::problem::Mode;

/// The ground of a domain, and the lines over it: tints of the colours of Okabe and Ito, of different lightness, and
/// hatched in turn, so that neighbours differ without colour too.
pub(super) fn ground(mode: Mode) -> Color {
    match mode {
        Mode::Rotational => Color(0xD3, 0xE6, 0xF3),
        Mode::SlidingRotational => Color(0xF8, 0xDC, 0xC2),
        Mode::RotationalSliding => Color(0xC9, 0xE8, 0xDD),
        Mode::RotationalSlidingRotational => Color(0xD9, 0xA8, 0xC4),
        Mode::OverturningSliding => Color(0xFB, 0xEB, 0xC4),
        Mode::Overturning => INK,
        Mode::Sliding => Color(0xF6, 0xF6, 0xF6),
    }
}

/// Fills a domain.
pub(super) fn fill(svg: &mut Svg, mode: Mode, path: &Path) {
    let hatch = |color, gap, turn| Hatch { ground: ground(mode), color, gap, turn };
    match mode {
        Mode::SlidingRotational => svg.hatch(path, hatch(Color(0xEB, 0xB8, 0x88), 9.0, 45.0)),
        Mode::RotationalSliding => svg.hatch(path, hatch(Color(0x9F, 0xD3, 0xC0), 9.0, -45.0)),
        Mode::OverturningSliding => svg.hatch(path, hatch(Color(0xEF, 0xD4, 0x8E), 9.0, 90.0)),
        _ => svg.fill(path, ground(mode)),
    }
}

/// A line between two modes.
pub(super) const DIVIDE: Stroke = Stroke::new(INK, 2.0);
/// A line of equal half opening, thickness or friction.
pub(super) const LEVEL: Stroke = Stroke::new(Color(0x55, 0x55, 0x55), 1.0);
/// Stroke where a line is not proved.
pub(super) const OPEN: Stroke = Stroke { color: INK, width: 2.0, dashes: &[2.0, 4.0] };
/// Unlimited friction, where half arches overturn.
pub(super) const EDGE: Stroke = Stroke::new(INK, 6.0);
/// The lines of a weight, where both are drawn.
pub(super) fn of_weight(weight: SelfWeight) -> Stroke {
    match weight {
        SelfWeight::Heyman => {
            Stroke { color: Color(0xD5, 0x5E, 0), width: 2.0, dashes: &[9.0, 4.0] }
        }
        SelfWeight::Milankovitch => Stroke::new(Color(0, 0x5A, 0x8C), 2.0),
    }
}

/// A mode in the name of a group: `rrs`.
pub(super) fn code(mode: Mode) -> String {
    mode.label().chars().filter(|c| c.is_ascii_alphabetic()).collect()
}
