//! Proves: existence and uniqueness in a box, digits, exact values, inequalities.
//!
//! The operator that proves is in [`check::krawczyk`](crate::check::krawczyk).
//! A proof either succeeds or says why nothing is known ([`Undecided`]); nothing in between. A question that makes no
//! sense is [`Refused`] before; [`Error`] is either.

mod arithmetic;
mod asymmetric;
mod asymmetric_certificate;
mod asymmetric_thickness;
mod certificate;
mod closed_value;
mod constant;
mod cover;
mod decide;
mod enclosed;
mod error;
mod fingerprint;
mod in_doubles;
mod isolate;
mod jointed;
mod landmark;
mod linear;
mod posed;
mod positive;
mod processor_time;
mod programme;
mod refine;
mod refused;
pub mod root;
mod short;
pub mod state;
mod tilt;
mod tilt_of_stones;
mod undecided;
mod vector;
mod verdict;
mod voussoirs;

pub use asymmetric::{AsymmetricDigits, AsymmetricJoint, CertifiedAsymmetric, asymmetric};
pub use asymmetric_certificate::{asymmetric_kinds, certify_asymmetric};
pub use asymmetric_thickness::asymmetric_thicknesses;
pub use certificate::certify_landmark;
pub use closed_value::Exact;
pub use constant::{Constant, Value, quantities};
pub use cover::{between, cover};
pub use enclosed::Enclosed;
pub use error::Error;
pub use fingerprint::{MAX_FINGERPRINT_DIGITS, fingerprint};
pub use isolate::isolate_near;
pub use isolate::{Isolated, isolate};
pub use jointed::{
    Enumeration, JointedMotion, JointedSolution, LeastSolution, MOST_ENUMERATED_STONES, Standing,
    enumerate, least_solution,
};
pub use landmark::CertifiedLandmark;
pub(crate) use linear::Eliminated;
pub use processor_time::processor_time;
pub use programme::{MOST_JOINTED_STONES, Programme, programme};
pub use refine::{Refined, refine, refine_watched, stages};
pub use refused::{MAX_ARCH_DIGITS, MAX_DIGITS, Refused};
pub use tilt::{LargestTilt, TiltDigits, TiltLimit, tilted};
pub use tilt_of_stones::{MOST_TILTED_STONES, tilted_stones};
pub use undecided::{Open, Undecided};
pub use verdict::certify_arch;
pub use voussoirs::{
    VoussoirAssessment, VoussoirDigits, VoussoirLimit, VoussoirLoss, VoussoirStanding, Voussoirs,
    assess_voussoirs, voussoir_loss, voussoirs,
};
