//! `couplet figure`.

use super::map::{levels, tolerance, traced};
use super::output::{OutputFile, typed};
use super::parse::{self, Weights};
use crate::arch::SelfWeight;
use crate::atlas::Curve;
use crate::cli::failure::Failure;
use crate::report::{Content, Drawing, Format, Map, Report, View};
use clap::Args;

/// A figure of the paper, drawn from proved curves.
///
/// 2: rotational joint, thickness and thrust over the half opening. 3: the thickness over A = alpha cot(alpha/2). 4: the
/// thickness over the half opening. 5: the lines between the modes, both weights. 6: the map of one weight. Figures 2 to 5
/// show both weights unless one is named. Other planes and the curves as data: couplet map.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Its number in the paper, 2 to 6.
    #[arg(value_name = "NUMBER", value_parser = number)]
    number: usize,

    /// Self-weight model: heyman, milankovitch or, but for figure 6, both.
    #[arg(long, value_parser = parse::weights)]
    weight: Option<Weights>,

    /// Largest half-width of a tube, in rad and in thicknesses, from 1e-12 to 1.
    #[arg(long, default_value = "1e-4", value_name = "WIDTH", value_parser = tolerance, allow_negative_numbers = true)]
    tolerance: f64,

    /// Format: svg or png. If none is given, what the name of the file ends with tells it.
    #[arg(long, value_parser = format)]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,
}

fn number(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|number| View::of_figure(*number).is_some());
    number.ok_or_else(|| "a figure is a number from 2 to 6".to_owned())
}

fn format(name: &str) -> Result<&'static Format, String> {
    let format = Format::named(Content::Figure, name);
    format.ok_or_else(|| parse::unknown("a format", name, &["svg", "png"]))
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let format = arguments.file.format(arguments.format, Content::Map, "svg")?;
    if !format.is_picture {
        return Err(Failure::Input(format!("a figure is svg or png, not {}", format.name)));
    }
    let view = View::of_figure(arguments.number).unwrap_or(View::Lines);
    let usual = match view.is_of_one_weight() {
        true => Weights::One(SelfWeight::Milankovitch),
        false => Weights::Both,
    };
    let weights = arguments.weight.unwrap_or(usual).all();
    if weights.len() > 1 && view.is_of_one_weight() {
        return Err(Failure::Input("figure 6 shows one --weight".into()));
    }
    let file = arguments.file.open_for(format)?;
    let curves = |weight| Curve::ALL.into_iter().map(move |curve| (weight, curve));
    let asked = weights.iter().copied().flat_map(curves).collect();
    let tolerance = arguments.tolerance;
    let (traces, mut open) = traced(asked, tolerance, format)?;
    let contours = match view {
        View::Map(plane) => plane.contours(),
        _ => Vec::new(),
    };
    let levels = levels(&contours, &weights, &traces, tolerance, &mut open)?;
    let drawing = Drawing { view, marks: Vec::new(), command: typed() };
    let landmarks = Vec::new();
    let map = Map { tolerance, traces, levels, landmarks, drawing };
    open.extend(map.open());
    let report = Report::Map(map);
    file.write(|out| report.write(format, out))?;
    match open.is_empty() {
        true => Ok(()),
        false => Err(Failure::Undecided(open.join("; "))),
    }
}
