//! The command itself: surveys, computes what is missing, looks through.

use super::arguments::{Arguments, Share};
use crate::certify::batch::RowVerdict;
use crate::cli::commands::described::{described, remark};
use crate::cli::commands::output::Output;
use crate::cli::commands::progress::{ROWS, show_rows, styled};
use crate::cli::line::say;
use crate::report::words::{count, first_of};
use crate::sweep::failure::{Failure, print};
use crate::sweep::scene::{SWEEP_EXAMPLE, read_sweep};
use crate::sweep::sweep::{Sweep, verify};
use indicatif::ProgressBar;
use rayon::prelude::*;
use std::path::Path;
use std::sync::Mutex;

/// Rows that are proved again where a folder is looked through and nobody says how many.
const SAMPLE: usize = 100;
/// Names of other sweeps that are told.
const OTHERS: usize = 10;

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Some(path) = arguments.plan.as_deref().filter(|_| !arguments.schema) else {
        return Output::Standard.write(|out| out.write_all(SWEEP_EXAMPLE.as_bytes()));
    };
    if path.is_dir() {
        return look_through(path, arguments);
    }
    let (plan, notes) = described(path, read_sweep)?;
    remark(path, &notes);
    let base = path.parent().unwrap_or(Path::new(""));
    let output = arguments.output.as_deref().unwrap_or(Path::new(""));
    let sweep = Sweep::new(plan, base, output)?;
    let Share { k, n } = arguments.only.unwrap_or(Share { k: 1, n: 1 });
    let parts = sweep.share(k, n);
    let others = sweep.others();
    sweep.prepare()?;
    let folder = sweep.folder().display().to_string();
    if !others.is_empty() {
        let others = first_of(&others, OTHERS);
        say(&format!("couplet: other sweeps stay as they are beside {folder}: {others}"));
    }
    let bad_files = sweep.bad_files();
    bad_files.iter().for_each(|file| say(&format!("couplet: {file}")));
    let made = make(&sweep, &parts, arguments.verify.is_some())?;
    print(made.summary(&folder, parts.len()).as_bytes())?;
    made.lost.iter().for_each(|lost| say(&format!("couplet: {lost}")));
    if let Some(sample) = arguments.verify {
        look(&sweep, &parts, sample)?;
    }
    let [_, _, undecided, refused] = made.counts;
    let rows: u64 = made.counts.iter().sum();
    match (bad_files.len() + made.lost.len(), refused, undecided) {
        (0, 0, 0) => Ok(()),
        (0, 0, _) => Err(Failure::Undecided(format!("{undecided} of {rows} rows are undecided"))),
        (0, ..) => Err(Failure::Input(format!(
            "{refused} of {rows} rows could not be read; see their reasons"
        ))),
        (bad, ..) => Err(Failure::Input(format!(
            "{} could not be read; the rest is there",
            count(bad, "file or piece", "files or pieces")
        ))),
    }
}

/// Result of a share: the parts that were made.
struct MadeParts {
    /// Numbers of rows by verdict, of all parts that are there now.
    counts: [u64; 4],
    computed: usize,
    kept: usize,
    /// Parts whose files are not what they were.
    lost: Vec<String>,
}

impl MadeParts {
    fn summary(&self, folder: &str, parts: usize) -> String {
        let rows: u64 = self.counts.iter().sum();
        let verdicts = RowVerdict::ALL.iter().zip(self.counts).filter(|(_, count)| *count > 0);
        let verdicts: Vec<String> =
            verdicts.map(|(verdict, count)| format!("{} {count}", verdict.name())).collect();
        let verdicts = match verdicts.is_empty() {
            true => String::new(),
            false => format!(": {}", verdicts.join(", ")),
        };
        let (rows, parts) = (count(rows as usize, "row", "rows"), count(parts, "part", "parts"));
        format!(
            "{folder}: {rows} in {parts} ({} computed, {} kept){verdicts}\n",
            self.computed, self.kept
        )
    }
}

/// Computes the parts that are missing, or if all are read those that are not what was written.
fn make(sweep: &Sweep, parts: &[usize], reads: bool) -> Result<MadeParts, Failure> {
    let survey = sweep.survey(parts, reads)?;
    let mut made = MadeParts { counts: [0; 4], computed: 0, kept: 0, lost: Vec::new() };
    let mut missing = Vec::new();
    for (part, there) in survey {
        match there {
            Some(counts) => {
                made.kept += 1;
                add(&mut made.counts, counts);
            }
            None => missing.push(part),
        }
    }
    let bar = bar(missing.iter().map(|&part| length(sweep, part)).sum());
    let made = Mutex::new(made);
    let compute = |&part: &usize| {
        let computed = sweep.compute(part);
        let mut made = made.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        match computed {
            Ok(counts) => {
                made.computed += 1;
                add(&mut made.counts, counts);
            }
            // The other parts have their files.
            Err(Failure::Input(message)) => made.lost.push(format!("part {part}: {message}")),
            Err(error) => return Err(error),
        }
        tell(&bar, length(sweep, part));
        Ok(())
    };
    let done = missing.par_iter().with_max_len(1).try_for_each(compute);
    bar.finish_and_clear();
    done?;
    let mut made = made.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    made.lost.sort();
    Ok(made)
}

fn add(counts: &mut [u64; 4], more: [u64; 4]) {
    counts.iter_mut().zip(more).for_each(|(count, more)| *count += more);
}

fn length(sweep: &Sweep, part: usize) -> u64 {
    let rows = sweep.rows(part);
    rows.end - rows.start
}

fn bar(rows: u64) -> ProgressBar {
    let bar = styled(Some(rows), ROWS);
    bar.set_message("0 rows");
    bar
}

fn tell(bar: &ProgressBar, rows: u64) {
    bar.inc(rows);
    show_rows(bar, bar.position());
}

/// A folder of a sweep without its plan. The files of a data set are looked for beside the working folder.
fn look_through(folder: &Path, arguments: &Arguments) -> Result<(), Failure> {
    if arguments.output.is_some() {
        let message = "a folder is looked through where it is; --output belongs to a plan";
        return Err(Failure::Input(message.into()));
    }
    let sweep = Sweep::open(folder, Path::new(""))?;
    let Share { k, n } = arguments.only.unwrap_or(Share { k: 1, n: 1 });
    if arguments.verify.is_none() {
        say(&format!(
            "couplet: up to {SAMPLE} rows are proved again; --verify N for another number"
        ));
    }
    look(&sweep, &sweep.share(k, n), arguments.verify.unwrap_or(SAMPLE))
}

fn look(sweep: &Sweep, parts: &[usize], sample: usize) -> Result<(), Failure> {
    let bar = bar(parts.iter().map(|&part| length(sweep, part)).sum());
    let found = verify(sweep, parts, sample, &|rows| tell(&bar, rows));
    bar.finish_and_clear();
    let found = found?;
    let folder = sweep.folder().display();
    found.faults.iter().for_each(|fault| say(&format!("couplet: {fault}")));
    let summary = format!(
        "{folder}: {} in {} are there and as the plan asks; {} proved again bit for bit, {} of them certified and \
         checked in the second arithmetic\n",
        count(found.rows as usize, "row", "rows"),
        count(found.parts, "part", "parts"),
        count(found.again, "row", "rows"),
        found.certified,
    );
    print(summary.as_bytes())?;
    match found.faults.len() {
        0 => Ok(()),
        faults => {
            let faults = count(faults, "fault", "faults");
            Err(Failure::Undecided(format!("{folder} has {faults}")))
        }
    }
}
