//! Proves: existence and uniqueness in a box, digits, exact values, inequalities.
//!
//! The operator that proves is in [`check::krawczyk`](crate::check::krawczyk).
//! A proof either succeeds or says why nothing is known ([`Undecided`]); nothing in between. A question that makes no
//! sense is [`Refused`] before; [`Error`] is either.
//!
//! | file | what it does |
//! |---|---|
//! | `landmark`, `enclosed` | a landmark with all its digits, and in enclosures of some bits |
//! | `constant`, `closed_value` | one of its quantities; values that are exact |
//! | `state` | the state of any arch, and an arch of a given thickness |
//! | `batch` | many arches at once |
//! | `equation` | equations of the paper at given values |
//! | `asymmetric`, `asymmetric_thickness` | asymmetric solutions, and their thicknesses beside a verdict |
//! | `certificate`, `verdict`, `asymmetric_certificate` | certificates of landmarks, of arches, of asymmetric solutions |
//! | `fingerprint` | the hash of a certificate |
//! | `serial` | proved values for serde |
//! | `processor_time` | the clock of work |

mod asymmetric;
mod asymmetric_certificate;
mod asymmetric_thickness;
pub mod batch;
mod certificate;
mod closed_value;
mod constant;
mod enclosed;
pub mod equation;
mod fingerprint;
mod landmark;
mod processor_time;
mod serial;
pub mod state;
mod verdict;

pub use asymmetric::{
    AsymmetricDigits, AsymmetricJoint, AsymmetricSolutions, CertifiedAsymmetric, asymmetric,
    asymmetric_half_openings, most_asymmetric,
};
pub use asymmetric_certificate::{asymmetric_kinds, certify_asymmetric};
pub use asymmetric_thickness::asymmetric_thicknesses;
pub use certificate::certify_landmark;
pub use closed_value::Exact;
pub use constant::{Constant, Value, quantities};
pub use enclosed::Enclosed;
pub use fingerprint::{MAX_FINGERPRINT_DIGITS, fingerprint};
pub use landmark::CertifiedLandmark;
pub use processor_time::processor_time;
pub use verdict::certify_arch;

pub use crate::prover::cover::{between, cover};
pub use crate::prover::isolate::isolate;
#[doc(hidden)]
pub use crate::prover::linear::Eliminated;
pub use crate::prover::refine::{Refined, refine, refine_watched, stages};
pub use crate::prover::refused::MAX_DIGITS;
pub use crate::prover::{Answered, Error, Isolated, Open, Refused, Undecided};
