//! Proofs: landmarks, and the state of any arch.
//!
//! `couplet-solve` finds, [`certify`] proves; an answer is proved, or says why not.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod certify;
#[doc(hidden)]
pub mod prover;

use couplet_check::{arch, check, problem};
use couplet_lanes as lanes;
use couplet_number::{number, symbolic};
use couplet_solve as solve;

/// Names that most programs need: `use couplet_prove::prelude::*`.
///
/// ```
/// use couplet_prove::prelude::*;
/// let arch = Arch::parse("heyman", "90deg", "0.38")?;
/// let state = arch.least(12)?;
/// assert_eq!(format!("{} {}", state.mode, state.thickness), "[s,r,r] 0.122191586363");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub mod prelude {
    pub use crate::arch::SelfWeight;
    pub use crate::certify::state::{Answer, Certify};
    pub use crate::certify::{CertifiedLandmark, Error, Refused, Undecided};
    pub use crate::number::ExactNumber;
    pub use crate::problem::{Arch, Friction, Landmark, Mode, Quantity};
}
