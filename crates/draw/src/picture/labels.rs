//! Labels beside points, off lines and other labels.

use super::path::Point;
use super::room::{Rectangle, about, within};

/// Obstacles that labels of a window keep off.
#[derive(Clone, Debug, Default)]
pub struct Labels {
    /// Areas that other things take.
    pub taken: Vec<Rectangle>,
    /// Lines by their points.
    pub lines: Vec<Vec<Point>>,
    /// Points that have names.
    pub points: Vec<Point>,
    /// The window; none for the whole page.
    pub window: Option<Rectangle>,
}

/// Distance from a point to the edge of its label.
const NEAR: f64 = 7.0;
/// Part of a label at its edge that has no ink.
const EDGE: f64 = 1.0;
/// Distances to which a label may go, in these distances, and in how many directions it is tried.
const REACH: [f64; 6] = [1.0, 1.6, 2.6, 3.7, 5.0, 6.5];
const TURNS: u32 = 24;

impl Labels {
    /// Tells whether nothing but lines is in an area, and all of it in the window.
    pub fn is_free(&self, [low, high]: Rectangle) -> bool {
        let meets = |[a, b]: &Rectangle| a.0 < high.0 && low.0 < b.0 && a.1 < high.1 && low.1 < b.1;
        let holds =
            |[a, b]: Rectangle| a.0 <= low.0 && a.1 <= low.1 && high.0 <= b.0 && high.1 <= b.1;
        !self.taken.iter().any(meets) && self.window.is_none_or(holds)
    }

    /// Tells whether a line goes through an area.
    pub fn is_crossed(&self, area: Rectangle) -> bool {
        self.crossings(area) > 0
    }

    /// Straight parts of lines that go through an area.
    fn crossings(&self, [low, high]: Rectangle) -> usize {
        // A line along its edge is none.
        let (low, high) = ((low.0 + EDGE, low.1 + EDGE), (high.0 - EDGE, high.1 - EDGE));
        let is_in = |part: &&[Point]| {
            let [a, b] = [part[0], part[1]];
            let is_beside = a.0.max(b.0) < low.0
                || a.0.min(b.0) > high.0
                || a.1.max(b.1) < low.1
                || a.1.min(b.1) > high.1;
            !is_beside && !within(part, [low, high]).is_empty()
        };
        self.lines.iter().map(|line| line.windows(2).filter(is_in).count()).sum()
    }

    /// Tells whether an area is nearer to a point than to all others that have names.
    fn is_own(&self, [low, high]: Rectangle, at: Point) -> bool {
        let away = |of: Point| {
            let beyond = |x: f64, low: f64, high: f64| (low - x).max(x - high).max(0.0);
            beyond(of.0, low.0, high.0).hypot(beyond(of.1, low.1, high.1))
        };
        self.points.iter().all(|other| *other == at || away(*other) > away(at))
    }

    /// The middle of a label of half a width and height beside a point, which takes that place: as near to a direction
    /// as what is there allows, then as near to the point, and never nearer to another that has a name. Where every
    /// place is crossed by lines it lies on as few as it can; where all are taken it is in the window all the same.
    pub fn beside(&mut self, at: Point, half: Point, towards: Point) -> Point {
        let usual = towards.1.atan2(towards.0);
        let place = |turn: f64, reach: f64| {
            let (sin, cos) = turn.sin_cos();
            let far = reach * NEAR;
            (at.0 + cos * far + square(cos) * half.0, at.1 + sin * far + square(sin) * half.1)
        };
        let turns = (0..TURNS).map(|k| {
            // The usual one, then by turns further to each side.
            let step = f64::from(k.div_ceil(2)) / f64::from(TURNS) * std::f64::consts::TAU;
            usual + if k % 2 == 0 { step } else { -step }
        });
        let all: Vec<Point> =
            REACH.iter().flat_map(|reach| turns.clone().map(|turn| place(turn, *reach))).collect();
        let free = || all.iter().copied().filter(|at| self.is_free(about(*at, half)));
        let own = || free().filter(|middle| self.is_own(about(*middle, half), at));
        let clear = own().find(|at| !self.is_crossed(about(*at, half)));
        let crossings = |at: &Point| self.crossings(about(*at, half));
        let fewest = || own().min_by_key(crossings).or_else(|| free().min_by_key(crossings));
        let middle = clear.or_else(fewest).unwrap_or_else(|| match self.window {
            Some([low, high]) => (
                all[0].0.min(high.0 - half.0).max(low.0 + half.0),
                all[0].1.min(high.1 - half.1).max(low.1 + half.1),
            ),
            None => all[0],
        });
        self.taken.push(about(middle, half));
        middle
    }
}

/// From the circle to the square about it, so that a label in a corner is beside its point and not behind.
fn square(share: f64) -> f64 {
    (share * std::f64::consts::SQRT_2).clamp(-1.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const HALF: Point = (10.0, 5.0);

    #[test]
    fn a_label_is_where_it_is_usual_unless_something_is_there() {
        let mut labels = Labels::default();
        let right = labels.beside((0.0, 0.0), HALF, (1.0, 0.0));
        assert_eq!(right, (NEAR + HALF.0, 0.0));
        let other = labels.beside((0.0, 0.0), HALF, (1.0, 0.0));
        let apart =
            (right.0 - other.0).abs() >= 2.0 * HALF.0 || (right.1 - other.1).abs() >= 2.0 * HALF.1;
        assert!(apart, "{other:?}");
    }

    #[test]
    fn a_label_keeps_off_lines_and_in_its_window() {
        let lines = vec![vec![(-100.0, -2.0), (100.0, 2.0)], vec![(1.0, -100.0), (-1.0, 100.0)]];
        let window = Some([(-100.0, 0.0), (100.0, 100.0)]);
        let mut labels = Labels { lines, window, ..Labels::default() };
        for towards in [(1.0, 0.0), (0.0, -1.0), (-1.0, -1.0)] {
            let middle = labels.beside((0.0, 0.0), HALF, towards);
            assert!(!labels.is_crossed(about(middle, HALF)) && middle.1 >= HALF.1, "{middle:?}");
        }
    }

    /// The usual place of the second is nearer to the first one's point.
    #[test]
    fn a_label_is_nearest_to_its_own_point() {
        let (own, other) = ((0.0, 0.0), (2.0 * NEAR + 2.0 * HALF.0, 0.0));
        let mut labels = Labels { points: vec![own, other], ..Labels::default() };
        let wide = (HALF.0 + 1.0, HALF.1);
        let middle = labels.beside(own, wide, (1.0, 0.0));
        assert!(labels.is_own(about(middle, wide), own) && middle.0 < NEAR + wide.0, "{middle:?}");
    }

    /// A label between lines without room lies on one, and not elsewhere.
    #[test]
    fn a_label_has_a_place_all_the_same() {
        let lines =
            (-40..40).map(|k| vec![(-200.0, 3.0 * f64::from(k)), (200.0, 3.0 * f64::from(k))]);
        let mut labels = Labels { lines: lines.collect(), ..Labels::default() };
        let middle = labels.beside((0.0, 0.0), HALF, (1.0, 0.0));
        let (placed, usual) = (about(middle, HALF), about((NEAR + HALF.0, 0.0), HALF));
        assert!((1..=labels.crossings(usual)).contains(&labels.crossings(placed)), "{middle:?}");
    }
}
