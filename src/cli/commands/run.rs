//! `couplet run`.

use super::described::{described, remark};
use super::folder::RunFolder;
use super::output::Output;
use super::progress;
use crate::cli::line::say;
use crate::sweep::failure::Failure;
use crate::sweep::scene::{EXAMPLE, Hashing, Plan, SceneItem, SceneRun, explain, read_bytes};
use clap::Args;
use std::path::{Path, PathBuf};

/// Compute exactly what a scene asks for, and write it.
///
/// A scene is a TOML file that lists landmarks, arches and claims, with digits, formats and files;
/// --schema prints one with every key. If a scene has errors, all of them are reported and nothing is
/// computed. Results that several items need are computed once. The file couplet-run.json next to the
/// outputs records which a run wrote, and for --resume which are complete; a file that it does not name is not
/// replaced. Nothing is written outside the folder, whatever links it has.
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

    /// Replace files that are there and that no run wrote.
    #[arg(long)]
    overwrite: bool,

    /// Print what would be computed, as a tree, and compute nothing.
    #[arg(long)]
    plan: bool,

    /// Print on standard error, as a tree, what was computed, what each piece cost in processor time and
    /// evaluations, and what was left out and why.
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
    let scene = described(path, read_bytes)?;
    remark(path, &scene.notes);
    let mut folder = RunFolder::open(arguments.output.as_deref(), arguments.overwrite)?;
    let is_complete = |item: &SceneItem| arguments.resume && folder.is_complete(item);
    let complete: Vec<bool> = scene.items.iter().map(is_complete).collect();
    let plan = Plan::new(&scene, complete);
    if arguments.plan {
        return Output::Standard.write(|out| explain(&plan, None, out));
    }
    let items = scene.items.iter().zip(&plan.complete).filter(|(_, complete)| !**complete);
    let outputs: Vec<&Path> = items.filter_map(|(item, _)| item.output.as_deref()).collect();
    folder.prepare(&outputs, path)?;
    carry_out(&plan, &mut folder, arguments.explain)
}

/// Computes and writes one item after the other; each output is noted as soon as it is there.
fn carry_out(plan: &Plan, folder: &mut RunFolder, explained: bool) -> Result<(), Failure> {
    let bar = progress::bar(plan.ticks(), &plan.sizes())?;
    let tick = || bar.inc(1);
    let mut run = SceneRun::new(plan);
    let (mut undecided, mut misfits) = (Vec::new(), Vec::new());
    let mut printed = false;
    for (index, item) in plan.scene.items.iter().enumerate() {
        let path = item.output.as_ref().map(|output| folder.shown(output));
        let tell = |what: &str| {
            if let Some(path) = &path {
                bar.suspend(|| say(&format!("{what} {}", path.display())));
            }
        };
        if plan.complete[index] {
            tell("kept   ");
            continue;
        }
        let report = run.item(index, &tick);
        let placed = |what: &String| match &path {
            Some(path) => format!("{what} in {}", path.display()),
            None => what.clone(),
        };
        undecided.extend(report.undecided.iter().map(placed));
        misfits.extend(report.misfit.iter().map(placed));
        if report.report.is_none() {
            continue;
        }
        let output = match &item.output {
            Some(output) => folder.begin(output)?,
            None => Output::Standard,
        };
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
            if report.undecided.is_empty() {
                folder.note(item, hash)?;
            }
            tell("written");
        }
    }
    bar.finish_and_clear();
    if explained {
        explain_costs(plan, &run)?;
    }
    if !misfits.is_empty() {
        return Err([misfits, undecided].concat().join("; ").into());
    }
    Failure::unless_all("proved", &undecided)
}

/// Prints on standard error what a run has computed, as a tree with the cost of each piece.
fn explain_costs(plan: &Plan, run: &SceneRun) -> Result<(), Failure> {
    let mut tree = Vec::new();
    let written = explain(plan, Some(run.costs()), &mut tree);
    written.map_err(|error| Failure::Io(error.to_string()))?;
    String::from_utf8_lossy(&tree).lines().for_each(say);
    Ok(())
}
