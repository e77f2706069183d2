//! Sweeps: many arches proved into a partitioned Parquet data set.
//!
//! | file | what it does |
//! |---|---|
//! | `record` | what a sweep is, in one form; its name |
//! | `cost` | how many rows make a part |
//! | `queries`, `query` | the rows of a part as they are asked |
//! | `slices`, `text`, `groups`, `pieces` | the pieces of the files of a data set |
//! | `column`, `kind` | a column of a Parquet file, as it is read; what its values mean |
//! | `table` | a part as a Parquet file |
//! | `store` | the folder of the parts |
//! | `sweep` | a sweep and its parts: the door |
//! | `verify` | looks through what was made |

mod column;
mod cost;
mod groups;
mod kind;
mod pieces;
mod queries;
mod query;
mod record;
mod slices;
mod store;
#[allow(clippy::module_inception, reason = "the folder is named after what it does")]
mod sweep;
mod table;
mod text;
mod verify;

use couplet_prove::strategies;
pub use sweep::{SurveyedPart, Sweep};
pub use verify::{Verified, verify};
