//! The command line: one file per command.
//!
//! Exit codes: 0 everything asked was proved; 1 something was refuted, refused or undecided; 2 bad
//! usage or input; 3 a resource or I/O failure.

mod accepted;
mod check;
#[cfg(feature = "mpfr")]
mod commands;
mod completions;
mod failure;
mod man;
#[cfg(feature = "mpfr")]
mod threads;

use crate::check::visible;
use clap::{CommandFactory, Parser};
use failure::Failure;
use std::process::ExitCode;

#[cfg(not(feature = "mpfr"))]
use check::Command;
#[cfg(feature = "mpfr")]
use commands::Command;

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

/// Parses the arguments, runs the command, and says how it went.
pub fn run() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return usage(&error),
    };
    match cli.command.run(Cli::command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            // It may quote what others wrote.
            eprintln!("couplet: {}", visible(&failure.to_string()));
            ExitCode::from(match failure {
                Failure::Undecided(_) => 1,
                #[cfg(feature = "mpfr")]
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
        .join("; ")
        .replace(":; ", ": ");
    let possible = match error.kind() {
        clap::error::ErrorKind::InvalidSubcommand => commands_there_are(),
        clap::error::ErrorKind::UnknownArgument => "; --help lists the options".into(),
        _ => String::new(),
    };
    let line = visible(line.strip_prefix("error: ").unwrap_or(&line));
    eprintln!("couplet: {line}{possible}");
    ExitCode::from(2)
}

/// The commands of this build, for a message about an unknown one.
fn commands_there_are() -> String {
    let cli = Cli::command();
    let names: Vec<&str> = cli.get_subcommands().map(clap::Command::get_name).collect();
    let Some((last, others)) = names.split_last() else { return String::new() };
    let these = match cfg!(feature = "study") {
        true => "the commands are",
        false => "this build has the commands",
    };
    format!("; {these} {} and {last}", others.join(", "))
}
