//! Difference in thickness between arches of the two weights on the lines between modes, at equal friction.
//!
//! To a friction angle belongs one inclination, `phi = chi - sin chi cos chi`, whatever the weight. Over the
//! inclination the thickness on a line is a chain of cubics, each with a proved tube; of two weights the difference
//! of these is a cubic too, in a tube as wide as both together.
//!
//! Lines that follow each other are one dividing curve. Its landmarks are at another friction for each weight: between
//! these one weight is on one line, and the other already on the next.

use super::arc::{Coordinate, CubicArc, arc};
use super::cubic::exact;
use super::place::Place;
use super::trace::{LEAST_TOLERANCE, Piece, Trace};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::number::{Ball, worded};
use crate::problem::{Landmark, Line};
use rug::float::Round;
use std::fmt;

worded! {
    /// A curve of lines between modes, one after the other.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Divide {
        /// Divide between a shoulder that slides and one that turns: from the origin by T, S and J to B.
        Shoulder = "shoulder",
        /// Divide between an inner joint that slides and a crown that turns: from the origin by T to l.
        Inner = "inner",
        /// Divide between a haunch above the joint that slides and one below it: from S to l.
        Joints = "joints",
        /// Divide at which the haunch arrives at the crown: from J to l.
        Crown = "crown",
    }
    /// All four divides.
    pub const ALL;
    /// The name used in files.
    pub fn name -> &'static str;
}

/// The half-width that is left for the tube of each of two weights.
const SHARE: f64 = 0.45;
/// The least tolerance of a difference.
pub const LEAST_DIFFERENCE: f64 = 4.0 * LEAST_TOLERANCE;

/// Milankovitch's thickness less Heyman's along a dividing curve, for each friction that it has for both.
#[derive(Clone, Debug)]
pub struct Difference {
    /// The curve.
    pub divide: Divide,
    steps: Vec<Step>,
    landmarks: Vec<(Landmark, SelfWeight, f64)>,
    nodes: Vec<DifferencePoint>,
}

/// A part of the curve on which either thickness is one cubic of the inclination.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// The lines of Heyman's weight and of Milankovitch's.
    pub lines: [Line; 2],
    /// The inclinations between which it runs.
    pub range: [f64; 2],
    /// The friction angle, rad.
    pub friction_angle: CubicArc,
    /// The difference.
    pub difference: CubicArc,
}

/// Values at an inclination.
#[derive(Clone, Debug)]
pub struct DifferencePoint {
    /// The inclination, exactly.
    pub parameter: f64,
    /// `phi`, rad.
    pub friction_angle: Ball,
    /// `mu = tan phi`.
    pub friction: Ball,
    /// Heyman's thickness and Milankovitch's.
    pub thickness: [Ball; 2],
    /// The second less the first.
    pub difference: Ball,
}

/// The pieces of the lines of one weight, end to end: none begins before the last one ends.
struct Track<'a> {
    parts: Vec<(Line, Piece<'a>, [f64; 2])>,
}

impl Divide {
    /// Lines of the divide, in order.
    pub fn lines(self) -> &'static [Line] {
        use Line as L;
        match self {
            Self::Shoulder => {
                &[L::RotationShoulder, L::AboveHaunchEnd, L::BelowHaunchEnd, L::CrownEnd]
            }
            Self::Inner => &[L::ShoulderEnd, L::RotationInner],
            Self::Joints => &[L::Joints],
            Self::Crown => &[L::Crown],
        }
    }
}

impl fmt::Display for Divide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl<'a> Track<'a> {
    fn new(traces: &'a [Trace], lines: &[Line]) -> Self {
        let mut parts: Vec<(Line, Piece, [f64; 2])> = Vec::new();
        for (line, trace) in lines.iter().zip(traces) {
            for piece in trace.pieces() {
                let [from, to] = piece.range();
                // Where lines follow each other both reach over the landmark, by less than a rounding.
                let from = parts.last().map_or(from, |(.., [_, end])| from.max(*end));
                if from < to {
                    parts.push((*line, piece, [from, to]));
                }
            }
        }
        Self { parts }
    }

    /// The piece over a part of the way that none of its ends cuts.
    fn over(&self, [low, high]: [f64; 2]) -> Option<(Line, Piece<'a>)> {
        let index = self.parts.partition_point(|(.., [_, to])| *to <= low);
        let (line, piece, [from, to]) = self.parts.get(index)?;
        (*from <= low && high <= *to).then_some((*line, *piece))
    }
}

/// Milankovitch's less Heyman's.
fn less([heyman, milankovitch]: [CubicArc; 2]) -> CubicArc {
    let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    CubicArc {
        values: minus(milankovitch.values, heyman.values),
        slopes: minus(milankovitch.slopes, heyman.slopes),
        // Each side has room for the rounding of its doubles, and so has the sum for theirs.
        off: (heyman.off + milankovitch.off) * (1.0 + f64::EPSILON),
        by_length: heyman.by_length + milankovitch.by_length,
    }
}

