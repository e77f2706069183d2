//! Values for other programs: one list of proved values, and one file for each language that is written
//! from it.
//!
//! **No format computes anything.** Doubles are correctly rounded and their bounds rounded outward before
//! they come here ([`Binary`](crate::number::Binary)); a format only knows how its language writes them so
//! that they are read back bit for bit. Every file says what made it, to how many digits, and which hash
//! the certificate of each landmark has. What is not proved is named in a comment and gets no value.
//!
//! In every language a value has one name, made of the subject, the weight and the quantity
//! (`T_HEYMAN_THICKNESS`); the same name with `LOWER`, `UPPER`, `ERROR` added is what its double leaves
//! open. `names.rs` has the rules.

mod c;
mod document;
mod fortran;
mod julia;
mod label;
mod latex;
mod listing;
mod matlab;
mod names;
#[cfg(feature = "parquet")]
mod parquet;
mod python;
mod rust;
mod subject;

#[cfg(feature = "parquet")]
pub use parquet::ParquetRows;
pub use subject::{Certificate, Exported, Of, Proof, Status, Subject};

use std::io;

/// A language or a file format of another program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExportFormat {
    /// For a program that reads JSON.
    Json,
    /// The same content as TOML.
    Toml,
    /// A table with `siunitx`, with what the paper prints beside each value.
    Latex,
    /// A header for C99 and C++.
    C,
    /// A module.
    Rust,
    /// A module.
    Python,
    /// A module.
    Julia,
    /// A function for MATLAB and Octave.
    Matlab,
    /// A module.
    Fortran,
    /// A table for data frames.
    #[cfg(feature = "parquet")]
    Parquet,
}

/// What is handed on.
#[derive(Debug)]
pub struct Export {
    /// What it is, in a few words.
    pub title: &'static str,
    /// The schema of the document, for JSON and TOML.
    pub schema: &'static str,
    /// Significant digits of each value.
    pub digits: usize,
    /// Landmarks, or arches.
    pub subjects: Vec<Subject>,
}

/// The program and its version.
const TOOL: &str = concat!("couplet ", env!("CARGO_PKG_VERSION"));

/// Writes everything in a format. The binary one (Parquet) is for a file, the others are UTF-8 text.
pub fn write(format: ExportFormat, export: &Export, out: &mut dyn io::Write) -> io::Result<()> {
    match format {
        ExportFormat::Json => document::json(export, out),
        ExportFormat::Toml => document::toml(export, out),
        ExportFormat::Latex => latex::write(export, out),
        ExportFormat::C => c::write(export, out),
        ExportFormat::Rust => rust::write(export, out),
        ExportFormat::Python => python::write(export, out),
        ExportFormat::Julia => julia::write(export, out),
        ExportFormat::Matlab => matlab::write(export, out),
        ExportFormat::Fortran => fortran::write(export, out),
        #[cfg(feature = "parquet")]
        ExportFormat::Parquet => parquet::write(export, out),
    }
}
