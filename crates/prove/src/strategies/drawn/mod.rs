//! Strategies of `proptest`: what a property test draws its arches from.

mod arches;
mod numbers;
mod queries;

pub use arches::{arch, collapsing, standing};
pub use numbers::{friction, half_opening, weight};
pub use queries::{DrawnQuery, query};
