//! Checks: the operator behind every proof, and what a stranger needs to verify a result.
//!
//! This room sees the number traits and the equations, never a solver, and builds without a C
//! compiler (`--no-default-features --features check`).

pub mod krawczyk;
