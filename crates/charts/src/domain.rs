//! The domains of the modes, by the curves around them.

use super::canvas::Canvas;
use super::chain::Chain;
use super::plane::Plane;
use crate::atlas::{Corner, Curve, DomainSide, boundary};
use crate::picture::{Frame, Path};
use crate::problem::Mode;
use std::f64::consts::FRAC_PI_2;

/// Tells whether a mode has an area in a plane, and not only a line.
fn is_area(mode: Mode, plane: Plane) -> bool {
    match mode {
        Mode::Overturning => false,
        Mode::Rotational => plane != Plane::OpeningThickness,
        Mode::Sliding => plane != Plane::OpeningFriction,
        _ => true,
    }
}

/// Parts of the way around the domain of a mode; `None` if one of its curves is not there. Of an edge the part is its
/// end, where that is a corner of the plane; edges along which the half opening changes are curves.
fn parts(
    mode: Mode,
    canvas: &Canvas,
    chain: impl Fn(Curve) -> Option<Chain>,
) -> Option<Vec<Chain>> {
    let mut parts = Vec::new();
    for side in boundary(mode) {
        parts.push(match side {
            DomainSide::Along(curve) => chain(curve)?,
            DomainSide::Back(curve) => chain(curve)?.reversed(),
            DomainSide::Edge(_, Corner::RightTop) => chain(Curve::Overturning)?,
            DomainSide::Edge(Corner::RightTop, _) => chain(Curve::Limit)?.reversed(),
            DomainSide::Edge(_, corner) => {
                // Friction angle, thickness and half opening there.
                let (friction, thickness, opening) = match corner {
                    Corner::RightBottom => (FRAC_PI_2, 0.0, 0.0),
                    Corner::LeftTop => (0.0, 2.0, 0.0),
                    _ => continue,
                };
                let (x, y) = match canvas.plane {
                    Plane::ThicknessFriction => (friction, thickness),
                    Plane::OpeningFriction => (opening, friction),
                    Plane::OpeningThickness => (opening, thickness),
                };
                let point = (canvas.axes[0].shown(x), canvas.axes[1].shown(y));
                Chain::straight(point, point)
            }
        });
    }
    Some(parts)
}

/// The way around the domain of a mode, if it is an area and all its curves are there.
pub(super) fn around(
    mode: Mode,
    canvas: &Canvas,
    chain: impl Fn(Curve) -> Option<Chain>,
) -> Option<Chain> {
    let mut way = Chain::default();
    let parts = is_area(mode, canvas.plane).then(|| parts(mode, canvas, chain))??;
    for next in parts {
        // Straight from where the last part ends: along an edge, or not at all.
        if let (Some([_, from]), Some([to, _])) = (way.ends(), next.ends()) {
            way.0.extend(Chain::straight(from, to).0);
        }
        way.0.extend(next.0);
    }
    (!way.0.is_empty()).then_some(way)
}

/// Once round, in a frame.
pub(super) fn area(way: &Chain, frame: &Frame) -> Path {
    let mut path = Path::default();
    if let Some([start, _]) = way.ends() {
        path.start(frame.at(start));
    }
    way.0.iter().for_each(|arc| arc.draw(&mut path, frame));
    path.close();
    path
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::atlas::Trace;
    use crate::picture::Point;
    use std::collections::HashMap;

    /// Neighbouring parts meet, but where an edge of the plane is between them.
    #[test]
    fn the_curves_around_a_domain_meet() {
        for weight in SelfWeight::ALL {
            let trace = |curve| (curve, Trace::new(curve, weight, 1e-1).unwrap());
            let traces: HashMap<Curve, Trace> = Curve::ALL.into_iter().map(trace).collect();
            for plane in Plane::ALL {
                for mode in Mode::ALL.into_iter().filter(|mode| is_area(*mode, plane)) {
                    let canvas = Canvas::usual(plane);
                    let chain = |curve| Chain::of_trace(&traces[&curve], &canvas.axes);
                    let parts = parts(mode, &canvas, chain).unwrap();
                    let all: Vec<[Point; 2]> =
                        parts.iter().map(|part| part.ends().unwrap()).collect();
                    for (one, next) in all.iter().zip(all.iter().cycle().skip(1)) {
                        let (from, to) = (one[1], next[0]);
                        let along = |a: f64, b: f64| (a - b).abs() < 1e-9;
                        let is_edge = along(from.0, to.0) || along(from.1, to.1);
                        assert!(is_edge, "{mode:?}, {plane:?}: {from:?} to {to:?}");
                    }
                }
            }
        }
    }
}
