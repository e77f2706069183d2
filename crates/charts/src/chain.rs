//! A proved curve as Bézier arcs in a plane.

use super::look;
use super::plane::{DEGREES, PlaneAxis};
use crate::atlas::{Level, Piece, Place, Section, Trace, arc, over_joint};
use crate::picture::room::span;
use crate::picture::{Frame, Path, Point, Stroke, Svg};
use crate::problem::Mode;

/// Arcs end to end, in the units shown.
#[derive(Clone, Debug, Default)]
pub(super) struct Chain(pub Vec<Arc>);

/// A cubic Bézier curve by its ends and, between them, its handles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    pub corners: [Point; 4],
    /// True if the arc is in a proved tube.
    pub is_proved: bool,
    /// Distance that it may have from the truth along each axis, in rad or in what else is shown.
    pub off: [f64; 2],
}

/// Straight parts for each arc, where only its course counts.
const PARTS: u32 = 8;

/// A part of a piece is halved no more often than this.
const DEPTH: u32 = 10;

impl Chain {
    /// A curve along two axes; `None` if it has no place there.
    pub(super) fn of_trace(trace: &Trace, axes: &[PlaneAxis; 2]) -> Option<Self> {
        Self::of_pieces(trace.pieces(), &trace.points().first()?.place, axes)
    }

