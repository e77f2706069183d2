//! Numbers that enclose, and polynomials that are exact: what couplet calculates with.
//!
//! No arch is known here: the traits are what its equations are written against.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

#[macro_use]
pub mod number;
#[cfg(feature = "mpfr")]
pub mod symbolic;
