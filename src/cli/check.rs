//! `couplet check`: what the small program `couplet-check` does, with the arithmetic of MPFR beside.

use crate::check::{AcceptedFile, Engine, check_files};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use clap::Args;
use std::ffi::OsString;

/// Check certificates: the root that is claimed, and every digit.
///
/// The checker trusts nothing that a certificate says: it computes residuals, slopes and roundings from the
/// claim. Each file gets one line: `accepted`, `refused` with the reason, `not checked` if it has more digits than
/// the arithmetic is meant for, `not read` if it cannot be. `-` is standard input. The exit code is 1 if a file was
/// refused, else 3 if one was not checked or not read.
#[derive(Args)]
pub(super) struct Arguments {
    /// Certificates to check.
    #[arg(value_name = "FILE", required = true)]
    files: Vec<OsString>,

    /// Arithmetic: astro (pure Rust, shares nothing with MPFR, up to 50000 digits), or mpfr.
    #[arg(long, default_value = "astro", value_parser = parse::engine)]
    engine: Engine,

    /// The whole statement of each accepted file in one sentence, with every digit.
    #[arg(long)]
    statement: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let words = if arguments.statement { AcceptedFile::statement } else { AcceptedFile::summary };
    Ok(check_files(&arguments.files, arguments.engine, words, "--engine mpfr")?)
}
