//! The commands of the whole program.

mod arch;
mod assess;
mod audit;
mod axes;
mod by_value;
mod certify;
mod complementarity;
mod constants;
mod described;
pub mod doors;
mod draw;
mod equation;
mod figure;
mod find;
mod folder;
mod given_rows;
mod judge;
mod look;
mod map;
mod memory;
mod notes;
mod output;
mod print;
mod progress;
mod prove;
mod run;
mod sample;
mod state;
mod states;
mod stream;
mod study;
mod survey;
mod sweep;
mod tilt;
mod voussoirs;

use super::{check, completions, man};
use crate::sweep::failure::Failure;
use clap::Subcommand;

/// The commands in the groups of the help: each with the module of its arguments, what else it is called by who does
/// not know its name yet, and examples. Completions and the manual are made of them all.
macro_rules! commands {
    ($($group:literal {
        $($name:ident($module:ident) [$($alias:literal)*] $($example:expr),+;)*
    })*) => {
        #[derive(Subcommand)]
        pub(super) enum Command {
            $($(
                #[command(aliases = [$($alias),*] as [&str; _], after_help = examples(&[$($example),+]))]
                $name($module::Arguments),
            )*)*
            Completions(completions::Arguments),
            Man(man::Arguments),
        }

        impl Command {
            /// Groups of commands, each with its heading.
            pub(super) const GROUPS: &[(&str, &[&str])] =
                &[$(($group, &[$(stringify!($name)),*]),)* ("The program", &["Completions", "Man"])];

            /// Runs the command; `program` describes the whole command line.
            pub(super) fn run(&self, program: fn() -> clap::Command) -> Result<(), Failure> {
                match self {
                    $($(Self::$name(arguments) => $module::run(arguments),)*)*
                    Self::Completions(arguments) => completions::run(arguments, program()),
                    Self::Man(arguments) => man::run(arguments, program()),
                }
            }
        }
    };
}

commands! {
    "Most used" {
        Assess(assess) ["arch" "bridge" "safety" "thrust"]
            assess::QUESTION.example,
            "couplet assess --span 10m±2cm --rise 3m±1cm --thickness 60cm±1cm --friction 31deg±1deg",
            "couplet assess --span 18.9m --rise 4.2m --thickness 90cm --stones 41 --friction 0.6 --tilt 5deg",
            "couplet assess --span 33ft --rise 10ft --thickness 2ft --friction 0.6 -o bridge.svg";
        State(state) ["mechanism"]
            state::QUESTION.example,
            "couplet state --span 10m --rise 3m --friction 31deg --weight both --digits 6";
        Draw(draw) []
            draw::QUESTION.example,
            "couplet draw --at T --mode [s,r,r] -o triple.png";
        Map(map) ["plot"]
            "couplet map --lines --tolerance 1e-2 -o map.svg",
            "couplet map point rrr/srr --at 80deg --digits 50",
            "couplet map difference --tolerance 1e-3";
        States(states) []
            "couplet sample --count 20 -o arches.csv && couplet states arches.csv --digits 17 -o states.csv";
        Find(find) []
            "couplet find half-opening --thickness 0.15 --friction 0.6",
            "couplet find friction --half-opening 80deg --thickness 0.1",
            "couplet find boundary rrs/rsr --friction 1.6";
        Constants(constants) []
            "couplet constants T --digits 50",
            "couplet constants --weight milankovitch --format csv -o constants.csv";
        Certify(certify) []
            "couplet certify T --digits 100 -o T.json",
            certify::STATE.example;
        Check(check) [] "couplet certify T --digits 100 -o T.json && couplet check T.json";
    }
    "More" {
        Voussoirs(voussoirs) []
            voussoirs::QUESTION.example,
            "couplet voussoirs --half-opening pi/2 --friction 0.6 --stones 2..40 -o convergence.svg";
        Complementarity(complementarity) []
            complementarity::QUESTION.example,
            "couplet complementarity --half-opening pi/2 --friction 0.4 --stones 5 --half";
        Equation(equation) []
            "couplet equation 7 --rotation-joint 1.0",
            "couplet equation 12 --rotation-joint 57deg --weight heyman --digits 50";
        Sweep(sweep) [] "couplet sweep --schema";
        Sample(sample) [] "couplet sample --hard --count 1000 --seed 1 -o hard.csv";
        Judge(judge) ["compare"]
            "couplet sample --count 20 | couplet states - --digits 17 --format csv -o theirs.csv && \
             couplet judge theirs.csv";
        Run(run) [] "couplet run --schema > scene.toml && couplet run scene.toml --plan";
        Figure(figure) [] "couplet figure 7 -o figure7.svg";
        Audit(audit) [] "couplet audit --weight heyman";
        Prove(prove) [] "couplet prove eq-8 --show", "couplet prove --index";
        Study(study) [] "couplet study --help";
    }
}

/// Columns of an example: one that a terminal broke could not be copied.
const COLUMNS: usize = 78;

/// Examples below the help of a command, each a line, or several that a shell reads as one.
fn examples(all: &[&str]) -> String {
    let mut help = String::from("Examples:");
    for example in all {
        let mut line = String::from(" ");
        for word in example.split(' ') {
            if line.chars().count() + 1 + word.chars().count() + " \\".len() > COLUMNS {
                help += &format!("\n{line} \\");
                line = String::from("     ");
            }
            line += &format!(" {word}");
        }
        help += &format!("\n{line}");
    }
    help
}

/// Commands of a program in groups, for its help.
pub(super) fn grouped(program: &clap::Command) -> String {
    let mut help = String::new();
    for (group, names) in Command::GROUPS {
        help += &format!("{group}:\n");
        let of = |name: &&str| program.find_subcommand(name.to_lowercase());
        for command in names.iter().filter_map(of) {
            let about = command.get_about().map(ToString::to_string).unwrap_or_default();
            help += &format!("  {:<16} {about}\n", command.get_name());
        }
        help.push('\n');
    }
    help
}

impl Command {
    /// Tells whether the command computes on many threads.
    pub(super) fn computes(&self) -> bool {
        !matches!(self, Self::Check(_) | Self::Completions(_) | Self::Man(_))
    }
}
