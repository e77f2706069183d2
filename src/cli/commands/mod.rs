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
mod study;

use super::{Failure, check};
use crate::arch::SelfWeight;
use crate::certify::MAX_DIGITS;
use crate::problem::Landmark;
use crate::report::export::ExportFormat;
use crate::report::{ConstantsFormat, Format};
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

fn constants_format(text: &str) -> Result<ConstantsFormat, String> {
    use ConstantsFormat::Export;
    match text {
        "table" => Ok(ConstantsFormat::Table),
        "json" => Ok(Export(ExportFormat::Json)),
        "csv" => Ok(ConstantsFormat::Csv),
        "toml" => Ok(Export(ExportFormat::Toml)),
        "latex" => Ok(Export(ExportFormat::Latex)),
        "c" => Ok(Export(ExportFormat::C)),
        "rust" => Ok(Export(ExportFormat::Rust)),
        "python" => Ok(Export(ExportFormat::Python)),
        "julia" => Ok(Export(ExportFormat::Julia)),
        "matlab" => Ok(Export(ExportFormat::Matlab)),
        "fortran" => Ok(Export(ExportFormat::Fortran)),
        #[cfg(feature = "parquet")]
        "parquet" => Ok(Export(ExportFormat::Parquet)),
        #[cfg(not(feature = "parquet"))]
        "parquet" => Err(NO_PARQUET.into()),
        _ => Err(
            "a format is one of table, json, csv, toml, latex, c, rust, python, julia, matlab, \
                  fortran, parquet"
                .into(),
        ),
    }
}

/// What to say where Parquet is not built in.
#[cfg(not(feature = "parquet"))]
const NO_PARQUET: &str = "this couplet was built without the feature parquet (cargo install --path . --features parquet)";

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

fn list<const N: usize>(names: [&str; N]) -> String {
    names.join(", ")
}
