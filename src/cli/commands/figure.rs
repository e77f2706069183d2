//! `couplet figure`.

use super::map::tolerance;
use super::output::OutputFile;
use super::print::PrintArguments;
use crate::cli::line::typed;
use crate::report::{Content, Format, View, arches_of_figure};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, Weights};
use crate::sweep::scene::{ItemKind, answered, figure};
use clap::Args;

/// A figure of the paper, drawn from proved curves and states.
///
/// 1: the symbols of the problem, at T. 2: rotational joint, thickness and thrust over the half opening. 3: the
/// thickness of overturning over A = alpha cot(alpha/2) and over the half opening. 4: the same with rotation, and
/// how they join. 5: the lines between the modes, both weights. 6: the map of one weight. Figures 2 to 5 show both
/// weights unless one is named. 7 and 8: the four modes at T, two each. 9: S. 10: J. 11: B. 12: L and l; the arch,
/// its lines of thrust and of friction, and its mechanism. Other planes and the curves as data: couplet map; other
/// arches: couplet draw.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Its number in the paper, 1 to 12.
    #[arg(value_name = "NUMBER", value_parser = number)]
    number: usize,

    /// Self-weight model: heyman, milankovitch or, for figures 2 to 5, both.
    #[arg(long, value_parser = parse::weights)]
    weight: Option<Weights>,

    /// For figures 2 to 6, the largest half-width of a tube, in rad and in thicknesses, from 1e-12 to 1; 1e-4 if not
    /// given.
    #[arg(long, value_name = "WIDTH", value_parser = tolerance, allow_negative_numbers = true)]
    tolerance: Option<f64>,

    /// Format: svg, png or pdf. If none is given, what the name of the file ends with tells it.
    #[arg(long, value_parser = format)]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,

    #[command(flatten)]
    print: PrintArguments,
}

fn number(text: &str) -> Result<usize, String> {
    let is_one =
        |number: &usize| View::of_figure(*number).is_some() || arches_of_figure(*number).is_some();
    let number = text.parse().ok().filter(is_one);
    number.ok_or_else(|| "a figure is a number from 1 to 12".to_owned())
}

fn format(name: &str) -> Result<&'static Format, String> {
    let format = Format::named(Content::FIGURE, name);
    format.ok_or_else(|| parse::unknown("a format", name, &["svg", "png", "pdf"]))
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let format = arguments.file.format(arguments.format, Content::FIGURE, "svg")?;
    let Arguments { number, tolerance, .. } = *arguments;
    let weights = arguments.weight.map(<[_]>::to_vec);
    let asked = figure(number, weights, tolerance, |key| format!("--{key}"), |_| typed())?;
    let (file, print) = (arguments.file.open_for(format)?, arguments.print.print());
    let answer = answered(ItemKind::Figure, asked, (format, &print));
    match answer.report {
        Some(report) => file.printed((&*report, format, &print), answer.undecided),
        None => Failure::of_open(answer.undecided),
    }
}
