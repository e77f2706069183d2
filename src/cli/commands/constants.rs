//! `couplet constants`.

use super::output::Destination;
use super::{Failure, progress};
use crate::arch::{Landmark, SelfWeight};
use crate::certify::CertifiedLandmark;
use crate::report::{Constants, LandmarkReport, Proved};
use clap::Args;
use rayon::prelude::*;

/// Print the landmark constants, each with a proof that it exists, is unique, and has the digits
/// shown.
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

    #[command(flatten)]
    destination: Destination,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let output = arguments.destination.open()?;
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
            LandmarkReport { landmark, weight, outcome }
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
    output.write(|out| report.write(arguments.destination.format, out))?;
    match undecided.is_empty() {
        true => Ok(()),
        false => Err(Failure::Undecided(format!("not everything was proved: {undecided}"))),
    }
}
