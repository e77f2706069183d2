//! Small frames that show a part of the map larger.

use super::canvas::{Canvas, step};
use super::content::Content;
use super::plane::Plane;
use crate::picture::color::{GUIDE, INK, WHITE};
use crate::picture::room::Rectangle;
use crate::picture::{Frame, Path, Point, Side, Stroke, Svg};
use crate::problem::Landmark;

/// A part of the map, larger.
pub(super) struct Inset {
    /// Where it is on the page, and what it shows.
    pub frame: Frame,
    name: &'static str,
}

/// The insets by the names of their groups: S and J, and all domains in which an inner joint slides.
const JOINTS: &str = "inset-sj";
const MIXED: &str = "inset-tl";
const ENDS: &str = "inset-l";
/// For the labels of its ticks, to the left and below, and around the rest.
const LEFT: f64 = 50.0;
const BELOW: f64 = 28.0;
const REST: f64 = 8.0;
const TICK: f64 = 14.0;

impl Inset {
    /// The insets of a map whose frame has this corner: S and J, which are close, and where thin domains lie side by
    /// side, these too.
    pub(super) fn all(content: &Content, canvas: &Canvas, corner: Point) -> Vec<Self> {
        if !canvas.is_usual {
            return Vec::new();
        }
        let at = |(x, y): Point| (corner.0 + x, corner.1 + y);
        let [joints, top] =
            [Landmark::Shift, Landmark::Triple].map(|landmark| content.of(landmark));
        let ends =
            [Landmark::Junction, Landmark::OverturningEnd].map(|landmark| content.of(landmark));
        let [Some(s), Some(t), Some(j), Some(l)] = [joints, top, ends[0], ends[1]] else {
            return Vec::new();
        };
        let inset =
            |name, place, size, x, y| Self { frame: Frame { corner: at(place), size, x, y }, name };
        match canvas.plane {
            Plane::ThicknessFriction => {
                let (x, y) = (around(s.0, j.0, 2.6), around(s.1, j.1, 2.6));
                vec![inset(JOINTS, (72.0, 54.0), (260.0, 215.0), x, y)]
            }
            Plane::OpeningFriction | Plane::OpeningThickness => {
                let (x, y) = (around(t.0, l.0, 0.3), around(t.1, l.1, 0.1));
                let y = [y[0], y[1].min(canvas.axes[1].range[1])];
                let (joints_x, joints_y) = (around(s.0, j.0, 1.8), around(s.1, j.1, 1.8));
                vec![
                    inset(MIXED, (76.0, 36.0), (250.0, 220.0), x, y),
                    inset(JOINTS, (76.0, 310.0), (250.0, 150.0), joints_x, joints_y),
                ]
            }
        }
    }

    /// The insets of the lines of both weights: where S and J of both are, and the end of rotation.
    pub(super) fn of_both(of: impl Fn(Landmark) -> Vec<Point>, corner: Point) -> Vec<Self> {
        let [close, ends] =
            [[of(Landmark::Shift), of(Landmark::Junction)].concat(), of(Landmark::RotationEnd)];
        let limits = Plane::ThicknessFriction.axes().map(|axis| axis.range);
        if close.is_empty() || ends.is_empty() {
            return Vec::new();
        }
        let inset = |name, place: Point, size: Point, points: &[Point], [x, y]: [f64; 2]| {
            let range = |of: fn(&Point) -> f64, more: f64, limits: [f64; 2]| {
                let values = points.iter().map(of);
                let low: f64 = values.clone().fold(f64::INFINITY, f64::min) - more;
                let high = values.fold(f64::NEG_INFINITY, f64::max) + more;
                [low.max(limits[0]), high.min(limits[1])]
            };
            let (x, y) = (range(|p| p.0, x, limits[0]), range(|p| p.1, y, limits[1]));
            let corner = (corner.0 + place.0, corner.1 + place.1);
            Self { frame: Frame { corner, size, x, y }, name }
        };
        vec![
            inset(JOINTS, (76.0, 30.0), (300.0, 170.0), &close, [1.2, 0.025]),
            inset(ENDS, (76.0, 250.0), (300.0, 130.0), &ends, [8.0, 0.03]),
        ]
    }

    /// Whether S and J are told apart in it.
    pub(super) fn is_close(&self) -> bool {
        self.name == JOINTS
    }

    /// The beginning of the names of its groups.
    pub(super) fn id(&self) -> &'static str {
        self.name
    }

    /// Whether it lies over a point of the page, or nearly.
    pub(super) fn covers(&self, (x, y): Point) -> bool {
        let [low, high] = self.taken();
        (low.0..=high.0).contains(&x) && (low.1..=high.1).contains(&y)
    }

    /// What it takes of the page.
    pub(super) fn taken(&self) -> Rectangle {
        let (left, top) = self.frame.corner;
        [
            (left - LEFT - REST, top - 2.0 * REST),
            (self.frame.right() + 2.0 * REST, self.frame.bottom() + BELOW + REST),
        ]
    }

    /// From the part of the map that it shows to where it shows it.
    pub(super) fn draw_guides(&self, svg: &mut Svg, map: &Frame) {
        let Frame { x, y, corner: (_, top), .. } = self.frame;
        let (low, high) = (map.at((x[0], y[0])), map.at((x[1], y[1])));
        let (right, bottom) = (self.frame.right(), self.frame.bottom());
        let guides = [((low.0, high.1), (right, top)), (low, (right, bottom))];
        // Of a large part the upper one is enough.
        let guides = if self.is_close() { &guides[..] } else { &guides[..1] };
        for (from, to) in guides {
            svg.stroke(&Path::through([*from, *to]), Stroke::new(GUIDE, 1.0));
        }
        svg.stroke(&Path::rectangle(low, high), Stroke::new(INK, 1.0));
    }

    /// The inset itself, without names; what is drawn in it gets a beginning for the names of its groups.
    pub(super) fn draw(&self, svg: &mut Svg, canvas: &Canvas, draw: impl FnOnce(&mut Svg, &str)) {
        let frame = &self.frame;
        let (left, top) = frame.corner;
        let (right, bottom) = (frame.right() + REST, frame.bottom() + BELOW);
        svg.fill(&Path::rectangle((left - LEFT, top - REST), (right, bottom)), WHITE);
        svg.clipped(&frame.outline(), |svg| draw(svg, &format!("{}-", self.name)));
        svg.stroke(&frame.outline(), Stroke::new(INK, 1.2));
        let [x, y] = &canvas.axes;
        frame.ticks(svg, Side::Bottom, &x.ticks(frame.x, step(frame.x, 3.0)), TICK);
        frame.ticks(svg, Side::Left, &y.ticks(frame.y, step(frame.y, 3.0)), TICK);
    }
}

/// A range with so many times its length more at each end.
fn around(a: f64, b: f64, more: f64) -> [f64; 2] {
    let (low, high) = (a.min(b), a.max(b));
    let more = more * (high - low);
    [low - more, high + more]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_shown_with_what_is_around_it() {
        assert_eq!(around(3.0, 1.0, 0.5), [0.0, 4.0]);
    }
}
