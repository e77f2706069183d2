//! `couplet check`: also the whole of the small program.

use crate::check::{Accepted, MAX_DIGITS, Refusal, summary, visible_name};
use crate::sweep::engine::Engine;
use crate::sweep::failure::{Failure, print, reason};
use clap::Args;
use std::ffi::{OsStr, OsString};
use std::fs::File;
use std::io::{self, Read};

/// Check certificates: that the equations have the root claimed, and that every digit is right.
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

    /// Arithmetic: astro (pure Rust, shares nothing with MPFR, up to 50000 digits); where they are built in, mpfr, and
    /// malachite (pure Rust, quicker than astro, up to 50000 digits; in part MPFR's algorithms, so no witness beside mpfr).
    #[arg(long, default_value = "astro", value_parser = Engine::named)]
    engine: Engine,
}

/// A certificate of a million digits has about 25 MB.
const MAX_BYTES: u64 = 64 << 20;

/// What became of a file.
enum Verdict {
    Accepted(Box<Accepted>),
    Refused(String),
    NotChecked(String),
    NotRead(io::Error),
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let (mut refused, mut open) = (0, 0);
    for name in &arguments.files {
        let said = match verdict(name, arguments.engine) {
            Verdict::Accepted(accepted) => {
                format!("accepted  {}{}", summary(&accepted), arguments.engine.remark())
            }
            Verdict::Refused(reason) => {
                refused += 1;
                format!("refused: {reason}")
            }
            Verdict::NotChecked(reason) => {
                open += 1;
                format!("not checked: {reason}")
            }
            Verdict::NotRead(error) => {
                open += 1;
                format!("not read: {}", reason(&error))
            }
        };
        print(format!("{}: {said}\n", visible_name(name)).as_bytes())?;
    }
    let all = arguments.files.len();
    match (refused, open) {
        (0, 0) => Ok(()),
        (0, open) => Err(Failure::Io(format!("{open} of {all} not checked"))),
        (refused, 0) => Err(Failure::Undecided(format!("{refused} of {all} refused"))),
        (refused, open) => {
            Err(Failure::Undecided(format!("{refused} of {all} refused, {open} not checked")))
        }
    }
}

fn verdict(name: &OsStr, engine: Engine) -> Verdict {
    let bytes = match read(name) {
        Ok(bytes) => bytes,
        Err(error) => return Verdict::NotRead(error),
    };
    if bytes.len() as u64 > MAX_BYTES {
        return Verdict::Refused(format!("the file has more than {MAX_BYTES} bytes"));
    }
    match engine.check(&bytes) {
        Ok(accepted) => Verdict::Accepted(Box::new(accepted)),
        Err(limit @ Refusal::Limit(..)) => {
            let other = match cfg!(feature = "mpfr") {
                true => "--engine mpfr",
                false => "--engine mpfr, in a build that has it,",
            };
            Verdict::NotChecked(format!("{limit}; {other} checks up to {MAX_DIGITS}"))
        }
        Err(refusal) => Verdict::Refused(refusal.to_string()),
    }
}

/// The bytes of a file, a little more than the most that is allowed at the most.
pub(super) fn read(name: &OsStr) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    if name == "-" {
        io::stdin().lock().take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    } else {
        let file = File::open(name)?;
        // A file of this size is read into memory of this size.
        let size = file.metadata().map_or(0, |file| file.len()).min(MAX_BYTES);
        bytes.reserve_exact(usize::try_from(size).unwrap_or(0) + 1);
        file.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    }
    Ok(bytes)
}
