//! What a state costs: proved to 16 digits, in balls of doubles, and as a quick look in doubles, by mode and over a
//! random mix; and beside balls of MPFR alone, in turns.

use couplet::arch::SelfWeight;
use couplet::certify::batch::SharedOpenings;
use couplet::certify::state::{Answer, Balls, Certify, Inquiry, Outcome};
use couplet::number::ExactNumber;
use couplet::problem::{Arch, Friction, tally};
use couplet::solve::start::quick_state;
use cpu_time::ThreadTime;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::collections::BTreeMap;
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

/// Half openings with frictions over the same, each with each.
fn grid_of_arches() -> Vec<Arch> {
    const HALF_OPENINGS: u32 = 25;
    const FRICTIONS: u32 = 40;
    let part =
        |most: f64, place: u32, of: u32| format!("{:.15}", most * f64::from(place) / f64::from(of));
    let row = |alpha| (1..=FRICTIONS).map(move |mu| (alpha, mu));
    let places = (1..=HALF_OPENINGS).flat_map(row);
    places
        .map(|(alpha, mu)| arch(M, &part(2.648, alpha, HALF_OPENINGS), &part(5.0, mu, FRICTIONS)))
        .collect()
}

/// The same as they are typed.
fn mix_of_texts() -> Vec<(String, String)> {
    let text = |(alpha, mu)| (format!("{alpha:.15}"), format!("{mu:.15}"));
    mix(1000).into_iter().map(text).collect()
}

fn mix_of_arches() -> Vec<Arch> {
    mix_of_texts().iter().map(|(alpha, mu)| arch(M, alpha, mu)).collect()
}

fn states(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("state, 16 digits");
    for (mode, half_opening, friction) in CASES {
        let arch = arch(M, half_opening, friction);
        group.bench_function(BenchmarkId::new("proved", mode), |b| {
            b.iter(|| arch.certify(16).unwrap());
        });
    }
    let queries = mix_of_arches();
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
    let grid = grid_of_arches();
    group.bench_function("proved, grid", |b| {
        b.iter(|| {
            let openings = SharedOpenings::new(Balls::DoubleDoubles, 16, true).unwrap();
            grid.iter().filter(|q| matches!(openings.state(q), Ok(Answer::Stands(_)))).count()
        });
    });
    group.bench_function("proved, grid, each alone", |b| {
        b.iter(|| grid.iter().filter(|q| matches!(q.certify(16), Ok(Answer::Stands(_)))).count());
    });
    group.bench_function("in balls of doubles, mix", |b| {
        b.iter(|| {
            let stands = |q: &&Arch| matches!(q.state_in_doubles(), Ok(Outcome::Stands(_)));
            queries.iter().filter(stands).count()
        });
    });
    let texts = mix_of_texts();
    group.bench_function("read, mix", |b| {
        b.iter(|| {
            texts.iter().for_each(|(alpha, mu)| drop(black_box(arch(M, alpha, mu))));
        });
    });
    group.finish();
    beside_mpfr(&queries);
}

/// The mode, or why nothing stands.
fn name(answer: &Answer) -> String {
    match answer {
        Answer::Stands(state) => state.mode.to_string(),
        Answer::Falls { fall, .. } => format!("falls, {fall:?}").to_lowercase(),
    }
}

/// The mix in turns with balls of MPFR alone: the least CPU time of several rounds of each query, and how many are
/// decided without MPFR.
fn beside_mpfr(queries: &[Arch]) {
    const ROUNDS: usize = 5;
    // So many digits ask for more bits of MPFR than a double-double has, which tells the two apart.
    const TOLD: usize = 18;
    fn least(times: &mut f64, job: impl FnOnce()) {
        let start = ThreadTime::now();
        job();
        *times = times.min(start.elapsed().as_secs_f64());
    }
    let mut rows: BTreeMap<String, (usize, usize, [f64; 3])> = BTreeMap::new();
    for arch in queries {
        let mut times = [f64::INFINITY; 3];
        for _ in 0..ROUNDS {
            least(&mut times[0], || drop(black_box(arch.certify(16))));
            least(&mut times[1], || drop(black_box(Inquiry::new(arch, 16, true).state(16, true))));
            least(&mut times[2], || drop(black_box(arch.state_in_doubles())));
        }
        let (_, cost) = tally::measure(|| arch.certify(TOLD).unwrap());
        let quickly = usize::from(cost.working_bits <= 106);
        let of = [name(&arch.certify(16).unwrap()), "all".into()];
        for name in of {
            let row = rows.entry(name).or_default();
            row.0 += 1;
            row.1 += quickly;
            row.2.iter_mut().zip(times).for_each(|(sum, time)| *sum += time);
        }
    }
    println!(
        "mix, microseconds of CPU        number  without MPFR  16 digits   MPFR  ratio  doubles"
    );
    for (name, (count, quickly, times)) in rows {
        let [quick, mpfr, doubles] = times.map(|time| 1e6 * time / count as f64);
        let ratio = mpfr / quick;
        println!(
            "{name:30} {count:7} {quickly:13} {quick:10.2} {mpfr:6.0} {ratio:6.1} {doubles:8.2}"
        );
    }
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
