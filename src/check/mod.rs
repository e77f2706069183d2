//! Checks: the operator behind every proof, and what a stranger needs to verify a result.
//!
//! This room sees the number traits and the equations, never a solver, and builds without a C
//! compiler (`--no-default-features --features check`; with `check,cli` the command is there too).

mod checker;
mod claim;
mod conditions;
mod decimal;
mod dyadic;
mod engine;
mod format;
pub mod krawczyk;
mod object;
mod quantity;
mod refusal;

pub use checker::{Accepted, MAX_DIGITS, WITNESS_BITS, check, check_certificate};
pub use claim::{Claim, Exact, State, Subject, first_failure};
pub use conditions::{conditions, inner_friction, room_for_steepest, shoulder_friction};
pub use decimal::Written;
pub use dyadic::{Dyadic, MAX_EXPONENT, ParseDyadicError};
pub use engine::Engine;
pub use format::{Certificate, ClaimFile, SCHEMA, StateFile, ValueFile, Witness};
pub use quantity::Known;
pub use refusal::Refusal;
