//! The command line: one file per command.
//!
//! Exit codes: 0 everything asked was proved; 1 something was refuted, refused or undecided; 2 bad
//! usage or input; 3 a resource or I/O failure.

mod arch;
mod assess;
mod audit;
mod constants;
mod output;
mod progress;
mod prove;
mod state;
mod states;

use crate::arch::{Landmark, SelfWeight};
use crate::certify::MAX_DIGITS;
use crate::report::Format;
use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Certified constants of the finite-friction Couplet–Heyman problem: how thin a circular masonry
/// arch can be and still stand, and how it falls.
#[derive(Parser)]
#[command(name = "couplet", version, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXIT_CODES: &str = "\
Exit codes: 0 everything asked was proved; 1 something was refuted, refused or undecided;
2 bad usage or input; 3 a resource or I/O failure.";

#[derive(Subcommand)]
enum Command {
    Constants(constants::Arguments),
    State(state::Arguments),
    Assess(assess::Arguments),
    States(states::Arguments),
    Audit(audit::Arguments),
    Prove(prove::Arguments),
}

/// Why a command did not do what was asked.
#[derive(Debug, thiserror::Error)]
enum Failure {
    /// The input makes no sense.
    #[error("{0}")]
    Input(String),
    /// Not everything could be proved; what could has been printed.
    #[error("{0}")]
    Undecided(String),
    /// A file or a stream.
    #[error("{0}")]
    Io(String),
}

/// Parses the arguments, runs the command, and says how it went.
pub fn run() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return usage(&error),
    };
    let outcome = match cli.command {
        Command::Constants(arguments) => constants::run(&arguments),
        Command::State(arguments) => state::run(&arguments),
        Command::Assess(arguments) => assess::run(&arguments),
        Command::States(arguments) => states::run(&arguments),
        Command::Audit(arguments) => audit::run(&arguments),
        Command::Prove(arguments) => prove::run(&arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("couplet: {failure}");
            ExitCode::from(match failure {
                Failure::Undecided(_) => 1,
                Failure::Input(_) => 2,
                Failure::Io(_) => 3,
            })
        }
    }
}

/// Help goes to standard output; an error becomes one line.
fn usage(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() {
        // Nothing is left to do if even this cannot be written.
        let _ = error.print();
        return ExitCode::SUCCESS;
    }
    if error.kind() == clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        let _ = error.print();
        return ExitCode::from(2);
    }
    let text = error.render().to_string();
    let line = text
        .lines()
        .take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"))
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with("tip: to pass"))
        .collect::<Vec<_>>()
        .join("; ");
    let possible = match error.kind() {
        clap::error::ErrorKind::InvalidSubcommand => {
            "; the commands are constants, state, assess, states, audit and prove"
        }
        clap::error::ErrorKind::UnknownArgument => "; --help lists the options",
        _ => "",
    };
    eprintln!("couplet: {}{possible}", line.strip_prefix("error: ").unwrap_or(&line));
    ExitCode::from(2)
}

fn landmark(text: &str) -> Result<Landmark, String> {
    Landmark::ALL.into_iter().find(|landmark| landmark.symbol() == text).ok_or_else(|| {
        format!("a landmark is one of {}", list(Landmark::ALL.map(Landmark::symbol)))
    })
}

fn weight(text: &str) -> Result<SelfWeight, String> {
    SelfWeight::ALL.into_iter().find(|weight| weight.name() == text).ok_or_else(|| {
        format!("a weight is one of {}", list(SelfWeight::ALL.map(SelfWeight::name)))
    })
}

fn format(text: &str) -> Result<Format, String> {
    match text {
        "table" => Ok(Format::Table),
        "json" => Ok(Format::Json),
        "csv" => Ok(Format::Csv),
        _ => Err("a format is one of table, json, csv".into()),
    }
}

fn digits(text: &str) -> Result<usize, String> {
    text.parse()
        .ok()
        .filter(|digits| (1..=MAX_DIGITS).contains(digits))
        .ok_or_else(|| format!("digits are a whole number from 1 to {MAX_DIGITS}"))
}

/// States are proved in numbers of moderate length.
const MAX_STATE_DIGITS: usize = 10_000;

fn state_digits(text: &str) -> Result<usize, String> {
    digits(text)
        .ok()
        .filter(|digits| *digits <= MAX_STATE_DIGITS)
        .ok_or_else(|| format!("digits are a whole number from 1 to {MAX_STATE_DIGITS}"))
}

fn list<const N: usize>(names: [&str; N]) -> String {
    names.join(", ")
}
