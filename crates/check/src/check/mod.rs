//! Checks: the operator behind every proof, and what a stranger needs to verify a result.
//!
//! This room sees the number traits and the equations, never a solver, and builds without a C compiler. The program
//! `couplet-check` is its command.

mod checker;
mod claim;
mod decimals;
mod engine;
mod files;
mod format;
mod given;
pub mod krawczyk;
mod record;
mod refusal;
mod summary;
mod visible;
pub mod whole;

pub use crate::number::visible;
pub use checker::{
    ASTRO_DIGITS, Accepted, EXTRA_BITS, MALACHITE_DIGITS, MAX_DIGITS, WITNESS_BITS, check,
    check_certificate, verify,
};
pub use claim::{ArchFile, AsymmetricFile, ClaimFile, StandsFile, StateFile, TooThinFile};
pub use engine::Engine;
pub use files::{CheckFailure, NO_MPFR, check_files, print, read, reason};
pub use format::{Certificate, SCHEMA, ValueFile, Witness};
pub use refusal::Refusal;
pub use summary::summary;
pub use visible::visible_name;
