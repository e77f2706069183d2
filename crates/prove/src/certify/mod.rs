//! Proves: existence and uniqueness in a box, digits, exact values, inequalities.
//!
//! The operator that proves is in [`check::krawczyk`](crate::check::krawczyk).
//! A proof either succeeds or says why nothing is known ([`Undecided`]); nothing in between. A question that makes no
//! sense is [`Refused`] before; [`Error`] is either.

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
mod jointed;
mod landmark;
mod processor_time;
mod programme;
mod serial;
pub mod state;
pub mod survey;
mod survey_certificate;
mod tilt;
mod tilt_mechanism;
mod tilt_of_stones;
mod verdict;
mod voussoirs;

pub use asymmetric::{AsymmetricDigits, AsymmetricJoint, CertifiedAsymmetric, asymmetric};
pub use asymmetric_certificate::{asymmetric_kinds, certify_asymmetric};
pub use asymmetric_thickness::asymmetric_thicknesses;
pub use certificate::certify_landmark;
pub use closed_value::Exact;
pub use constant::{Constant, Value, quantities};
pub use enclosed::Enclosed;
pub use fingerprint::{MAX_FINGERPRINT_DIGITS, fingerprint};
pub use jointed::{
    Enumeration, JointedMotion, JointedSolution, LeastSolution, MOST_ENUMERATED_STONES, Standing,
    enumerate, least_solution,
};
pub use landmark::CertifiedLandmark;
pub use processor_time::processor_time;
pub use programme::{MOST_JOINTED_STONES, Programme, programme};
pub use survey_certificate::certify_survey;
pub use tilt::{LargestTilt, TiltDigits, tilted};
pub use tilt_mechanism::{TiltMechanism, TiltedJoint};
pub use tilt_of_stones::{MOST_TILTED_STONES, tilted_stones};
pub use verdict::certify_arch;
pub use voussoirs::{
    VoussoirAssessment, VoussoirDigits, VoussoirLimit, VoussoirLoss, VoussoirStanding, Voussoirs,
    assess_voussoirs, voussoir_loss, voussoirs,
};

pub use crate::prover::cover::{between, cover};
pub use crate::prover::isolate::isolate;
pub use crate::prover::isolate::isolate_near;
#[doc(hidden)]
pub use crate::prover::linear::Eliminated;
pub use crate::prover::refine::{Refined, refine, refine_watched, stages};
pub use crate::prover::refused::{MAX_DIGITS, MAX_TILT_DIGITS};
pub use crate::prover::{Answered, Error, Isolated, Open, Refused, Undecided};
