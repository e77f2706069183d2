//! `couplet judge`.

use super::given_rows::source;
use super::output::{OutputFile, is_written};
use super::stream::{CHUNK, Progress, written};
use crate::arch::SelfWeight;
use crate::cli::line::say;
use crate::judge::{Demand, Verdict};
use crate::problem::Quantity;
use crate::report::judged::{self, JudgeSummary, JudgedAssemblies, verdicts};
use crate::report::words::list;
use crate::report::{Content, Format, Reported};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use crate::sweep::rows::{
    ArchReader, Columns, GivenRows, Judge, Keep, Numbered, Purpose, ReadRow, Role, Syntax,
};
use clap::Args;
use rayon::prelude::*;
use std::path::PathBuf;

/// Judge somebody else's results, row by row.
///
/// Judge somebody else's results: each row against the certified state of its arch.
///
/// The file is a table with a header, or JSON objects, one on each line or in an array: what `couplet
/// states`, `state`, `assess` and `run` write, and what other programs write (`couplet states --help` says how
/// numbers may be spelt). Our names for columns are weight, half_opening (or alpha), friction (or mu) or
/// friction_angle (or phi); and, to be judged, can_stand, mode, thickness (or eta), thrust, intrinsic_thrust,
/// rotation_joint, sliding_joint, sliding_friction, rotational_friction. They may have capitals. Other columns
/// are not read; the line number joins the output with the input.
///
/// The thickness is the least thickness that is claimed, unless the row also says something of an arch that
/// has a thickness: least_thickness, geometric_safety, required_friction, friction_safety, least_thrust or
/// largest_thrust. Then it is the thickness that the arch has, `stands` says whether it stands there, and all
/// these are judged. Without that `stands` means can_stand. `--columns t=given_thickness` says so too.
///
/// A row says that the arch cannot stand in one of these ways: can_stand is false, no or 0; the least
/// thickness or the mode is nan, inf, none, null, n/a, falls or a hyphen; the mode is [s,s] and there is no
/// thickness; or the least thickness is empty and no column says whether the arch stands. Any other empty
/// field claims nothing. Only the letters of a mode count: rrs is [r,r,s].
///
/// A number is correct to k digits if its error is at most half a unit of the k-th significant digit of
/// the true value (of the k-th decimal, if that is zero). The report also says how the last printed digit
/// was rounded: correctly, faithfully (less than a unit away) or wrongly; and whether the number is the
/// double nearest to the truth, the best that double precision can do. Errors are absolute, relative, in
/// units of the last printed place, and in units of the last place of the nearest double; they come from
/// proved enclosures and are correctly rounded.
///
/// The verdict of a row is one of: correctly rounded; correct; inaccurate; thicker than the least
/// thickness; wrong mode; claims that an arch falls which stands; thinner than the least thickness;
/// claims an arch that cannot stand; no claim; undecided; bad row. The first two are accepted: every number
/// has a correct digit and is less than a unit of its last printed place from the truth, or is correct to 12
/// digits; but a least thickness that is too small has 3 correct digits at least, however few are printed. If
/// several verdicts apply, the last one in this list is reported. Thinner (the unsafe side), thicker and inaccurate are
/// reported only for numbers that are not accepted. Where the mode is wrong and the other is met half a unit
/// of the last place of the friction or of the half opening away, the report says how near.
///
/// With --assemblies the rows are verdicts on the stones of `couplet sample --assemblies`: `id`, `stands`, and
/// `program` where there are several. Of each program it counts the right ones at each margin, and tells from which on
/// all are.
///
/// Exit codes: 0 all rows are accepted; 1 some are not; 2 some cannot be read, or bad usage; 3 a
/// resource or I/O failure.
#[derive(Args)]
pub(crate) struct Arguments {
    /// The results; `-` is standard input.
    #[arg(value_name = "FILE")]
    file: PathBuf,

    /// Judge verdicts on assemblies of stones.
    #[arg(long, conflicts_with_all = ["keep", "weight", "inputs", "accept", "worst"])]
    assemblies: bool,

