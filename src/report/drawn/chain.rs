//! A proved curve as Bézier arcs in a plane.

use super::plane::{Axis, Plane};
use crate::atlas::{Level, Piece, Place, Trace};
use crate::picture::{Frame, Path, Point};
use crate::problem::Mode;

/// Arcs end to end, in the units shown.
#[derive(Clone, Debug, Default)]
pub(super) struct Chain(pub Vec<Arc>);

/// A cubic Bézier curve by its ends and, between them, its handles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    pub corners: [Point; 4],
    /// Whether it is in a proved tube.
    pub is_proved: bool,
}

/// Straight parts for each arc, where only its course counts.
const PARTS: u32 = 8;

impl Chain {
    /// A curve in a plane; `None` if it has no place there.
    pub(super) fn new(trace: &Trace, plane: Plane) -> Option<Self> {
        let start = trace.points().swap_remove(0).place;
        Self::of_pieces(trace.pieces(), &start, plane)
    }

    /// A level in a plane, to unlimited friction or to the physical limit.
    pub(super) fn of_level(level: &Level, plane: Plane) -> Option<Self> {
        let mut whole = Self::default();
        for (k, part) in level.parts.iter().enumerate() {
            let chain = match part.parameter() {
                Some(_) => Self::of_pieces(part.pieces(), &part.ends()[0], plane)?,
                None => {
                    let at = |place: &Place| {
                        let [x, y] = plane.axes().map(|axis| axis.place(place));
                        Some((x?, y?))
                    };
                    let [from, to] = part.ends();
                    Self::straight(at(from)?, at(to)?)
                }
            };
            // Pure sliding comes down to where the next part begins.
            let comes_down = k == 0 && part.mode == Mode::Sliding;
            whole.0.extend(if comes_down { chain.reversed().0 } else { chain.0 });
        }
        (!whole.0.is_empty()).then_some(whole)
    }

    fn of_pieces<'a>(
        pieces: impl Iterator<Item = Piece<'a>>,
        start: &Place,
        plane: Plane,
    ) -> Option<Self> {
        let axes = plane.axes();
        // What a curve does not move along is the same at its start.
        let [still_x, still_y] =
            axes.map(|axis| start.coordinate(axis.variable).map(|value| value.mid().to_f64()));
        let arc = |piece: Piece| {
            let (x, y) = (handles(&piece, &axes[0], still_x)?, handles(&piece, &axes[1], still_y)?);
            let corners = [0, 1, 2, 3].map(|k| (x[k], y[k]));
            Some(Arc { corners, is_proved: piece.is_proved() })
        };
        let arcs: Option<Vec<Arc>> = pieces.map(arc).collect();
        arcs.filter(|arcs| !arcs.is_empty()).map(Self)
    }

    /// A straight line.
    pub(super) fn straight(from: Point, to: Point) -> Self {
        let on = |share: f64| (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
        let corners = [from, on(1.0 / 3.0), on(2.0 / 3.0), to];
        Self(vec![Arc { corners, is_proved: true }])
    }

    /// From its end to its start.
    pub(super) fn reversed(&self) -> Self {
        let back = |arc: &Arc| {
            let [a, b, c, d] = arc.corners;
            Arc { corners: [d, c, b, a], ..*arc }
        };
        Self(self.0.iter().rev().map(back).collect())
    }

    /// Its two ends.
    pub(super) fn ends(&self) -> Option<[Point; 2]> {
        Some([self.0.first()?.corners[0], self.0.last()?.corners[3]])
    }

    /// Drawn in a frame: what is proved, and what is not.
    pub(super) fn paths(&self, frame: &Frame) -> [Path; 2] {
        [true, false].map(|wanted| {
            let (mut path, mut pen) = (Path::default(), None);
            for arc in self.0.iter().filter(|arc| arc.is_proved == wanted) {
                if pen != Some(arc.corners[0]) {
                    path.start(frame.at(arc.corners[0]));
                }
                arc.draw(&mut path, frame);
                pen = Some(arc.corners[3]);
            }
            path
        })
    }

    /// Points along it.
    pub(super) fn points(&self) -> Vec<Point> {
        let along = |arc: &Arc| {
            let corners = arc.corners;
            (0..PARTS).map(move |k| at(&corners, f64::from(k) / f64::from(PARTS)))
        };
        let end = self.0.last().map(|arc| arc.corners[3]);
        self.0.iter().flat_map(along).chain(end).collect()
    }
}

