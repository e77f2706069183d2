//! The curves of the map: beside the states of arches on both sides of each, in every format, and refused.

mod command;
mod difference;
mod page;
#[cfg(feature = "parquet")]
mod parquet;
mod pictures;
mod states;
