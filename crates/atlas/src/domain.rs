//! The domains of the modes in the plane of friction angle and thickness, as closed loops of curves.
//!
//! Together they tile `0 <= phi <= pi/2`, `0 <= eta <= 2`: each line of the map is a side of two of them, in opposite
//! directions, and each edge of the rectangle is used up once. What proves that the modes are where these loops
//! say are the claims `map-…` of `couplet prove`; `[r]` is an edge, at unlimited friction.

use super::curve::Curve;
use super::end::CurveEnd;
use crate::problem::{Landmark, Line, Mode};

/// A side of a domain, in the direction in which the loop runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DomainSide {
    /// A curve from its beginning to its end.
    Along(Curve),
    /// A curve from its end to its beginning.
    Back(Curve),
    /// An edge of the rectangle between two of its points.
    Edge(Corner, Corner),
}

/// A point on the edge of the rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Corner {
    /// An end of curves.
    End(CurveEnd),
    /// `phi = pi/2`, `eta = 0`.
    RightBottom,
    /// `phi = pi/2`, `eta = 2`: what `L` is there.
    RightTop,
    /// `phi = 0`, `eta = 2`.
    LeftTop,
}

impl DomainSide {
    /// Corners where it begins and ends.
    pub fn ends(self) -> [Corner; 2] {
        match self {
            Self::Along(curve) => curve.ends().map(Corner::End),
            Self::Back(curve) => {
                let [from, to] = curve.ends().map(Corner::End);
                [to, from]
            }
            Self::Edge(from, to) => [from, to],
        }
    }
}

/// The loop around the domain of a mode, counterclockwise where the friction angle runs to the right and the
/// thickness upwards; of `[r]` the edge alone.
pub fn boundary(mode: Mode) -> Vec<DomainSide> {
    use DomainSide::{Along, Back, Edge};
    let line = Curve::Line;
    let landmark = |landmark| Corner::End(CurveEnd::Landmark(landmark));
    let (origin, l, b) = (
        Corner::End(CurveEnd::Origin),
        landmark(Landmark::RotationEnd),
        landmark(Landmark::Border),
    );
    match mode {
        Mode::Rotational => vec![
            Edge(origin, Corner::RightBottom),
            Edge(Corner::RightBottom, l),
            Back(line(Line::RotationInner)),
            Back(line(Line::RotationShoulder)),
        ],
        Mode::SlidingRotational => {
            vec![Along(line(Line::RotationShoulder)), Back(line(Line::ShoulderEnd))]
        }
        Mode::RotationalSliding => vec![
            Along(line(Line::RotationInner)),
            Back(line(Line::Joints)),
            Back(line(Line::AboveHaunchEnd)),
        ],
        Mode::RotationalSlidingRotational => {
            vec![
                Along(line(Line::Joints)),
                Back(line(Line::Crown)),
                Back(line(Line::BelowHaunchEnd)),
            ]
        }
        Mode::OverturningSliding => vec![
            Along(line(Line::Crown)),
            Edge(l, Corner::RightTop),
            Edge(Corner::RightTop, b),
            Back(line(Line::CrownEnd)),
        ],
        Mode::Sliding => vec![
            Along(line(Line::ShoulderEnd)),
            Along(line(Line::AboveHaunchEnd)),
            Along(line(Line::BelowHaunchEnd)),
            Along(line(Line::CrownEnd)),
            Edge(b, Corner::LeftTop),
            Edge(Corner::LeftTop, origin),
        ],
        Mode::Overturning => vec![Edge(l, Corner::RightTop)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    fn domains() -> impl Iterator<Item = Mode> {
        Mode::ALL.into_iter().filter(|mode| *mode != Mode::Overturning)
    }

    #[test]
    fn every_loop_is_closed() {
        for mode in domains() {
            let sides = boundary(mode);
            for (index, side) in sides.iter().enumerate() {
                let next = sides[(index + 1) % sides.len()];
                assert_eq!(side.ends()[1], next.ends()[0], "{mode} behind side {index}");
            }
        }
    }

    /// Each line is a side of the two modes that it divides, once in each direction; each edge once: nothing is
    /// left out, and nothing is there twice.
    #[test]
    fn the_loops_cancel_but_for_the_rectangle() {
        let mut used: HashMap<Line, Vec<(Mode, bool)>> = HashMap::new();
        let mut edges = Vec::new();
        for (mode, side) in
            domains().flat_map(|mode| boundary(mode).into_iter().map(move |s| (mode, s)))
        {
            match side {
                DomainSide::Along(Curve::Line(line)) => {
                    used.entry(line).or_default().push((mode, true))
                }
                DomainSide::Back(Curve::Line(line)) => {
                    used.entry(line).or_default().push((mode, false))
                }
                DomainSide::Edge(from, to) => edges.push((from, to)),
                other => panic!("{other:?} divides nothing"),
            }
        }
        for line in Line::ALL {
            let both = &used[&line];
            assert!(both.len() == 2 && both[0].1 != both[1].1, "{line}: {both:?}");
            assert!(line.modes().iter().all(|mode| both.iter().any(|(m, _)| m == mode)), "{line}");
        }
        // The edges alone are one loop around the rectangle.
        let (mut at, mut left) = (edges[0].1, edges.len() - 1);
        while at != edges[0].0 {
            at = edges.iter().find(|(from, _)| *from == at).unwrap().1;
            left -= 1;
        }
        assert_eq!(left, 0);
    }
}
