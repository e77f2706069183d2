//! The claims of the paper, proved or refuted, for a reader and for Coq; and how others would compute.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod claims;
#[cfg(feature = "study")]
pub mod study;

use couplet_atlas as atlas;
use couplet_check::{arch, check, problem};
use couplet_number::{number, symbolic};
use couplet_prove::{certify, judge, prover};
use couplet_solve as solve;
