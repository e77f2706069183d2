//! The commands of the whole program.

mod arch;
mod assess;
mod audit;
mod certify;
mod constants;
mod judge;
mod output;
mod parse;
mod progress;
mod prove;
mod rows;
mod run;
mod state;
mod states;
mod study;

use super::check;
use super::failure::Failure;
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
    Study(study::Arguments),
}

impl Command {
    /// What to say to someone who names another.
    pub const NAMES: &str = "; the commands are constants, state, assess, states, judge, audit, prove, run, \
                             certify, check and study";

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
            Self::Study(arguments) => study::run(arguments),
        }
    }
}
