//! Judgements of what others computed, and arches to try them on.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod judge;
pub mod strategies;

use couplet_check::{arch, problem};
use couplet_number::number;
use couplet_prove::{certify, prover};
use couplet_solve as solve;
