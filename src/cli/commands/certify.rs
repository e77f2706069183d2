//! `couplet certify`.

use super::output::{Output, is_standard};
use super::{notes, progress};
use crate::arch::SelfWeight;
use crate::arch::asymmetric::AsymmetricMode;
use crate::ask::{ArchAsked, ArchGiven, ArchQuestion, Field, Spelling, SurveyGiven};
use crate::certify::{
    asymmetric_kinds, certify_arch, certify_asymmetric, certify_landmark, certify_survey,
};
use crate::check::Certificate;
use crate::problem::{Arch, Landmark};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use clap::Args;
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

/// Time of a certificate over that of the constants.
const TIMES: f64 = 2.5;

/// Write certificates that need no trust in the solver.
///
/// Write certificates that `couplet check` accepts without trusting the solver.
///
/// Of a landmark; of the state of an arch at its least thickness, or why it stands at no thickness; with --thickness,
/// that an arch stands with it or does not; of a verdict on all arches between measured ends; of an asymmetric solution
/// of the complementarity problem (19). An arch stands if an admissible symmetric state exists, which does not exclude
/// such a solution.
#[derive(Args)]
#[command(mut_arg("stones", |arg| arg.hide(true)))]
#[command(mut_arg("joints", |arg| arg.hide(true)))]
#[command(mut_arg("tilt", |arg| arg.hide(true)))]
#[command(mut_arg("density", |arg| arg.hide(true)))]
#[command(mut_arg("depth", |arg| arg.hide(true)))]
pub(crate) struct Arguments {
    /// A landmark (T, S, J, B, l, L, sb), `state` for the state of an arch, `arch` for an arch of a thickness, `survey`
    /// for all arches whose numbers lie in ranges (78deg..80deg, 0.6±10%), `asymmetric` for an asymmetric solution of
    /// (19), or `all` for all landmarks.
    #[arg(value_name = "SUBJECT", value_parser = target)]
    target: CertifyTarget,

    #[command(flatten)]
    arch: ArchAsked,

    /// For `asymmetric`, how the mechanism closes: inner_sliding, shoulder_opening or shoulder_sliding; the one that is
    /// found if not given.
    #[arg(long, value_name = "MODE", value_parser = parse::asymmetric_mode)]
    mode: Option<AsymmetricMode>,

    /// Self-weight model, heyman or milankovitch; milankovitch if not given, both for `all`.
    #[arg(long, value_parser = parse::weight)]
    weight: Option<SelfWeight>,

    /// Significant digits, 1 to 1000000.
    #[arg(long, default_value = "30", value_parser = parse::digits, allow_negative_numbers = true)]
    digits: usize,

    /// The file to write, or for `all` the folder; standard output if not given.
    #[arg(short, long, value_name = "PATH")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq)]
enum CertifyTarget {
    Landmark(Landmark),
    State,
    Arch,
    Survey,
    Asymmetric,
    All,
}

fn target(text: &str) -> Result<CertifyTarget, String> {
    match text {
        "state" => Ok(CertifyTarget::State),
        "arch" => Ok(CertifyTarget::Arch),
        "survey" => Ok(CertifyTarget::Survey),
        "asymmetric" => Ok(CertifyTarget::Asymmetric),
        "all" => Ok(CertifyTarget::All),
        symbol => parse::landmark_or(symbol, &["state", "arch", "survey", "asymmetric", "all"])
            .map(CertifyTarget::Landmark),
    }
}

/// Question about an arch at its least thickness.
pub const STATE: ArchQuestion = ArchQuestion {
    refuses: &[
        (Field::Stones, "the checker knows an arch with a joint at every angle"),
        (Field::Joints, "the checker knows an arch with a joint at every angle"),
        (Field::Tilt, "the checker knows an arch without acceleration"),
        (Field::Density, "a certificate has no forces"),
        (Field::Thickness, "a thickness belongs to `arch`"),
    ],
    needs: &[],
    unlimited: false,
    example: "couplet certify state --half-opening 80deg --friction 0.6",
};
/// Question about an asymmetric solution.
pub const ASYMMETRIC: ArchQuestion = ArchQuestion {
    example: "couplet certify asymmetric --half-opening 2.3 --friction 1.05",
    ..STATE
};
/// Question about an arch of a thickness.
pub const ARCH: ArchQuestion = ArchQuestion {
    refuses: STATE.refuses.split_last().unwrap().1,
    needs: &[Field::Thickness],
    unlimited: false,
    example: "couplet certify arch --half-opening 80deg --friction 0.6 --thickness 0.1",
};
/// Question about all arches between two ends.
pub const SURVEY: ArchQuestion = ArchQuestion {
    example: "couplet certify survey --half-opening 78deg..80deg --friction 0.6 --thickness 0.1..0.12",
    ..ARCH
};

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let is_landmark = matches!(arguments.target, CertifyTarget::Landmark(_) | CertifyTarget::All);
    if is_landmark && arguments.arch != ArchAsked::default() {
        return Err("an arch belongs to `state`, `arch`, `survey` and `asymmetric`".into());
    }
    if arguments.target != CertifyTarget::Asymmetric && arguments.mode.is_some() {
        return Err("a mode belongs to `asymmetric`".into());
    }
    let weight = arguments.weight.unwrap_or(SelfWeight::Milankovitch);
    let digits = arguments.digits;
    let output = || Output::open(arguments.output.as_deref());
    let question = match arguments.target {
        CertifyTarget::All => return all(arguments),
        CertifyTarget::Landmark(landmark) => {
            let output = output()?;
            progress::tell(&[digits], TIMES)?;
            return write(output, &certify_landmark(landmark, weight, digits)?);
        }
        CertifyTarget::Survey => return survey(arguments, weight),
        CertifyTarget::Asymmetric => ASYMMETRIC,
        CertifyTarget::State => STATE,
        CertifyTarget::Arch => ARCH,
    };
    let given = ArchGiven::read(&question, &arguments.arch, Spelling::Option)?;
    let arch = given.arch(weight)?;
    let is_asymmetric = arguments.target == CertifyTarget::Asymmetric;
    if is_asymmetric && !arch.is_limited() {
        let words = "an asymmetric solution needs a limited friction: give --friction a number";
        return Err(words.into());
    }
    let mode = match is_asymmetric {
        true => Some(arguments.mode.map_or_else(|| only_kind(&arch), Ok)?),
        false => None,
    };
    let output = output()?;
    notes::frictions([arch.friction()]);
    let made = match mode {
        Some(mode) => certify_asymmetric(&arch, mode, digits)?,
        None => certify_arch(&arch, given.thickness.as_ref(), digits)?,
    };
    write(output, &made)
}

