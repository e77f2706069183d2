//! A thin arch, unrolled: along it the joints, across it the thickness, enlarged, and how it falls in that scale.

use super::panel::ModePanel;
use crate::arch::mechanism::Contact;
use crate::atlas::{Block, SketchedLine, moved};
use crate::picture::color::{INK, WHITE};
use crate::picture::{Anchor, Page, Path, Point, Svg, Type, text};
use crate::sketch::{across, look, polar};

/// The frame of an arch that is unrolled.
pub(super) struct Strip {
    alpha: f64,
    half: bool,
    /// Factor by which the thickness is drawn larger than the length.
    times: f64,
    /// Thickness as it is drawn.
    across: f64,
    /// The outlines of the blocks as they fall: angles from the crown and offsets in thicknesses.
    blocks: Vec<Vec<[f64; 2]>>,
}

/// Distance by which the corner that moves most is moved, in thicknesses.
const AMPLITUDE: f64 = 0.5;
/// Doubles do not tell how the blocks of a thinner arch move across it.
const THINNEST: f64 = 1e-10;
/// Points along a face of a block.
const POINTS: u32 = 24;

/// The outlines of blocks that have moved by part of the thickness.
fn fallen(panel: &ModePanel) -> Vec<Vec<[f64; 2]>> {
    let eta = panel.sketch.thickness();
    let Some(collapse) = panel.collapse.filter(|_| eta > THINNEST) else { return Vec::new() };
    let outline = |block: &Block| {
        let [from, to] = block.between;
        let at = |k: u32, offset: f64| {
            let joint = from + (to - from) * f64::from(k) / f64::from(POINTS);
            let [x, y] = block.motion.to(&polar(joint, 1.0 + offset * eta));
            [x.atan2(y), (x.hypot(y) - 1.0) / eta]
        };
        let there = (0..=POINTS).map(|k| at(k, 0.5));
        there.chain((0..=POINTS).rev().map(|k| at(k, -0.5))).collect()
    };
    moved(collapse, &panel.sketch.at, AMPLITUDE * eta).blocks.iter().map(outline).collect()
}

/// An arch thinner than this on the page is unrolled too.
const THIN: f64 = 26.0;
/// The thickness in the strip, and what is around it.
const ACROSS: f64 = 130.0;
const TOP: f64 = 34.0;
/// Height of the strip with what is around it.
pub(super) const HEIGHT: f64 = TOP + ACROSS + 40.0;

impl Strip {
    /// Strip of an arch of some radius on the page, if it is thin there.
    pub(super) fn of(panel: &ModePanel, radius: f64, half: bool) -> Option<Self> {
        let sketch = panel.sketch;
        let thickness = radius * sketch.thickness();
        // Without lines there is nothing to see in it.
        if thickness >= THIN || sketch.forces.is_empty() {
            return None;
        }
        let blocks = fallen(panel);
        let lines = sketch.forces.iter().flat_map(|of| of.lines().all());
        let points = lines.flat_map(|line| &line.points).chain(blocks.iter().flatten());
        let furthest = points.map(|[_, offset]| offset.abs()).fold(0.5, f64::max);
        let across = ACROSS / (2.0 * furthest);
        Some(Self { alpha: sketch.half_opening(), half, times: across / thickness, across, blocks })
    }

    /// Caption: by how much the thickness is enlarged, and the fall with it.
    fn caption(&self) -> String {
        let times = match self.times {
            few if few < 1e4 => format!("{few:.0} times"),
            many => format!("{} times and more", text::power_of_ten(many.log10().floor() as i64)),
        };
        let falls = if self.blocks.is_empty() { "" } else { " and fall" };
        format!("unrolled; thickness{falls} enlarged {times}")
    }

    pub(super) fn draw(&self, svg: &mut Svg, panel: &ModePanel, (left, top): Point, width: f64) {
        let [inner, outer] = [-0.5, 0.5];
        let from = if self.half { 0.0 } else { -self.alpha };
        let at = |joint: f64, offset: f64| -> Point {
            let across = (joint - from) / (self.alpha - from);
            (left + across * width, top + TOP + ACROSS / 2.0 - offset * self.across)
        };
        let frame = Path::rectangle(at(from, outer), at(self.alpha, inner));
        let sides: &[f64] = if self.half { &[1.0] } else { &[1.0, -1.0] };
        let along = |line: &SketchedLine| {
            let points = across(line.points.iter().copied(), self.half);
            Path::through(points.into_iter().map(|[joint, offset]| at(joint, offset)))
        };
        svg.group("unrolled", |svg| {
            let style = Type::new(Page::SMALL, INK).at(Anchor::Middle);
            svg.text(&self.caption(), (left + width / 2.0, top + TOP / 2.0), style);
            svg.fill(&frame, look::STONE);
            for (block, side) in
                self.blocks.iter().flat_map(|block| sides.iter().map(move |s| (block, s)))
            {
                let outline =
                    Path::around(block.iter().map(|[joint, offset]| at(side * joint, *offset)));
                svg.tint(&outline, look::FALLEN, look::SHEER);
                svg.stroke(&outline, look::FALLEN_EDGE);
            }
            svg.stroke(&frame, look::OUTLINE);
            for (place, of) in panel.view.lines.iter().enumerate() {
                let [thrust, friction] = look::of_lines(place, of.thrust.len());
                svg.stroke(&along(of.friction), friction);
                of.thrust.iter().for_each(|line| svg.stroke(&along(line), thrust));
            }
            for (contact, joint) in panel.view.marks.iter().copied() {
                let sides = if joint > 0.0 { sides } else { &[1.0] };
                for side in sides {
                    let [low, high] = [inner, outer].map(|offset| at(side * joint, offset));
                    match contact {
                        Contact::Extrados => svg.ring(high, look::HINGE_RADIUS, WHITE, look::HINGE),
                        Contact::Intrados => svg.ring(low, look::HINGE_RADIUS, WHITE, look::HINGE),
                        _ => svg.stroke(&Path::through([low, high]), look::SLIDES),
                    }
                }
            }
            for (joint, name) in [(0.0, "crown"), (self.alpha, "shoulder")] {
                let (x, _) = at(joint, inner);
                svg.text(name, (x, top + TOP + ACROSS + 18.0), style);
            }
        });
    }
}
