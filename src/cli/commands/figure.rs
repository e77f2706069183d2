//! `couplet figure`.

use super::curves::{levels, traced};
use super::map::tolerance;
use super::output::OutputFile;
use super::print::PrintArguments;
use crate::arch::SelfWeight;
use crate::atlas::{Curve, Sketch};
use crate::cli::line::typed;
use crate::problem::{Landmark, Mode};
use crate::report::{Axes, Content, Drawing, Format, Map, Sketched, Style, View, arches_of_figure};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, Weights};
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

/// Half-width of a tube, if none is given.
const TOLERANCE: f64 = 1e-4;

fn draw(
    arguments: &Arguments,
    format: &Format,
    shown: &[(Landmark, &[Mode])],
) -> Result<(), Failure> {
    let weight = match arguments.weight {
        None => SelfWeight::Milankovitch,
        Some(Weights::One(weight)) => weight,
        Some(Weights::Both) => {
            return Err(format!("figure {} shows one --weight", arguments.number).into());
        }
    };
    if arguments.tolerance.is_some() {
        let number = arguments.number;
        return Err(
            format!("figure {number} has no curves of the map: leave out --tolerance").into()
        );
    }
    let sketch = |(landmark, modes): &(Landmark, &[Mode])| {
        Sketch::landmark(*landmark, weight, false).and_then(|sketch| sketch.in_modes(modes))
    };
    let sketches = shown.iter().map(sketch).collect::<Result<_, _>>()?;
    let style = Style::of_figure(arguments.number);
    let between = Vec::new();
    let report = Sketched { sketches, style, measures: None, between, command: typed() };
    let print = arguments.print.print();
    arguments.file.open_for(format)?.printed((&report, format, &print), [""; 0])
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let format = arguments.file.format(arguments.format, Content::FIGURE, "svg")?;
    if let Some(shown) = arches_of_figure(arguments.number) {
        return draw(arguments, format, shown);
    }
    let view = View::of_figure(arguments.number).unwrap_or(View::Lines);
    let usual = match view.is_of_one_weight() {
        true => Weights::One(SelfWeight::Milankovitch),
        false => Weights::Both,
    };
    let weights = arguments.weight.unwrap_or(usual).all();
    if weights.len() > 1 && view.is_of_one_weight() {
        return Err("figure 6 shows one --weight".into());
    }
    let file = arguments.file.open_for(format)?;
    let curves = |weight| Curve::ALL.into_iter().map(move |curve| (weight, curve));
    let asked = weights.iter().copied().flat_map(curves).collect();
    let tolerance = arguments.tolerance.unwrap_or(TOLERANCE);
    let (traces, mut open) = traced(asked, tolerance, format)?;
    let contours = match view {
        View::Map(plane) => plane.contours(),
        _ => Vec::new(),
    };
    let levels = levels(&contours, &weights, &traces, tolerance, &mut open)?;
    let drawing = Drawing { view, axes: Axes::default(), marks: Vec::new(), command: typed() };
    let landmarks = Vec::new();
    let map = Map { tolerance, traces, levels, borders: Vec::new(), landmarks, drawing };
    open.extend(map.open());
    file.printed((&map, format, &arguments.print.print()), open)
}
