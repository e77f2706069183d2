//! `couplet sample`.

use super::output::OutputFile;
use super::parse;
use crate::cli::failure::Failure;
use crate::report::{Content, Format};
use crate::strategies::samples;
use clap::Args;

/// Draw arches to test a solver with: ordinary ones, or hard ones.
///
/// Hard are arches next to a landmark, where modes meet, of which they share 3 to 40 digits, tiny openings
/// (3e-60), openings next to half a turn (0.9999pi), frictions like 0, 1e80 and inf, and exact ones like
/// 5pi/12 and tan(pi/5). The same seed draws the same arches. `couplet states` answers them, and `couplet judge`
/// judges what another program says of them; beside the exact text stand the nearest doubles.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Hard arches instead of ordinary ones.
    #[arg(long)]
    hard: bool,

    /// How many, up to 10000000.
    #[arg(long, value_name = "N", default_value = "100", allow_negative_numbers = true, value_parser = clap::value_parser!(u64).range(0..=10_000_000))]
    count: u64,

    /// What they are drawn from: any whole number from 0 on.
    #[arg(long, default_value = "1", allow_negative_numbers = true)]
    seed: u64,

    #[arg(long, default_value = "csv", value_parser = parse::format(Content::Samples), help = parse::format_help(Content::Samples))]
    format: &'static Format,

    #[command(flatten)]
    output: OutputFile,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Some(lines) = arguments.format.samples else { return Ok(()) };
    arguments.output.open()?.write(|out| {
        out.write_all(&(lines.header)()?)?;
        let samples = samples(arguments.seed, arguments.hard);
        (1..=arguments.count)
            .zip(samples)
            .try_for_each(|(id, sample)| out.write_all(&(lines.row)(id, &sample)?))
    })
}