    /// The columns to read, as theirs=ours separated by commas; theirs=ours:deg for an angle in degrees;
    /// just the name if both are the same. Other columns are ignored. The default is our own names, in
    /// radians.
    #[arg(long, value_delimiter = ',', value_name = "THEIRS=OURS,…")]
    columns: Vec<String>,

    /// Columns or keys of the file that are handed on to each row (csv and jsonl), or `all` that are not
    /// read. One whose name the output has for itself is called input_NAME there; JSON has them in `kept`.
    #[arg(long, value_delimiter = ',', value_name = "NAME,…")]
    keep: Vec<String>,

    /// Self-weight model of the rows that have none, heyman or milankovitch; milankovitch if not given.
    #[arg(long, value_parser = parse::weight)]
    weight: Option<SelfWeight>,

    /// The half opening and the friction that the solver used: exact, the decimal as written; or double,
    /// the nearest double to it, which is what a program in double precision uses if the file has all
    /// digits of its input. An angle in degrees is then rounded in degrees and again in radians. If the
    /// inputs in the file are themselves rounded, the reported errors include that rounding.
    #[arg(long, value_parser = ["exact", "double"], default_value = "exact")]
    inputs: String,

    /// Correct digits that every number of an accepted row must have, however many are printed.
    #[arg(long, value_name = "DIGITS", value_parser = parse::digits, allow_negative_numbers = true)]
    accept: Option<usize>,

    /// How many of the worst rows are shown, up to 1000.
    #[arg(
        long, value_name = "N", default_value = "5", allow_negative_numbers = true,
        value_parser = clap::value_parser!(u16).range(0..=1000)
    )]
    worst: u16,

    #[arg(long, value_parser = parse::format(Content::JUDGED), help = format_help())]
    format: Option<&'static Format>,

    #[command(flatten)]
    output: OutputFile,
}

fn format_help() -> String {
    let each = Format::all(Content::JUDGED).filter(|format| judged::has_rows(format));
    format!(
        "{}; {} list every row and put a short summary on standard error, the others are a summary with a \
         histogram and the worst rows",
        parse::usual_format_help(Content::JUDGED, "table"),
        list(each.map(|format| format.name))
    )
}

