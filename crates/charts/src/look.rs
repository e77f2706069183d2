//! Look of the modes and the weights.

use crate::arch::SelfWeight;
use crate::picture::color::INK;
use crate::picture::{Color, Hatch, Path, Stroke, Svg};
use crate::problem::Mode;

/// The ground of a domain: tints of the colours of Okabe and Ito in three shades of grey, so that neighbours differ to
/// every eye and on paper without colour, and letters are read on all of them.
pub(super) fn ground(mode: Mode) -> Color {
    match mode {
        Mode::Rotational => Color(0x9A, 0xBD, 0xDF),
        Mode::SlidingRotational => Color(0xF8, 0xD2, 0xAE),
        Mode::RotationalSliding => Color(0xC0, 0xE6, 0xD2),
        Mode::RotationalSlidingRotational => Color(0xCF, 0x9C, 0xBC),
        Mode::OverturningSliding => Color(0xF4, 0xDB, 0x96),
        Mode::Overturning => INK,
        Mode::Sliding => Color(0xFA, 0xFA, 0xFA),
    }
}

/// The lines over the ground of a domain in the middle shade, which has three.
fn hatch(mode: Mode) -> Option<Hatch> {
    let hatch = |color, turn| Some(Hatch { ground: ground(mode), color, gap: 9.0, turn });
    match mode {
        Mode::SlidingRotational => hatch(Color(0xDD, 0x9A, 0x5C), 45.0),
        Mode::RotationalSliding => hatch(Color(0x7D, 0xBB, 0x9F), -45.0),
        Mode::OverturningSliding => hatch(Color(0xCD, 0xA6, 0x38), 90.0),
        _ => None,
    }
}

/// Fills a domain.
pub(super) fn fill(svg: &mut Svg, mode: Mode, path: &Path) {
    match hatch(mode) {
        Some(hatch) => svg.hatch(path, hatch),
        None => svg.fill(path, ground(mode)),
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

/// Behind the symbol of a landmark.
pub(super) fn mark(weight: SelfWeight) -> char {
    match weight {
        SelfWeight::Heyman => 'ₕ',
        SelfWeight::Milankovitch => 'ₘ',
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::atlas::{Curve, DomainSide, boundary};

    type Three = [f64; 3];

    /// Colours that an eye without one kind of cones makes of linear red, green and blue (Machado, Oliveira and
    /// Fernandes, 2009, severity 1), after what every other makes of it.
    const EYES: [[Three; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    ];
    /// CIE X, Y and Z of linear red, green and blue, and of white (IEC 61966-2-1).
    const XYZ: [Three; 3] = [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.1191920, 0.9503041],
    ];
    const D65: Three = [0.95047, 1.0, 1.08883];

    fn times(matrix: [Three; 3], of: Three) -> Three {
        matrix.map(|row| row.iter().zip(of).map(|(a, b)| a * b).sum())
    }

    /// CIE Lab of a colour, the share of `over` in it, to an eye.
    fn lab(ground: Color, (over, share): (Color, f64), eye: [Three; 3]) -> Three {
        let linear = |(a, b): (u8, u8)| {
            let x = ((1.0 - share) * f64::from(a) + share * f64::from(b)) / 255.0;
            if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
        };
        let rgb = [(ground.0, over.0), (ground.1, over.1), (ground.2, over.2)].map(linear);
        let [x, y, z] = times(XYZ, times(eye, rgb).map(|part| part.clamp(0.0, 1.0)));
        let root = |(part, white): (f64, f64)| {
            let part = part / white;
            if part > 216.0 / 24389.0 {
                part.cbrt()
            } else {
                (24389.0 / 27.0 * part + 16.0) / 116.0
            }
        };
        let [x, y, z] = [(x, D65[0]), (y, D65[1]), (z, D65[2])].map(root);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// A domain near, between its lines, and from afar, where they are one colour with the ground.
    fn seen(mode: Mode, eye: [Three; 3]) -> Vec<Three> {
        let ground = ground(mode);
        let over = hatch(mode).map(|hatch| (hatch.color, 1.6 / hatch.gap));
        let near = lab(ground, (ground, 0.0), eye);
        [near].into_iter().chain(over.map(|over| lab(ground, over, eye))).collect()
    }

    /// Modes whose domains have a curve in common.
    fn neighbours() -> Vec<[Mode; 2]> {
        let curves = |mode| -> Vec<Curve> {
            let sides = boundary(mode).into_iter();
            let curve = |side| match side {
                DomainSide::Along(curve) | DomainSide::Back(curve) => Some(curve),
                DomainSide::Edge(..) => None,
            };
            sides.filter_map(curve).collect()
        };
        let areas = Mode::ALL.into_iter().filter(|mode| *mode != Mode::Overturning);
        let pairs = areas.clone().flat_map(|one| areas.clone().map(move |other| [one, other]));
        let meet = |[one, other]: &[Mode; 2]| {
            one.label() < other.label()
                && curves(*one).iter().any(|curve| curves(*other).contains(curve))
        };
        pairs.filter(meet).collect()
    }

    #[test]
    fn every_eye_tells_neighbours_apart_and_grey_does() {
        let neighbours = neighbours();
        assert_eq!(neighbours.len(), 8, "{neighbours:?}");
        for [one, other] in neighbours {
            for eye in EYES {
                for (a, b) in seen(one, eye)
                    .iter()
                    .flat_map(|a| seen(other, eye).into_iter().map(move |b| (a, b)))
                {
                    let distance =
                        a.iter().zip(b).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
                    assert!(distance >= 10.0, "{one} {other}: {distance}");
                }
            }
            let [a, b] = [one, other].map(|mode| lab(ground(mode), (INK, 0.0), EYES[0])[0]);
            assert!((a - b).abs() >= 10.0, "{one} {other} in grey: {a} {b}");
            assert!(a.min(b) > 65.0, "letters are black");
        }
    }
}
