//! How much of an arch of equal stones is looked at.

/// Which states are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// The whole arch, with a vertical force in the crown.
    Whole,
    /// A half of it, whose crown bears none and moves up and down: symmetric states.
    Half,
}

impl Extent {
    /// The joints between so many equal stones, in halves of a stone from the crown.
    pub(super) fn joints(self, stones: i32) -> impl Iterator<Item = i32> {
        let first = match self {
            Self::Whole => -stones,
            Self::Half => stones % 2,
        };
        (first..=stones).step_by(2)
    }
}
