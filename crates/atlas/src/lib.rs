//! The map as data: its curves from end to end, proved for every value of a parameter; and what is drawn of an arch.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod atlas;

use couplet_check::{arch, check, problem};
use couplet_draw::sketch;
use couplet_number::number;
use couplet_prove::{certify, prover};
use couplet_solve::solve;
