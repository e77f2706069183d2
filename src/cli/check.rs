//! `couplet check`: also the whole of the small program.

use super::failure::{Failure, print};
use crate::check::{Accepted, Refusal, given_text, verify};
use crate::problem::{Friction, Problem};
use clap::Args;
use std::fs::File;
use std::io::{self, Read};

/// Check certificates: that the equations have the root claimed, and that every digit is right.
///
/// The checker trusts nothing that a certificate says: it computes residuals, slopes and roundings from the
/// claim. Each file gets one line, `accepted` or `refused` with the reason; `-` is standard input. The
/// exit code is 1 if a file was refused.
#[derive(Args)]
pub(super) struct Arguments {
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
pub(super) enum Command {
    Check(Arguments),
    Completions(super::completions::Arguments),
    Man(super::man::Arguments),
}

#[cfg(not(feature = "mpfr"))]
impl Command {
    /// Runs the command; `program` describes the whole command line.
    pub(super) fn run(&self, program: fn() -> clap::Command) -> Result<(), Failure> {
        match self {
            Self::Check(arguments) => run(arguments),
            Self::Completions(arguments) => super::completions::run(arguments, program()),
            Self::Man(arguments) => super::man::run(arguments, program()),
        }
    }
}

/// A certificate of a million digits has about 25 MB.
const MAX_BYTES: u64 = 64 << 20;

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
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
        print(format!("{line}\n").as_bytes())?;
    }
    match refused {
        0 => Ok(()),
        n => Err(Failure::Undecided(format!("{n} of {} refused", arguments.files.len()))),
    }
}

fn checked(bytes: &[u8], engine: EngineChoice) -> Result<Accepted, Refusal> {
    match engine {
        EngineChoice::Astro => verify(bytes),
        #[cfg(feature = "mpfr")]
        EngineChoice::Mpfr => {
            crate::check::check::<crate::number::Ball>(bytes, crate::check::MAX_DIGITS)
        }
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
    let subject = match &accepted.problem {
        Problem::Landmark { landmark, .. } => landmark.symbol().to_owned(),
        Problem::State { mode, arch } => {
            let (half_opening, friction) = (given_text(arch.half_opening()), arch.friction());
            let friction = match friction {
                Friction::Coefficient(mu) => given_text(mu),
                friction => friction.to_string(),
            };
            format!("{mode} half_opening {half_opening} friction {friction}")
        }
    };
    let first = accepted.values.first().map_or(String::new(), |(quantity, value)| {
        let shown: String = value.chars().take(22).collect();
        let more = if shown.len() < value.len() { "…" } else { "" };
        format!("{} {shown}{more} ", quantity.name())
    });
    let plural = if accepted.digits == 1 { "" } else { "s" };
    format!(
        "{subject} {}  {first}to {} digit{plural}",
        accepted.problem.weight().name(),
        accepted.digits
    )
}
