//! Candidates: where roots, states and lines of thrust seem to be. No proof is known here, and none can be.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod solve;

use couplet_check::{arch, problem};
// The room `number`, and `symbolic` where there is MPFR.
use couplet_number::*;
