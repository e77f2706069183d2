//! `couplet run`.

use super::output::{Output, is_same_file};
use super::progress;
use crate::cli::failure::Failure;
use crate::report::words::count;
use crate::scene::{
    EXAMPLE, Fault, Hashing, Item, MANIFEST, MAX_BYTES, Manifest, Plan, Run, Scene, explain,
    read_bytes,
};
use clap::Args;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

/// Compute exactly what a scene asks for, and write it.
///
/// A scene is a TOML file that lists landmarks, arches and claims, with digits, formats and files;
/// --schema prints one with every key. If a scene has errors, all of them are reported and nothing is
/// computed. Results that several items need are computed once. The file couplet-run.json next to the
/// outputs records for --resume which are complete.
#[derive(Args)]
pub(crate) struct Arguments {
    /// The scene; `-` is standard input.
    #[arg(value_name = "SCENE", required_unless_present = "schema")]
    scene: Option<PathBuf>,

    /// The folder of the outputs, made if need be; the current one if not given.
    #[arg(short, long, value_name = "FOLDER")]
    output: Option<PathBuf>,

    /// Keep an existing output if request, couplet version and file content are unchanged.
    #[arg(long)]
    resume: bool,

    /// Print what would be computed, as a tree, and compute nothing.
    #[arg(long)]
    plan: bool,

    /// Print on standard error, as a tree, what was computed, what each piece cost, and what was left
    /// out and why.
    #[arg(long, conflicts_with = "plan")]
    explain: bool,

    /// Print a scene that explains every key.
    #[arg(long, conflicts_with_all = ["scene", "output", "resume", "plan", "explain"])]
    schema: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Some(path) = arguments.scene.as_deref().filter(|_| !arguments.schema) else {
        return Output::Standard.write(|out| out.write_all(EXAMPLE.as_bytes()));
    };
    let scene = scene(path)?;
    // Nothing before a file's name is the current folder.
    let folder = arguments.output.as_deref().unwrap_or(Path::new(""));
    let mut manifest = Manifest::of(folder);
    let is_complete = |item: &Item| arguments.resume && manifest.is_complete(folder, item);
    let complete: Vec<bool> = scene.items.iter().map(is_complete).collect();
    let plan = Plan::new(&scene, complete);
    if arguments.plan {
        return Output::Standard.write(|out| explain(&plan, None, out));
    }
    prepare(&plan, folder, path)?;
    carry_out(&plan, folder, &mut manifest, arguments.explain)
}

/// Writes to standard error; nobody may be reading it.
fn say(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}

/// Reads a scene; its faults go to standard error, a line each.
fn scene(path: &Path) -> Result<Scene, Failure> {
    let standard = path == Path::new("-");
    let name = if standard { "standard input".into() } else { path.display().to_string() };
    let failed = |error: io::Error| Failure::reading(&name, &error);
    let mut bytes = Vec::new();
    let file: Box<dyn Read> = match standard {
        true => Box::new(io::stdin()),
        false => Box::new(File::open(path).map_err(failed)?),
    };
    file.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes).map_err(failed)?;
    read_bytes(&bytes).map_err(|faults| {
        for Fault { place, message } in &faults {
            say(&format!("{name}:{}:{}: {message}\n", place.line, place.column));
        }
        let errors = count(faults.len(), "error", "errors");
        Failure::Input(format!("{name} has {errors}; nothing was computed"))
    })
}

/// Makes the folders, and sees whether every output can be written, before any work.
fn prepare(plan: &Plan, folder: &Path, scene: &Path) -> Result<(), Failure> {
    let items = plan.scene.items.iter().zip(&plan.complete);
    let outputs: Vec<PathBuf> = items
        .filter(|(_, complete)| !**complete)
        .filter_map(|(item, _)| Some(folder.join(item.output.as_ref()?)))
        .collect();
    if let Some(output) = outputs.iter().find(|output| is_same_file(output, scene)) {
        let output = output.display();
        return Err(Failure::Input(format!("refusing to overwrite the scene {output}")));
    }
    for output in &outputs {
        let parent = output.parent().unwrap_or(folder);
        fs::create_dir_all(parent).map_err(|error| Failure::writing(parent.display(), &error))?;
        // Open a pipe only when there is something to write.
        if !output.exists() || output.is_file() || output.is_dir() {
            Output::open(Some(output))?;
        }
    }
    match outputs.is_empty() {
        true => Ok(()),
        false => Output::open(Some(&folder.join(MANIFEST))).map(drop),
    }
}

/// Computes and writes one item after the other; each output is noted as soon as it is there.
fn carry_out(
    plan: &Plan,
    folder: &Path,
    manifest: &mut Manifest,
    explained: bool,
) -> Result<(), Failure> {
    let bar = progress::bar(plan.ticks(), plan.size());
    let tick = || bar.inc(1);
    let mut run = Run::new(plan);
    let mut undecided = Vec::new();
    let mut printed = false;
    for (index, item) in plan.scene.items.iter().enumerate() {
        let path = item.output.as_ref().map(|output| folder.join(output));
        let tell = |what: &str| {
            if let Some(path) = &path {
                bar.suspend(|| say(&format!("{what} {}\n", path.display())));
            }
        };
        if plan.complete[index] {
            tell("kept   ");
            continue;
        }
        let report = run.item(index, &tick);
        let open = report.undecided.iter();
        undecided.extend(open.map(|what| match &path {
            Some(path) => format!("{what} in {}", path.display()),
            None => what.clone(),
        }));
        if !report.is_known() {
            continue;
        }
        let output = Output::open(path.as_deref())?;
        let mut hash = String::new();
        bar.suspend(|| {
            output.write(|out| {
                if path.is_none() && std::mem::replace(&mut printed, true) {
                    writeln!(out)?;
                }
                let mut hashing = Hashing::new(out);
                report.write(&mut hashing)?;
                hash = hashing.hash();
                Ok(())
            })
        })?;
        if path.is_some() {
            // An undecided output is tried again.
            match report.undecided.is_empty() {
                true => manifest.note(item, hash),
                false => manifest.forget(item),
            }
            Output::open(Some(&folder.join(MANIFEST)))?.write(|out| manifest.write(out))?;
            tell("written");
        }
    }
    bar.finish_and_clear();
    if explained {
        let mut tree = Vec::new();
        let written = explain(plan, Some(run.costs()), &mut tree);
        written.map_err(|error| Failure::Io(error.to_string()))?;
        say(&String::from_utf8_lossy(&tree));
    }
    match undecided.is_empty() {
        true => Ok(()),
        false => {
            Err(Failure::Undecided(format!("not everything was proved: {}", undecided.join(", "))))
        }
    }
}
