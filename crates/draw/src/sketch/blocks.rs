//! The blocks as they fall, at rest or moving.

use super::Collapse;
use super::look;
use super::moved::{Block, moved};
use super::scale::{PageScale, faces, polar};
use crate::arch::Configuration;
use crate::number::Drawable;
use crate::picture::{Path, Point, Rigid, Svg};

/// The blocks of a mode, displaced by an amplitude; and on the way there, if they move.
#[derive(Clone, Debug)]
pub struct Blocks {
    /// The blocks where they are drawn.
    pub fallen: Vec<Block>,
    /// The blocks at each step of a motion that begins and ends there.
    steps: Vec<Vec<Block>>,
    radii: [f64; 2],
    joints: Vec<f64>,
}

/// Steps from there to rest.
const STEPS: u32 = 12;
/// Time of the way there and back.
const SECONDS: f64 = 5.0;

impl Blocks {
    /// Blocks of a mode, no corner moved by more than an amplitude in units of `r`; `joints` are those
    /// between stones.
    pub fn new<T: Drawable>(
        collapse: &Collapse<T>,
        at: &Configuration<T>,
        amplitude: f64,
        animate: bool,
        joints: &[f64],
    ) -> Self {
        let radii = faces(at.thickness.double());
        let at = |share: f64| moved(collapse, at, amplitude * share).blocks;
        let steps = if animate { 2 * STEPS } else { 0 };
        // Slow at both ends.
        let share =
            |k: u32| (1.0 + (std::f64::consts::PI * f64::from(k) / f64::from(STEPS)).cos()) / 2.0;
        Self {
            fallen: at(1.0),
            steps: (0..=steps).filter(|_| animate).map(|k| at(share(k))).collect(),
            radii,
            joints: joints.to_vec(),
        }
    }

    /// Blocks that have moved, of the whole arch or of the right half.
    pub fn at_rest(fallen: Vec<Block>, radii: [f64; 2], joints: &[f64]) -> Self {
        Self { fallen, steps: Vec::new(), radii, joints: joints.to_vec() }
    }

    /// Tells whether a stone lies over the crown, so that the block there is one for both halves.
    pub fn has_keystone(&self) -> bool {
        self.joints.first().is_some_and(|first| *first > 0.0)
    }

    /// The outlines of both halves or of one, 1 for the right one and -1 for the left.
    pub fn draw(&self, svg: &mut Svg, scale: &PageScale, sides: &[f64]) {
        for side in sides {
            self.draw_half(svg, scale, *side, self.has_keystone() && sides.len() > 1);
        }
    }

    /// A half; the right one has the whole of a block that is one for both.
    fn draw_half(&self, svg: &mut Svg, scale: &PageScale, side: f64, has_keystone: bool) {
        for (place, block) in self.fallen.iter().enumerate() {
            let is_keystone = has_keystone && block.between[0] == 0.0;
            if is_keystone && side < 0.0 {
                continue;
            }
            let steps: Vec<Rigid> = self
                .steps
                .iter()
                .filter_map(|all| all.get(place))
                .map(|b| rigid(b, scale, side))
                .collect();
            let joints: Vec<f64> = self
                .joints
                .iter()
                .copied()
                .filter(|joint| (block.between[0]..block.between[1]).contains(joint))
                .collect();
            let [from, to] = block.between;
            let (from, sides) =
                if is_keystone { (-to, &[1.0, -1.0][..]) } else { (from, &[side][..]) };
            let outline = scale.sector([from, to], self.radii, side);
            svg.moved(rigid(block, scale, side), &steps, SECONDS, |svg| {
                svg.tint(&outline, look::FALLEN, look::SHEER);
                for side in sides.iter().filter(|_| !joints.is_empty()) {
                    svg.stroke(&scale.joints(&joints, self.radii, *side), look::FALLEN_JOINT);
                }
                svg.stroke(&outline, look::FALLEN_EDGE);
            });
        }
    }

    /// Arrows from where the blocks were to where they are.
    pub fn arrows(&self, svg: &mut Svg, scale: &PageScale, side: f64) {
        for block in &self.fallen {
            let [from, to] = block.between;
            let half = (to - from) / 2.0;
            let (middle, radius) = ((from + to) / 2.0, half.sin() / half);
            let centre = polar(middle, radius);
            let [tail, head] =
                [centre, block.motion.to(&centre)].map(|point| scale.at(point, side));
            arrow(svg, tail, head);
        }
    }

    /// The corners, to the right and up.
    pub fn corners(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let radii = self.radii;
        self.fallen.iter().flat_map(move |block| {
            let [from, to] = block.between;
            let joints = (0..=8).map(move |k| from + (to - from) * f64::from(k) / 8.0);
            joints.flat_map(move |joint| radii.map(|radius| block.motion.to(&polar(joint, radius))))
        })
    }
}

/// A motion on the page.
fn rigid(block: &Block, scale: &PageScale, side: f64) -> Rigid {
    let ([cos, sin], [right, up]) = (block.motion.turn, block.motion.shift);
    Rigid {
        shift: (side * scale.radius * right, -scale.radius * up),
        degrees: -side * sin.atan2(cos).to_degrees(),
        about: scale.center,
    }
}

/// An arrow; one that is too short is left out.
pub fn arrow(svg: &mut Svg, tail: Point, head: Point) {
    let (dx, dy) = (head.0 - tail.0, head.1 - tail.1);
    let length = dx.hypot(dy);
    if length < 9.0 {
        return;
    }
    let (dx, dy) = (dx / length, dy / length);
    let tip = (length / 2.0).min(9.0);
    let back = |across: f64| {
        (head.0 - tip * dx - across * tip * dy, head.1 - tip * dy + across * tip * dx)
    };
    svg.stroke(
        &Path::through([tail, (head.0 - tip * 0.6 * dx, head.1 - tip * 0.6 * dy)]),
        look::ARROW,
    );
    svg.fill(&Path::around([head, back(0.35), back(-0.35)]), look::ARROW.color);
}
