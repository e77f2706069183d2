//! What a state costs: proved to 16 digits and as a quick look in doubles, by mode and over a random mix.

use couplet::arch::SelfWeight;
use couplet::certify::state::{Answer, Certify};
use couplet::number::ExactNumber;
use couplet::problem::{Arch, Friction};
use couplet::solve::start::quick_state;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;

const M: SelfWeight = SelfWeight::Milankovitch;

/// One arch for each mode, and two that do not stand.
const CASES: [(&str, &str, &str); 8] = [
    ("[r,r,r]", "2", "1.5"),
    ("[s,r,r]", "2.3", "1.05"),
    ("[r,r,s]", "2.45", "1.35"),
    ("[r,s,r]", "2.533", "1.545"),
    ("[r,s]", "2.57", "1.75"),
    ("[r]", "2.62", "inf"),
    ("slides", "2.6", "0.3"),
    ("too thick", "2.65", "5"),
];

fn arch(weight: SelfWeight, half_opening: &str, friction: &str) -> Arch {
    let number = |text: &str| text.parse::<ExactNumber>().unwrap();
    let friction = match friction {
        "inf" => Friction::Infinite,
        mu => Friction::Coefficient(number(mu)),
    };
    Arch::new(weight, number(half_opening), friction).unwrap()
}

/// Equidistributed queries over `(0, 2.648) x (0, 5)`.
fn mix(count: usize) -> Vec<(f64, f64)> {
    let golden = |i: usize, step: f64| (i as f64 * step).fract();
    (1..=count)
        .map(|i| (2.648 * golden(i, 0.754_877_666), 5.0 * golden(i, 0.569_840_291)))
        .collect()
}

fn states(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("state, 16 digits");
    for (mode, half_opening, friction) in CASES {
        let arch = arch(M, half_opening, friction);
        group.bench_function(BenchmarkId::new("proved", mode), |b| {
            b.iter(|| arch.certify(16).unwrap());
        });
    }
    let queries: Vec<Arch> = mix(1000)
        .into_iter()
        .map(|(alpha, mu)| arch(M, &format!("{alpha:.15}"), &format!("{mu:.15}")))
        .collect();
    group.sample_size(10).throughput(Throughput::Elements(queries.len() as u64));
    group.bench_function("proved, mix", |b| {
        b.iter(|| {
            queries.iter().filter(|q| matches!(q.certify(16), Ok(Answer::Stands(_)))).count()
        });
    });
    group.bench_function("proved alone, mix", |b| {
        b.iter(|| {
            let stands = |q: &&Arch| matches!(q.certify_alone(16), Ok(Answer::Stands(_)));
            queries.iter().filter(stands).count()
        });
    });
    group.finish();
}

fn quick(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("state, doubles");
    let queries = mix(1000);
    group.throughput(Throughput::Elements(queries.len() as u64));
    group.bench_function("quick look, mix", |b| {
        b.iter(|| {
            queries
                .iter()
                .filter(|(a, mu)| quick_state(M, black_box(*a), *mu).mode.is_some())
                .count()
        });
    });
    for (mode, alpha, mu) in [
        ("[r,r,r]", 2.0, 1.5),
        ("[s,r,r]", 2.3, 1.05),
        ("[r,r,s]", 2.45, 1.35),
        ("[r,s]", 2.57, 1.75),
    ] {
        group.throughput(Throughput::Elements(1));
        group.bench_function(BenchmarkId::new("quick look", mode), |b| {
            b.iter(|| quick_state(M, black_box(alpha), black_box(mu)));
        });
    }
    group.finish();
}

criterion_group!(benches, states, quick);
criterion_main!(benches);
