//! Sweeps: many arches proved into a partitioned Parquet data set.
//!
//! | file | what it does |
//! |---|---|
//! | `cost` | how many rows make a part |
//! | `queries`, `listed` | the rows of a part as they are asked |
//! | `text` | the pieces of the files of a data set |
//! | `table` | rows of a part by columns |
//! | `part_file` | a part as a Parquet file: on itself, as it is looked through |
//! | `store`, `part_name` | the folder of the parts, and their names |
//! | `new_file` | a file of a sweep until it appears |
//! | `sweep` | a sweep and its parts: the door |
//! | `verify` | looks through what was made |

mod cost;
mod listed;
mod new_file;
mod part_file;
mod part_name;
mod queries;
mod store;
#[allow(clippy::module_inception, reason = "the folder is named after what it does")]
mod sweep;
mod table;
mod text;
mod verify;

use couplet_judge::strategies;
pub use sweep::{SurveyedPart, Sweep};
pub use verify::{Verified, verify};
