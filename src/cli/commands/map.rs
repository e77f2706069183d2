//! `couplet map`.

use super::axes::AxesArguments;
use super::notes::{self, each_once};
use super::output::{Output, OutputFile};
use super::print::PrintArguments;
use crate::arch::SelfWeight;
use crate::atlas::BorderLine;
use crate::atlas::{
    self, Contour, Curve, Difference, Divide, LEAST_DIFFERENCE, LEAST_TOLERANCE, NoPoint,
};
use crate::certify::Undecided;
use crate::cli::line::typed;
use crate::number::ExactNumber;
use crate::problem::Friction;
use crate::report::{Format, Map, MapAsked, MapDifferences, MapPoint, Marked, Plane, Reported};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, Weights};
use crate::sweep::scene::{ItemKind, Request, SceneMap, answered, contour_key};
use clap::{Args, Subcommand};
use rayon::prelude::*;

/// Draw the map of the collapse modes, or write its curves.
///
/// The curves of the map, each proved for every value of its parameter, from landmark to landmark.
///
/// A curve is a chain of pieces. On each, for each value of the parameter, exactly one solution lies in a tube
/// about the cubic through its two nodes; neighbours join, and the ends are the landmarks. Without a format of data
/// the curves are summed up: pieces, the widest tube, and from where to where.
///
/// Curves: rotation, overturning, sliding; two modes that meet (rrr/srr, [r,s,r]/[r,s]); limit, where the thickness
/// reaches 2.
///
/// Formats of pictures, svg, png and pdf, draw the map: the domains of the modes in a --plane, or --lines alone. html
/// is a page with the map, of both weights unless one is named, that says what lies under the pointer. If no format is
/// given, what the name of the file ends with tells it; without a file it is table.
#[derive(Args)]
#[command(args_conflicts_with_subcommands = true, disable_help_subcommand = true)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    other: Option<MapQuestion>,

    #[command(flatten)]
    drawn: DrawnMap,
}

/// Question about the map that is none of its curves.
#[derive(Subcommand)]
enum MapQuestion {
    /// The point of one curve at a value of its parameter, to any number of digits.
    Point(PointArguments),
    /// By how much the thickness of Milankovitch's weight is above that of Heyman's on each dividing curve, at equal
    /// friction.
    Difference(DifferenceArguments),
}

#[derive(Args)]
struct PointArguments {
    /// The curve.
    #[arg(value_name = "CURVE", value_parser = curve)]
    curve: Curve,

    /// Value of its parameter (80deg, 1.2, 3/2).
    #[arg(long, value_name = "PARAMETER", allow_hyphen_values = true)]
    at: String,

    /// Self-weight model: heyman, milankovitch or both.
    #[arg(long, default_value = "milankovitch", value_parser = parse::weights)]
    weight: Weights,

    /// Significant digits, 1 to 1000000.
    #[arg(long, default_value = "30", value_parser = parse::digits, allow_negative_numbers = true)]
    digits: usize,

    #[arg(long, value_parser = parse::format(MapPoint::content()), help = parse::format_help(MapPoint::content()))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,
}

#[derive(Args)]
struct DifferenceArguments {
    /// Largest half-width of a tube, from 4e-12 to 1.
    #[arg(long, default_value = "1e-4", value_name = "WIDTH", value_parser = tolerance, allow_negative_numbers = true)]
    tolerance: f64,

    #[arg(long, value_parser = parse::format(MapDifferences::content()), help = parse::format_help(MapDifferences::content()))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,

    #[command(flatten)]
    print: PrintArguments,
}

#[derive(Args)]
struct DrawnMap {
    /// Curves, with commas between several; all if none is named.
    #[arg(long = "curve", value_name = "NAME", value_parser = curves)]
    curves: Vec<CurveNames>,

    /// The lines of these half openings (80deg, 2.5), mode by mode, with commas between several; without --curve only
    /// these.
    #[arg(
        long = "half-opening",
        visible_alias = "alpha",
        value_name = "ANGLE",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    half_openings: Vec<ExactNumber>,

