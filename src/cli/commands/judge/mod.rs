//! `couplet judge`.

mod columns;
mod row;

use super::output::OutputFile;
use super::rows::{
    CHUNK, JsonObject, Line, Progress, Source, Syntax, csv_records, in_order, json_lines,
};
use crate::arch::SelfWeight;
use crate::cli::commands::parse;
use crate::cli::failure::Failure;
use crate::judge::{Demand, Verdict};
use crate::problem::Quantity;
use crate::report::judged::{JudgeSummary, verdicts};
use crate::report::words::list;
use crate::report::{Content, Format};
use clap::Args;
use columns::{Columns, Role};
use row::{Cells, Judge};
use std::io;
use std::path::PathBuf;

/// Judge somebody else's results: each row against the certified state of its arch.
///
/// The file is CSV with a header, or JSON lines. Our names for columns are weight, half_opening,
/// friction or friction_angle; and, to be judged, stands, mode, thickness, thrust, intrinsic_thrust,
/// rotation_joint, sliding_joint, sliding_friction, rotational_friction; alpha, mu and eta are known
/// too. Other columns are ignored; the line number joins the output with the input. The output of
/// `couplet states` can be judged directly.
///
/// A row says that the arch cannot stand in one of these ways: `stands` is false, no or 0; the thickness
/// or the mode is nan, inf, none, null, n/a, falls or a hyphen; the mode is [s,s] and there is no
/// thickness; or the thickness is empty and there is no column `stands`. Any other empty field claims
/// nothing. Only the letters of a mode count: rrs is [r,r,s].
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
/// claims an arch that cannot stand; no claim; undecided; bad row. The first two are accepted. If several
/// apply, the last one in this list is reported. Thinner (the unsafe side), thicker and inaccurate are
/// reported only for numbers that miss --accept.
///
/// Exit codes: 0 all rows are accepted; 1 some are not; 2 some cannot be read, or bad usage; 3 a
/// resource or I/O failure.
#[derive(Args)]
pub(crate) struct Arguments {
    /// The results; `-` is standard input.
    #[arg(value_name = "FILE")]
    file: PathBuf,

    /// The columns to read, as theirs=ours separated by commas; theirs=ours:deg for an angle in degrees;
    /// just the name if both are the same. Other columns are ignored. The default is our own names, in
    /// radians.
    #[arg(long, value_delimiter = ',', value_name = "THEIRS=OURS,…")]
    columns: Vec<String>,

    /// Self-weight model of all rows, heyman or milankovitch, if it is not in a column.
    #[arg(long, value_parser = parse::weight)]
    weight: Option<SelfWeight>,

    /// The half opening and the friction that the solver used: exact, the decimal as written; or double,
    /// the nearest double to it, which is what a program in double precision uses if the file has all
    /// digits of its input. An angle in degrees is then rounded in degrees and again in radians. If the
    /// inputs in the file are themselves rounded, the reported errors include that rounding.
    #[arg(long, value_parser = ["exact", "double"], default_value = "exact")]
    inputs: String,

    /// Correct digits that every number of an accepted row must have. The default is 3, or fewer if fewer
    /// are printed and correctly rounded.
    #[arg(long, value_name = "DIGITS", value_parser = parse::state_digits, allow_negative_numbers = true)]
    accept: Option<usize>,

    /// How many of the worst rows are shown, up to 1000.
    #[arg(long, value_name = "N", default_value = "5", allow_negative_numbers = true, value_parser = clap::value_parser!(u16).range(0..=1000))]
    worst: u16,

    #[arg(long, default_value = "table", value_parser = parse::format(Content::Judged), help = format_help())]
    format: &'static Format,

    #[command(flatten)]
    output: OutputFile,
}

fn format_help() -> String {
    let each = Format::all(Content::Judged).filter(|format| format.judged_lines.is_some());
    format!(
        "{}; {} list every row and put a short summary on standard error, the others are a summary with a \
         histogram and the worst rows",
        parse::format_help(Content::Judged),
        list(each.map(|format| format.name))
    )
}

