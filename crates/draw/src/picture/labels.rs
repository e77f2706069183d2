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
    /// The window; none for the whole page.
    pub window: Option<Rectangle>,
}

/// Distance from a point to the edge of its label.
const NEAR: f64 = 7.0;
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
        let is_in = |part: &[Point]| !within(part, area).is_empty();
        self.lines.iter().any(|line| line.windows(2).any(is_in))
    }

    /// The middle of a label of half a width and height beside a point, which takes that place: as near to a direction
    /// as what is there allows, then as near to the point. Where every place is crossed by lines it lies on one.
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
        let clear = free().find(|at| !self.is_crossed(about(*at, half)));
        let middle = clear.or_else(|| free().next()).unwrap_or(all[0]);
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

    /// A label between lines without room lies on one, and not elsewhere.
    #[test]
    fn a_label_has_a_place_all_the_same() {
        let lines =
            (-40..40).map(|k| vec![(-200.0, 3.0 * f64::from(k)), (200.0, 3.0 * f64::from(k))]);
        let mut labels = Labels { lines: lines.collect(), ..Labels::default() };
        assert_eq!(labels.beside((0.0, 0.0), HALF, (1.0, 0.0)), (NEAR + HALF.0, 0.0));
    }
}
