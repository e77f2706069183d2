//! What one evaluation of each equation costs, by number type and precision; and what a ball costs beside
//! the MPFR number in it.

use couplet::arch::{Ring, SelfWeight, cubic, overturning, sliding, thrust};
use couplet::number::{Angle, AstroInterval, Ball, Real};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use rug::Float;
use std::hint::black_box;
use std::time::Duration;

/// The operations are short: these times have thousands of them.
const WARM_UP: Duration = Duration::from_millis(50);
const MEASURED: Duration = Duration::from_millis(150);

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
    group.warm_up_time(WARM_UP).measurement_time(MEASURED);
    let mut bench = |label: &str, job: &dyn Fn() -> T| {
        group.bench_function(label, |b| b.iter(|| black_box(job())));
    };
    bench("sine and cosine", &|| black_box(&joint).rad.sin_cos().0);
    bench("(2)", &|| thrust::lower(black_box(&joint), black_box(&ring)).value());
    bench("(3)", &|| thrust::upper(black_box(&alpha), black_box(&joint), black_box(&ring)).value());
    bench("(4)", &|| thrust::whole(black_box(&alpha), black_box(&ring)).value());
    bench("(5)", &|| {
        thrust::tangency(&black_box(&joint).times_cotangent(), black_box(&ring)).value()
    });
    bench("(7) in A", &|| {
        cubic::in_opening_variable(black_box(&letters), black_box(&delta), black_box(&h))
    });
    bench("(7) in eta", &|| {
        cubic::in_thickness(black_box(&letters), black_box(&delta), black_box(&eta))
    });
    bench("(7) in h", &|| cubic::in_thrust(black_box(&letters), black_box(&delta), black_box(&h)));
    bench("(8)", &|| cubic::link(black_box(&joint)));
    bench("(12)", &|| cubic::radicand(black_box(&letters), black_box(&delta)));
    bench("(13)", &|| overturning::opening_variable(black_box(&ring)).value());
    bench("(15)", &|| overturning::thickness(SelfWeight::Milankovitch, black_box(&delta)));
    bench("(17)", &|| sliding::shoulder(black_box(&alpha), black_box(&h)).value());
    bench("(17) for h", &|| sliding::shoulder_thrust(black_box(&alpha), black_box(&mu)).value());
    bench("(18)", &|| sliding::inner(black_box(&joint), black_box(&h)).value());
}

fn by_number_type(criterion: &mut Criterion) {
    equations(criterion, "double", &1.0);
    for bits in [128u32, 1024] {
        equations(criterion, &format!("MPFR {bits}"), &Float::with_val(bits, 1));
        equations(criterion, &format!("ball {bits}"), &Ball::integer(1, bits));
    }
    equations(criterion, "astro-float 128", &AstroInterval::integer(1, 128));
}

/// The four operations, by balls and by MPFR.
fn operations(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("operations");
    group.sample_size(20);
    group.warm_up_time(WARM_UP).measurement_time(MEASURED);
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
