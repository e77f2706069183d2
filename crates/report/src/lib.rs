//! Answers in every format: tables, JSON, CSV, LaTeX, other languages, pictures. Nothing is computed here.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

#[cfg(test)]
#[path = "../../draw/src/picture/reading.rs"]
mod reading;
pub mod report;

use couplet_ask::ask;
use couplet_atlas::atlas;
use couplet_check::{arch, problem};
use couplet_claims::claims;
#[cfg(feature = "study")]
use couplet_claims::study;
use couplet_draw::{picture, sketch};
use couplet_number::number;
use couplet_prove::{certify, judge, strategies};
