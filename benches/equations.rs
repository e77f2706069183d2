//! What one evaluation of each equation costs, by number type and precision; and what a ball costs beside
//! the MPFR number in it.

use couplet::arch::{Ring, SelfWeight, cubic, overturning, sliding, thrust};
use couplet::number::{Angle, AstroInterval, Ball, Dual, Real};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use rug::Float;
use std::hint::black_box;

/// Every equation once, at an ordinary joint, half opening, thickness and thrust. Sines and cosines are
/// computed before: they are measured beside.
fn equations<T: Real>(criterion: &mut Criterion, name: &str, like: &T) {
    let (joint, alpha) = (Angle::new(like.ratio(19, 20)), Angle::new(like.ratio(12, 5)));
    let (eta, h, mu) = (like.ratio(3, 10), like.ratio(1, 5), like.ratio(6, 5));
    let delta = like.int(1);
    let ring = Ring::new(SelfWeight::Milankovitch, &eta);
    let letters = cubic::abbreviations(&joint);
    let mut group = criterion.benchmark_group(format!("equations, {name}"));
    group.sample_size(20);
    let mut bench = |label: &str, job: &dyn Fn() -> T| {
        group.bench_function(label, |b| b.iter(|| black_box(job())));
    };
    bench("sine and cosine", &|| joint.rad.sin_cos().0);
    bench("(2)", &|| thrust::lower(&joint, &ring).value());
    bench("(3)", &|| thrust::upper(&alpha, &joint, &ring).value());
    bench("(4)", &|| thrust::whole(&alpha, &ring).value());
    bench("(5)", &|| thrust::tangency(&joint.times_cotangent(), &ring).value());
    bench("(7) in A", &|| cubic::in_opening_variable(&letters, &delta, &h));
    bench("(7) in eta", &|| cubic::in_thickness(&letters, &delta, &eta));
    bench("(7) in h", &|| cubic::in_thrust(&letters, &delta, &h));
    bench("(8)", &|| cubic::link(&joint));
    bench("(12)", &|| cubic::radicand(&letters, &delta));
    bench("(13)", &|| overturning::opening_variable(&ring).value());
    bench("(15)", &|| overturning::thickness(SelfWeight::Milankovitch, &delta));
    bench("(17)", &|| sliding::shoulder(&alpha, &h).value());
    bench("(17) for h", &|| sliding::shoulder_thrust(&alpha, &mu).value());
    bench("(18)", &|| sliding::inner(&joint, &h).value());
}

fn by_number_type(criterion: &mut Criterion) {
    equations(criterion, "double", &1.0);
    for bits in [128u32, 1024] {
        equations(criterion, &format!("MPFR {bits}"), &Float::with_val(bits, 1));
        equations(criterion, &format!("ball {bits}"), &Ball::integer(1, bits));
        let dual = Dual::variable(Ball::integer(1, bits), 0);
        equations(criterion, &format!("dual of balls {bits}"), &dual);
    }
    equations(criterion, "astro-float 128", &AstroInterval::integer(1, 128));
}

/// The four operations, by balls and by MPFR.
fn operations(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("operations");
    group.sample_size(30);
    for bits in [64u32, 256, 1024, 4096, 16_384] {
        let (x, y) = (Float::with_val(bits, 2).sqrt(), Float::with_val(bits, 3).sqrt());
        let (a, b) = (Ball::integer(2, bits).sqrt(), Ball::integer(3, bits).sqrt());
        group.bench_function(BenchmarkId::new("MPFR *", bits), |c| {
            c.iter(|| black_box(x.clone() * &y));
        });
        group.bench_function(BenchmarkId::new("ball *", bits), |c| {
            c.iter(|| black_box(a.clone() * &b));
        });
        group.bench_function(BenchmarkId::new("MPFR /", bits), |c| {
            c.iter(|| black_box(x.clone() / &y));
        });
        group.bench_function(BenchmarkId::new("ball /", bits), |c| {
            c.iter(|| black_box(a.clone() / &b));
        });
        group.bench_function(BenchmarkId::new("MPFR +", bits), |c| {
            c.iter(|| black_box(x.clone() + &y));
        });
        group.bench_function(BenchmarkId::new("ball +", bits), |c| {
            c.iter(|| black_box(a.clone() + &b));
        });
    }
    group.finish();
}

criterion_group!(benches, by_number_type, operations);
criterion_main!(benches);
