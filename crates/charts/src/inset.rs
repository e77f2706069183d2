//! Small frames that show a part of the map larger.

use super::canvas::Canvas;
use super::content::PlaneContent;
use super::page::{self, SIZE};
use super::plane::{Plane, step};
use crate::picture::color::{INK, WHITE};
use crate::picture::room::{Rectangle, about, roomiest, span, within};
use crate::picture::scale::Tick;
use crate::picture::text;
use crate::picture::{Frame, FrameSide, Name, Path, Point, Stroke, Svg, Type};
use crate::problem::Landmark;

/// A part of the map, larger.
pub(super) struct Inset {
    /// Frame of the inset on the page, and what it shows.
    pub frame: Frame,
    name: &'static str,
}

/// The insets by the names of their groups: S and J, and all domains in which an inner joint slides.
const JOINTS: &str = "inset-sj";
const MIXED: &str = "inset-tl";
const ENDS: &str = "inset-l";
const TRIPLE: &str = "inset-t";
/// Space for the labels of its ticks, to the left and below, and around the rest.
const LEFT: f64 = 50.0;
const BELOW: f64 = 28.0;
const REST: f64 = 8.0;
const TICK: f64 = 14.0;
/// Numbers of insets, and their size.
const NUMBER: f64 = 16.0;
const NUMBERS: [&str; 3] = ["(i)", "(ii)", "(iii)"];
/// Space for the name of a landmark, around it.
const NAME: f64 = 26.0;

impl Inset {
    /// The insets of a map: S and J, which are close, and where thin domains lie side by side, these too. On axes
    /// as usual each has its place; on others it is put where a domain has room for it, off what is `taken`.
    pub(super) fn all(content: &PlaneContent, map: &Frame, taken: &[Rectangle]) -> Vec<Self> {
        let canvas = &content.canvas;
        if !canvas.is_usual && map.size.0 >= SIZE.0 {
            return roomy(content, map, taken);
        }
        let inset = |(name, [x, y]): &EnlargedPart| {
            let (place, size) = match (canvas.plane, *name) {
                (Plane::ThicknessFriction, _) => ((72.0, 54.0), SIZES[0]),
                (_, MIXED) => ((76.0, 36.0), (250.0, 220.0)),
                _ => ((76.0, 310.0), (250.0, 150.0)),
            };
            Self { frame: Frame { corner: place, size, x: *x, y: *y }, name }
        };
        Self::within(map, parts(content).iter().map(inset).collect())
    }

    /// Insets in a map, whose places and sizes are those in one of the usual width; below one that is narrow, each as
    /// wide as it, one under the other.
    fn within(map: &Frame, mut insets: Vec<Self>) -> Vec<Self> {
        let times = map.size.0 / SIZE.0;
        let mut top = map.bottom() + page::BELOW + 2.0 * REST;
        for Self { frame: Frame { corner, size, .. }, .. } in &mut insets {
            if times < 1.0 {
                *size = (map.size.0, size.1 * map.size.0 / size.0);
                *corner = (map.corner.0, top);
                top += size.1 + BELOW + 3.0 * REST;
            } else {
                *size = (times * size.0, times * size.1);
                *corner = (map.corner.0 + times * corner.0, map.corner.1 + times * corner.1);
            }
        }
        insets
    }

    /// Room below a map that its insets take, if they are there.
    pub(super) fn down(insets: &[Self], map: &Frame) -> f64 {
        let lowest = insets.iter().map(|inset| inset.taken()[1].1).fold(0.0, f64::max);
        (lowest + REST - map.bottom() - page::BELOW).max(0.0)
    }

    /// The insets of the lines of both weights: where S and J of both are, the end of rotation, and T.
    pub(super) fn of_both(of: impl Fn(Landmark) -> Vec<Point>, map: &Frame) -> Vec<Self> {
        let [close, ends] =
            [[of(Landmark::Shift), of(Landmark::Junction)].concat(), of(Landmark::RotationEnd)];
        let triple = of(Landmark::Triple);
        let limits = Plane::ThicknessFriction.axes().map(|axis| axis.range);
        if close.is_empty() || ends.is_empty() {
            return Vec::new();
        }
        let inset = |name, corner: Point, size: Point, points: &[Point], [x, y]: [f64; 2]| {
            let range = |of: fn(&Point) -> f64, more: f64, limits: [f64; 2]| {
                let [low, high] = span(points.iter().map(of));
                [(low - more).max(limits[0]), (high + more).min(limits[1])]
            };
            let (x, y) = (range(|p| p.0, x, limits[0]), range(|p| p.1, y, limits[1]));
            Self { frame: Frame { corner, size, x, y }, name }
        };
        let insets = vec![
            inset(JOINTS, (76.0, 30.0), (300.0, 170.0), &close, [1.2, 0.025]),
            inset(ENDS, (76.0, 250.0), (300.0, 130.0), &ends, [8.0, 0.03]),
            inset(TRIPLE, (520.0, 442.0), (224.0, 92.0), &triple, [1.5, 0.05]),
        ];
        Self::within(map, insets)
    }

    /// Tells whether S and J are told apart in it.
    pub(super) fn is_close(&self) -> bool {
        self.name == JOINTS
    }

