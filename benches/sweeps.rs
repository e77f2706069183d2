//! What a sweep costs beside the library alone: the processor time of a plan swept into a folder, over that of a
//! loop over the same arches which keeps verdict, mode and nearest doubles in memory and writes nothing. Both with
//! two threads, in turns, in one process, so nothing that a process costs to start is in it. Nothing is asserted.
//!
//! | plan | the library alone |
//! |---|---|
//! | a grid of 1,000 x 1,000 | the numbers of both axes are read once from their texts; a [`SharedOpening`] for each half opening, asked for each friction |
//! | a sample of 1,000,000 | the arches are drawn, and each is proved on its own; and beside it without the time in which they are drawn |
//! | a table of 1,000,000 rows | the texts of the same arches, in memory, are read, and each is proved on its own |
//!
//! `doubles` is the loop that `couplet.states` of Python compares with: 100,000 arches of doubles, one thread, each
//! proved on its own, and all of them by columns.

use couplet::Error;
use couplet::arch::SelfWeight;
use couplet::certify::batch::{DoubleArches, DoubleUnits, RowVerdict, SharedOpening};
use couplet::certify::state::{Answer, Certify, Figure};
use couplet::number::ExactNumber;
use couplet::problem::{Arch, Friction, Mode, Quantity};
use couplet::scene::{SweepArches, read_sweep};
use couplet::strategies::samples;
use couplet::sweep::sweep::Sweep;
use cpu_time::{ProcessTime, ThreadTime};
use rayon::ThreadPool;
use rayon::prelude::*;
use rug::Rational;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

const THREADS: usize = 2;
const DIGITS: usize = 17;
/// Half openings and frictions of the grid, and the root of the rows of the others.
const SIDE: usize = 1_000;
/// Arches of a sample that are drawn from one seed.
const BLOCK: usize = 1_000;
const SEED: u64 = 1;
const ROUNDS: usize = 7;

/// What is kept of an arch.
type Kept = (u8, Option<Mode>, f64);

fn kept(answer: Result<&Answer, &Error>) -> Kept {
    match answer {
        Ok(Answer::Stands(state)) => {
            let Figure { double, .. } = state.thickness;
            (0, Some(state.mode), double)
        }
        Ok(Answer::Falls { .. }) => (1, None, f64::NAN),
        Err(_) => (2, None, f64::NAN),
    }
}

fn alone(arch: &Arch) -> Kept {
    kept(arch.certify_alone(DIGITS).as_ref())
}

fn grid(half_openings: &[String], frictions: &[String]) -> Vec<Kept> {
    let frictions: Vec<Friction> = frictions.iter().map(|text| text.parse().unwrap()).collect();
    let column = |text: &String| {
        let half_opening: ExactNumber = text.parse().unwrap();
        let opening = SharedOpening::new(SelfWeight::Milankovitch, half_opening, DIGITS).unwrap();
        let answer = |mu: &Friction| kept(opening.certify(mu.clone(), false).as_deref());
        frictions.iter().map(answer).collect::<Vec<Kept>>()
    };
    half_openings.par_iter().flat_map_iter(column).collect()
}

/// The arches of a block of a sample.
fn drawn(block: usize) -> impl Iterator<Item = Arch> {
    samples(SEED + block as u64, false).take(BLOCK).map(|sample| sample.arch)
}

/// What is kept of a sample, and the processor time that drawing it took.
fn sample(blocks: usize) -> (Vec<Kept>, Duration) {
    let block = |block: usize| {
        let start = ThreadTime::now();
        let arches: Vec<Arch> = drawn(block).collect();
        let drawing = start.elapsed();
        (arches.iter().map(alone).collect::<Vec<Kept>>(), drawing)
    };
    let found: Vec<_> = (0..blocks).into_par_iter().map(block).collect();
    let drawing = found.iter().map(|(_, drawing)| *drawing).sum();
    (found.into_iter().flat_map(|(kept, _)| kept).collect(), drawing)
}

fn table(texts: &[[String; 3]]) -> Vec<Kept> {
    let row = |[weight, alpha, mu]: &[String; 3]| alone(&Arch::parse(weight, alpha, mu).unwrap());
    texts.par_iter().with_min_len(BLOCK).map(row).collect()
}

/// A sweep of a plan from nothing, and how many of its rows have which verdict.
fn sweep(plan: &str, folder: &Path) -> [u64; 4] {
    let (plan, _) = read_sweep(plan.as_bytes()).unwrap_or_else(|_| panic!("the plan is one"));
    let sweep = Sweep::new(plan, folder, folder).unwrap();
    sweep.prepare().unwrap();
    let parts: Vec<usize> = (0..sweep.parts()).collect();
    let part = |&part: &usize| sweep.compute(part).unwrap();
    let add = |mut all: [u64; 4], more: [u64; 4]| {
        all.iter_mut().zip(more).for_each(|(all, more)| *all += more);
        all
    };
    parts.par_iter().with_max_len(1).map(part).reduce(|| [0; 4], add)
}

fn folder() -> PathBuf {
    std::env::temp_dir().join(format!("couplet-sweeps-{}", std::process::id()))
}

