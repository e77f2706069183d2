//! The values of levels, outside the frame where these end.

use super::canvas::Canvas;
use super::chain::Chain;
use super::content::PlaneContent;
use super::plane::Plane;
use crate::atlas::Contour;
use crate::picture::color::{GUIDE, INK, WHITE};
use crate::picture::room::Rectangle;
use crate::picture::spread::spread;
use crate::picture::{Anchor, Frame, Path, Point, Stroke, Svg, Type, text};

const SIZE: f64 = 15.0;
const LABEL: f64 = 18.0;
/// Distance from the frame to the values, to which a leader goes, and to what they are; above it names of
/// landmarks come first.
const OFF: f64 = 18.0;
const ABOVE: f64 = 40.0;
const AWAY: f64 = 72.0;
/// Distance between a leader and its value.
const GAP: f64 = 4.0;
/// Distance between two values, in sizes of the font.
const APART: f64 = 1.1;

/// A value as it is read: `80°`, or with its letter where not all lines are those of the plane.
pub(super) fn shown(contour: &Contour, is_named: bool) -> String {
    let value = contour.given().replace("deg", "°");
    match contour {
        _ if !is_named => value,
        Contour::HalfOpening(_) => format!("α = {value}"),
        Contour::Thickness(_) => format!("η = {value}"),
        Contour::Friction(_) => format!("μ = {value}"),
    }
}

/// Place where a chain leaves a frame for the last time, by its right or by its upper edge.
fn leaves(chain: &Chain, frame: &Frame, is_right: bool) -> Option<Point> {
    let points = chain.points();
    let edge = if is_right { frame.x[1] } else { frame.y[1] };
    let towards = |(x, y): Point| if is_right { x } else { y };
    let is_on = |at: &Point| frame.shows(*at);
    // What ends on the edge, but for rounding.
    let end = points.last().filter(|end| (towards(**end) - edge).abs() <= 1e-9 * edge.abs());
    let crossing = |pair: &[Point]| {
        let (from, to) = (pair[0], pair[1]);
        let share = (edge - towards(from)) / (towards(to) - towards(from));
        let at = (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
        let at = if is_right { (edge, at.1) } else { (at.0, edge) };
        ((0.0..=1.0).contains(&share) && frame.shows(at)).then_some(at)
    };
    let end = end.map(|end| if is_right { (edge, end.1) } else { (end.0, edge) }).filter(is_on);
    end.or_else(|| points.windows(2).rev().find_map(crossing))
}

/// Values of frictions over the friction angle, beside their upright lines, which end at no such edge; what they take.
pub(super) fn upright(svg: &mut Svg, frame: &Frame, content: &PlaneContent) -> Vec<Rectangle> {
    let is_upright = |contour: &Contour| {
        let plane = content.canvas.plane;
        matches!(contour, Contour::Friction(_)) && plane == Plane::ThicknessFriction
    };
    let mut taken = Vec::new();
    for (contour, chain) in content.levels.iter().filter(|(contour, _)| is_upright(contour)) {
        let Some([_, top]) = chain.ends().filter(|[_, top]| frame.shows(*top)) else { continue };
        let label = shown(contour, true);
        let (x, y) = frame.at(top);
        let half = text::width(&label, SIZE) / 2.0;
        let at = (x, y + SIZE * (1.0 + 1.2 * (taken.len() % 4) as f64));
        svg.text(&label, at, Type::new(SIZE, INK).at(Anchor::Middle).on(WHITE));
        taken.push([(x - half, at.1 - SIZE / 2.0), (x + half, at.1 + SIZE / 2.0)]);
    }
    taken
}

/// Values at the right edge, or above the upper one, with the name of their quantity.
pub(super) fn levels(svg: &mut Svg, frame: &Frame, content: &PlaneContent) {
    let PlaneContent { levels, canvas: Canvas { plane, .. }, .. } = content;
    let is_right = *plane == Plane::ThicknessFriction;
    let is_named = !levels.iter().all(|(contour, _)| plane.is_crossed_by(contour));
    let along = |(x, y): Point| if is_right { y } else { x };
    let mut ends: Vec<(f64, String)> = levels
        .iter()
        .filter_map(|(contour, chain)| {
            Some((along(frame.at(leaves(chain, frame, is_right)?)), shown(contour, is_named)))
        })
        .collect();
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let widest = text::widest(ends.iter().map(|(_, label)| label), SIZE);
    let (gap, low, high) = match is_right {
        true => (APART * SIZE, frame.corner.1, frame.bottom()),
        false => (widest + 0.5 * SIZE, frame.corner.0, frame.right()),
    };
    // Of more than have room every second, or fewer, has its value.
    let every = (gap * ends.len() as f64 / (high - low)).ceil().max(1.0) as usize;
    let ends: Vec<(f64, String)> = ends.into_iter().rev().step_by(every).rev().collect();
    let wanted: Vec<f64> = ends.iter().map(|end| end.0).collect();
    for ((place, label), shifted) in ends.iter().zip(spread(&wanted, gap, low, high)) {
        let (from, to, at, anchor) = match is_right {
            true => {
                let x = frame.right();
                ((x, *place), (x + OFF - GAP, shifted), (x + OFF, shifted), Anchor::Start)
            }
            false => {
                let y = frame.corner.1;
                let at = (shifted, y - ABOVE - SIZE / 2.0);
                ((*place, y), (shifted, y - ABOVE + GAP), at, Anchor::Middle)
            }
        };
        svg.stroke(&Path::through([from, to]), Stroke::new(GUIDE, 1.0));
        svg.text(label, at, Type::new(SIZE, INK).at(anchor));
    }
    if is_named {
        return;
    }
    let style = Type::new(LABEL, INK).at(Anchor::Middle);
    let (across, up) = (frame.corner.0 + frame.size.0 / 2.0, frame.corner.1 + frame.size.1 / 2.0);
    match is_right {
        true => {
            svg.text(plane.contour_label(), (frame.right() + AWAY, up), style.turned(-90.0));
        }
        false => svg.text(plane.contour_label(), (across, frame.corner.1 - AWAY), style),
    }
}
