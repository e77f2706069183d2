//! The command line: one file per command.
//!
//! Exit codes: 0 everything asked was proved; 1 something was refuted, refused or undecided; 2 bad
//! usage or input; 3 a resource or I/O failure.

mod check;
mod commands;
mod completions;
mod line;
mod man;
mod version;

use crate::door::pool;
use crate::sweep::failure::Failure;
use crate::sweep::unfinished;
use clap::{ColorChoice, CommandFactory, FromArgMatches, Parser};
use std::ffi::{OsStr, OsString};
use std::io;
use std::process::ExitCode;

use commands::Command;
pub use commands::doors;
pub use line::Heard;
use line::say;

/// Certified constants of the finite-friction Couplet–Heyman problem: how thin a circular masonry
/// arch can be and still stand, and how it falls.
#[derive(Parser)]
#[command(name = "couplet", version, long_version = version::LONG.as_str(), after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,

    /// When to colour the help: auto, always or never.
    #[arg(
        long,
        global = true,
        default_value = "auto",
        value_name = "WHEN",
        hide_possible_values = true
    )]
    color: ColorChoice,

    /// Threads to compute with; one for each core if not given.
    #[arg(long, global = true, help_heading = "Options of every command", value_name = "N", value_parser = pool::read)]
    threads: Option<usize>,
}

const EXIT_CODES: &str = "\
Exit codes: 0 everything asked was proved; 1 something was refuted, refused or undecided;
2 bad usage or input; 3 a resource or I/O failure; 130 interrupted.";

/// Parses the arguments of the process, runs the command, and says how it went.
pub fn run() -> ExitCode {
    ExitCode::from(run_from(std::env::args_os().skip(1).collect()))
}

/// Exit code of a run with these arguments, without the name of the program; the exit code.
pub fn run_from(arguments: Vec<OsString>) -> u8 {
    unfinished::guard(remove_at_an_interrupt);
    answered(arguments)
}

/// Runs a command for a program that hears what it writes and says; its exit code. It sets no handler of signals, and
/// computes in the pool of threads that it is called in.
pub fn heard(arguments: Vec<OsString>) -> (u8, Heard) {
    line::heard(|| answered(arguments))
}

fn answered(arguments: Vec<OsString>) -> u8 {
    line::keep(&arguments);
    // Only the help of the program itself has groups; to make them takes a part of a short run.
    let is_command = arguments
        .first()
        .is_some_and(|word| word != "help" && !word.to_string_lossy().starts_with('-'));
    let program = if is_command { Cli::command() } else { grouped(Cli::command()) };
    let program = program.color(color(&arguments));
    let words = std::iter::once("couplet".into()).chain(arguments);
    let parsed = program.try_get_matches_from(words);
    let parsed = parsed.and_then(|found| Cli::from_arg_matches(&found));
    let cli = match parsed {
        Ok(cli) => cli,
        Err(error) => return usage(&error),
    };
    match cli.run() {
        Ok(()) => 0,
        Err(failure) => {
            // It may quote what others wrote.
            say(&format!("couplet: {failure}"));
            match failure {
                Failure::Undecided(_) => 1,
                Failure::Input(_) => 2,
                Failure::Io(_) => 3,
            }
        }
    }
}

/// Signals that end the process, and panics, end what is unfinished before.
fn remove_at_an_interrupt() {
    // Without a handler an interrupt leaves a hidden file behind; start all the same.
    let _ = ctrlc::set_handler(|| {
        unfinished::remove_all();
        std::process::exit(130);
    });
    // Where a panic ends the process at once, nothing is dropped.
    if cfg!(panic = "abort") {
        let tell = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            unfinished::remove_all();
            tell(panic);
        }));
    }
}

/// The program with its commands in groups.
fn grouped(program: clap::Command) -> clap::Command {
    let groups = commands::grouped(&program);
    let template = format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{groups}{{all-args}}{{after-help}}"
    );
    program
        .override_usage("couplet [OPTIONS] <COMMAND>")
        .mut_subcommands(|command| command.hide(true))
        .help_template(template)
}

