//! `couplet check`: also the whole of the small program.

use super::failure::Failure;
use crate::check::{Accepted, Refusal, check};
use crate::number::AstroInterval;
use crate::problem::Subject;
use clap::Args;
use std::fs::File;
use std::io::{self, Read};

/// Check certificates: that the equations have the root claimed, and that every digit is right.
///
/// Nothing that a certificate says is believed: residuals, slopes and roundings are computed from the
/// claim. Each file gets one line, `accepted` or `refused` with the reason; `-` is standard input. The
/// exit code is 1 if one was refused.
#[derive(Args)]
pub struct Arguments {
    /// Certificates to check.
    #[arg(value_name = "FILE", required = true)]
    files: Vec<String>,

    /// Arithmetic: astro (pure Rust, up to 50000 digits) or mpfr (where it is built in).
    #[arg(long, default_value = "astro", value_parser = engine)]
    engine: EngineChoice,
}

#[derive(Clone, Copy)]
enum EngineChoice {
    Astro,
    #[cfg(feature = "mpfr")]
    Mpfr,
}

fn engine(text: &str) -> Result<EngineChoice, String> {
    match text {
        "astro" => Ok(EngineChoice::Astro),
        #[cfg(feature = "mpfr")]
        "mpfr" => Ok(EngineChoice::Mpfr),
        #[cfg(not(feature = "mpfr"))]
        "mpfr" => Err("mpfr is not built in; the arithmetic is astro".into()),
        _ => Err("an arithmetic is one of astro, mpfr".into()),
    }
}

/// The commands of the small program.
#[cfg(not(feature = "mpfr"))]
#[derive(clap::Subcommand)]
pub enum Command {
    Check(Arguments),
}

#[cfg(not(feature = "mpfr"))]
impl Command {
    /// What to say to someone who names another.
    pub const NAMES: &str = "; this build has the command check only";

    /// Does what is asked.
    pub fn run(&self) -> Result<(), Failure> {
        let Self::Check(arguments) = self;
        run(arguments)
    }
}

/// Pure Rust sines and cosines: 40,000 digits of T take 40 s, 100,000 more than five minutes.
const ASTRO_DIGITS: usize = 50_000;
/// A certificate of a million digits has about 25 MB.
const MAX_BYTES: u64 = 64 << 20;

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut refused = 0;
    for name in &arguments.files {
        let bytes = read(name).map_err(|error| Failure::reading(name, &error))?;
        let verdict = if bytes.len() as u64 > MAX_BYTES {
            Err(format!("the file has more than {MAX_BYTES} bytes"))
        } else {
            checked(&bytes, arguments.engine).map_err(|refusal| refusal.to_string())
        };
        let line = match verdict {
            Ok(accepted) => format!("{name}: accepted  {}", summary(&accepted)),
            Err(reason) => {
                refused += 1;
                format!("{name}: refused: {reason}")
            }
        };
        print(&line)?;
    }
    match refused {
        0 => Ok(()),
        n => Err(Failure::Undecided(format!("{n} of {} refused", arguments.files.len()))),
    }
}

fn checked(bytes: &[u8], engine: EngineChoice) -> Result<Accepted, Refusal> {
    match engine {
        EngineChoice::Astro => check::<AstroInterval>(bytes, ASTRO_DIGITS),
        #[cfg(feature = "mpfr")]
        EngineChoice::Mpfr => check::<crate::number::Ball>(bytes, crate::check::MAX_DIGITS),
    }
}

/// The bytes of a file, a little more than the most that is allowed at the most.
fn read(name: &str) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    match name {
        "-" => io::stdin().lock().take(MAX_BYTES + 1).read_to_end(&mut bytes)?,
        name => File::open(name)?.take(MAX_BYTES + 1).read_to_end(&mut bytes)?,
    };
    Ok(bytes)
}

/// What was accepted, in a few words.
fn summary(accepted: &Accepted) -> String {
    let claim = &accepted.claim;
    let subject = match &claim.subject {
        Subject::Landmark(landmark) => landmark.symbol().to_owned(),
        Subject::State(state) => {
            let friction = state.friction.as_ref().map_or("inf".to_owned(), |mu| mu.text());
            let mode = state.mode.label();
            format!("{mode} half_opening {} friction {friction}", state.half_opening.text())
        }
    };
    let first = accepted.values.first().map_or(String::new(), |(quantity, value)| {
        let shown: String = value.chars().take(22).collect();
        let more = if shown.len() < value.len() { "…" } else { "" };
        format!("{} {shown}{more} ", quantity.name())
    });
    let plural = if accepted.digits == 1 { "" } else { "s" };
    format!("{subject} {}  {first}to {} digit{plural}", claim.weight.name(), accepted.digits)
}

/// Prints a line; a reader that has closed the pipe has what it wanted.
fn print(line: &str) -> Result<(), Failure> {
    use io::Write;
    match writeln!(io::stdout(), "{line}") {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::writing("to standard output", &error))
        }
        _ => Ok(()),
    }
}