    /// The lines of these least thicknesses over the half opening and the friction.
    #[arg(
        long = "thickness",
        visible_alias = "eta",
        value_name = "NUMBER",
        value_delimiter = ',',
        value_parser = parse::thickness,
        allow_hyphen_values = true
    )]
    thicknesses: Vec<ExactNumber>,

    /// The lines of these frictions (0.6, 30deg) over the half opening and the least thickness.
    #[arg(
        long = "friction",
        visible_alias = "mu",
        value_name = "FRICTION",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    frictions: Vec<Friction>,

    /// Self-weight model: heyman, milankovitch or both; milankovitch if none is named, but for html both.
    #[arg(long, value_parser = parse::weights)]
    weight: Option<Weights>,

    /// Largest half-width of a tube, in rad and in thicknesses, from 1e-12 to 1; with --scale log in parts of the least
    /// thickness shown.
    #[arg(long, default_value = "1e-4", value_name = "WIDTH", value_parser = tolerance, allow_negative_numbers = true)]
    tolerance: f64,

    /// For a picture, what lies along its axes: thickness-friction (if not given), opening-friction or
    /// opening-thickness.
    #[arg(long, value_parser = plane)]
    plane: Option<Plane>,

    /// For a picture, only the lines, of both weights if so asked; over thickness and friction.
    #[arg(long)]
    lines: bool,

    #[command(flatten)]
    axes: AxesArguments,

    /// What the branches of asymmetric solutions of the complementarity problem (19) reach, as lines over the half
    /// opening; without --curve only these. In a picture with --plane opening-friction, from 120 to 145 degrees and
    /// from 38 to 56 unless other ranges are given.
    #[arg(long, conflicts_with = "lines")]
    asymmetric: bool,

    /// For a map, an arch to mark, with its proved state: half opening, friction and, if it has one, thickness
    /// (80deg,0.6,0.15). With a range (78deg..82deg,0.6±10%) a box with all arches between. May be repeated.
    #[arg(long = "mark", value_name = "ALPHA,MU[,ETA]", allow_hyphen_values = true)]
    marks: Vec<Marked>,

    /// For a map, without lines of equal half opening, thickness or friction.
    #[arg(long)]
    bare: bool,

    #[arg(long, value_parser = parse::format(Map::content()), help = parse::format_help(Map::content()))]
    format: Option<&'static Format>,

    #[command(flatten)]
    file: OutputFile,

    #[command(flatten)]
    print: PrintArguments,
}

/// Curves named together.
#[derive(Clone, Debug)]
struct CurveNames(Vec<Curve>);

/// Names with commas between them; those of modes in brackets separate nothing.
fn curves(text: &str) -> Result<CurveNames, String> {
    let mut depth = 0;
    let is_between = |c: char| {
        depth += i32::from(c == '[') - i32::from(c == ']');
        c == ',' && depth == 0
    };
    text.split(is_between).map(curve).collect::<Result<_, _>>().map(CurveNames)
}

fn curve(text: &str) -> Result<Curve, String> {
    let names: Vec<String> = Curve::ALL.iter().map(ToString::to_string).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let is_asymmetric = BorderLine::ALL.iter().any(|line| line.name() == text);
    Curve::named(text).ok_or_else(|| match is_asymmetric {
        true => {
            format!("{text} is drawn with --asymmetric; a curve is one of {}", names.join(", "))
        }
        false => parse::unknown("a curve", text, &names),
    })
}

pub(super) fn tolerance(text: &str) -> Result<f64, String> {
    let tolerance = text.parse().ok().filter(|width| (LEAST_TOLERANCE..=1.0).contains(width));
    tolerance.ok_or_else(|| format!("a tolerance is a number from {LEAST_TOLERANCE:e} to 1"))
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.other {
        Some(MapQuestion::Point(of)) => point(of),
        Some(MapQuestion::Difference(of)) => difference(of),
        None => all_curves(&arguments.drawn),
    }
}

fn plane(text: &str) -> Result<Plane, String> {
    let names = Plane::ALL.map(Plane::name);
    Plane::named(text).ok_or_else(|| parse::unknown("a plane", text, &names))
}

