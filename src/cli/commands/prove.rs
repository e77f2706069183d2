//! `couplet prove`.

use super::notes::each_once;
use super::output::{Output, OutputFile};
use crate::check::{read, visible_name};
use crate::claims::Claim;
use crate::claims::coq;
use crate::report::{Claims, Format, Index, Reported};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use clap::Args;
use rayon::prelude::*;
use std::collections::HashMap;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Prove or refute the claims of the paper, one by one.
///
/// Each claim has an id, such as eq-7-eta; eq-7 selects all that begin with it. The exit code is 1 only
/// if a claim is undecided: a misprint that is refuted and corrected is a result.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Claims to decide; all if none is named.
    #[arg(value_name = "CLAIM")]
    claims: Vec<String>,

    /// List the claims, without deciding them.
    #[arg(long, conflicts_with_all = ["show", "format", "coq"])]
    list: bool,

    /// The paper, place by place: each equation and comparison with the claims that decide it.
    #[arg(long, conflicts_with_all = ["claims", "list", "show", "coq"])]
    index: bool,

    /// Show the derivations: hypotheses, intermediate polynomials, cofactors.
    #[arg(long)]
    show: bool,

    #[arg(
        long, value_parser = parse::format(Claims::content()),
        help = parse::usual_format_help(Claims::content(), "text")
    )]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,

    /// Instead, write certificates as theorems for the proof assistant Coq into a folder.
    #[arg(
        long, value_name = "FOLDER", requires = "certificate",
        conflicts_with_all = ["claims", "show", "format", "output"]
    )]
    coq: Option<PathBuf>,

    /// With --coq, the certificates, `-` for standard input.
    #[arg(long, value_name = "FILE", num_args = 1.., requires = "coq")]
    certificate: Vec<OsString>,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(folder) = &arguments.coq {
        return write_coq(folder, certificate_files(&arguments.certificate)?);
    }
    let format = arguments.file.format(arguments.format, Claims::content(), "text")?;
    let named = each_once(arguments.claims.clone(), String::clone, String::clone);
    let chosen =
        parse::claims_named(&named).map_err(|error| format!("{error}; --list shows the claims"))?;
    let output = arguments.file.open()?;
    if arguments.list {
        return output.write(|out| list(&chosen, out));
    }
    let decisions: Vec<_> = chosen.par_iter().map(Claim::decide).collect();
    let undecided: Vec<&str> = decisions
        .iter()
        .filter(|decision| decision.outcome.is_err())
        .map(|decision| decision.claim.id)
        .collect();
    let report: Box<dyn Reported> = match arguments.index {
        true => Box::new(Index { decisions }),
        false => Box::new(Claims { decisions, show: arguments.show, timed: true }),
    };
    output.write(|out| report.write(format, out))?;
    Failure::unless_all("decided", &undecided)
}

/// The claims: id, place in the paper, statement.
fn list(claims: &[Claim], out: &mut dyn io::Write) -> io::Result<()> {
    let width = |text: fn(&Claim) -> &str| claims.iter().map(|c| text(c).chars().count()).max();
    let id = width(|claim| claim.id).unwrap_or(0);
    let place = width(|claim| claim.place).unwrap_or(0);
    claims.iter().try_for_each(|claim| {
        writeln!(out, "{:<id$}  {:<place$}  {}", claim.id, claim.place, claim.statement)
    })
}

/// Writes the Coq files into a folder, which is made if need be, and tells their names.
fn write_coq(folder: &Path, files: Vec<(String, String)>) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| Failure::writing(folder.display(), &error))?;
    let mut written = String::new();
    for (name, text) in files {
        let path = folder.join(name);
        Output::open(Some(&path))?.write(|out| out.write_all(text.as_bytes()))?;
        written += &visible_name(path.as_os_str());
        written.push('\n');
    }
    Output::open(None)?.write(|out| out.write_all(written.as_bytes()))
}

/// The Coq files of certificates. Those of one subject and weight are numbered from the second on.
fn certificate_files(certificates: &[OsString]) -> Result<Vec<(String, String)>, Failure> {
    let mut files: Vec<(String, String)> = Vec::new();
    let mut seen = HashMap::new();
    for path in certificates {
        let shown = visible_name(path);
        let bytes = read(path).map_err(|error| Failure::reading(&shown, &error))?;
        let (name, text) = coq::certificate(&bytes)
            .map_err(|why| Failure::Input(format!("{shown}: refused: {why}")))?;
        let count = seen.entry(name.clone()).and_modify(|n| *n += 1).or_insert(1);
        let name = match *count {
            1 => name,
            n => format!("{}{n}.v", name.trim_end_matches(".v")),
        };
        files.push((name, text));
    }
    Ok(files)
}
