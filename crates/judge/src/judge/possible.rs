//! A number that an arch may have or not.

/// A number of an arch, as it is claimed, known or certified.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Possible<T> {
    /// The value.
    Finite(T),
    /// Unbounded.
    Infinite,
    /// The arch has no such number.
    Missing,
}

impl<T> Possible<T> {
    /// The value, where it is finite.
    pub fn finite(&self) -> Option<&T> {
        match self {
            Self::Finite(value) => Some(value),
            Self::Infinite | Self::Missing => None,
        }
    }
}
