//! Work of a scene: each piece is done once, for all that ask for it.

use super::arch_node::ArchNode;
use super::computable::Computable;
use super::curve_node::CurveNode;
use super::drawn::DrawnArch;
use super::landmark_node::LandmarkNode;
use super::survey_node::SurveyNode;
use crate::claims::Claim;

/// A piece of work.
#[derive(Debug)]
pub(super) enum Work<'s> {
    /// A landmark.
    Landmark(LandmarkNode),
    /// An arch.
    Arch(ArchNode<'s>),
    /// A claim of the paper.
    Claim(Claim),
    /// A curve of the map.
    Curve(CurveNode),
    /// An arch that is drawn.
    Drawing(Box<DrawnArch>),
    /// All arches between two ends.
    Survey(SurveyNode<'s>),
}

impl<'s> Work<'s> {
    /// Words for one and for many of each kind, in the order in which kinds are counted.
    pub(super) const KINDS: [(&'static str, &'static str); 6] = [
        ("landmark", "landmarks"),
        ("arch", "arches"),
        ("claim", "claims"),
        ("curve", "curves"),
        ("drawn arch", "drawn arches"),
        ("range of arches", "ranges of arches"),
    ];

    /// Node that is computed, with the place of its kind.
    fn computed(&self) -> (usize, &(dyn Computable + 's)) {
        match self {
            Self::Landmark(node) => (0, node),
            Self::Arch(node) => (1, node),
            Self::Claim(claim) => (2, claim),
            Self::Curve(node) => (3, node),
            Self::Drawing(drawn) => (4, &**drawn),
            Self::Survey(node) => (5, node),
        }
    }

    /// Node that is computed.
    pub(super) fn of(&self) -> &(dyn Computable + 's) {
        self.computed().1
    }

    /// Words for its kind.
    pub(super) fn kind(&self) -> (&'static str, &'static str) {
        Self::KINDS[self.computed().0]
    }
}
