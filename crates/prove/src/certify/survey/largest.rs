//! Order of a heap: the largest first.

use std::cmp::Ordering;

/// Something that is ordered by its size alone, for a heap.
pub(super) struct Largest<T> {
    pub size: f64,
    pub of: T,
}

impl<T> PartialEq for Largest<T> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<T> Eq for Largest<T> {}

impl<T> PartialOrd for Largest<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<T> Ord for Largest<T> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.size.total_cmp(&other.size)
    }
}
