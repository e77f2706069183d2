//! The names of landmarks and modes: in their domain where there is room, else beside it with a leader.

use super::chain::Chain;
use super::content::Content;
use super::look;
use super::plane::Plane;
use super::spot::{Spot, disc};
use crate::picture::color::{INK, WHITE};
use crate::picture::room::{Rectangle, roomiest, within};
use crate::picture::{Anchor, Frame, Path, Point, Stroke, Svg, Type, text};
use crate::problem::{Landmark, Mode};
use crate::report::words;

/// Names in a frame of the map.
pub(super) struct Names<'a> {
    pub content: &'a Content,
    pub plane: Plane,
    pub frame: &'a Frame,
    /// Of the fonts for modes and for landmarks.
    pub sizes: [f64; 2],
    /// What other things take of the page.
    pub taken: Vec<Rectangle>,
}

/// Half the room that a leader needs at its end.
const TIP: Point = (2.0, 2.0);
/// How far a name may be from its domain.
const REACH: [f64; 5] = [36.0, 46.0, 60.0, 80.0, 104.0];
/// Directions that are tried.
const TURNS: u32 = 24;

impl Names<'_> {
    /// Landmarks with their names. Next to each other S and J share one, unless they are `told_apart`.
    pub(super) fn landmarks(&mut self, svg: &mut Svg, told_apart: bool) {
        for (landmark, at) in &self.content.landmarks {
            if !self.frame.shows(*at) {
                continue;
            }
            disc(svg, self.frame.at(*at));
            let name = match landmark {
                Landmark::Shift if !told_apart => "S, J",
                Landmark::Junction if !told_apart => continue,
                _ => words::symbol(*landmark),
            };
            let spot = Spot::new(*landmark, name, self.frame.at(*at), self.plane, self.sizes[1]);
            self.taken.push(spot.taken());
            spot.draw(svg);
        }
    }

    /// The name of overturning beside its edge, if enough of that is seen.
    pub(super) fn overturning(&mut self, svg: &mut Svg) {
        let points = self.content.edge.as_ref().map(Chain::points).unwrap_or_default();
        let Some(middle) = points.get(points.len() / 2) else { return };
        if !points.iter().all(|point| self.frame.shows(*point)) {
            return;
        }
        let size = self.sizes[0];
        let width = text::width(Mode::Overturning.label(), size);
        let middle = self.frame.at(*middle);
        let beside = width / 2.0 + 8.0;
        let at = match self.plane {
            Plane::ThicknessFriction => (middle.0 - beside, middle.1),
            Plane::OpeningFriction => (middle.0, middle.1 + 0.9 * size),
            Plane::OpeningThickness => (middle.0 + beside, middle.1),
        };
        self.write(svg, Mode::Overturning, at, WHITE);
    }

    /// The names of the modes, but for those that need a leader and are `elsewhere`; returns the named ones.
    pub(super) fn modes(&mut self, svg: &mut Svg, elsewhere: &[Mode]) -> Vec<Mode> {
        let mut named = Vec::new();
        let (frame, size) = (self.frame, self.sizes[0]);
        let window = [frame.corner, (frame.right(), frame.bottom())];
        for (mode, way) in &self.content.areas {
            let outline: Vec<Point> = way.points().into_iter().map(|p| frame.at(p)).collect();
            let outline = within(&outline, window);
            if let Some(at) = roomiest(&outline, half(*mode, size), &self.taken) {
                self.write(svg, *mode, at, look::ground(*mode));
            } else if elsewhere.contains(mode) {
                continue;
            } else if let Some(tip) = roomiest(&outline, TIP, &self.taken)
                && let Some(at) = self.beside(*mode, tip)
            {
                let style = Stroke::new(INK, 1.0);
                let edge = edge(at, half(*mode, size), tip);
                svg.stroke(&Path::through([tip, edge]), style);
                svg.disc(tip, 2.0, INK);
                self.write(svg, *mode, at, WHITE);
            } else {
                continue;
            }
            named.push(*mode);
        }
        named
    }

    fn write(&mut self, svg: &mut Svg, mode: Mode, at: Point, ground: crate::picture::Color) {
        let style = Type::new(self.sizes[0], INK).at(Anchor::Middle).on(ground);
        svg.text(mode.label(), at, style);
        self.taken.push(rectangle(at, half(mode, self.sizes[0])));
    }

    /// The nearest place for a name beside its domain, off all lines and all other names.
    fn beside(&self, mode: Mode, tip: Point) -> Option<Point> {
        let half = half(mode, self.sizes[0]);
        let on_page = |chain: &Chain| -> Vec<Point> {
            chain.points().into_iter().map(|point| self.frame.at(point)).collect()
        };
        let lines: Vec<Vec<Point>> =
            self.content.lines.iter().map(|(_, chain)| on_page(chain)).collect();
        let is_free = |at: &Point| {
            let [low, high] = rectangle(*at, half);
            let inside = low.0 > self.frame.corner.0 + 4.0
                && low.1 > self.frame.corner.1 + 4.0
                && high.0 < self.frame.right() - 4.0
                && high.1 < self.frame.bottom() - 4.0;
            let crosses = |line: &Vec<Point>| {
                line.windows(2).any(|part| !within(part, [low, high]).is_empty())
            };
            let meets =
                |[a, b]: &Rectangle| a.0 < high.0 && low.0 < b.0 && a.1 < high.1 && low.1 < b.1;
            inside && !lines.iter().any(crosses) && !self.taken.iter().any(meets)
        };
        let around = |reach: f64| {
            (0..TURNS).map(move |k| {
                // From the lower right on: there nothing stands in most planes.
                let turn = f64::from(k) / f64::from(TURNS) * std::f64::consts::TAU + 0.6;
                (tip.0 + reach * turn.cos(), tip.1 + reach * turn.sin())
            })
        };
        REACH.into_iter().flat_map(around).find(is_free)
    }
}

/// Half the width and the height of a name, with some room.
fn half(mode: Mode, size: f64) -> Point {
    (text::width(mode.label(), size) / 2.0 + 4.0, 0.64 * size)
}

fn rectangle(at: Point, half: Point) -> Rectangle {
    [(at.0 - half.0, at.1 - half.1), (at.0 + half.0, at.1 + half.1)]
}

/// Where the way from the middle of a rectangle to a point leaves it.
fn edge(middle: Point, half: Point, to: Point) -> Point {
    let (dx, dy) = (to.0 - middle.0, to.1 - middle.1);
    let share = (half.0 / dx.abs()).min(half.1 / dy.abs()).min(1.0);
    (middle.0 + share * dx, middle.1 + share * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_leader_begins_at_the_edge_of_the_name() {
        assert_eq!(edge((0.0, 0.0), (10.0, 5.0), (100.0, 0.0)), (10.0, 0.0));
        assert_eq!(edge((0.0, 0.0), (10.0, 5.0), (0.0, -50.0)), (0.0, -5.0));
        assert_eq!(edge((0.0, 0.0), (10.0, 5.0), (2.0, 2.0)), (2.0, 2.0));
    }
}
