//! `couplet assess`.

use super::arch::{ArchArguments, Missing};
use super::measures::MeasureArguments;
use super::output::AnswerOutput;
use super::state::print;
use super::tilt::{acceleration, tilted_as, write};
use crate::certify::asymmetric_thicknesses;
use crate::certify::state::{Balls, Inquiry, Wanted, measured_assessment};
use crate::number::ExactNumber;
use crate::problem::{Arch, Quantity};
use crate::report::Answer;
use crate::sweep::failure::Failure;
use clap::Args;

/// Print whether an arch of a given thickness stands, its safety factors, and the thrusts it can bear.
#[derive(Args)]
#[command(
    override_usage = "couplet assess --half-opening <ANGLE> --friction <MU> --thickness <ETA> [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    /// Thickness-to-radius ratio, between 0 and 2 (0.12, 3/25, 0.12r); of an arch in metres a length (60cm), or a
    /// ratio with its r.
    #[arg(long, visible_alias = "eta", value_name = "ETA", allow_hyphen_values = true)]
    thickness: Option<String>,

    /// A uniform horizontal acceleration over that of gravity (0.1), or the angle by which the ground is tilted
    /// (5deg): whether an admissible state of the whole arch is left, and the largest one with which there is.
    #[arg(long, value_name = "K", allow_hyphen_values = true, conflicts_with = "quantities")]
    tilt: Option<String>,

    #[command(flatten)]
    measures: MeasureArguments,

    #[command(flatten)]
    output: AnswerOutput,
}

/// A command line that has everything.
const EXAMPLE: &str = "couplet assess --half-opening 80deg --friction 0.6 --thickness 0.12";

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let option = arguments.thickness.is_none().then_some("--thickness");
    let measured = arguments.measures.measured()?;
    let needs = Missing { option, example: EXAMPLE };
    let arches = arguments.arch.arches(&needs, measured.half_opening.as_ref())?;
    let eta = arguments.thickness.as_deref().unwrap_or_default();
    let eta = measured.thickness(eta)?;
    if let Some(tilt) = &arguments.tilt {
        if measured.measures.is_some_and(|measures| measures.has_forces()) {
            return Err("--tilt tells no forces: leave out --density and --depth".into());
        }
        return tilted(arguments, &arches, &eta, tilt);
    }
    let all = measured.quantities(&Quantity::ASSESSMENT, &Quantity::MEASURED_ASSESSMENT);
    let quantities = arguments.output.quantities(&all)?;
    let digits = arguments.arch.digits;
    let answer = |line, arch: &Arch| {
        // Some formats have quadruples, which take more bits than the digits.
        let found = Balls::Mpfr.assess(arch, &eta, digits);
        let answer = Answer::assessment(line, (arch, &eta), &found)
            .with_asymmetric(|| asymmetric_thicknesses(arch, digits));
        match &measured.measures {
            Some(measures) => {
                let sizes = measured_assessment((arch, &eta), measures, digits);
                answer.measured(measures.circle(), sizes)
            }
            None => answer,
        }
    };
    print(&arguments.output, (digits, quantities), &arches, answer)
}

/// The arches under an acceleration.
fn tilted(
    arguments: &Arguments,
    arches: &[Arch],
    eta: &ExactNumber,
    text: &str,
) -> Result<(), Failure> {
    let format = tilted_as(arguments.output.format()?)?;
    let tilt = acceleration(text, arches)?;
    let (output, _) = arguments.output.open()?;
    let digits = arguments.arch.digits;
    write((output, format), arches, (eta, &tilt), None, |arch| {
        let standing = Inquiry::new(arch, digits, false).assess(eta, digits, Wanted::Standing)?;
        Ok(match standing.stands {
            Ok(true) => Ok(Some(crate::certify::tilted(arch, eta, &tilt, digits)?)),
            Ok(false) => Ok(None),
            Err(undecided) => Err(undecided),
        })
    })
}
