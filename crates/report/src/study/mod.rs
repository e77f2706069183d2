//! Results of `couplet study`: tables for a person, files with the raw numbers and figures.

mod files;
mod tables;

pub use files::StudyFiles;
pub use tables::{accuracy_table, stability_table};
