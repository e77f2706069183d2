//! `couplet sweep`.
//!
//! | file | what it does |
//! |---|---|
//! | `arguments`, `command` | what is asked, and what is said |
//! | `record` | what a sweep is, in one form; its name |
//! | `cost` | how many rows make a part |
//! | `queries`, `query` | the rows of a part as they are asked |
//! | `slices`, `text`, `groups`, `pieces` | the pieces of the files of a data set |
//! | `answers` | what is proved of them |
//! | `column`, `kind` | a column of a Parquet file, as it is read; what its values mean |
//! | `table` | a part as a Parquet file |
//! | `store` | the folder of the parts |
//! | `sweep` | a sweep and its parts: the door |
//! | `verify` | looks through what was made |

#[cfg(feature = "parquet")]
mod answers;
mod arguments;
#[cfg(feature = "parquet")]
mod column;
#[cfg(feature = "parquet")]
mod command;
#[cfg(feature = "parquet")]
mod cost;
#[cfg(feature = "parquet")]
mod groups;
#[cfg(feature = "parquet")]
mod kind;
#[cfg(feature = "parquet")]
mod pieces;
#[cfg(feature = "parquet")]
mod queries;
#[cfg(feature = "parquet")]
mod query;
#[cfg(feature = "parquet")]
mod record;
#[cfg(feature = "parquet")]
mod slices;
#[cfg(feature = "parquet")]
mod store;
#[cfg(feature = "parquet")]
#[allow(clippy::module_inception, reason = "the folder is named after what it does")]
mod sweep;
#[cfg(feature = "parquet")]
mod table;
#[cfg(feature = "parquet")]
mod text;
#[cfg(feature = "parquet")]
mod verify;

use crate::cli::failure::Failure;
pub(crate) use arguments::Arguments;
#[cfg(feature = "parquet")]
pub use sweep::{Part, Sweep, SweepError};
#[cfg(feature = "parquet")]
pub use verify::{Verified, verify};

#[cfg(feature = "parquet")]
pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    command::run(arguments)
}

#[cfg(not(feature = "parquet"))]
pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { plan, output, only, verify, schema } = arguments;
    let _ = (plan, output, only.map(|share| (share.k, share.n)), verify, schema);
    Err(Failure::Input(
        "a sweep writes Parquet, and this couplet was built without the feature parquet (cargo install --path . \
         --features parquet); `couplet states` answers a table"
            .into(),
    ))
}