/// The processor time of this process for some work in a pool, and what the work has found.
fn timed<T: Send>(pool: &ThreadPool, work: impl FnOnce() -> T + Send) -> (f64, T) {
    let start = ProcessTime::now();
    let found = pool.install(work);
    (start.elapsed().as_secs_f64(), found)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// The library and the sweep in turns; `library` tells the time that its queries took, too.
fn beside(name: &str, plan: &str, library: impl Fn() -> (Vec<Kept>, Duration) + Sync) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(THREADS).build().unwrap();
    let folder = folder();
    let (mut bare, mut proofs, mut swept) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        let (time, (kept, asking)) = timed(&pool, &library);
        bare.push(time);
        proofs.push(time - asking.as_secs_f64());
        let (time, counts) = timed(&pool, || sweep(plan, &folder));
        swept.push(time);
        let count = |verdict: u8| kept.iter().filter(|kept| kept.0 == verdict).count() as u64;
        assert_eq!(counts, [count(0), count(1), count(2), 0], "the same arches");
        for entry in fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() {
                fs::remove_dir_all(entry).unwrap();
            }
        }
    }
    let [bare, proofs, swept] = [bare, proofs, swept].map(median);
    let microseconds = |time: f64| 1e6 * time / (SIDE * SIDE) as f64;
    println!(
        "| {name} | {:.3} | {:.3} | {:.3} | {:.3} | {:.3} |",
        microseconds(proofs),
        microseconds(bare),
        microseconds(swept),
        swept / bare,
        swept / proofs
    );
}

/// The processor times of arches of doubles, one by one and by columns, in microseconds each.
fn doubles() -> [f64; 2] {
    const ROWS: usize = 100_000;
    let spread = |step: f64, most: f64| {
        (1..=ROWS).map(|place| most * (place as f64 * step).fract()).collect::<Vec<f64>>()
    };
    let (alphas, mus) = (spread(0.754_877_666, 2.648), spread(0.569_840_291, 5.0));
    let weight = SelfWeight::Milankovitch;
    let exact = |x: f64| ExactNumber::from(&Rational::from_f64(x).unwrap());
    let arch = |(alpha, mu): (&f64, &f64)| {
        alone(&Arch::new(weight, exact(*alpha), Friction::Coefficient(exact(*mu))).unwrap())
    };
    let (half_openings, frictions, units) = (&alphas, &mus, DoubleUnits::default());
    let arches = DoubleArches { weight, half_openings, frictions, thicknesses: None, units };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let turn = |_: usize| {
        let (looped, kept) =
            timed(&pool, || alphas.iter().zip(&mus).map(arch).collect::<Vec<Kept>>());
        let (together, found) = timed(&pool, || arches.columns(&[Quantity::Thickness]).unwrap());
        let same = |(kept, verdict): (&Kept, &RowVerdict)| kept.0 == *verdict as u8;
        assert!(kept.iter().zip(&found.verdicts).all(same), "the same arches");
        [looped, together]
    };
    let turns: Vec<[f64; 2]> = (0..ROUNDS).map(turn).collect();
    [0, 1].map(|which| 1e6 * median(turns.iter().map(|turn| turn[which]).collect()) / ROWS as f64)
}

fn main() {
    let asked = std::env::args().skip(1).find(|name| !name.starts_with('-'));
    let asks = |name: &str| asked.as_deref().is_none_or(|asked| asked == name);
    let folder = folder();
    fs::create_dir_all(&folder).unwrap();
    println!("Medians of {ROUNDS} turns, {THREADS} threads, microseconds of processor time a row");
    println!(
        "| plan | library, asked | library | sweep | sweep / library | sweep / asked |\n|---|---|---|---|---|---|"
    );
    let head = "schema = \"couplet.sweep/1\"\n";
    if asks("grid") {
        let plan = format!(
            "{head}[grid]\nhalf_opening = {{ from = \"20deg\", to = \"140deg\", steps = {SIDE} }}\n\
             friction = {{ from = 0.02, to = 2, steps = {SIDE} }}\n"
        );
        let (read, _) = read_sweep(plan.as_bytes()).unwrap_or_else(|_| panic!("the plan is one"));
        let SweepArches::Grid { half_opening, friction } = read.arches else { panic!() };
        let half_openings: Vec<String> = half_opening.iter().map(ToString::to_string).collect();
        let frictions: Vec<String> = friction.iter().map(ToString::to_string).collect();
        beside("grid", &plan, || (grid(&half_openings, &frictions), Duration::ZERO));
    }
    if asks("sample") {
        let plan = format!("{head}[sample]\ncount = {}\nseed = {SEED}\n", SIDE * SIDE);
        beside("sample", &plan, || sample(SIDE * SIDE / BLOCK));
    }
    if asks("table") {
        let arches = (0..SIDE * SIDE / BLOCK).flat_map(drawn);
        let text = |arch: Arch| {
            let numbers = [arch.half_opening().to_string(), arch.friction().to_string()];
            let [alpha, mu] = numbers;
            [arch.weight().name().to_owned(), alpha, mu]
        };
        let texts: Vec<[String; 3]> = arches.map(text).collect();
        let mut csv = "weight,half_opening,friction\n".to_owned();
        texts
            .iter()
            .for_each(|[weight, alpha, mu]| writeln!(csv, "{weight},{alpha},{mu}").unwrap());
        fs::write(folder.join("arches.csv"), csv).unwrap();
        let plan = format!("{head}[data]\nfiles = \"arches.csv\"\n");
        beside("table", &plan, || (table(&texts), Duration::ZERO));
    }
    fs::remove_dir_all(&folder).unwrap();
    if asks("doubles") {
        let [looped, together] = doubles();
        println!("\nDoubles, one thread: {looped:.3} one by one, {together:.3} by columns");
    }
}
