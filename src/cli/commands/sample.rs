//! `couplet sample`.

use super::output::OutputFile;
use crate::report::{Content, Format, SampledLines};
use crate::strategies::samples;
use crate::sweep::failure::Failure;
use crate::sweep::parse;
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
    #[arg(long, value_name = "N", default_value = "100", allow_negative_numbers = true, value_parser = count)]
    count: u64,

    /// What they are drawn from: any whole number from 0 on.
    #[arg(long, default_value = "1", allow_negative_numbers = true, value_parser = seed)]
    seed: u64,

    #[arg(
        long, value_parser = parse::format(Content::SAMPLES),
        help = parse::usual_format_help(Content::SAMPLES, "csv")
    )]
    format: Option<&'static Format>,

    #[command(flatten)]
    output: OutputFile,
}

/// The most arches that are drawn.
const MOST: u64 = 10_000_000;

fn count(text: &str) -> Result<u64, String> {
    let count = text.parse().ok().filter(|count| *count <= MOST);
    count.ok_or_else(|| format!("a count is a whole number from 0 to {MOST}"))
}

fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("a seed is a whole number from 0 to {}", u64::MAX))
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let format = arguments.output.format(arguments.format, Content::SAMPLES, "csv")?;
    let Some(lines) = SampledLines::of(format) else { return Ok(()) };
    arguments.output.open()?.write(|out| {
        out.write_all(&(lines.header)()?)?;
        let samples = samples(arguments.seed, arguments.hard);
        (1..=arguments.count)
            .zip(samples)
            .try_for_each(|(id, sample)| out.write_all(&(lines.row)(id, &sample)?))
    })
}