impl Cli {
    fn run(&self) -> Result<(), Failure> {
        if !line::is_heard() && (self.threads.is_some() || self.command.computes()) {
            pool::start(self.threads)?;
        }
        self.command.run(Self::command)
    }
}

/// Choice of when to colour, which has to be known before the arguments are read: help is a part of reading them.
fn color(words: &[OsString]) -> ColorChoice {
    let mut arguments = words.iter().map(OsString::as_os_str);
    while let Some(argument) = arguments.next() {
        let value = match argument.to_str() {
            Some("--") => break,
            Some("--color") => arguments.next(),
            Some(text) => text.strip_prefix("--color=").map(OsStr::new),
            None => None,
        };
        if let Some(choice) = value.and_then(|value| value.to_str()?.parse().ok()) {
            return choice;
        }
    }
    ColorChoice::Auto
}

/// Help goes to standard output; an error becomes one line.
fn usage(error: &clap::Error) -> u8 {
    if !error.use_stderr() {
        return match error.print() {
            Ok(()) => 0,
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => 0,
            Err(error) => {
                say(&format!("couplet: {}", Failure::writing("to standard output", &error)));
                3
            }
        };
    }
    if error.kind() == clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        let _ = error.print();
        return 2;
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
        clap::error::ErrorKind::InvalidSubcommand if !line.contains("tip: ") => {
            commands_there_are()
        }
        clap::error::ErrorKind::UnknownArgument => "; --help lists the options".into(),
        _ => String::new(),
    };
    let (line, possible) = match beyond(error) {
        Some(limit) => (limit, String::new()),
        None => (missing(error, &text).unwrap_or(line), possible),
    };
    say(&format!("couplet: {}{possible}", line.strip_prefix("error: ").unwrap_or(&line)));
    2
}

/// Sentence of docs/limits.md for an option that asks for what is beyond them.
fn beyond(error: &clap::Error) -> Option<String> {
    use clap::error::{ContextKind, ContextValue, ErrorKind};
    const WEIGHT: &str = "the load is the weight of the arch itself: no fill, traffic, settlement or strength of the stone (docs/limits.md)";
    const CIRCULAR: &str = "arches are circular, of one thickness (docs/limits.md)";
    const WHOLE: &str = "this answer is told whole; --format csv or json names each value";
    let (ErrorKind::UnknownArgument, Some(ContextValue::String(name))) =
        (error.kind(), error.get(ContextKind::InvalidArg))
    else {
        return None;
    };
    let limit = match name.as_str() {
        "--load" | "--fill" | "--traffic" | "--settlement" | "--strength" => WEIGHT,
        "--pointed" | "--elliptic" => CIRCULAR,
        "--plain" | "--quantity" => WHOLE,
        _ => return None,
    };
    Some(format!("there is no {name}: {limit}"))
}

/// Message of what is missing, in one clause, and what a whole line has, as the first usage in the `text` of
/// the error says.
fn missing(error: &clap::Error, text: &str) -> Option<String> {
    use clap::error::{ContextKind, ContextValue, ErrorKind};
    let (ErrorKind::MissingRequiredArgument, Some(ContextValue::Strings(names))) =
        (error.kind(), error.get(ContextKind::InvalidArg))
    else {
        return None;
    };
    let verb = if names.len() == 1 { "is" } else { "are" };
    let usage = text.lines().find_map(|line| line.strip_prefix("Usage: "));
    let whole = usage.map_or(String::new(), |line| format!("; usage: {line}"));
    Some(format!("{} {verb} missing{whole}", names.join(", ")))
}

/// The commands, for a message about an unknown one.
fn commands_there_are() -> String {
    let cli = Cli::command();
    let names: Vec<&str> = cli.get_subcommands().map(clap::Command::get_name).collect();
    let Some((last, others)) = names.split_last() else { return String::new() };
    format!("; the commands are {} and {last}", others.join(", "))
}
