//! Strategies of `proptest`: what a property test draws its arches from.

mod arches;
mod assemblies;
mod numbers;
mod queries;

pub use arches::{DrawnThickness, arch, assessed, collapsing, query, standing};
pub use assemblies::assembly;
pub use numbers::{friction, half_opening, weight};
pub use queries::DrawnQuery;