impl Arc {
    /// Goes on along it.
    pub(super) fn draw(&self, path: &mut Path, frame: &Frame) {
        let [_, b, c, d] = self.corners.map(|corner| frame.at(corner));
        path.curve(b, c, d);
    }
}

/// The four coordinates of a piece along an axis. Hermite's cubic in the parameter is Bézier's with its handles
/// a third of the way along the slopes.
fn handles(piece: &Piece, axis: &Axis, still: Option<f64>) -> Option<[f64; 4]> {
    let [from, to] = piece.range();
    let corners = match piece.cubic(axis.variable) {
        Some([[start, end], [first, last]]) => {
            let third = (to - from) / 3.0;
            [start, start + third * first, end - third * last, end]
        }
        None => [still?; 4],
    };
    Some(corners.map(|value| axis.shown(value)))
}

/// A point of a Bézier curve, from 0 to 1.
fn at(corners: &[Point; 4], share: f64) -> Point {
    let rest = 1.0 - share;
    let weights =
        [rest.powi(3), 3.0 * rest * rest * share, 3.0 * rest * share * share, share.powi(3)];
    let sum = |of: fn(&Point) -> f64| corners.iter().zip(weights).map(|(c, w)| of(c) * w).sum();
    (sum(|p| p.0), sum(|p| p.1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arch::SelfWeight;
    use crate::atlas::{Curve, Variable};
    use crate::problem::Line;

    /// The arc is the cubic: at every share of a piece it lies in the tube at that share of the parameter.
    #[test]
    fn arcs_lie_in_the_tubes() {
        let curve = Curve::Line(Line::RotationShoulder);
        let trace = Trace::new(curve, SelfWeight::Heyman, 1e-6).unwrap();
        let chain = Chain::new(&trace, Plane::ThicknessFriction).unwrap();
        let mut seen = 0;
        for (piece, arc) in trace.pieces().zip(&chain.0) {
            for share in [0.0, 0.125, 0.5, 0.75] {
                let [from, to] = piece.range();
                let place = piece.place(from + share * (to - from)).unwrap();
                let (x, y) = at(&arc.corners, share);
                let there = |v| place.coordinate(v).unwrap().mid().to_f64();
                let away = (x.to_radians() - there(Variable::FrictionAngle)).abs();
                assert!(away < 2e-6 && (y - there(Variable::Thickness)).abs() < 2e-6);
                seen += 1;
            }
        }
        assert!(seen > 20);
    }

    #[test]
    fn a_curve_without_a_place_has_no_arcs() {
        let rotation = Trace::new(Curve::Rotation, SelfWeight::Heyman, 1e-2).unwrap();
        assert!(Chain::new(&rotation, Plane::ThicknessFriction).is_none());
        assert!(Chain::new(&rotation, Plane::OpeningThickness).is_some());
        let overturning = Trace::new(Curve::Overturning, SelfWeight::Heyman, 1e-2).unwrap();
        let chain = Chain::new(&overturning, Plane::ThicknessFriction).unwrap();
        assert!(chain.points().iter().all(|p| p.0 == 90.0), "unlimited friction");
    }

    #[test]
    fn what_is_not_proved_is_apart() {
        let mut chain = Chain::straight((0.0, 0.0), (1.0, 0.0));
        chain.0.extend(Chain::straight((1.0, 0.0), (2.0, 0.0)).0);
        chain.0.extend(Chain::straight((2.0, 0.0), (3.0, 0.0)).0);
        chain.0[1].is_proved = false;
        let frame = Frame { corner: (0.0, 0.0), size: (30.0, 10.0), x: [0.0, 3.0], y: [0.0, 1.0] };
        let [proved, open] = chain.paths(&frame).map(|path| path.to_string());
        assert_eq!(proved.matches('M').count(), 2);
        assert!(open.starts_with("M10 10C") && open.ends_with("20 10"), "{open}");
        assert_eq!(chain.reversed().ends(), Some([(3.0, 0.0), (0.0, 0.0)]));
    }
}