/// Correct digits that are demanded if none are asked for.
const DEMANDED: usize = 3;

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let columns = Columns::new(&arguments.columns).map_err(Failure::Input)?;
    let source = Source::open(Some(&arguments.file))?;
    if arguments.output.is_same_file(&arguments.file) {
        let file = arguments.file.display();
        return Err(Failure::Input(format!("refusing to overwrite the input {file}")));
    }
    let progress = Progress::new(&source);
    let syntax = source.syntax;
    let input = progress.counted(source.into_reader());
    let is_given = arguments.weight.is_some();
    let (columns, lines) = match syntax {
        Syntax::Csv => csv_cells(columns, input, is_given)?,
        Syntax::JsonLines => json_cells(columns, input, is_given)?,
    };
    let quantities: Vec<Quantity> = Quantity::STATE
        .into_iter()
        .filter(|&quantity| columns.all.iter().any(|c| c.role == Role::Number(quantity)))
        .collect();
    let each = arguments.format.judged_lines;
    let demand = Demand {
        digits: arguments.accept.unwrap_or(DEMANDED),
        or_all_printed: arguments.accept.is_none(),
    };
    let doubles = arguments.inputs == "double";
    let judge = Judge { columns, weight: arguments.weight, doubles, demand };
    let mut summary = JudgeSummary::new(demand, usize::from(arguments.worst));
    let output = arguments.output.open()?;
    let mut complete = false;
    output.write(|out| {
        if let Some(each) = each {
            out.write_all(&(each.header)(&quantities)?)?;
        }
        let answer = |(line, cells)| {
            let row = judge.row(line, cells);
            let text = each.map_or(Ok(Vec::new()), |each| (each.row)(&row, &quantities));
            (row, text)
        };
        in_order(lines, &progress, answer, |answers| {
            for (row, text) in answers {
                summary.add(row);
                out.write_all(&text?)?;
            }
            out.flush()?;
            Ok::<_, io::Error>(true)
        })?;
        if let Some(write) = arguments.format.judged {
            write(&summary, out)?;
        }
        complete = true;
        Ok(())
    })?;
    // The reader closed the pipe early.
    if !complete {
        return Ok(());
    }
    if each.is_some() {
        // Standard error may be closed.
        let _ = verdicts(&summary, &mut io::stderr());
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

type Rows = Box<dyn Iterator<Item = Line<Cells>>>;

/// The columns that a CSV file has, and its rows.
fn csv_cells(
    mut columns: Columns,
    input: impl io::Read + 'static,
    is_given: bool,
) -> Result<(Columns, Rows), Failure> {
    let (header, records) = csv_records(input)?;
    if header.iter().all(str::is_empty) {
        return Err(Failure::Input("the file is empty".into()));
    }
    let places = columns.places(&header)?;
    columns.check_weight(&vec![true; places.len()], is_given)?;
    let width = header.len();
    let cells = move |record: csv::StringRecord| match record.len() {
        found if found == width => {
            Ok(places.iter().map(|&place| record.get(place).map(str::to_owned)).collect())
        }
        found => Err(format!(
            "{found} fields where the header has {width}; a field with commas has to be quoted"
        )),
    };
    let rows = records.map(move |(line, record)| (line, record.and_then(&cells)));
    Ok((columns, Box::new(rows)))
}

/// The columns that the first rows of JSON lines have, and all rows.
fn json_cells(
    columns: Columns,
    input: impl io::Read + 'static,
    is_given: bool,
) -> Result<(Columns, Rows), Failure> {
    let keys: Vec<String> = columns.all.iter().map(|column| column.theirs.clone()).collect();
    let mut rows = json_lines(input, move |bytes| {
        let object = JsonObject::parse(bytes)?;
        Ok(keys.iter().map(|key| object.text(key)).collect::<Cells>())
    });
    let first: Vec<Line<Cells>> = rows.by_ref().take(CHUNK).collect();
    let read = || first.iter().filter_map(|(_, cells)| cells.as_ref().ok());
    // If no row can be read, each reports its error.
    if read().next().is_some() {
        let has = |place: usize| read().any(|cells| cells[place].is_some());
        let seen: Vec<bool> = (0..columns.all.len()).map(has).collect();
        columns.check(&seen, "the first rows have").map_err(Failure::Input)?;
        columns.check_weight(&seen, is_given)?;
    }
    Ok((columns, Box::new(first.into_iter().chain(rows))))
}