/// Judges verdicts on assemblies.
fn assemblies(arguments: &Arguments) -> Result<(), Failure> {
    let columns = Columns::named(&arguments.columns, Purpose::Assemblies)?;
    let source = source(Some(&arguments.file), &arguments.output)?;
    let format = arguments.output.format(arguments.format, Content::JUDGED, "table")?;
    is_written("a verdict on an assembly", JudgedAssemblies::content(), format)?;
    let rows = GivenRows::new((source.syntax, source.into_input()), columns, Keep::All, true)?.rows;
    let mut judged = JudgedAssemblies::default();
    for (line, row) in rows {
        let added = row.and_then(|ReadRow { cells, kept }| {
            let text = |name| Some(kept.iter().find(|(of, _)| of == name)?.1.text());
            let id = text("id").ok_or("the id is missing")?.trim_matches('"');
            let stands = cells.first().and_then(Option::as_deref).unwrap_or_default();
            judged.add(text("program").unwrap_or_default(), id, stands)
        });
        added.map_err(|error| format!("line {line}: {error}"))?;
    }
    let wrong = (!judged.are_right()).then_some("some verdicts are not right");
    arguments.output.open()?.report((&judged, format), wrong)
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.assemblies {
        return assemblies(arguments);
    }
    let columns = Columns::named(&arguments.columns, Purpose::Judge).map_err(Failure::Input)?;
    let source = source(Some(&arguments.file), &arguments.output)?;
    let format = arguments.output.format(arguments.format, Content::JUDGED, "table")?;
    let progress = Progress::new(&source);
    let syntax = source.syntax;
    let input = progress.counted(source.into_input());
    let keep = Keep::new(&arguments.keep);
    let has_rows = judged::has_rows(format);
    let in_lines = format.name != "csv";
    let given = GivenRows::new((syntax, input), columns, keep, in_lines)?;
    let GivenRows { columns, spelling, kept, rows } = given;
    let (seen, rows) = match syntax {
        Syntax::Json => seen_in(rows, &columns)?,
        Syntax::Csv => (vec![true; columns.all.len()], rows),
    };
    let (has_weight, quantities) = claimed(&columns, &seen);
    let demand = arguments.accept.map(|digits| Demand { digits, or_as_printed: false });
    let (weight, doubles) = (arguments.weight, arguments.inputs == "double");
    let assumed = (weight.is_none() && !has_weight).then_some(SelfWeight::Milankovitch);
    let weight = weight.unwrap_or(SelfWeight::Milankovitch);
    let reader = ArchReader { columns, weight, doubles, spelling };
    let judge = Judge { reader, demand: demand.unwrap_or_default() };
    let mut summary = JudgeSummary::new(judge.demand, assumed, usize::from(arguments.worst));
    let output = arguments.output.open()?;
    let mut complete = false;
    output.write(|out| {
        let columns = (&quantities[..], &kept[..]);
        out.write_all(&judged::header(format, columns)?)?;
        let answer = |row| {
            let text = judged::row(format, &row, columns);
            (row, text)
        };
        let answers = |rows| judge.rows(rows).into_par_iter().map(answer).collect();
        written(rows, &progress, answers, out, |row| summary.add(row))?;
        if !has_rows {
            summary.write(format, out)?;
        }
        complete = true;
        Ok(())
    })?;
    // The reader closed the pipe early.
    if !complete {
        return Ok(());
    }
    if has_rows {
        verdicts(&summary).iter().for_each(|text| say(text));
    }
    verdict(&summary)
}

fn verdict(summary: &JudgeSummary) -> Result<(), Failure> {
    let (rows, bad) = (summary.rows(), summary.count(Verdict::BadRow));
    match (bad, rows - summary.accepted()) {
        _ if rows == 0 => Err(Failure::Input("the file has no rows".into())),
        (0, 0) => Ok(()),
        (0, others) => Err(Failure::Undecided(format!("{others} of {rows} rows are not accepted"))),
        (bad, _) => Err(Failure::Input(format!("{bad} of {rows} rows could not be read"))),
    }
}

/// Tells whether the columns that were seen have a weight, and which quantities they claim.
fn claimed(columns: &Columns, seen: &[bool]) -> (bool, Vec<Quantity>) {
    let there = || columns.all.iter().zip(seen).filter(|(_, seen)| **seen).map(|(c, _)| c.role);
    let is_given = there().any(Role::is_of_thickness);
    let all = Quantity::STATE.into_iter().chain(Quantity::ASSESSMENT);
    let quantities = all
        .filter(|&quantity| !(is_given && quantity == Quantity::Thickness))
        .filter(|&quantity| there().any(|role| role == Role::Number(quantity)))
        .collect();
    (there().any(|role| role == Role::Weight), quantities)
}

/// Rows that are read one after the other.
type RowsToRead = Box<dyn Iterator<Item = Numbered<ReadRow>> + Send>;

/// The columns that the first rows of JSON have, and all the rows.
fn seen_in(mut rows: RowsToRead, columns: &Columns) -> Result<(Vec<bool>, RowsToRead), Failure> {
    let first: Vec<Numbered<ReadRow>> = rows.by_ref().take(CHUNK).collect();
    let read = || first.iter().filter_map(|(_, row)| row.as_ref().ok());
    let has = |place: usize| read().any(|row| row.cells[place].is_some());
    let seen: Vec<bool> = (0..columns.all.len()).map(has).collect();
    // If no row can be read, each reports its error.
    if read().next().is_some() {
        columns.check(&seen, "the first rows have")?;
    }
    Ok((seen, Box::new(first.into_iter().chain(rows))))
}
