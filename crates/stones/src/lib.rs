//! Arches of stones, proved: with joints only where stones meet, and tilted.
//!
//! | file | what it does |
//! |---|---|
//! | `voussoirs` | the least thickness, and an arch of a given one |
//! | `jointed` | solutions in which the joints do not dilate, one by one along the thickness |
//! | `programme` | the static programme: extreme thrusts, and the multipliers that prove them |
//! | `tilt`, `tilt_mechanism` | the largest tilt of an arch without joints, and how it falls then |
//! | `tilt_of_stones` | the same of stones |
//! | `zero`, `positive` | a zero of a polynomial, and its digits; a function positive on an interval |
//! | `vector` | forces and the lines of conditions on them |
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

mod jointed;
mod positive;
mod programme;
mod tilt;
mod tilt_mechanism;
mod tilt_of_stones;
mod vector;
mod voussoirs;
mod zero;

pub use jointed::{
    Enumeration, JointedMotion, JointedSolution, LeastSolution, MOST_ENUMERATED_STONES, Standing,
    enumerate, least_solution,
};
pub use programme::{MOST_JOINTED_STONES, Programme, programme};
pub use tilt::{LargestTilt, TiltDigits, tilted};
pub use tilt_mechanism::{TiltMechanism, TiltedJoint, measured_tilt};
pub use tilt_of_stones::{MOST_TILTED_STONES, tilted_stones};
pub use voussoirs::{
    VoussoirAssessment, VoussoirDigits, VoussoirLimit, VoussoirLoss, VoussoirStanding, Voussoirs,
    assess_voussoirs, measured_voussoirs, voussoir_loss, voussoirs,
};

use couplet_check::{arch, problem};
use couplet_number::number;
use couplet_prove::prover;
use couplet_solve as solve;
