//! Proves: existence and uniqueness in a box, digits, exact values, inequalities.
//!
//! The operator that proves is in [`check::krawczyk`](crate::check::krawczyk).
//! A proof either succeeds or says why nothing is known ([`Undecided`]); nothing in between.

mod audit;
mod certificate;
mod constant;
mod cover;
mod exact;
mod fingerprint;
mod isolate;
pub mod judge;
mod printed;
mod refine;
pub mod state;
mod verdict;

pub use audit::{
    Audited, Comparison, Enclosed, Relation, audit, audit_of, compare_weights, compare_weights_of,
    enclosed,
};
pub use certificate::{certify_landmark, certify_state};
pub use constant::{CertifiedLandmark, Constant, MAX_DIGITS, Value, quantities};
pub use cover::{between, cover};
pub use exact::Exact;
pub use fingerprint::{MAX_FINGERPRINT_DIGITS, fingerprint};
pub use isolate::{Isolated, isolate};
pub use printed::PrintedVerdict;
pub use refine::{Refined, refine, refine_watched, stages};
pub use verdict::Undecided;
