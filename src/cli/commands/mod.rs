//! The commands of the whole program.

mod arch;
mod assess;
mod audit;
mod certify;
mod constants;
mod judge;
mod output;
mod progress;
mod prove;
mod rows;
mod run;
mod state;
mod states;
#[cfg(feature = "study")]
mod study;

use super::{Failure, check, completions, man};
use crate::arch::SelfWeight;
use crate::certify::MAX_DIGITS;
use crate::problem::Landmark;
use crate::report::words::list;
use crate::report::{Content, Format};
use crate::scene::MAX_ARCH_DIGITS;
use clap::Subcommand;

#[derive(Subcommand)]
pub enum Command {
    Constants(constants::Arguments),
    State(state::Arguments),
    Assess(assess::Arguments),
    States(states::Arguments),
    Judge(judge::Arguments),
    Audit(audit::Arguments),
    Prove(prove::Arguments),
    Run(run::Arguments),
    Certify(certify::Arguments),
    Check(check::Arguments),
    #[cfg(feature = "study")]
    Study(study::Arguments),
    Completions(completions::Arguments),
    Man(man::Arguments),
}

impl Command {
    /// Does what is asked.
    pub fn run(&self) -> Result<(), Failure> {
        match self {
            Self::Constants(arguments) => constants::run(arguments),
            Self::State(arguments) => state::run(arguments),
            Self::Assess(arguments) => assess::run(arguments),
            Self::States(arguments) => states::run(arguments),
            Self::Judge(arguments) => judge::run(arguments),
            Self::Audit(arguments) => audit::run(arguments),
            Self::Prove(arguments) => prove::run(arguments),
            Self::Run(arguments) => run::run(arguments),
            Self::Certify(arguments) => certify::run(arguments),
            Self::Check(arguments) => check::run(arguments),
            #[cfg(feature = "study")]
            Self::Study(arguments) => study::run(arguments),
            Self::Completions(arguments) => completions::run(arguments),
            Self::Man(arguments) => man::run(arguments),
        }
    }
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

/// What reads the name of a format.
fn format(
    content: Content,
) -> impl Fn(&str) -> Result<&'static Format, String> + Clone + Send + Sync + 'static {
    move |name| {
        let format = Format::named(content, name)
            .ok_or_else(|| format!("a format is one of {}", Format::names(content)))?;
        format.missing().map_or(Ok(format), Err)
    }
}

/// What an option of formats is for.
fn format_help(content: Content) -> String {
    format!("Output format: {}", Format::names(content))
}

fn digits(text: &str) -> Result<usize, String> {
    text.parse()
        .ok()
        .filter(|digits| (1..=MAX_DIGITS).contains(digits))
        .ok_or_else(|| format!("digits are a whole number from 1 to {MAX_DIGITS}"))
}

fn state_digits(text: &str) -> Result<usize, String> {
    digits(text)
        .ok()
        .filter(|digits| *digits <= MAX_ARCH_DIGITS)
        .ok_or_else(|| format!("digits are a whole number from 1 to {MAX_ARCH_DIGITS}"))
}
