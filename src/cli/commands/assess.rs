//! `couplet assess`.

use super::arch::ArchArguments;
use super::draw;
use super::look::LookArguments;
use super::output::AnswerOutput;
use super::state::print;
use super::survey;
use super::tilt;
use super::voussoirs;
use crate::ask::{ArchQuestion, Field};
use crate::certify::state::Wanted;
use crate::problem::Arch;
use crate::sweep::answer;
use crate::sweep::failure::Failure;
use clap::Args;

/// Tell whether an arch of a thickness stands, and how safely.
///
/// Whether it stands, its safety factors, the thrusts it can bear, and what limits each.
///
/// A number may be a range: 2.98m..3.02m, 3m±2cm (or 3m+-2cm), 31deg±1deg, 0.6±10%, 0.5..inf. Then it is told
/// of every arch inside: all stand, none does, or some do, with the least and largest values and the arches that
/// have them.
#[derive(Args)]
#[command(
    override_usage = "couplet assess --half-opening <ANGLE> --friction <MU> --thickness <ETA> [OPTIONS]"
)]
pub(crate) struct Arguments {
    #[command(flatten)]
    arch: ArchArguments,

    #[command(flatten)]
    output: AnswerOutput,

    #[command(flatten)]
    look: LookArguments,
}

/// Question about an arch of a thickness.
pub const QUESTION: ArchQuestion = ArchQuestion {
    refuses: &[],
    needs: &[Field::Thickness],
    unlimited: false,
    example: "couplet assess --half-opening 80deg --friction 0.6 --thickness 0.12",
};

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.arch.asked.has_range() {
        return survey::print(&QUESTION, &arguments.arch, (&arguments.output, &arguments.look));
    }
    let (given, arches) = arguments.arch.read(&QUESTION)?;
    let Some(eta) = &given.thickness else { return Ok(()) };
    if given.tilt.is_some() {
        arguments.output.tells_all("--tilt")?;
    }
    let asked = arguments.arch.understood(&given);
    let digits = arguments.arch.digits();
    if let Some(printed) = arguments.output.drawing(&arguments.look)? {
        let stones = if given.tilt.is_some() { voussoirs::divisions(&given)? } else { Vec::new() };
        if tilt::draw(&given, (&asked, &arches), stones.first(), &printed, digits)? {
            return Ok(());
        }
        return draw::arch(&given, arguments.arch.one_weight()?, printed);
    }
    if given.stones.is_some() {
        return voussoirs::print(&arguments.arch, &given, &arches, &arguments.output);
    }
    let format = arguments.output.format()?;
    let digits = arguments.arch.digits_of(&given, format);
    if let Some(tilt) = &given.tilt {
        let (output, sizes) = ((arguments.output.file(), format), arguments.arch.measures(&given));
        return tilt::write(output, (&asked, &arches), (eta, tilt, None), (digits, sizes));
    }
    let quantities = arguments.output.quantities(&given.quantities())?;
    let (proved, balls) = (format.proved_digits(digits), format.balls());
    let answer = |line, arch: &Arch| {
        let found = balls.assess(arch, eta, proved, Wanted::Everything);
        answer::assessment(
            crate::report::Extent::ALL,
            line,
            (arch, eta, arguments.arch.measures(&given)),
            proved,
            &found,
        )
    };
    print(&arguments.output, (digits, quantities), (&asked, &arches), answer)
}
