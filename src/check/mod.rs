//! Checks: the operator behind every proof, and what a stranger needs to verify a result.
//!
//! This room sees the number traits and the equations, never a solver, and builds without a C
//! compiler (`--no-default-features --features check`).

mod decimal;
mod dyadic;
mod engine;
pub mod krawczyk;

pub use decimal::Written;
pub use dyadic::{Dyadic, MAX_EXPONENT, ParseDyadicError};
pub use engine::Engine;
