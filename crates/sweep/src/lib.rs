//! Many arches: tables of rows, scenes and sweeps; what the command, Python and C call.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod answer;
pub mod failure;
pub mod parse;
pub mod rows;
pub mod scene;
pub mod surveyed;
#[cfg(feature = "parquet")]
pub mod sweep;
pub mod unfinished;

use couplet_ask as ask;
use couplet_atlas as atlas;
use couplet_check::{arch, check, problem};
use couplet_claims as claims;
use couplet_draw::picture;
use couplet_judge::judge;
use couplet_number::number;
use couplet_prove::certify;
/// Answers, maps and pictures as they are written.
mod report {
    pub(crate) use couplet_charts::*;
    pub(crate) use couplet_pictures::*;
    pub(crate) use couplet_report::*;
}
use couplet_solve as solve;
