//! Arguments of the command.

use crate::arch::SelfWeight;
use crate::cli::commands::output::OutputFile;
use crate::problem::Quantity;
use crate::report::{Content, Format};
use crate::sweep::parse;
use clap::Args;
use std::path::PathBuf;

/// Answer a table of arches, a row each.
///
/// Read queries, one a row, and write what is proved of each, in the same order.
///
/// The input is a table with a header, or JSON objects, one on each line or in an array. Its columns or keys
/// are weight, half_opening (or alpha) or span and rise, friction (or mu) or friction_angle (or phi), and
/// thickness (or eta); radius, measured_at, density and depth, as for `state`.
/// A row without a thickness is answered as by `couplet state`, one with a thickness as by `couplet assess`:
/// a table with a column for the thickness has the columns of both, and the least thickness is
/// least_thickness there. Commas, semicolons, tabs or blanks separate; where semicolons do, a number may have
/// a decimal comma. `#` may begin the header (NumPy). Values are exact text, as for `state`; also
/// 0.107D+00 (Fortran), and 0x1.8p+1, which is exactly that double.
///
/// Rows of one half opening share its proofs, wherever they stand, and no digit depends on it: a grid takes a
/// fraction of the time of as many arches.
///
/// With --ranges a value may be a range, as for `assess` (0.55..0.65, 3m±2cm; in JSON also [0.55, 0.65]), and
/// each row is answered for every arch inside: `outcome` is all_stand, none_stands or both_occur, and each
/// quantity has its ends, least_thickness_lower and least_thickness_upper. A row of single values is answered as
/// the range that each of them is.
///
/// Other columns are not read, and `--keep` hands them on; stones, joints and tilt are refused unless they are kept by
/// name. A bad row becomes a row with its error and its
/// line number; the other rows are answered. Rows are answered as they come: who waits for an answer before
/// the next question gets it. An interrupted run keeps the rows written so far, except Parquet, which is
/// unreadable until its footer is written at the end.
///
/// Parquet (needs the feature parquet) has one row for each value: the query, mode, quantity, the value as
/// text with its bounds, the nearest double with its bounds.
#[derive(Args)]
pub(crate) struct Arguments {
    /// The queries; `-` is standard input, which is read if no file is given.
    #[arg(value_name = "FILE")]
    pub(super) file: Option<PathBuf>,

    /// Self-weight model of the rows that have none: heyman or milankovitch.
    #[arg(long, default_value = "milankovitch", value_parser = parse::weight)]
    pub(super) weight: SelfWeight,

    /// Significant digits, 1 to 1000000. With 17 JSON also has the nearest double of each value, in decimal and in
    /// hexadecimal.
    #[arg(long, default_value = "17", value_parser = parse::digits, allow_negative_numbers = true)]
    pub(super) digits: usize,

    /// The columns to read, as theirs=ours separated by commas; theirs=ours:deg for an angle in degrees; just the
    /// name if both are the same. The default is our own names. And the columns that a table has beside what is asked
    /// and told: `doubles`, the nearest to what is given and to each value; `hex`, these of values in hexadecimal;
    /// `all` of them.
    #[arg(long, value_delimiter = ',', value_name = "THEIRS=OURS,…")]
    pub(super) columns: Vec<String>,

    /// Columns or keys of the input that are handed on to the output, or `all` that are not read. One
    /// whose name the output has for itself is called input_NAME there; JSON has them in `kept`.
    #[arg(long, value_delimiter = ',', value_name = "NAME,…")]
    pub(super) keep: Vec<String>,

    /// Only these quantities (thickness, thrust, …), with commas between several. Without a
    /// friction among them the frictions at which the mode changes are not proved, which saves time.
    #[arg(
        long = "quantity", alias = "quantities", value_name = "NAME", value_delimiter = ',',
        value_parser = parse::quantity
    )]
    pub(super) quantities: Vec<Quantity>,

    #[arg(
        long,
        value_parser = parse::format(Content::ROWS),
        help = parse::format_help(Content::ROWS) + "; if not given what the name of the file ends with tells it, else \
            that of the input"
    )]
    pub(super) format: Option<&'static Format>,

    /// Answer each row for every arch inside its ranges (csv and jsonl). Columns are those of ranges then, whatever
    /// the rows have; without it a range is refused in its row.
    #[arg(long)]
    pub(super) ranges: bool,

    #[command(flatten)]
    pub(super) output: OutputFile,
}
