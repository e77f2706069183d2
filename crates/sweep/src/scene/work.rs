//! Work of a scene: each piece is done once, for all that ask for it.

use super::arch_node::ArchNode;
use super::curve_node::CurveNode;
use super::drawn::DrawnArch;
use super::landmark_node::LandmarkNode;
use super::shared::Shared;
use super::survey_node::SurveyNode;
use crate::claims::Claim;
use std::any::Any;

/// A piece of work.
#[derive(Debug)]
pub enum Work<'s> {
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

/// Result of a piece of work, of a type that its kind has.
pub(super) type Done = Box<dyn Any + Send + Sync>;

/// An arch takes about as long as a landmark of this many digits.
pub(super) const ARCH: usize = 200;
/// A claim, or a curve of the map, as long as one of this many.
pub(super) const LONG: usize = 10_000;

/// What is computed once.
pub(super) trait Computable {
    /// Key of equal work of its kind, however its numbers are written.
    fn key(&self) -> String;

    /// The work, in digits of landmarks that take as long.
    fn size(&self) -> usize {
        ARCH
    }

    /// Number of times that it reports progress.
    fn ticks(&self) -> u64 {
        1
    }

    /// Its name, and lines on what is computed of it.
    fn lines(&self) -> Vec<String>;

    /// Computes it. What reports progress more than once does so itself.
    fn compute(&self, shared: &Shared, tick: &(dyn Fn() + Sync)) -> Done;
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

    /// What is computed, with the place of its kind.
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

    /// What is computed.
    pub(super) fn of(&self) -> &(dyn Computable + 's) {
        self.computed().1
    }

    /// Words for its kind.
    pub(super) fn kind(&self) -> (&'static str, &'static str) {
        Self::KINDS[self.computed().0]
    }
}

impl Computable for Claim {
    fn key(&self) -> String {
        self.id.to_owned()
    }

    fn size(&self) -> usize {
        LONG
    }

    fn lines(&self) -> Vec<String> {
        vec![format!("{}, {}", self.id, self.place)]
    }

    fn compute(&self, _: &Shared, tick: &(dyn Fn() + Sync)) -> Done {
        let done = self.decide();
        tick();
        Box::new(done)
    }
}
