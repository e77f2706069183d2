//! Words for an arch that falls: what is proved of it, and what is a drawing only.

use super::Sketched;
use super::motion::{reached, unit};
use super::numbers::{FEW, length};
use crate::atlas::{Collapse, Forces, Sketch};
use crate::number::Drawable;
use crate::problem::Mode;
use crate::report::numbers::rounded;

/// An arch that falls, with the mechanism that its weight drives.
pub(super) struct Falling<'a> {
    forces: &'a Forces,
    collapse: &'a Collapse,
}

impl<'a> Falling<'a> {
    /// `None` of an arch that stands, and where no mechanism is proved.
    pub(super) fn of(sketch: &'a Sketch) -> Option<Self> {
        let (forces, collapse) = (sketch.forces.first()?, sketch.collapses.first()?);
        sketch.falls().then_some(Self { forces, collapse })
    }

    pub(super) fn paragraphs(&self, drawn: &Sketched) -> [String; 2] {
        [
            format!("Proved: {}", self.proved()),
            format!("Drawn, not proved: {}", self.drawn_only(drawn)),
        ]
    }

    /// Statement of what the joints and their rates prove.
    pub(super) fn proved(&self) -> String {
        let Collapse { mode, power, friction_power, is_dilatant, .. } = self.collapse;
        let contradicts = match mode {
            Mode::Sliding => "friction is passed at one of the joints that slide here",
            Mode::Rotational | Mode::Overturning => {
                "at one of the joints that open here the line of thrust leaves the arch"
            }
            _ => {
                "at one of the joints here the line of thrust leaves the arch or friction is passed"
            }
        };
        let rest = match (mode, is_dilatant) {
            (Mode::Rotational | Mode::Overturning, _) | (_, true) => String::new(),
            _ => format!(", of which friction takes {}", rounded(friction_power, FEW)),
        };
        format!(
            "whatever the thrust, {contradicts}. The rates of this motion are positive, and the weight drives it: it \
             gives {} wr for {}{rest}.",
            rounded(power, FEW),
            unit(*mode)
        )
    }

    /// Statement of what was chosen for the eye.
    pub(super) fn drawn_only(&self, drawn: &Sketched) -> String {
        let Forces { thrust, beyond, thrust_lines, .. } = self.forces;
        let asked = |joint: &crate::atlas::Mark| {
            let at = crate::number::Angle::new(joint.at.clone());
            let shear = crate::arch::statics::shear_force(&at, thrust);
            let ratio = shear / crate::arch::statics::normal_force(&at, thrust);
            ratio.double().abs()
        };
        let line = match (beyond, &thrust_lines[..]) {
            (Some(by), _) if self.collapse.mode == Mode::Overturning => {
                format!(
                    "the line of thrust without thrust, {} beyond the extrados of the shoulder",
                    length(by.double())
                )
            }
            (Some(by), _) => {
                format!(
                    "of all lines of thrust the one that is as far beyond the faces at each hinge, {}",
                    length(by.double())
                )
            }
            (None, lines) => {
                let asked = self.forces.marks.iter().map(asked).fold(0.0, f64::max);
                let lines = if lines.len() > 1 {
                    "the extreme lines of thrust"
                } else {
                    "a line of thrust"
                };
                format!(
                    "{lines} at the thrust at which both joints ask for the same friction, {asked:.4}"
                )
            }
        };
        let thrust = thrust.double();
        // A line that begins far beyond the arch is left out.
        let is_far = thrust_lines.iter().all(|line| line.points.len() < 2);
        let line = if is_far { format!("{line} (too far to be drawn)") } else { line };
        format!(
            "{line}, h = H/(wr) = {thrust:.4}; the blocks, moved rigidly, the corner that moves most by {}.",
            reached(drawn)
        )
    }
}
