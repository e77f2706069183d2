//! The commands of the whole program.

mod arch;
mod assess;
mod audit;
mod axes;
mod certify;
mod complementarity;
mod constants;
mod curves;
mod described;
mod draw;
mod figure;
mod find;
mod folder;
mod judge;
mod map;
mod measures;
mod notes;
mod output;
mod progress;
mod prove;
mod run;
mod sample;
mod state;
mod states;
mod stream;
#[cfg(feature = "study")]
mod study;
mod sweep;
mod tilt;
mod voussoirs;

use super::{check, completions, man};
use crate::sweep::failure::Failure;
use clap::Subcommand;

#[derive(Subcommand)]
pub(super) enum Command {
    Constants(constants::Arguments),
    State(state::Arguments),
    Assess(assess::Arguments),
    Find(find::Arguments),
    Voussoirs(voussoirs::Arguments),
    Complementarity(complementarity::Arguments),
    Map(map::Arguments),
    Draw(draw::Arguments),
    Figure(figure::Arguments),
    States(states::Arguments),
    Sweep(sweep::Arguments),
    Sample(sample::Arguments),
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
    /// Whether the command computes on many threads.
    pub(super) fn computes(&self) -> bool {
        !matches!(self, Self::Check(_) | Self::Completions(_) | Self::Man(_))
    }

    /// Runs the command; `program` describes the whole command line.
    pub(super) fn run(&self, program: fn() -> clap::Command) -> Result<(), Failure> {
        match self {
            Self::Constants(arguments) => constants::run(arguments),
            Self::State(arguments) => state::run(arguments),
            Self::Assess(arguments) => assess::run(arguments),
            Self::Find(arguments) => find::run(arguments),
            Self::Voussoirs(arguments) => voussoirs::run(arguments),
            Self::Complementarity(arguments) => complementarity::run(arguments),
            Self::Map(arguments) => map::run(arguments),
            Self::Draw(arguments) => draw::run(arguments),
            Self::Figure(arguments) => figure::run(arguments),
            Self::States(arguments) => states::run(arguments),
            Self::Sweep(arguments) => sweep::run(arguments),
            Self::Sample(arguments) => sample::run(arguments),
            Self::Judge(arguments) => judge::run(arguments),
            Self::Audit(arguments) => audit::run(arguments),
            Self::Prove(arguments) => prove::run(arguments),
            Self::Run(arguments) => run::run(arguments),
            Self::Certify(arguments) => certify::run(arguments),
            Self::Check(arguments) => check::run(arguments),
            #[cfg(feature = "study")]
            Self::Study(arguments) => study::run(arguments),
            Self::Completions(arguments) => completions::run(arguments, program()),
            Self::Man(arguments) => man::run(arguments, program()),
        }
    }
}
