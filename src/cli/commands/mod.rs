//! The commands of the whole program.

mod arch;
mod assess;
mod audit;
mod axes;
mod by_value;
mod certify;
mod complementarity;
mod constants;
mod curves;
mod described;
mod draw;
mod equation;
mod figure;
mod find;
mod folder;
mod given_rows;
mod judge;
mod map;
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

/// The commands, each with the module of its arguments; completions and the manual are made of them all.
macro_rules! commands {
    ($($(#[$feature:meta])? $name:ident($module:ident)),*) => {
        #[derive(Subcommand)]
        pub(super) enum Command {
            $($(#[$feature])? $name($module::Arguments),)*
            Completions(completions::Arguments),
            Man(man::Arguments),
        }

        impl Command {
            /// Runs the command; `program` describes the whole command line.
            pub(super) fn run(&self, program: fn() -> clap::Command) -> Result<(), Failure> {
                match self {
                    $($(#[$feature])? Self::$name(arguments) => $module::run(arguments),)*
                    Self::Completions(arguments) => completions::run(arguments, program()),
                    Self::Man(arguments) => man::run(arguments, program()),
                }
            }
        }
    };
}

commands!(
    Constants(constants),
    State(state),
    Assess(assess),
    Find(find),
    Equation(equation),
    Voussoirs(voussoirs),
    Complementarity(complementarity),
    Map(map),
    Draw(draw),
    Figure(figure),
    States(states),
    Sweep(sweep),
    Sample(sample),
    Judge(judge),
    Audit(audit),
    Prove(prove),
    Run(run),
    Certify(certify),
    Check(check),
    #[cfg(feature = "study")]
    Study(study)
);

impl Command {
    /// Tells whether the command computes on many threads.
    pub(super) fn computes(&self) -> bool {
        !matches!(self, Self::Check(_) | Self::Completions(_) | Self::Man(_))
    }
}