impl Difference {
    /// Follows both weights along a curve, in tubes of the difference no wider on either side than `tolerance`, from
    /// [`LEAST_DIFFERENCE`] up to 1. Undecided if a piece is not proved.
    pub fn new(divide: Divide, tolerance: f64) -> Result<Self, Undecided> {
        let trace = |(line, weight): (&Line, SelfWeight)| {
            let trace = Trace::over_inclination(*line, weight, SHARE * tolerance)?;
            let open = || format!("{line}, {weight}: not every piece is proved");
            match trace.gaps().count() {
                0 => Ok(trace),
                _ => Err(Undecided::new(open())),
            }
        };
        let of = |weight| divide.lines().iter().map(move |line| (line, weight)).map(trace);
        let traces: [Vec<Trace>; 2] = [
            of(SelfWeight::Heyman).collect::<Result<_, _>>()?,
            of(SelfWeight::Milankovitch).collect::<Result<_, _>>()?,
        ];
        Self::between(divide, &traces)
            .ok_or_else(|| Undecided::new(format!("{divide}: a part of it has no bound")))
    }

    fn between(divide: Divide, traces: &[Vec<Trace>; 2]) -> Option<Self> {
        let ends = |traces: &Vec<Trace>| {
            let from = traces.first()?.parameters()[0].upper().to_f64_round(Round::Up);
            let to = traces.last()?.parameters()[1].lower().to_f64_round(Round::Down);
            Some([from, to])
        };
        let [heyman, milankovitch] = [ends(&traces[0])?, ends(&traces[1])?];
        let (low, high) = (heyman[0].max(milankovitch[0]), heyman[1].min(milankovitch[1]));
        let tracks = traces.each_ref().map(|traces| Track::new(traces, divide.lines()));
        let cuts = tracks.iter().flat_map(|track| track.parts.iter().map(|(.., [_, to])| *to));
        let mut cuts: Vec<f64> =
            cuts.filter(|s| low < *s && *s < high).chain([low, high]).collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let (mut steps, mut nodes) = (Vec::new(), Vec::new());
        for pair in cuts.windows(2) {
            let range = [pair[0], pair[1]];
            let [heyman, milankovitch] = [tracks[0].over(range)?, tracks[1].over(range)?];
            let pieces = [heyman.1, milankovitch.1];
            let along = |piece: &Piece, coordinate| arc(piece, coordinate, range);
            let sides = [
                along(&pieces[0], Coordinate::Thickness)?,
                along(&pieces[1], Coordinate::Thickness)?,
            ];
            steps.push(Step {
                lines: [heyman.0, milankovitch.0],
                range,
                friction_angle: along(&pieces[0], Coordinate::FrictionAngle)?,
                difference: less(sides),
            });
            nodes.push(DifferencePoint::new(range[0], &pieces)?);
            if range[1] == high {
                nodes.push(DifferencePoint::new(high, &pieces)?);
            }
        }
        let mut landmarks: Vec<(Landmark, SelfWeight, f64)> = Vec::new();
        for (weight, traces) in SelfWeight::ALL.into_iter().zip(traces) {
            for (line, trace) in divide.lines().iter().zip(traces) {
                for (end, at) in line.ends().into_iter().zip(trace.parameters()) {
                    let Some(landmark) = end else { continue };
                    let is_known = landmarks.iter().any(|(l, w, _)| (*l, *w) == (landmark, weight));
                    // The ends are as near to their landmark as doubles are.
                    let [from, to] =
                        [at.lower().to_f64_round(Round::Down), at.upper().to_f64_round(Round::Up)];
                    let is_shared = to >= low && from <= high;
                    if is_shared && !is_known {
                        landmarks.push((landmark, weight, at.mid().to_f64().clamp(low, high)));
                    }
                }
            }
        }
        (!steps.is_empty()).then_some(Self { divide, steps, landmarks, nodes })
    }

    /// Steps of the difference, in order.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Points where each step begins, and where the last one ends.
    pub fn points(&self) -> &[DifferencePoint] {
        &self.nodes
    }

    /// The landmarks of either weight on the part that both have, with their inclinations.
    pub fn landmarks(&self) -> &[(Landmark, SelfWeight, f64)] {
        &self.landmarks
    }

    /// The largest half-width of a tube of the difference.
    pub fn width(&self) -> f64 {
        self.steps.iter().map(|step| step.difference.off).fold(0.0, f64::max)
    }

    /// Bounds of the difference on all of the curve: a cubic lies between its Bézier handles.
    pub fn bounds(&self) -> [f64; 2] {
        let of = |step: &Step| {
            let handles = step.handles();
            let low = handles.into_iter().fold(f64::INFINITY, f64::min) - step.difference.off;
            [low, handles.into_iter().fold(f64::NEG_INFINITY, f64::max) + step.difference.off]
        };
        let wider = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        self.steps.iter().map(of).fold([f64::INFINITY, f64::NEG_INFINITY], wider)
    }
}

