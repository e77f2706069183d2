//! A window onto a plane, with its axes.

use super::color::INK;
use super::path::{Path, Point};
use super::scale::Tick;
use super::svg::{Anchor, Stroke, Svg, Type};
use super::text::{self, LEADING};

/// A rectangle of the page, and what lies in it: from left to right and from the bottom to the top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The upper left corner on the page.
    pub corner: Point,
    /// Width and height on the page.
    pub size: Point,
    /// Values at the left and at the right edge.
    pub x: [f64; 2],
    /// Values at the bottom and at the top.
    pub y: [f64; 2],
}

/// An edge of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameSide {
    /// The first coordinate from below.
    Bottom,
    /// The first coordinate from above.
    Top,
    /// The second coordinate.
    Left,
    /// The second coordinate.
    Right,
}

/// Distance from the frame to the labels of its ticks.
const OFF: f64 = 8.0;
/// The length of a tick.
const TICK: f64 = 5.0;

impl Frame {
    /// Place of a point of the plane on the page.
    pub fn at(&self, (x, y): Point) -> Point {
        let share = |value: f64, [from, to]: [f64; 2]| (value - from) / (to - from);
        let (across, up) = (share(x, self.x), share(y, self.y));
        (self.corner.0 + across * self.size.0, self.corner.1 + (1.0 - up) * self.size.1)
    }

    /// Tells whether a point of the plane is in it.
    pub fn shows(&self, (x, y): Point) -> bool {
        let within = |value: f64, [from, to]: [f64; 2]| (from..=to).contains(&value);
        within(x, self.x) && within(y, self.y)
    }

    /// The right edge on the page.
    pub fn right(&self) -> f64 {
        self.corner.0 + self.size.0
    }

    /// The lower edge on the page.
    pub fn bottom(&self) -> f64 {
        self.corner.1 + self.size.1
    }

    /// Edges of the frame on the page.
    pub fn outline(&self) -> Path {
        Path::rectangle(self.corner, (self.right(), self.bottom()))
    }

    /// Every so many ticks at an edge have room for their labels.
    fn labelled(&self, side: FrameSide, ticks: &[Tick], size: f64) -> usize {
        let is_along = matches!(side, FrameSide::Bottom | FrameSide::Top);
        let half = |tick: &Tick| match is_along {
            true => text::width(&tick.label, size) / 2.0 + 0.2 * size,
            false => LEADING * size / 2.0,
        };
        let place = |tick: &Tick| {
            let (x, y) = self.at((tick.place, tick.place));
            if is_along { x } else { -y }
        };
        let fits = |every: &usize| {
            let kept: Vec<&Tick> = ticks.iter().step_by(*every).collect();
            kept.windows(2).all(|two| place(two[1]) - place(two[0]) >= half(two[0]) + half(two[1]))
        };
        [1, 2, 3, 4, 6].into_iter().find(fits).unwrap_or(ticks.len().max(1))
    }

    /// Ticks at an edge, pointing inwards, with their labels outside where these have room.
    pub fn ticks(&self, svg: &mut Svg, side: FrameSide, ticks: &[Tick], size: f64) {
        let half = size * LEADING / 2.0;
        let every = self.labelled(side, ticks, size);
        for (k, tick) in ticks.iter().enumerate() {
            let (x, y) = self.at((tick.place, tick.place));
            let (from, to, label, anchor) = match side {
                FrameSide::Bottom => {
                    let y = self.bottom();
                    ((x, y), (x, y - TICK), (x, y + 1.25 * OFF + half), Anchor::Middle)
                }
                FrameSide::Top => {
                    let y = self.corner.1;
                    ((x, y), (x, y + TICK), (x, y - OFF / 2.0 - half), Anchor::Middle)
                }
                FrameSide::Left => {
                    let x = self.corner.0;
                    ((x, y), (x + TICK, y), (x - OFF, y), Anchor::End)
                }
                FrameSide::Right => {
                    let x = self.right();
                    ((x, y), (x - TICK, y), (x + OFF, y), Anchor::Start)
                }
            };
            svg.stroke(&Path::through([from, to]), Stroke::new(INK, 1.2));
            if k.is_multiple_of(every) {
                svg.text(&tick.label, label, Type::new(size, INK).at(anchor));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plane_points_up_and_the_page_down() {
        let frame =
            Frame { corner: (10.0, 20.0), size: (90.0, 200.0), x: [0.0, 90.0], y: [0.0, 2.0] };
        assert_eq!(frame.at((0.0, 2.0)), (10.0, 20.0));
        assert_eq!(frame.at((45.0, 0.5)), (55.0, 170.0));
        assert!(frame.shows((90.0, 0.0)) && !frame.shows((90.1, 0.0)) && !frame.shows((1.0, -0.1)));
        assert_eq!(frame.outline().to_string(), "M10 20L100 20L100 220L10 220Z");
    }

    #[test]
    fn each_tick_stands_at_its_edge() {
        let frame =
            Frame { corner: (0.0, 0.0), size: (100.0, 100.0), x: [0.0, 1.0], y: [0.0, 1.0] };
        let ticks = [Tick { place: 0.25, label: "a".into() }];
        for (side, tick) in [
            (FrameSide::Bottom, "M25 100L25 95"),
            (FrameSide::Top, "M25 0L25 5"),
            (FrameSide::Left, "M0 75L5 75"),
            (FrameSide::Right, "M100 75L95 75"),
        ] {
            let mut svg = Svg::new((100.0, 100.0), "", "");
            frame.ticks(&mut svg, side, &ticks, 10.0);
            assert!(svg.finish().contains(tick), "{side:?}");
        }
    }
}
