//! A thin arch, unrolled: along it the joints, across it the thickness, enlarged.

use super::panel::ModePanel;
use crate::arch::mechanism::Contact;
use crate::atlas::{Sketch, SketchedLine, Subject};
use crate::picture::color::{INK, WHITE};
use crate::picture::{Anchor, Path, Point, Svg, Type, text};
use crate::sketch::{across, look};

/// The frame of an arch that is unrolled.
pub(super) struct Strip {
    alpha: f64,
    half: bool,
    /// Factor by which the thickness is drawn larger than the length.
    times: f64,
}

/// An arch thinner than this on the page is unrolled too.
const THIN: f64 = 26.0;
/// The thickness in the strip, and what is around it.
const ACROSS: f64 = 130.0;
const TOP: f64 = 34.0;
const SMALL: f64 = 15.0;
/// Height of the strip with what is around it.
pub(super) const HEIGHT: f64 = TOP + ACROSS + 40.0;

impl Strip {
    /// Strip of an arch of some radius on the page, if it is thin there.
    pub(super) fn of(sketch: &Sketch, radius: f64, half: bool) -> Option<Self> {
        let thickness = radius * sketch.thickness();
        let times = ACROSS / thickness;
        let of = Self { alpha: sketch.half_opening(), half, times };
        // Without lines there is nothing to see in it.
        (thickness < THIN && !sketch.forces.is_empty()).then_some(of)
    }

    pub(super) fn draw(&self, svg: &mut Svg, panel: &ModePanel, (left, top): Point, width: f64) {
        let [inner, outer] = [-0.5, 0.5];
        let from = if self.half { 0.0 } else { -self.alpha };
        let at = |joint: f64, offset: f64| -> Point {
            let across = (joint - from) / (self.alpha - from);
            (left + across * width, top + TOP + (0.5 - offset) * ACROSS)
        };
        let frame = Path::rectangle(at(from, outer), at(self.alpha, inner));
        let sides: &[f64] = if self.half { &[1.0] } else { &[1.0, -1.0] };
        let along = |line: &SketchedLine| {
            let points = across(line.points.iter().copied(), self.half);
            Path::through(points.into_iter().map(|[joint, offset]| at(joint, offset)))
        };
        svg.group("unrolled", |svg| {
            let times = match self.times {
                few if few < 1e4 => format!("{few:.0} times"),
                many => {
                    format!("{} times and more", text::power_of_ten(many.log10().floor() as i64))
                }
            };
            let words = format!("unrolled; across the arch {times} enlarged");
            svg.text(
                &words,
                (left + width / 2.0, top + TOP / 2.0),
                Type::new(SMALL, INK).at(Anchor::Middle),
            );
            svg.fill(&frame, look::STONE);
            svg.stroke(&frame, look::OUTLINE);
            let is_standing = matches!(panel.sketch.subject, Subject::Standing { .. });
            for (place, forces) in panel.sketch.forces.iter().enumerate() {
                let is_second = is_standing && place > 0;
                let friction = if is_second { look::LARGEST_FRICTION } else { look::FRICTION };
                svg.stroke(&along(&forces.friction_line), friction);
                let thrust = match forces.thrust_lines.len() {
                    1 if is_second => look::LARGEST,
                    1 => look::THRUST,
                    _ => look::EXTREME,
                };
                forces.thrust_lines.iter().for_each(|line| svg.stroke(&along(line), thrust));
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
            let style = Type::new(SMALL, INK).at(Anchor::Middle);
            for (joint, name) in [(0.0, "crown"), (self.alpha, "shoulder")] {
                let (x, y) = at(joint, inner);
                svg.text(name, (x, y + 18.0), style);
            }
        });
    }
}
