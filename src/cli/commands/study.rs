//! `couplet study`.

use super::output::Output;
use super::print::PrintArguments;
use super::progress::styled;
use crate::cli::line::typed;
use crate::report::study::{StudyFiles, accuracy_table, stability_table};
use crate::study::accuracy;
use crate::study::cases::{QUANTITIES, cases};
use crate::study::limits::LIMITS;
use crate::study::stability;
use crate::sweep::failure::Failure;
use clap::{Args, Subcommand};
use std::fs;
use std::io;
use std::path::PathBuf;
use std::time::Duration;

/// Measure error against run time, and digits that are lost.
///
/// Every error is the distance to a certified value of much higher precision. Nothing here is part of a
/// proof.
#[derive(Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    study: Study,
}

#[derive(Subcommand)]
enum Study {
    /// Error against run time, for every way to compute a value.
    Accuracy(Options),
    /// Digits lost on the way to each limit of the problem.
    Stability(Options),
}

#[derive(Args)]
struct Options {
    /// Only these, separated by commas: kinds of quantity (eta-cubic, A-cubic, h-cubic, radicand,
    /// half-opening, landmark, state) or limits (alpha-to-zero, …).
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    only: Vec<String>,

    /// A quick look, of some seconds.
    #[arg(long)]
    quick: bool,

    /// Write raw numbers, a README and figures into a folder: SVG and, where they are built in (feature plots), PNG and
    /// PDF.
    #[arg(short, long, value_name = "FOLDER")]
    output: Option<PathBuf>,

    #[command(flatten)]
    print: PrintArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.study {
        Study::Accuracy(options) => accuracy(options),
        Study::Stability(options) => stability(options),
    }
}

const BAR: &str = "{bar:40} {pos}/{len}  about {eta} left";

/// Refuses a name that does not exist.
fn known(only: &[String], names: &[&str]) -> Result<(), Failure> {
    match only.iter().find(|name| !names.contains(&name.as_str())) {
        Some(name) => {
            let all = names.join(", ");
            Err(format!("unknown study '{name}'; the studies are {all}").into())
        }
        None => Ok(()),
    }
}

fn accuracy(options: &Options) -> Result<(), Failure> {
    known(&options.only, &QUANTITIES)?;
    let folder = StudyFolder::make(options)?;
    let effort = if options.quick { accuracy::QUICK } else { accuracy::FULL };
    let asked = |name: &str| options.only.is_empty() || options.only.iter().any(|o| o == name);
    let cases: Vec<_> = cases().into_iter().filter(|c| asked(c.quantity)).collect();
    let bar = styled(Some(cases.len() as u64), BAR);
    let mut rows = accuracy::sines(&effort);
    for case in &cases {
        rows.extend(accuracy::measure(case, &effort));
        bar.inc(1);
    }
    bar.finish_and_clear();
    Output::open(None)?.write(|out| accuracy_table(&rows, out))?;
    folder.write(StudyFiles::accuracy(&rows, &typed(), &options.print.print()))
}

fn stability(options: &Options) -> Result<(), Failure> {
    known(&options.only, &LIMITS.map(|limit| limit.name))?;
    let folder = StudyFolder::make(options)?;
    let (steps, budget) = match options.quick {
        true => (&stability::QUICK[..], Duration::from_millis(2)),
        false => (&stability::FULL[..], Duration::from_millis(50)),
    };
    let asked = |name: &str| options.only.is_empty() || options.only.iter().any(|o| o == name);
    let limits: Vec<_> = LIMITS.iter().filter(|limit| asked(limit.name)).collect();
    let bar = styled(Some((limits.len() * steps.len()) as u64), BAR);
    let mut rungs = Vec::new();
    for limit in limits {
        for &k in steps {
            rungs.extend(stability::climb(limit, k, budget));
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    Output::open(None)?.write(|out| stability_table(&rungs, out))?;
    folder.write(StudyFiles::stability(&rungs, &typed(), &options.print.print()))
}

/// Folder into which the files go, if anywhere; made before any work is done.
struct StudyFolder(Option<PathBuf>);

impl StudyFolder {
    fn make(options: &Options) -> Result<Self, Failure> {
        if let Some(folder) = &options.output {
            if folder.extension().is_some() && !folder.is_dir() {
                let (shown, name) = (folder.display(), folder.with_extension(""));
                return Err(format!(
                    "'{shown}' looks like a file: --output is a folder for several files, such as '{}'",
                    name.display()
                )
                .into());
            }
            fs::create_dir_all(folder)
                .map_err(|error| Failure::writing(folder.display(), &error))?;
        }
        Ok(Self(options.output.clone()))
    }

    fn write(&self, files: io::Result<StudyFiles>) -> Result<(), Failure> {
        let Some(folder) = &self.0 else { return Ok(()) };
        let files = files.map_err(|error| Failure::writing(folder.display(), &error))?;
        for (name, bytes) in &files.0 {
            let output = Output::open(Some(&folder.join(name)))?;
            output.write(|out| out.write_all(bytes))?;
        }
        if !cfg!(feature = "plots") {
            eprintln!(
                "couplet: the figures as SVG only: PNG and PDF are left out of this build (feature plots)"
            );
        }
        Ok(())
    }
}
