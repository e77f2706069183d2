//! The picture of an arch, by what draws the pictures of `couplet draw`.

use couplet_check::arch::{Configuration, SelfWeight};
use couplet_check::problem::Mode;
use couplet_draw::sketch::{
    ArchView, Blocks, Collapse, Forces, falling, furthest_haunch, joints_of, moment_of, picture,
};
use couplet_number::number::{DoubleDoubleBall, Drawable};

/// The width in units of the picture.
const WIDTH: f64 = 560.0;
/// How far the corner that moves most is moved, in units of `r`.
const AMPLITUDE: f64 = 0.12;

/// What is drawn of an arch.
pub(crate) struct Drawing<'a> {
    pub(crate) weight: SelfWeight,
    pub(crate) at: &'a Configuration<DoubleDoubleBall>,
    pub(crate) is_limited: bool,
    pub(crate) title: &'a str,
}

impl Drawing<'_> {
    /// At its least thickness: its lines, its joints, how it falls, and that moving if it is wanted.
    pub(crate) fn state(&self, mode: Mode, moves: bool) -> Option<String> {
        let moment = moment_of(self.weight, mode, self.at)?;
        let marks = joints_of(mode, self.at);
        let forces = Forces::new(self.weight, (self.at, &[]), self.is_limited, &[moment], marks);
        let collapse = Collapse::new(self.weight, mode, self.at, false).ok()?;
        Some(self.drawn(Some(&forces), Some((&collapse, self.at, moves))))
    }

    /// As it falls in a mode, with the joints of its state: a haunch goes to where the line of thrust is the furthest
    /// beyond. `None` where its weight is not proved to drive it.
    pub(crate) fn falling(&self, mode: Mode, moves: bool) -> Option<String> {
        let mut at = self.at.clone();
        if mode.has_haunch() && !at.rotation_joint.rad.is_zero() {
            at.rotation_joint = furthest_haunch(self.weight, mode, &at);
        }
        let of = (&[][..], self.is_limited);
        let (forces, collapse) = falling(self.weight, mode, &mut at, of, (&[], false)).ok()?;
        Some(self.drawn(Some(&forces), Some((&collapse, &at, moves))))
    }

    /// As it stands, with the line of a crown moment.
    pub(crate) fn standing(&self, moment: DoubleDoubleBall) -> String {
        let forces =
            Forces::new(self.weight, (self.at, &[]), self.is_limited, &[moment], Vec::new());
        self.drawn(Some(&forces), None)
    }

    /// Without a line.
    pub(crate) fn bare(&self) -> String {
        self.drawn(None, None)
    }

    /// Its lines, if there are some, and how it falls from where, if it does.
    fn drawn(
        &self,
        forces: Option<&Forces<DoubleDoubleBall>>,
        falls: Option<(&Collapse<DoubleDoubleBall>, &Configuration<DoubleDoubleBall>, bool)>,
    ) -> String {
        let eta = self.at.thickness.double();
        let marks = falls.map(|(collapse, ..)| collapse.joints_at_limit());
        let blocks = |(collapse, at, moves)| Blocks::new(collapse, at, AMPLITUDE, moves, &[]);
        let view = ArchView {
            half_opening: self.at.half_opening.rad.double(),
            radii: [1.0 - eta / 2.0, 1.0 + eta / 2.0],
            lines: forces.iter().map(|of| of.lines()).collect(),
            has_jump: !self.is_limited && forces.is_some_and(|of| of.thrust.is_zero()),
            marks: marks.unwrap_or_default(),
            blocks: falls.map(blocks),
            ..ArchView::default()
        };
        picture(&view, WIDTH, self.title)
    }
}
