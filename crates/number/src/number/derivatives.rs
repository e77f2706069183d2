//! Values with derivatives.

/// A value with its partial derivatives.
pub trait Derivatives<T> {
    /// The derivative to unknown `index`, or `None` where it is exactly zero.
    fn slope(&self, index: usize) -> Option<&T>;
}
