//! `couplet constants`.

use super::output::{Place, not_a_terminal};
use super::{Failure, progress};
use crate::arch::SelfWeight;
use crate::certify::{CertifiedLandmark, fingerprint};
use crate::problem::Landmark;
use crate::report::{Constants, ConstantsFormat, LandmarkReport, Proved};
use clap::Args;
use rayon::prelude::*;

/// Print the landmark constants, each with a proof that it exists, is unique, and has the digits
/// shown.
///
/// The formats toml, c, rust, python, julia, matlab and fortran are files for other programs: each value
/// as the nearest double of the true value (whatever --digits is), with outward bounds and a bound of its
/// error, and as text with all digits; latex is a table with siunitx beside what the paper prints; parquet
/// is for data frames, where couplet is built with that feature. A name is landmark, weight, quantity, as
/// in COUPLET_T_HEYMAN_THICKNESS (c). Each of them, and json, names the certificate of each landmark by its
/// SHA-256, up to 10000 digits; `couplet certify T --weight heyman --digits 30 | sha256sum` prints it again.
#[derive(Args)]
pub struct Arguments {
    /// Landmarks to print, of T, S, J, B, l, L, sb; all if none is named.
    ///
    /// T triple, S shift, J junction, B border point; l end of rotation, L end of overturning; sb
    /// widest rotational joint.
    #[arg(value_name = "LANDMARK", value_parser = super::landmark)]
    landmarks: Vec<Landmark>,

    /// Self-weight model, heyman or milankovitch; both if not given.
    #[arg(long, value_parser = super::weight)]
    weight: Option<SelfWeight>,

    /// Significant digits, 1 to 1000000; values are correctly rounded to them.
    #[arg(long, default_value = "30", value_parser = super::digits, allow_negative_numbers = true)]
    digits: usize,

    /// Output format: table, json, csv, toml, latex, c, rust, python, julia, matlab, fortran or parquet.
    #[arg(long, default_value = "table", value_parser = super::constants_format)]
    format: ConstantsFormat,

    #[command(flatten)]
    place: Place,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.format.is_binary() && arguments.place.is_standard() {
        not_a_terminal()?;
    }
    let output = arguments.place.open()?;
    let hashed = matches!(arguments.format, ConstantsFormat::Export(_));
    let asked = |landmark: &Landmark| {
        arguments.landmarks.is_empty() || arguments.landmarks.contains(landmark)
    };
    let weights = arguments.weight.map_or(SelfWeight::ALL.to_vec(), |weight| vec![weight]);
    let points: Vec<(Landmark, SelfWeight)> = weights
        .iter()
        .flat_map(|&weight| {
            Landmark::ALL.into_iter().filter(asked).map(move |landmark| (landmark, weight))
        })
        .collect();
    let ticks = points.iter().map(|&(landmark, _)| CertifiedLandmark::ticks(landmark)).sum();
    let bar = progress::bar(ticks, points.len() * arguments.digits);
    let landmarks: Vec<LandmarkReport> = points
        .into_par_iter()
        .map(|(landmark, weight)| {
            let outcome = CertifiedLandmark::new(landmark, weight)
                .and_then(|point| {
                    let constants = point.constants(arguments.digits, &|| bar.inc(1))?;
                    Ok(Proved::new(&point, constants))
                })
                .map_err(|undecided| undecided.to_string());
            let fingerprint = (hashed && outcome.is_ok()).then(|| {
                fingerprint(landmark, weight, arguments.digits).map_err(|undecided| undecided.0)
            });
            LandmarkReport { landmark, weight, outcome, fingerprint }
        })
        .collect();
    bar.finish_and_clear();
    let undecided: Vec<&str> = landmarks
        .iter()
        .filter(|entry| entry.outcome.is_err())
        .map(|entry| entry.landmark.symbol())
        .collect();
    let undecided = undecided.join(", ");
    let report = Constants { digits: arguments.digits, landmarks };
    output.write(|out| report.write(arguments.format, out))?;
    match undecided.is_empty() {
        true => Ok(()),
        false => Err(Failure::Undecided(format!("not everything was proved: {undecided}"))),
    }
}
