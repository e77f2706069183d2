//! `couplet sample`.

use super::output::{Output, OutputFile, is_written};
use crate::report::assembled::{self, Assembled};
use crate::report::{Content, Format, sampled_header, sampled_row};
use crate::strategies::{Margin, assemblies, samples};
use crate::sweep::failure::Failure;
use crate::sweep::parse;
use crate::sweep::unfinished::{HIDDEN, Unfinished};
use clap::Args;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

/// Draw arches, or arches of stones, to test a solver with.
///
/// Draw arches to test a solver with: ordinary or hard ones, or stones that just stand or fall.
///
/// Hard are arches next to a landmark, where modes meet, of which they share 3 to 40 digits, tiny openings
/// (3e-60), openings next to half a turn (0.9999pi), frictions like 0, 1e80 and inf, and exact ones like
/// 5pi/12 and tan(pi/5). The same seed draws the same arches. `couplet states` answers them, and `couplet judge`
/// judges what another program says of them; beside the exact text stand the nearest doubles.
///
/// With --assemblies: circular arches of 2 to 60 stones, each twice, by --margin above its least thickness or least
/// friction, where it stands, and as much below, where it falls; with the proof, the mechanism, and every stone as a
/// polygon with its weight and centroid. As obj or dxf each is a file in the folder --output, with the answers
/// beside them. `couplet judge --assemblies` tells which of somebody's verdicts are right.
#[derive(Args)]
pub(crate) struct Arguments {
    /// Hard arches instead of ordinary ones.
    #[arg(long)]
    hard: bool,

    /// Assemblies of stones near a threshold instead of arches: two for each of the count.
    #[arg(long, conflicts_with = "hard")]
    assemblies: bool,

    /// Distance of the assemblies from their threshold, 0.01% to 50%, with commas between several: what creeps or
    /// rounds learns more from 1%,5%,20%.
    #[arg(
        long,
        value_name = "PART",
        value_delimiter = ',',
        requires = "assemblies",
        default_value = "0.1%"
    )]
    margin: Vec<Margin>,

    /// How many, up to 10000000; of assemblies at each margin.
    #[arg(long, value_name = "N", default_value = "100", allow_negative_numbers = true, value_parser = count)]
    count: u64,

    /// What they are drawn from: any whole number from 0 on.
    #[arg(long, default_value = "1", allow_negative_numbers = true, value_parser = seed)]
    seed: u64,

    /// Output format, of arches csv or jsonl, of assemblies csv, json, obj or dxf; if not given what the name of the
    /// file ends with tells it, else it is csv.
    #[arg(long, value_parser = parse::format(Content::DRAWN))]
    format: Option<&'static Format>,

    #[command(flatten)]
    output: OutputFile,
}

/// The most arches that are drawn.
const MOST: u64 = 10_000_000;
/// The answers beside the bodies.
const ANSWERS: &str = "assemblies.json";

fn count(text: &str) -> Result<u64, String> {
    let count = text.parse().ok().filter(|count| *count <= MOST);
    count.ok_or_else(|| format!("a count is a whole number from 0 to {MOST}"))
}

fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("a seed is a whole number from 0 to {}", u64::MAX))
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.assemblies {
        return arguments.assemblies();
    }
    let format = arguments.format("an arch", Content::SAMPLES)?;
    arguments.output.open()?.write(|out| {
        out.write_all(&sampled_header(format)?)?;
        let samples = samples(arguments.seed, arguments.hard);
        (1..=arguments.count)
            .zip(samples)
            .try_for_each(|(id, sample)| out.write_all(&sampled_row(format, id, &sample)?))
    })
}

impl Arguments {
    fn format(&self, what: &str, content: Content) -> Result<&'static Format, Failure> {
        if let Some(format) = self.format {
            is_written(what, content, format)?;
        }
        self.output.format(self.format, content, "csv")
    }

    /// Assemblies with their numbers, each twice.
    fn drawn(&self) -> impl Iterator<Item = Assembled> {
        self.margin.iter().flat_map(|margin| {
            let pairs = (1..=self.count).zip(assemblies(self.seed, *margin));
            pairs.filter_map(|(number, pair)| Assembled::pair(number, pair)).flatten()
        })
    }

    fn assemblies(&self) -> Result<(), Failure> {
        let format = self.format("an assembly", Content::ASSEMBLIES)?;
        match format.name {
            "csv" => self.output.open()?.write(|out| {
                out.write_all(&assembled::header()?)?;
                self.drawn().try_for_each(|of| out.write_all(&assembled::row(&of)?))
            }),
            "json" => self.output.open()?.write(|out| list(self.drawn(), out)),
            "dxf" => self.folder(format, assembled::dxf),
            _ => self.folder(format, assembled::obj),
        }
    }

    /// The bodies, a file each, and the answers.
    fn folder(&self, format: &Format, bodies: fn(&Assembled) -> String) -> Result<(), Failure> {
        let Some(folder) = self.output.path() else {
            return Err(format!(
                "{} is a file for each assembly: name their folder with --output",
                format.name
            )
            .into());
        };
        let failed = |error: io::Error| Failure::writing(folder.display(), &error);
        let is_there = is_empty(folder)?;
        let parent = folder.parent().filter(|parent| !parent.as_os_str().is_empty());
        let base = if is_there { folder } else { parent.unwrap_or(Path::new(".")) };
        fs::create_dir_all(base).map_err(failed)?;
        // All of it appears at once, so that what was killed can be asked again.
        let hidden = Unfinished::folder(base).map_err(failed)?;
        let drawn: Vec<Assembled> = self.drawn().collect();
        for of in &drawn {
            let path = hidden.path().join(format!("{}.{}", of.id, format.extension));
            Output::open(Some(&path))?.write(|out| out.write_all(bodies(of).as_bytes()))?;
        }
        let answers = Output::open(Some(&hidden.path().join(ANSWERS)))?;
        answers.write(|out| list(drawn.into_iter(), out))?;
        // A folder that is there may be somebody's working folder, and stays the one that it is.
        match is_empty(folder)? {
            true => hidden.appear_in(folder, ANSWERS),
            false => hidden.appear(folder),
        }
        .map_err(failed)
    }
}

/// Tells whether a folder is there; what is there has to be an empty one: bodies of another draw would be taken for
/// those of this one. Hidden is what was killed.
fn is_empty(folder: &Path) -> Result<bool, Failure> {
    let failed = |error: io::Error| Failure::writing(folder.display(), &error);
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound && !folder.is_symlink() => {
            return Ok(false);
        }
        entries => entries.map_err(failed)?,
    };
    for entry in entries {
        if !entry.map_err(failed)?.file_name().to_string_lossy().starts_with(HIDDEN) {
            let folder = folder.display();
            return Err(format!("{folder} is not empty: name a new or an empty folder").into());
        }
    }
    Ok(true)
}

/// A list of objects, each on a line of its own.
fn list(all: impl Iterator<Item = Assembled>, out: &mut dyn Write) -> io::Result<()> {
    let mut before = "[\n";
    for of in all {
        out.write_all(before.as_bytes())?;
        out.write_all(assembled::json(&of)?.trim_ascii_end())?;
        before = ",\n";
    }
    out.write_all(if before == ",\n" { b"\n]\n" } else { b"[]\n" })
}