/// The verdict on all arches of a survey.
fn survey(arguments: &Arguments, weight: SelfWeight) -> Result<(), Failure> {
    let given = SurveyGiven::read(&SURVEY, &arguments.arch, Spelling::Option)?;
    let survey = given.survey(weight).map_err(|error| error.to_string())?;
    let output = Output::open(arguments.output.as_deref())?;
    notes::frictions(survey.friction());
    let made = certify_survey(&survey, arguments.digits)?;
    output.write(|out| made.write(out))
}

/// The kind of the asymmetric solution that is found, if it is one alone.
fn only_kind(arch: &Arch) -> Result<AsymmetricMode, Failure> {
    let kinds = asymmetric_kinds(arch);
    match kinds[..] {
        [kind] => Ok(kind),
        [] => Err(Failure::Undecided("no asymmetric solution is found".into())),
        _ => {
            let names: Vec<&str> = kinds.iter().map(|kind| kind.name()).collect();
            Err(format!("it has several: give --mode {}", names.join(" or ")).into())
        }
    }
}

/// All landmarks, each in a file of its own.
fn all(arguments: &Arguments) -> Result<(), Failure> {
    let folder = arguments.output.as_deref().filter(|folder| !is_standard(folder));
    let folder = folder.ok_or("`all` needs a folder, --output PATH")?;
    let failed = |error: std::io::Error| Failure::writing(folder.display(), &error);
    fs::create_dir_all(folder).map_err(failed)?;
    let weights = arguments.weight.map_or(SelfWeight::ALL.to_vec(), |weight| vec![weight]);
    let points: Vec<(Landmark, SelfWeight)> = Landmark::ALL
        .into_iter()
        .flat_map(|landmark| weights.iter().map(move |&weight| (landmark, weight)))
        .collect();
    progress::tell(&vec![arguments.digits; points.len()], TIMES)?;
    let made: Vec<Certificate> = points
        .par_iter()
        .map(|&(landmark, weight)| certify_landmark(landmark, weight, arguments.digits))
        .collect::<Result<_, _>>()?;
    for ((landmark, weight), certificate) in points.into_iter().zip(&made) {
        let path = folder.join(file_name(landmark, weight));
        write(Output::open(Some(Path::new(&path)))?, certificate)?;
    }
    Ok(())
}

/// `l` and `L` must not meet on a file system that does not tell them apart.
fn file_name(landmark: Landmark, weight: SelfWeight) -> String {
    let name = landmark.name().replace(' ', "-");
    format!("{name}-{}.json", weight.name())
}

fn write(output: Output, certificate: &Certificate) -> Result<(), Failure> {
    output.write(|out| certificate.write(out))
}
