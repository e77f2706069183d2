//! The files of a study: raw numbers as CSV, a README with what they mean and where they come from, and
//! the figures.

use crate::picture::Print;
use crate::{Content, Format, reported};
use couplet_study::row::Measurement;
use couplet_study::stability::Rung;
use couplet_study::{accuracy_figures, figure::Figure, stability_figure};
use serde::Serialize;
use std::io;
use std::process::Command;

/// Files by name.
type NamedBytes = Vec<(String, Vec<u8>)>;

/// Names and contents.
pub struct StudyFiles(pub NamedBytes);

impl StudyFiles {
    /// The files of `couplet study accuracy`.
    pub fn accuracy(rows: &[Measurement], command: &str, print: &Print) -> io::Result<Self> {
        let mut files = vec![
            ("accuracy.csv".into(), table(rows)),
            ("README.md".into(), readme("Error against run time", command, ACCURACY)),
        ];
        for figure in accuracy_figures::figures(rows) {
            files.extend(drawn(figure, print)?);
        }
        Ok(Self(files))
    }

    /// The files of `couplet study stability`.
    pub fn stability(rungs: &[Rung], command: &str, print: &Print) -> io::Result<Self> {
        let mut files = vec![
            ("stability.csv".into(), table(rungs)),
            ("README.md".into(), readme("Digits lost towards the limits", command, STABILITY)),
        ];
        files.extend(drawn(("digits-left", stability_figure::figure(rungs)), print)?);
        Ok(Self(files))
    }
}

/// A figure in every format of pictures that is built in.
fn drawn((name, figure): (&str, Figure), print: &Print) -> io::Result<NamedBytes> {
    let svg = figure.svg(print)?;
    let formats = Format::all(Content::FIGURE).filter(|format| format.missing().is_none());
    let file = |format: &Format| {
        Ok((format!("{name}.{}", format.extension), reported::drawn(svg.clone(), (format, print))?))
    };
    formats.map(file).collect()
}

fn table<T: Serialize>(rows: &[T]) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        // A vector takes everything, and the rows are flat.
        let _ = writer.serialize(row);
    }
    writer.into_inner().unwrap_or_default()
}

const ACCURACY: &str = "\
| column | meaning |
|---|---|
| `quantity`, `case`, `method` | what was computed, for which input, and how |
| `precision_bits` | the precision that the method was given |
| `threads` | threads used |
| `cpu_seconds`, `wall_seconds` | median of warm repeats |
| `cpu_lower_seconds`, `cpu_upper_seconds` | quartiles of the CPU times of the repeats |
| `first_seconds` | CPU time of the first call |
| `error_absolute_log10`, `error_relative_log10` | decimal logarithm of the distance to a certified value, worst unknown |
| `error_units` | the same in units of the last place |
| `claimed_relative_log10` | the bound that the method itself claims |
| `certified_digits` | decimal digits that it proves |
| `digits_lost` | decimal digits of the precision beyond the error |
| `working_bits` | the precision that it worked in |
| `evaluations`, `newton_steps` | of the system |
| `peak_memory_kb` | largest resident memory of the process so far |
| `verdict` | `proved`, `computed`, or why there is no value |
";

const STABILITY: &str = "\
| column | meaning |
|---|---|
| `limit`, `output` | which limit, and what is computed there |
| `distance_log10` | decimal logarithm of the distance from the limit |
| `method` | how it was computed |
| `working_bits` | the bits it was given; for `certified` the bits it needed for 16 digits |
| `condition_log10` | decimal logarithm of the condition number: digits that the problem itself loses |
| `error_relative_log10` | decimal logarithm of the relative distance to a certified value |
| `digits_lost` | decimal digits of the working precision beyond the error (or, certified, beyond the bound) |
| `cpu_seconds` | median CPU time |
| `verdict` | `proved`, `computed`, or why there is no value |
";

fn readme(title: &str, command: &str, columns: &str) -> Vec<u8> {
    let run = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        output.status.success().then(|| text.trim().to_owned()).filter(|text| !text.is_empty())
    };
    let unknown = || "unknown".to_owned();
    let processor = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        Some(line.split(':').nth(1)?.trim().to_owned())
    });
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!(
        "# {title}\n\n| | |\n|---|---|\n| command | `{command}` |\n| version | couplet {} |\n| commit | {} |\n\
         | machine | {}, {cores} cores |\n| date | {} |\n\n{columns}",
        env!("CARGO_PKG_VERSION"),
        run("git", &["rev-parse", "--short", "HEAD"]).unwrap_or_else(unknown),
        processor.unwrap_or_else(unknown),
        run("date", &["-u", "+%Y-%m-%d"]).unwrap_or_else(unknown),
    )
    .into_bytes()
}
