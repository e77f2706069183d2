//! What a certified landmark costs beside the sines and cosines of its angles, and what one equation
//! costs over each number type.
//!
//! The ratio table is measured side by side in one process on one thread: for each number of digits
//! the jobs take turns, and the least processor times are compared. Nothing is asserted. `MOST_DIGITS=10000` stops the
//! table there.

use couplet::arch::{Ring, SelfWeight, Unknown, thrust};
use couplet::certify::{CertifiedLandmark, Constant};
use couplet::number::{Angle, AstroInterval, Ball, Dual, Real};
use couplet::problem::Landmark;
use cpu_time::ThreadTime;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use rug::{Assign, Float};
use std::hint::black_box;
use std::process::Command;
use std::time::Duration;

const DIGITS: [usize; 5] = [100, 1_000, 10_000, 100_000, 1_000_000];

fn bits(digits: usize) -> u32 {
    couplet::number::bits_of(digits) + 32
}

/// Sines and cosines of the three angles of T by MPFR, of full-length arguments.
fn bare(angles: &[Float]) {
    for angle in angles {
        let (mut sin, mut cos) = (Float::new(angle.prec()), Float::new(angle.prec()));
        (&mut sin, &mut cos).assign(angle.sin_cos_ref());
        black_box((sin, cos));
    }
}

fn angles(point: &CertifiedLandmark, bits: u32) -> Vec<Float> {
    let refined = point.enclosure(bits).unwrap();
    [Unknown::HalfOpening, Unknown::RotationJoint, Unknown::SlidingJoint]
        .map(|unknown| Float::with_val(bits, refined.value(unknown).unwrap().mid()))
        .to_vec()
}

/// All quantities of T as enclosures, without the decimal conversion.
fn enclosures(point: &CertifiedLandmark, bits: u32) {
    let refined = point.enclosure(bits).unwrap();
    for quantity in couplet::certify::quantities(Landmark::Triple) {
        black_box(refined.quantity(quantity));
    }
}

fn decimals(point: &CertifiedLandmark, digits: usize) -> Vec<Constant> {
    point.constants(digits).unwrap()
}

/// The time of this thread's processor alone: what else the machine does counts for little.
fn timed(job: impl FnOnce()) -> Duration {
    let start = ThreadTime::now();
    job();
    start.elapsed()
}

/// The last number of digits of the table.
fn most() -> usize {
    let given = std::env::var("MOST_DIGITS").ok().and_then(|digits| digits.parse().ok());
    given.unwrap_or(usize::MAX)
}

/// The table of ratios: T of Milankovitch's weight, all quantities.
fn ratios() {
    let line = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).output().ok();
        output.map_or_else(String::new, |o| String::from_utf8_lossy(&o.stdout).trim().to_owned())
    };
    let processor = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = processor.lines().find_map(|l| l.strip_prefix("model name")).unwrap_or(": unknown");
    println!("\nT, Milankovitch, all quantities, one thread; MPFR sin_cos of its three angles = 1");
    println!("machine: {}", model.trim_start_matches([' ', '\t', ':']));
    println!("commit:  {}", line("git", &["rev-parse", "--short", "HEAD"]));
    println!("command: cargo bench --bench landmarks\n");
    println!("| digits | sin_cos of 3 angles | enclosures | ratio | with decimals | ratio |");
    println!("|---|---|---|---|---|---|");
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    one_thread.install(|| {
        let point = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Milankovitch).unwrap();
        for digits in DIGITS.into_iter().filter(|&digits| digits <= most()) {
            let bits = bits(digits);
            let angles = angles(&point, bits);
            // The caches of constants are warm for both from here on.
            bare(&angles);
            let rounds = (400_000 / digits).clamp(2, 101);
            let mut times = [Vec::new(), Vec::new(), Vec::new()];
            for _ in 0..rounds {
                times[0].push(timed(|| bare(&angles)));
                times[1].push(timed(|| enclosures(&point, bits)));
                times[2].push(timed(|| drop(black_box(decimals(&point, digits)))));
            }
            let [bare, enclosures, decimals] =
                times.map(|times| times.into_iter().min().unwrap_or_default());
            println!(
                "| {digits} | {bare:.2?} | {enclosures:.2?} | {:.2} | {decimals:.2?} | {:.2} |",
                enclosures.as_secs_f64() / bare.as_secs_f64(),
                decimals.as_secs_f64() / bare.as_secs_f64(),
            );
        }
    });
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap_or(" unknown");
    println!("\npeak memory of the process: {}\n", peak.trim());
}

fn landmarks(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("certify");
    group.sample_size(10);
    group.bench_function("isolate T", |b| {
        b.iter(|| CertifiedLandmark::new(Landmark::Triple, SelfWeight::Milankovitch).unwrap());
    });
    let point = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Milankovitch).unwrap();
    for digits in [30, 1_000, 10_000] {
        group.bench_function(BenchmarkId::new("all quantities of T", digits), |b| {
            b.iter(|| decimals(&point, digits));
        });
    }
    group.finish();
}

/// Eq. (2), sine and cosine included, over each number type.
fn equation(criterion: &mut Criterion) {
    fn lower<T: Real>(beta: &T, eta: &T) -> T {
        let ring = Ring::new(SelfWeight::Milankovitch, eta);
        thrust::lower(&Angle::new(beta.clone()), &ring).value()
    }
    let mut group = criterion.benchmark_group("equation (2)");
    let float = |x: f64| Float::with_val(128, x);
    let ball = |x: f64| Ball::exact(float(x), 128);
    let astro = |x: f64| AstroInterval::between(&float(x), &float(x), 128);
    group.bench_function("f64", |b| b.iter(|| lower(black_box(&1.04), black_box(&0.62))));
    group.bench_function("MPFR, 128 bits", |b| b.iter(|| lower(&float(1.04), &float(0.62))));
    group.bench_function("ball, 128 bits", |b| b.iter(|| lower(&ball(1.04), &ball(0.62))));
    group.bench_function("dual of balls, 128 bits", |b| {
        b.iter(|| lower(&Dual::variable(ball(1.04), 0), &Dual::variable(ball(0.62), 1)));
    });
    group.bench_function("astro-float interval, 128 bits", |b| {
        b.iter(|| lower(&astro(1.04), &astro(0.62)));
    });
    group.finish();
}

fn ratio_table(_: &mut Criterion) {
    ratios();
}

criterion_group!(benches, ratio_table, landmarks, equation);
criterion_main!(benches);
