//! The names of landmarks and modes: in their domain where there is room, else beside it with a leader.

use super::chain::Chain;
use super::content::PlaneContent;
use super::look;
use super::plane::Plane;
use super::spot::{disc, named, taken, towards};
use crate::picture::color::{INK, WHITE};
use crate::picture::labels::Labels;
use crate::picture::room::{Rectangle, about, roomiest, within};
use crate::picture::{Anchor, Frame, Path, Point, Stroke, Svg, Type, text};
use crate::problem::{Landmark, Mode};
use crate::report::words;

/// Names in a frame of the map.
pub(super) struct Names<'a> {
    pub content: &'a PlaneContent,
    pub frame: &'a Frame,
    /// Sizes of the fonts for modes and for landmarks.
    pub sizes: [f64; 2],
    /// Obstacles that the names keep off.
    pub labels: Labels,
}

/// Half the room that a leader needs at its end.
const TIP: Point = (2.0, 2.0);
/// Distances that a name may have from its domain.
const REACH: [f64; 5] = [36.0, 46.0, 60.0, 80.0, 104.0];
/// Distance between S and J, in sizes of the font, if each has its name.
const APART: f64 = 2.0;
/// Directions that are tried.
const TURNS: u32 = 24;

impl Names<'_> {
    /// Landmarks with their names. Next to each other S and J share one, unless they are `told_apart` or far enough
    /// from each other.
    pub(super) fn landmarks(&mut self, svg: &mut Svg, told_apart: bool) {
        let told_apart = told_apart || self.are_apart();
        let discs = self.content.landmarks.iter().map(|(_, at)| taken(self.frame.at(*at)));
        self.labels.taken.extend(discs);
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
            let towards = towards(*landmark, &self.content.canvas);
            let style = Type::new(self.sizes[1], INK);
            named(svg, &mut self.labels, (name, self.frame.at(*at)), towards, style);
        }
    }

    /// Tells whether S and J have room for a name each.
    fn are_apart(&self) -> bool {
        let [s, j] =
            [Landmark::Shift, Landmark::Junction].map(|l| Some(self.frame.at(self.content.of(l)?)));
        let room = APART * self.sizes[1];
        s.zip(j).is_some_and(|(s, j)| (s.0 - j.0).abs() > room || (s.1 - j.1).abs() > room)
    }

    /// The name of overturning beside its edge, if enough of that is seen.
    pub(super) fn overturning(&mut self, svg: &mut Svg) {
        let points = self.content.edge.as_ref().map(Chain::points).unwrap_or_default();
        if points.is_empty() || !points.iter().all(|point| self.frame.shows(*point)) {
            return;
        }
        let size = self.sizes[0];
        let beside = text::width(Mode::Overturning.label(), size) / 2.0 + 8.0;
        let place = |point: &Point| {
            let (x, y) = self.frame.at(*point);
            match self.content.canvas.plane {
                Plane::ThicknessFriction => (x - beside, y),
                Plane::OpeningFriction => (x, y + 0.9 * size),
                Plane::OpeningThickness => (x + beside, y),
            }
        };
        let is_free = |at: &Point| self.labels.is_free(about(*at, half(Mode::Overturning, size)));
        // From the middle outwards.
        let middle = points.len() / 2;
        let mut order: Vec<usize> = (0..points.len()).collect();
        order.sort_by_key(|k| k.abs_diff(middle));
        let Some(at) = order.into_iter().map(|k| place(&points[k])).find(is_free) else { return };
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
            let Labels { taken, lines, .. } = &self.labels;
            let roomiest = |half, lines| roomiest(&outline, half, taken, lines);
            // Off all lines where there is room for that.
            let half_name = half(*mode, size);
            if let Some(at) = roomiest(half_name, lines).or_else(|| roomiest(half_name, &[])) {
                self.write(svg, *mode, at, look::ground(*mode));
            } else if elsewhere.contains(mode) {
                continue;
            } else if let Some(tip) = roomiest(TIP, &[])
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
        self.labels.taken.push(about(at, half(mode, self.sizes[0])));
    }

    /// The nearest place for a name beside its domain, off all lines and all other names.
    fn beside(&self, mode: Mode, tip: Point) -> Option<Point> {
        let half = half(mode, self.sizes[0]);
        let is_free = |at: &Point| {
            let [low, high] = about(*at, half);
            let inside = low.0 > self.frame.corner.0 + 4.0
                && low.1 > self.frame.corner.1 + 4.0
                && high.0 < self.frame.right() - 4.0
                && high.1 < self.frame.bottom() - 4.0;
            inside && self.labels.is_free([low, high])
        };
        let around = |reach: f64| {
            (0..TURNS).map(move |k| {
                // From the lower right on: there nothing stands in most planes.
                let turn = f64::from(k) / f64::from(TURNS) * std::f64::consts::TAU + 0.6;
                (tip.0 + reach * turn.cos(), tip.1 + reach * turn.sin())
            })
        };
        let free = || REACH.into_iter().flat_map(around).filter(is_free);
        let clear = free().find(|at| !self.labels.is_crossed(about(*at, half)));
        clear.or_else(|| free().find(|at| !self.is_on_a_curve(about(*at, half))))
    }

    /// Tells whether a line between domains goes through an area; those of equal values are thin.
    fn is_on_a_curve(&self, area: Rectangle) -> bool {
        let lines =
            self.content.lines.iter().map(|(_, chain)| on_page(chain, self.frame)).collect();
        Labels { lines, ..Labels::default() }.is_crossed(area)
    }
}

/// The points of a chain on the page.
pub(super) fn on_page(chain: &Chain, frame: &Frame) -> Vec<Point> {
    chain.points().into_iter().map(|point| frame.at(point)).collect()
}

/// Half the width and the height of a name, with some room.
fn half(mode: Mode, size: f64) -> Point {
    (text::width(mode.label(), size) / 2.0 + 3.0, 0.6 * size)
}

/// Point where the way from the middle of a rectangle to a point leaves it.
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
