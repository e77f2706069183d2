//! `couplet constants`.

use super::notes::each_once;
use super::output::AnswerOutput;
use super::progress;
use crate::arch::SelfWeight;
use crate::certify::quantities;
use crate::picture::Print;
use crate::problem::{Landmark, Quantity};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, Weights};
use crate::sweep::scene::{ItemKind, Plan, Request, Scene, SceneRun};
use clap::Args;

/// Print the landmark constants, each with a proof.
///
/// Print the landmark constants, each with a proof that it exists, is unique, and has the digits
/// shown.
///
/// Files for other programs have each value as the nearest double of the true value (whatever --digits
/// is), with outward bounds and a bound of its error, and as text with all digits. A name is landmark,
/// weight, quantity, as in COUPLET_T_HEYMAN_THICKNESS (c). The format latex is a table with siunitx that
/// also has what the paper prints; parquet, for data frames, needs the feature parquet.
///
/// All formats but table and csv identify the certificate of each landmark by its SHA-256, up to 10000
/// digits; `couplet certify T --weight heyman --digits 30 | sha256sum` prints it again.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Landmarks to print, by symbol or name; all if none is named.
    ///
    /// T triple, S shift, J junction, B border point; l rotation-end, L overturning-end; sb widest-joint.
    #[arg(value_name = "LANDMARK", value_parser = landmark)]
    landmarks: Vec<Landmark>,

    /// Self-weight model: heyman, milankovitch or both.
    #[arg(long, default_value = "both", value_parser = parse::weights)]
    weight: Weights,

    /// Significant digits, 1 to 1000000; values are correctly rounded to them.
    #[arg(long, default_value = "30", value_parser = parse::digits, allow_negative_numbers = true)]
    digits: usize,

    #[command(flatten)]
    output: AnswerOutput,
}

/// A landmark; all of them have no name of their own here.
fn landmark(text: &str) -> Result<Landmark, String> {
    match text {
        "all" => Err("without a name it is all of them".into()),
        text => parse::landmark(text),
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let (format, digits) = (arguments.output.format()?, arguments.digits);
    let wanted = arguments.output.quantities(&Quantity::LANDMARK)?;
    let symbol = |landmark: &Landmark| landmark.symbol().to_owned();
    let named = each_once(arguments.landmarks.iter().copied(), |landmark| *landmark, symbol);
    let is_named = |landmark: &Landmark| named.is_empty() || named.contains(landmark);
    let weights = arguments.weight.to_vec();
    let points: Vec<(Landmark, SelfWeight)> = weights
        .into_iter()
        .flat_map(|weight| {
            Landmark::ALL.into_iter().filter(is_named).map(move |landmark| (landmark, weight))
        })
        .collect();
    let has = |(landmark, _): &(Landmark, SelfWeight)| {
        quantities(*landmark).any(|quantity| wanted.contains(&quantity))
    };
    if !points.iter().any(has) {
        return Err("none of these landmarks has what was asked for".into());
    }
    let (output, _) = arguments.output.open()?;
    let what = Request::Constants { points, quantities: wanted, digits };
    let scene = Scene::one(ItemKind::Constants, what, (format, &Print::default()));
    let plan = Plan::new(&scene, vec![false]);
    let bar = progress::bar(plan.ticks(), &plan.sizes())?;
    let answer = SceneRun::new(&plan).item(0, &|| bar.inc(1));
    bar.finish_and_clear();
    output.write(|out| answer.write(out))?;
    Failure::unless_all("proved", &answer.undecided)
}
