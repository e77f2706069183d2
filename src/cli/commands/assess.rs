//! `couplet assess`.

use super::arch::{ArchArguments, Needs};
use super::measures::{self, MeasureArguments, Measured};
use super::output::AnswerOutput;
use super::state::{hinted, print};
use crate::certify::state::{Inquiry, Wanted, measured_assessment};
use crate::cli::failure::Failure;
use crate::problem::{Arch, Quantity};
use crate::report::Answer;
use clap::Args;

/// Print whether an arch of a given thickness stands, its safety factors, and the thrusts it can bear.
#[derive(Args)]
#[command(
    override_usage = "couplet assess --half-opening <ANGLE> --friction <MU> --thickness <ETA> [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    /// Thickness-to-radius ratio, between 0 and 2 (0.12, 3/25); of an arch in metres also a length (60cm).
    #[arg(long, visible_alias = "eta", value_name = "ETA", allow_hyphen_values = true)]
    thickness: Option<String>,

    #[command(flatten)]
    measures: MeasureArguments,

    #[command(flatten)]
    output: AnswerOutput,
}

/// A command line that has everything.
const EXAMPLE: &str = "couplet assess --half-opening 80deg --friction 0.6 --thickness 0.12";

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let missing = arguments.thickness.is_none().then_some("--thickness").into_iter().collect();
    let measured = arguments.measures.measured()?;
    let needs = Needs { missing, example: EXAMPLE };
    let arches = arguments.arch.arches(&needs, measures::half_opening(measured.as_ref()))?;
    let eta = arguments.thickness.as_deref().unwrap_or_default();
    let eta = measures::thickness(measured.as_ref(), eta)?;
    let all = measures::quantities(
        &Quantity::ASSESSMENT,
        &Quantity::MEASURED_ASSESSMENT,
        measured.as_ref(),
    );
    let quantities = arguments.output.quantities(&all)?;
    let digits = arguments.arch.digits;
    print(&arguments.output, digits, quantities, || {
        let answer = |(line, arch): (u64, Arch)| {
            // Some formats have quadruples, which take more bits than the digits.
            let mut inquiry = Inquiry::new(&arch, digits, false);
            let found = inquiry.assess(&eta, digits, Wanted::Everything);
            let answer = Answer::assessment(line, (&arch, &eta), &found);
            let answer = hinted(&arguments.output, (&arch, digits), answer);
            match &measured {
                Some(Measured { measures, .. }) => {
                    answer.measured(measured_assessment((&arch, &eta), measures, digits))
                }
                None => answer,
            }
        };
        (1..).zip(arches).map(answer).collect()
    })
}