    /// The beginning of the names of its groups.
    pub(super) fn id(&self) -> &'static str {
        self.name
    }

    /// Tells whether the inset lies over a point of the page, or nearly.
    pub(super) fn covers(&self, (x, y): Point) -> bool {
        let [low, high] = self.taken();
        (low.0..=high.0).contains(&x) && (low.1..=high.1).contains(&y)
    }

    /// Area that the inset takes of the page.
    pub(super) fn taken(&self) -> Rectangle {
        let (left, top) = self.frame.corner;
        [
            (left - LEFT - REST, top - 2.0 * REST),
            (self.frame.right() + 2.0 * REST, self.frame.bottom() + BELOW + REST),
        ]
    }

    /// Draws the parts of the map that insets show; the numbers at both, where there are several.
    pub(super) fn draw_parts(insets: &[Self], svg: &mut Svg, map: &Frame) -> Vec<Name> {
        let mut names = Vec::new();
        for (Self { frame, .. }, number) in insets.iter().zip(NUMBERS) {
            let (low, high) = (map.at((frame.x[0], frame.y[0])), map.at((frame.x[1], frame.y[1])));
            svg.stroke(&Path::rectangle(low, high), Stroke::new(INK, 1.0));
            if insets.len() > 1 {
                names.push(Name::new(number, (low.0, high.1), (-1.0, -1.0)));
                let (x, y) = frame.corner;
                svg.text(number, (x, y - 10.0), Type::new(NUMBER, INK).on(WHITE));
            }
        }
        names
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
        // As many as have room.
        let ticks = |least| x.ticks(frame.x, step(frame.x, least));
        let length = |ticks: &Vec<Tick>| -> f64 {
            ticks.iter().map(|tick| text::width(&tick.label, TICK) + TICK).sum()
        };
        let across = [3.0, 2.0].map(ticks).into_iter().find(|ticks| length(ticks) < frame.size.0);
        frame.ticks(svg, FrameSide::Bottom, &across.unwrap_or_default(), TICK);
        frame.ticks(svg, FrameSide::Left, &y.ticks(frame.y, step(frame.y, 3.0)), TICK);
    }
}

/// A part of the map that is shown larger: the name of its inset, and what is along the axes.
pub(super) type EnlargedPart = (&'static str, [[f64; 2]; 2]);

/// The parts that are shown larger, within the map.
pub(super) fn parts(content: &PlaneContent) -> Vec<EnlargedPart> {
    use Landmark as L;
    let canvas = &content.canvas;
    let [Some(s), Some(t), Some(j), Some(l)] =
        [L::Shift, L::Triple, L::Junction, L::OverturningEnd].map(|landmark| content.of(landmark))
    else {
        return Vec::new();
    };
    let on = |range: [f64; 2], k: usize| {
        let [low, high] = canvas.axes[k].range;
        [range[0].max(low), range[1].min(high)]
    };
    let part = |name, a: Point, b: Point, more: Point| {
        let x = on(around(a.0, b.0, more.0), 0);
        (name, [x, on(around(a.1, b.1, more.1), 1)])
    };
    let is_shown = |(x, y): Point| {
        let [across, up] = canvas.axes.each_ref().map(|axis| axis.range);
        (across[0]..=across[1]).contains(&x) && (up[0]..=up[1]).contains(&y)
    };
    let all = match canvas.plane {
        Plane::ThicknessFriction => vec![((s, j), part(JOINTS, s, j, (2.6, 2.6)))],
        _ => {
            vec![((t, l), part(MIXED, t, l, (0.3, 0.1))), ((s, j), part(JOINTS, s, j, (1.8, 1.8)))]
        }
    };
    // A window without either has nothing to show of what lies between them.
    let seen = all.into_iter().filter(|((a, b), _)| is_shown(*a) || is_shown(*b));
    seen.map(|(_, part)| part).collect()
}

/// Sizes of an inset that are tried where it has no place of its own.
const SIZES: [Point; 3] = [(260.0, 215.0), (210.0, 170.0), (170.0, 130.0)];
/// Ratio of an inset to the map up to which nothing needs an inset: half the size is enough.
const LARGER: f64 = 2.0;

/// Insets where domains have room for them.
fn roomy(content: &PlaneContent, map: &Frame, taken: &[Rectangle]) -> Vec<Inset> {
    let window = [map.corner, (map.right(), map.bottom())];
    let outline = |way: &super::chain::Chain| -> Vec<Point> {
        let points: Vec<Point> = way.points().into_iter().map(|at| map.at(at)).collect();
        within(&points, window)
    };
    let outlines: Vec<Vec<Point>> = content.areas.iter().map(|(_, way)| outline(way)).collect();
    let discs = content.landmarks.iter().filter(|(_, at)| map.shows(*at));
    let mut taken: Vec<Rectangle> = taken
        .iter()
        .copied()
        .chain(discs.map(|(_, at)| about(map.at(*at), (NAME, NAME))))
        .collect();
    let mut found = Vec::new();
    for (name, [x, y]) in parts(content) {
        let (low, high) = (map.at((x[0], y[0])), map.at((x[1], y[1])));
        let (across, up) = (high.0 - low.0, low.1 - high.1);
        let is_seen = across > 0.0 && up > 0.0;
        let inset = SIZES.into_iter().filter(|_| is_seen).find_map(|size| {
            if LARGER * across > size.0 || LARGER * up > size.1 {
                return None;
            }
            let inset = Inset { frame: Frame { corner: (0.0, 0.0), size, x, y }, name };
            let [from, to] = inset.taken();
            let half = ((to.0 - from.0) / 2.0, (to.1 - from.1) / 2.0);
            let mut places = outlines.iter().map(|outline| roomiest(outline, half, &taken, &[]));
            let middle = places.find_map(|place| place)?;
            let corner = (middle.0 - half.0 - from.0, middle.1 - half.1 - from.1);
            Some(Inset { frame: Frame { corner, ..inset.frame }, name })
        });
        taken.extend(inset.iter().map(Inset::taken).chain([[(low.0, high.1), (high.0, low.1)]]));
        found.extend(inset);
    }
    found
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
