//! Questions about arches, read once for every door of couplet.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

pub mod ask;

use couplet_check::{arch, problem};
use couplet_number::number;