impl Step {
    /// The handles of the cubic of the difference, over a third of the way each.
    pub fn handles(&self) -> [f64; 4] {
        let third = (self.range[1] - self.range[0]) / 3.0;
        let CubicArc { values: [from, to], slopes: [first, last], .. } = self.difference;
        [from, from + third * first, to - third * last, to]
    }
}

/// The quantities at a parameter of a piece: at a node, where the root is enclosed on its own, nearer than by the tube.
fn place(piece: &Piece, parameter: f64) -> Option<Place> {
    match piece.nodes().into_iter().find(|node| node.sketch.s == parameter) {
        Some(node) => Some(Place::new(piece.form, &exact(parameter), &node.root)),
        None => piece.place(parameter),
    }
}

impl DifferencePoint {
    fn new(parameter: f64, pieces: &[Piece; 2]) -> Option<Self> {
        let [heyman, milankovitch] = pieces.each_ref().map(|piece| place(piece, parameter));
        let (heyman, milankovitch) = (heyman?, milankovitch?);
        let thickness = [heyman.thickness?, milankovitch.thickness?];
        let Place { friction_angle: Some(friction_angle), friction: Some(friction), .. } =
            milankovitch
        else {
            return None;
        };
        let difference = thickness[1].clone() - &thickness[0];
        Some(Self { parameter, friction_angle, friction, thickness, difference })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Enclosure;

    /// The cubic of a step at one of its inclinations.
    fn at(step: &Step, s: f64) -> f64 {
        let ([from, to], [a, b, c, d]) = (step.range, step.handles());
        let (v, u) = ((s - from) / (to - from), (to - s) / (to - from));
        u.powi(3) * a + 3.0 * u * u * v * b + 3.0 * u * v * v * c + v.powi(3) * d
    }

    /// In the wide tubes lies what the narrow ones hold, and nothing a millionth beside.
    #[test]
    fn the_tube_holds_the_difference() {
        for divide in Divide::ALL {
            let [wide, narrow] = [1e-3, 1e-7].map(|width| Difference::new(divide, width).unwrap());
            assert!(wide.width() <= 1e-3 && narrow.width() <= 1e-7, "{divide}");
            for (point, known) in
                narrow.points().iter().zip(0..).step_by(9).map(|(p, _)| (p, &p.difference))
            {
                let s = point.parameter;
                let over = |of: &Difference| {
                    let over = |step: &&Step| (step.range[0]..=step.range[1]).contains(&s);
                    *of.steps().iter().find(over).unwrap()
                };
                for of in [&wide, &narrow] {
                    let step = over(of);
                    let value = exact(at(&step, s));
                    let away = (value.clone() - known).mid().to_f64().abs();
                    let room = step.difference.off + known.rad().to_float().to_f64();
                    assert!(away <= room, "{divide} {s}: {away} {room}");
                }
                let beside = exact(at(&over(&narrow), s) + 1e-6);
                assert!(!known.overlaps(&beside), "false twin");
            }
        }
    }

    /// From the origin, where both are nothing, to B of Milankovitch's weight or to l of both.
    #[test]
    fn a_curve_is_as_long_as_both_weights_have_it() {
        for divide in Divide::ALL {
            let difference = Difference::new(divide, 1e-3).unwrap();
            let (first, last) = (&difference.points()[0], difference.points().last().unwrap());
            let lines = difference.steps().iter().map(|step| step.lines);
            match divide {
                Divide::Shoulder => {
                    assert!(first.difference.overlaps(&exact(0.0)) && first.parameter == 0.0);
                    assert!(last.thickness[1].overlaps(&exact(2.0)), "{last:?}");
                    // About T one weight is on the next line already.
                    let mut all: Vec<_> = lines.collect();
                    all.dedup();
                    use Line::{
                        AboveHaunchEnd as A, BelowHaunchEnd as B, CrownEnd as C,
                        RotationShoulder as D,
                    };
                    assert_eq!(all, [[D, D], [D, A], [A, A], [A, B], [A, C], [B, C], [C, C]]);
                }
                _ => {
                    let right = std::f64::consts::FRAC_PI_2;
                    assert!((last.parameter - right).abs() < 1e-15, "{divide}");
                    // Heyman's l is at 1, Milankovitch's at 2 (2 √3 - 3).
                    let known = 4.0 * 3f64.sqrt() - 7.0;
                    let found = last.difference.mid().to_f64();
                    assert!((found - known).abs() < 1e-3 && (found + 0.1).abs() > 1e-2, "{divide}");
                }
            }
            let [low, high] = difference.bounds();
            assert!(low < 0.0 && high < if divide == Divide::Shoulder { 1.0 } else { 0.04 });
        }
    }

    #[test]
    fn tubes_are_as_narrow_as_is_said() {
        let narrow = Difference::new(Divide::Crown, LEAST_DIFFERENCE).unwrap();
        assert!(narrow.width() <= LEAST_DIFFERENCE && narrow.width() > 0.0);
    }
}
