//! The room beside arches: how large they are on a sheet, and where.

use crate::picture::Anchor;

/// Names beside arches: places in units of `r` from the centre, and the room on the page beyond each.
#[derive(Clone, Debug, Default)]
pub(crate) struct Beside {
    /// To the left.
    pub left: Vec<(f64, f64)>,
    /// To the right.
    pub right: Vec<(f64, f64)>,
}

impl Beside {
    /// Names beside the one and beside the other.
    pub(crate) fn and(mut self, other: Self) -> Self {
        self.left.extend(other.left);
        self.right.extend(other.right);
        self
    }

    /// A name of a width that begins at a place, so far across from the centre; over the crown it has its middle there.
    pub(crate) fn name(across: f64, at: f64, room: f64) -> Self {
        match Anchor::beside(across) {
            Anchor::Start => Self { left: Vec::new(), right: vec![(at, room)] },
            Anchor::End => Self { left: vec![(at, room)], right: Vec::new() },
            Anchor::Middle => Self { left: vec![(at, room / 2.0)], right: vec![(at, room / 2.0)] },
        }
    }

    /// Distances in units of `r`, and the room beyond their ends.
    fn pairs(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.left.iter().flat_map(|l| self.right.iter().map(move |r| (r.0 - l.0, l.1 + r.1)))
    }

    /// The width that a radius asks for.
    pub(crate) fn width(&self, radius: f64) -> f64 {
        self.pairs().map(|(across, more)| radius * across + more).fold(0.0, f64::max)
    }

    /// The largest radius that has room in a width.
    pub(crate) fn radius(&self, width: f64) -> f64 {
        let all = self.pairs().filter(|(across, _)| *across > 0.0);
        all.map(|(across, more)| (width - more) / across).fold(f64::INFINITY, f64::min)
    }

    /// The centre of an arch between two ends: where it is wanted, unless what is on one side needs more.
    pub(crate) fn center(&self, wanted: f64, [from, to]: [f64; 2], radius: f64) -> f64 {
        let most = |ends: &[(f64, f64)], side: f64| {
            ends.iter().map(|(at, room)| room + side * radius * at).fold(0.0, f64::max)
        };
        wanted.min(to - most(&self.right, 1.0)).max(from + most(&self.left, -1.0))
    }
}