fn all_curves(arguments: &DrawnMap) -> Result<(), Failure> {
    let format = arguments.file.format(arguments.format, Map::content(), "table")?;
    let axes = arguments.axes.axes();
    let usual: Weights =
        if format.is_page() { &SelfWeight::ALL } else { &[SelfWeight::Milankovitch] };
    let openings = arguments.half_openings.iter().cloned().map(Contour::HalfOpening);
    let thicknesses = arguments.thicknesses.iter().cloned().map(Contour::Thickness);
    let frictions = arguments.frictions.iter().cloned().map(Contour::Friction);
    let mut asked = MapAsked {
        format,
        weights: arguments.weight.unwrap_or(usual).to_vec(),
        curves: arguments.curves.iter().flat_map(|CurveNames(curves)| curves).copied().collect(),
        contours: openings.chain(thicknesses).chain(frictions).collect(),
        plane: arguments.plane,
        lines: arguments.lines,
        bare: arguments.bare,
        asymmetric: arguments.asymmetric,
        axes: if arguments.asymmetric { axes.of_asymmetric(format) } else { axes },
        marks: arguments.marks.clone(),
        tolerance: arguments.tolerance,
    };
    let misfit = asked.misfit(|key| format!("--{}", key.replace('_', "-")));
    misfit.map_or(Ok(()), Err)?;
    let print = arguments.print.of(format)?;
    let marked = asked.marks.iter().flat_map(Marked::frictions);
    notes::frictions(arguments.frictions.iter().chain(marked));
    asked.marks = each_once(asked.marks, ToString::to_string, |mark| format!("the mark {mark}"));
    let file = arguments.file.open_for(format)?;
    asked.curves = each_once(asked.curves, |curve| *curve, |curve| format!("the curve {curve}"));
    asked.contours = each_once(asked.contours, contour_key, |contour| format!("the {contour}"));
    let what = Request::Map(SceneMap::new(asked, typed()));
    let answer = answered(ItemKind::Map, what, (format, &print));
    answer.misfit.map_or(Ok(()), |why| Err(Failure::from(why)))?;
    let Some(report) = answer.report else { return Failure::of_open(answer.undecided) };
    file.printed((&*report, format, &print), [""; 0])?;
    told(&arguments.file, &*report)?;
    Failure::of_open(answer.undecided)
}

/// Tells on standard output, in a line, what was written into a file.
fn told(output: &OutputFile, report: &dyn Reported) -> Result<(), Failure> {
    let (Some(path), Some(summary)) = (output.path(), report.summary()) else { return Ok(()) };
    Output::Standard.write(|out| writeln!(out, "{}: {summary}", path.display()))
}

fn point(asked: &PointArguments) -> Result<(), Failure> {
    let format = asked.file.format(asked.format, MapPoint::content(), "table")?;
    let (curve, exact) = (asked.curve, asked.at.parse::<ExactNumber>()?);
    let weights = asked.weight.to_vec();
    let weights = if curve.is_weightless() { &weights[..1] } else { &weights[..] };
    let points = weights.iter().map(|&weight| {
        let values = atlas::point(curve, weight, &exact, asked.digits);
        let values = values.map_err(|error| match error {
            NoPoint::Undecided(_) => Failure::Undecided(error.to_string()),
            _ => Failure::Input(error.to_string()),
        })?;
        Ok(MapPoint { curve, weight, given: asked.at.clone(), values })
    });
    let points: Vec<MapPoint> = points.collect::<Result<_, Failure>>()?;
    asked.file.open_for(format)?.write(|out| points.write(format, out))
}

fn difference(asked: &DifferenceArguments) -> Result<(), Failure> {
    let format = asked.file.format(asked.format, MapDifferences::content(), "table")?;
    let print = asked.print.of(format)?;
    let tolerance = asked.tolerance;
    if tolerance < LEAST_DIFFERENCE {
        return Err(format!("a difference has a tolerance from {LEAST_DIFFERENCE:e} to 1").into());
    }
    let file = asked.file.open_for(format)?;
    let differences: Result<Vec<Difference>, Undecided> =
        Divide::ALL.into_par_iter().map(|divide| Difference::new(divide, tolerance)).collect();
    let differences = MapDifferences { tolerance, differences: differences?, command: typed() };
    file.printed((&differences, format, &print), [""; 0])?;
    told(&asked.file, &differences)
}