    /// A level along two axes, to unlimited friction or to the physical limit.
    pub(super) fn of_level(level: &Level, axes: &[PlaneAxis; 2]) -> Option<Self> {
        let mut whole = Self::default();
        for (k, part) in level.parts.iter().enumerate() {
            let chain = match part.parameter() {
                Some(_) => Self::of_pieces(part.pieces(), &part.ends()[0], axes)?,
                None => {
                    let at = |place: &Place| {
                        let [x, y] = axes.each_ref().map(|axis| axis.place(place));
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

    /// Pieces along two axes, in parts as short as their tubes are narrow; `None` if they have no place there.
    pub(super) fn of_pieces<'a>(
        pieces: impl Iterator<Item = Piece<'a>>,
        start: &Place,
        axes: &[PlaneAxis; 2],
    ) -> Option<Self> {
        // What a curve does not move along is the same at its start.
        let still = axes.each_ref().map(|axis| axis.place(start));
        let mut chain = Self::default();
        for piece in pieces {
            let near = piece.width().unwrap_or(0.0).max(NEAR);
            chain.add(&piece, piece.range(), (axes, still), near, DEPTH)?;
        }
        (!chain.0.is_empty()).then_some(chain)
    }

    /// The half opening over the joint near the end of rotation, as the joint over the half opening, in degrees.
    pub(super) fn over_joint(section: &Section) -> Option<Self> {
        let part = |piece: Piece| {
            let [from, to] = piece.range().map(f64::sqrt);
            let opening = over_joint(&piece, [from, to])?;
            let third = (to - from) / 3.0;
            let ([start, end], [first, last]) = (opening.values, opening.slopes);
            let across = [start, start + third * first, end - third * last, end];
            let up = [from, from + third, to - third, to];
            let corners = [0, 1, 2, 3].map(|k| (across[k] * DEGREES, up[k] * DEGREES));
            // That it is the joint is exact, but for the roots of doubles.
            Some(Arc { corners, is_proved: true, off: [opening.off, NEAR * NEAR] })
        };
        section.pieces().map(part).collect::<Option<Vec<Arc>>>().map(Self)
    }

    fn add(
        &mut self,
        piece: &Piece,
        range: [f64; 2],
        (axes, still): (&[PlaneAxis; 2], [Option<f64>; 2]),
        near: f64,
        depth: u32,
    ) -> Option<()> {
        let [x, y] = [0, 1].map(|k| along(piece, &axes[k], range, still[k]));
        let (x, y) = (x?, y?);
        let is_near = |side: &Along| side.by_length <= near;
        // What lies beyond an edge is not seen.
        let is_beyond = |side: &Along, [low, high]: [f64; 2]| {
            let all = || side.handles.into_iter();
            side.by_length.is_finite() && (all().all(|x| x < low) || all().all(|x| x > high))
        };
        let is_hidden = is_beyond(&x, axes[0].range) || is_beyond(&y, axes[1].range);
        if (is_near(&x) && is_near(&y)) || is_hidden || depth == 0 {
            let corners = [0, 1, 2, 3].map(|k| (x.handles[k], y.handles[k]));
            // What is without bound is not drawn: it is beyond all edges.
            let (off, is_proved) = ([x.off, y.off], piece.is_proved());
            let is_there = x.by_length.is_finite() && y.by_length.is_finite();
            self.0.extend(is_there.then_some(Arc { corners, is_proved, off }));
            return Some(());
        }
        let middle = range[0] + (range[1] - range[0]) / 2.0;
        self.add(piece, [range[0], middle], (axes, still), near, depth - 1)?;
        self.add(piece, [middle, range[1]], (axes, still), near, depth - 1)
    }

    /// Distance that the arcs that a frame shows may have from the truth, in rad and in what else lies along
    /// the axes.
    pub(super) fn off(&self, frame: &Frame) -> [f64; 2] {
        let is_seen = |arc: &&Arc| {
            let within = |of: fn(&Point) -> f64, [low, high]: [f64; 2]| {
                let [least, most] = span(arc.corners.iter().map(of));
                least <= high && most >= low
            };
            within(|p| p.0, frame.x) && within(|p| p.1, frame.y)
        };
        self.0.iter().filter(is_seen).map(|arc| arc.off).fold([0.0; 2], larger)
    }

    /// A straight line.
    pub(super) fn straight(from: Point, to: Point) -> Self {
        let on = |share: f64| (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
        let corners = [from, on(1.0 / 3.0), on(2.0 / 3.0), to];
        Self(vec![Arc { corners, is_proved: true, off: [0.0; 2] }])
    }

    /// Chain from its end to its start.
    pub(super) fn reversed(&self) -> Self {
        let back = |arc: &Arc| {
            let [a, b, c, d] = arc.corners;
            Arc { corners: [d, c, b, a], ..*arc }
        };
        Self(self.0.iter().rev().map(back).collect())
    }

    /// Parts left and right of a place, of a chain that runs to the right.
    pub(super) fn split(&self, place: f64) -> [Self; 2] {
        let (mut before, mut after) = (Self::default(), Self::default());
        for arc in &self.0 {
            match arc.corners {
                [.., end] if end.0 <= place => before.0.push(*arc),
                [start, ..] if start.0 >= place => after.0.push(*arc),
                _ => {
                    let (first, last) = arc.halves(arc.share_at(place));
                    before.0.push(first);
                    after.0.push(last);
                }
            }
        }
        [before, after]
    }

    /// Ends of the chain.
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

    /// Draws the chain in a frame, and dotted what is not proved.
    pub(super) fn draw(&self, svg: &mut Svg, frame: &Frame, stroke: Stroke) {
        let [proved, open] = self.paths(frame);
        svg.stroke(&proved, stroke);
        if open != Path::default() {
            svg.stroke(&open, look::OPEN);
        }
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

/// The larger of two pairs, each along its axis.
pub(super) fn larger(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].max(b[0]), a[1].max(b[1])]
}

impl Arc {
    /// Share at which it passes a place, going to the right.
    fn share_at(&self, place: f64) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        while high - low > 1e-15 {
            let middle = (low + high) / 2.0;
            match at(&self.corners, middle).0 < place {
                true => low = middle,
                false => high = middle,
            }
        }
        low
    }

    /// Halves of the arc (de Casteljau).
    fn halves(&self, share: f64) -> (Self, Self) {
        let mix = |a: Point, b: Point| (a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1));
        let [a, b, c, d] = self.corners;
        let (ab, bc, cd) = (mix(a, b), mix(b, c), mix(c, d));
        let (abc, bcd) = (mix(ab, bc), mix(bc, cd));
        let middle = mix(abc, bcd);
        (
            Self { corners: [a, ab, abc, middle], ..*self },
            Self { corners: [middle, bcd, cd, d], ..*self },
        )
    }

    /// Goes on along it.
    pub(super) fn draw(&self, path: &mut Path, frame: &Frame) {
        let [_, b, c, d] = self.corners.map(|corner| frame.at(corner));
        path.curve(b, c, d);
    }
}

/// A part of a piece along an axis.
struct Along {
    handles: [f64; 4],
    /// Distance that it may have from the truth, and the part of it that shorter parts would reduce.
    off: f64,
    by_length: f64,
}

/// Distance below which nothing is drawn nearer, where tubes are narrower still.
const NEAR: f64 = 1e-6;

/// A part of a piece along an axis. Hermite's cubic in the parameter is Bézier's with its handles a third of the way
/// along the slopes.
fn along(
    piece: &Piece,
    axis: &PlaneAxis,
    [from, to]: [f64; 2],
    still: Option<f64>,
) -> Option<Along> {
    let third = (to - from) / 3.0;
    let far = |value: f64| {
        let [low, high] = axis.range;
        let beyond = 4.0 * (high - low);
        (value * axis.unit).clamp(low - beyond, high + beyond)
    };
    let along = |[start, end]: [f64; 2], [first, last]: [f64; 2], off: f64, by_length: f64| Along {
        handles: [start, start + third * first, end - third * last, end].map(far),
        off,
        by_length,
    };
    let coordinate = axis.coordinate;
    Some(match coordinate.variable().map(|variable| piece.cubic(variable)) {
        Some(None) => Along { handles: [still?; 4], off: 0.0, by_length: 0.0 },
        Some(Some([values, slopes])) if coordinate.is_variable() => {
            let whole = piece.range();
            let [start, end] = [from, to].map(|s| hermite(whole, values, slopes, s));
            let off = piece.width().unwrap_or(0.0);
            along([start.0, end.0], [start.1, end.1], off, 0.0)
        }
        _ if !piece.is_proved() => return None,
        _ => match arc(piece, coordinate, [from, to]) {
            Some(found) => along(found.values, found.slopes, found.off, found.by_length),
            None => Along { handles: [0.0; 4], off: f64::INFINITY, by_length: f64::INFINITY },
        },
    })
}

/// Hermite's cubic between two parameters at one of them or between, with its slope.
fn hermite([from, to]: [f64; 2], [a, b]: [f64; 2], [c, d]: [f64; 2], s: f64) -> (f64, f64) {
    // At the ends exactly what it is there.
    if s == from {
        return (a, c);
    }
    if s == to {
        return (b, d);
    }
    let length = to - from;
    let (v, u) = ((s - from) / length, (to - s) / length);
    let value = u * u * (1.0 + 2.0 * v) * a
        + v * v * (1.0 + 2.0 * u) * b
        + u * v * length * (u * c - v * d);
    let slope = 6.0 * u * v * (b - a) / length + u * (u - 2.0 * v) * c + v * (v - 2.0 * u) * d;
    (value, slope)
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
    use crate::plane::Plane;
    use crate::problem::Line;

    /// The arc is the cubic: at every share of a piece it lies in the tube at that share of the parameter.
    #[test]
    fn arcs_lie_in_the_tubes() {
        let curve = Curve::Line(Line::RotationShoulder);
        let trace = Trace::new(curve, SelfWeight::Heyman, 1e-6).unwrap();
        let chain = Chain::of_trace(&trace, &Plane::ThicknessFriction.axes()).unwrap();
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
        assert!(Chain::of_trace(&rotation, &Plane::ThicknessFriction.axes()).is_none());
        assert!(Chain::of_trace(&rotation, &Plane::OpeningThickness.axes()).is_some());
        let overturning = Trace::new(Curve::Overturning, SelfWeight::Heyman, 1e-2).unwrap();
        let chain = Chain::of_trace(&overturning, &Plane::ThicknessFriction.axes()).unwrap();
        assert!(chain.points().iter().all(|p| p.0 == 90.0), "unlimited friction");
    }

    #[test]
    fn a_chain_is_split_where_it_passes_a_place() {
        let mut chain = Chain::straight((0.0, 0.0), (1.0, 2.0));
        chain.0.extend(Chain::straight((1.0, 2.0), (3.0, 6.0)).0);
        let [before, after] = chain.split(1.5);
        assert_eq!((before.0.len(), after.0.len()), (2, 1));
        let (end, start) = (before.ends().unwrap()[1], after.ends().unwrap()[0]);
        assert!(end == start && (end.0 - 1.5).abs() < 1e-12 && (end.1 - 3.0).abs() < 1e-12);
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
