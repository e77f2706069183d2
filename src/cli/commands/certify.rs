//! `couplet certify`.

use super::arch::{Needs, ShapeArguments};
use super::output::{Output, is_standard};
use super::parse;
use crate::arch::SelfWeight;
use crate::certify::{Undecided, certify_landmark, certify_state};
use crate::check::Certificate;
use crate::cli::failure::Failure;
use crate::problem::{Friction, Landmark};
use clap::Args;
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

/// Write certificates that `couplet check` accepts without trusting the solver.
#[derive(Args)]
pub(crate) struct Arguments {
    /// A landmark (T, S, J, B, l, L, sb), `state` for the state of an arch, or `all` for all landmarks.
    #[arg(value_name = "SUBJECT", value_parser = target)]
    target: Target,

    #[command(flatten)]
    shape: ShapeArguments,

    /// Self-weight model, heyman or milankovitch; milankovitch if not given, both for `all`.
    #[arg(long, value_parser = parse::weight)]
    weight: Option<SelfWeight>,

    /// Significant digits, 1 to 1000000; at most 10000 for a state.
    #[arg(long, default_value = "30", value_parser = parse::digits, allow_negative_numbers = true)]
    digits: usize,

    /// The file to write, or for `all` the folder; standard output if not given.
    #[arg(short, long, value_name = "PATH")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq)]
enum Target {
    Landmark(Landmark),
    State,
    All,
}

fn target(text: &str) -> Result<Target, String> {
    match text {
        "state" => Ok(Target::State),
        "all" => Ok(Target::All),
        symbol => parse::landmark(symbol)
            .map(Target::Landmark)
            .map_err(|error| format!("{error}, or state, or all")),
    }
}

/// A command line that has everything.
const EXAMPLE: &str = "couplet certify state --half-opening 80deg --friction 0.6";

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.target != Target::State && arguments.shape.is_given() {
        return Err(Failure::Input("a half opening and a friction belong to `state`".into()));
    }
    match arguments.target {
        Target::All => all(arguments),
        Target::Landmark(landmark) => {
            let output = Output::open(arguments.output.as_deref())?;
            let weight = arguments.weight.unwrap_or(SelfWeight::Milankovitch);
            let made = certify_landmark(landmark, weight, arguments.digits);
            write(output, &made.map_err(undecided)?)
        }
        Target::State => {
            let weight = arguments.weight.unwrap_or(SelfWeight::Milankovitch);
            let needs = Needs { missing: Vec::new(), example: EXAMPLE };
            let arch = arguments.shape.arch(weight, &needs)?;
            if let Friction::Angle(_) = arch.friction() {
                let message = "a certificate takes the friction as a coefficient (0.6, 3/5, inf)";
                return Err(Failure::Input(message.into()));
            }
            parse::state_digits(&arguments.digits.to_string()).map_err(Failure::Input)?;
            let output = Output::open(arguments.output.as_deref())?;
            write(output, &certify_state(&arch, arguments.digits).map_err(undecided)?)
        }
    }
}

fn undecided(undecided: Undecided) -> Failure {
    Failure::Undecided(undecided.to_string())
}

/// All landmarks, each in a file of its own.
fn all(arguments: &Arguments) -> Result<(), Failure> {
    let folder = arguments.output.as_deref().filter(|folder| !is_standard(folder));
    let folder =
        folder.ok_or_else(|| Failure::Input("`all` needs a folder, --output PATH".into()))?;
    let failed = |error: std::io::Error| Failure::writing(folder.display(), &error);
    fs::create_dir_all(folder).map_err(failed)?;
    let weights = arguments.weight.map_or(SelfWeight::ALL.to_vec(), |weight| vec![weight]);
    let points: Vec<(Landmark, SelfWeight)> = Landmark::ALL
        .into_iter()
        .flat_map(|landmark| weights.iter().map(move |&weight| (landmark, weight)))
        .collect();
    let made: Vec<Certificate> = points
        .par_iter()
        .map(|&(landmark, weight)| certify_landmark(landmark, weight, arguments.digits))
        .collect::<Result<_, _>>()
        .map_err(undecided)?;
    for ((landmark, weight), certificate) in points.into_iter().zip(&made) {
        let path = folder.join(file_name(landmark, weight));
        write(Output::open(Some(Path::new(&path)))?, certificate)?;
    }
    Ok(())
}

/// `l` and `L` must not meet on a file system that does not tell them apart.
fn file_name(landmark: Landmark, weight: SelfWeight) -> String {
    let name = landmark.name().replace(' ', "-");
    format!("{name}-{}.json", weight.name())
}

fn write(output: Output, certificate: &Certificate) -> Result<(), Failure> {
    output.write(|out| certificate.write(out))
}
