//! States of arches in double-doubles, proved many at a time.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod lanes;

use couplet_check::{arch, problem};
use couplet_number::number;
use couplet_solve::solve;
