//! `couplet certify`.

use super::arch::{Missing, ShapeArguments};
use super::notes;
use super::output::{Output, is_standard};
use crate::arch::SelfWeight;
use crate::arch::asymmetric::AsymmetricMode;
use crate::certify::{asymmetric_kinds, certify_arch, certify_asymmetric, certify_landmark};
use crate::check::Certificate;
use crate::number::ExactNumber;
use crate::problem::{Arch, Landmark};
use crate::sweep::failure::Failure;
use crate::sweep::parse::{self, thickness};
use clap::Args;
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

/// Write certificates that `couplet check` accepts without trusting the solver.
///
/// Of a landmark; of the state of an arch at its least thickness, or why it stands at no thickness; with --thickness,
/// that an arch stands with it or does not; of an asymmetric solution of the complementarity problem (19). An arch
/// stands if an admissible symmetric state exists, which does not exclude such a solution.
#[derive(Args)]
pub(crate) struct Arguments {
    /// A landmark (T, S, J, B, l, L, sb), `state` for the state of an arch, `arch` for an arch of a thickness,
    /// `asymmetric` for an asymmetric solution of (19), or `all` for all landmarks.
    #[arg(value_name = "SUBJECT", value_parser = target)]
    target: CertifyTarget,

    #[command(flatten)]
    shape: ShapeArguments,

    /// Thickness-to-radius ratio, for `arch`, above 0 and up to 2 (0.12, 3/25).
    #[arg(long, visible_alias = "eta", value_name = "ETA", value_parser = thickness, allow_hyphen_values = true)]
    thickness: Option<ExactNumber>,

    /// For `asymmetric`, how the mechanism closes: inner_sliding, shoulder_opening or shoulder_sliding; the one that is
    /// found if not given.
    #[arg(long, value_name = "MODE", value_parser = parse::asymmetric_mode)]
    mode: Option<AsymmetricMode>,

    /// Self-weight model, heyman or milankovitch; milankovitch if not given, both for `all`.
    #[arg(long, value_parser = parse::weight)]
    weight: Option<SelfWeight>,

    /// Significant digits, 1 to 1000000; at most 10000 for an arch.
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
    Asymmetric,
    All,
}

fn target(text: &str) -> Result<CertifyTarget, String> {
    match text {
        "state" => Ok(CertifyTarget::State),
        "arch" => Ok(CertifyTarget::Arch),
        "asymmetric" => Ok(CertifyTarget::Asymmetric),
        "all" => Ok(CertifyTarget::All),
        symbol => parse::landmark_or(symbol, &["state", "arch", "asymmetric", "all"])
            .map(CertifyTarget::Landmark),
    }
}

/// Command lines that have everything.
const STATE: &str = "couplet certify state --half-opening 80deg --friction 0.6";
const ARCH: &str = "couplet certify arch --half-opening 80deg --friction 0.6 --thickness 0.1";

const ASYMMETRIC: &str = "couplet certify asymmetric --half-opening 2.3 --friction 1.05";

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let is_arch = matches!(
        arguments.target,
        CertifyTarget::State | CertifyTarget::Arch | CertifyTarget::Asymmetric
    );
    if !is_arch && arguments.shape.is_given() {
        let message = "a half opening and a friction belong to `state`, `arch` and `asymmetric`";
        return Err(message.into());
    }
    if arguments.target != CertifyTarget::Arch && arguments.thickness.is_some() {
        return Err("a thickness belongs to `arch`".into());
    }
    if arguments.target != CertifyTarget::Asymmetric && arguments.mode.is_some() {
        return Err("a mode belongs to `asymmetric`".into());
    }
    let weight = arguments.weight.unwrap_or(SelfWeight::Milankovitch);
    let (digits, thickness) = (arguments.digits, arguments.thickness.as_ref());
    let output = || Output::open(arguments.output.as_deref());
    let (option, example) = match arguments.target {
        CertifyTarget::All => return all(arguments),
        CertifyTarget::Landmark(landmark) => {
            let output = output()?;
            return write(output, &certify_landmark(landmark, weight, digits)?);
        }
        CertifyTarget::Asymmetric => (None, ASYMMETRIC),
        CertifyTarget::State => (None, STATE),
        CertifyTarget::Arch => (thickness.is_none().then_some("--thickness"), ARCH),
    };
    let arch = arguments.shape.arch(weight, &Missing { option, example })?;
    let is_asymmetric = arguments.target == CertifyTarget::Asymmetric;
    if is_asymmetric && !arch.is_limited() {
        let words = "an asymmetric solution needs a limited friction: give --friction a number";
        return Err(words.into());
    }
    parse::state_digits(&digits.to_string())?;
    let mode = match is_asymmetric {
        true => Some(arguments.mode.map_or_else(|| only_kind(&arch), Ok)?),
        false => None,
    };
    let output = output()?;
    notes::frictions([arch.friction()]);
    let made = match mode {
        Some(mode) => certify_asymmetric(&arch, mode, digits)?,
        None => certify_arch(&arch, thickness, digits)?,
    };
    write(output, &made)
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
