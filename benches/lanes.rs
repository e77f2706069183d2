//! What rows of doubles cost, proved many at a time: arches of Milankovitch's weight in no order, one thread; processor
//! time, in turns, so that the ratios are those of one run. One by one is what proves every other arch.

use couplet::arch::SelfWeight;
use couplet::certify::batch::{DoubleArches, DoubleUnits};
use couplet::certify::state::{Answer, Balls};
use couplet::lanes::{LaneArch, Lanes, Width};
use couplet::number::{DoubleDouble, DoubleDoubleBall, ExactNumber};
use couplet::problem::{Arch, Friction, Quantity};
use cpu_time::ThreadTime;
use std::hint::black_box;

const ARCHES: usize = 65_536;
const PIECE: usize = 1024;
const ROUNDS: usize = 11;
const M: SelfWeight = SelfWeight::Milankovitch;

/// The processor time of some work, ns an arch, and what it tells.
fn timed<T>(count: usize, work: impl FnOnce() -> T) -> (f64, T) {
    let start = ThreadTime::now();
    let found = black_box(work());
    (start.elapsed().as_secs_f64() * 1e9 / count as f64, found)
}

/// The thicknesses of arches one by one.
fn one_by_one(arches: &DoubleArches, count: usize, frictions: bool) -> Vec<Option<f64>> {
    let exact = |x: f64| ExactNumber::try_from(x).unwrap();
    let thickness = |row: usize| {
        let [alpha, mu] = [arches.half_openings[row], arches.frictions[row]];
        let arch = Arch::new(M, exact(alpha), Friction::Coefficient(exact(mu))).unwrap();
        match Balls::DoubleDoubles.state(&arch, 17, frictions) {
            Ok(Answer::Stands(state)) => Some(state.thickness.double),
            _ => None,
        }
    };
    (0..count).map(thickness).collect()
}

/// Times of some arches: by columns, and by the proofs alone.
fn table(name: &str, [half_openings, frictions]: [&[f64]; 2], quantities: &[Quantity]) {
    let units = DoubleUnits::default();
    let arches = DoubleArches { weight: M, half_openings, frictions, thicknesses: None, units };
    let number = |x: &f64| DoubleDoubleBall::exact(DoubleDouble::exact(*x));
    let in_lanes: Vec<LaneArch> = half_openings
        .iter()
        .zip(frictions)
        .map(|(alpha, mu)| (number(alpha), Some(number(mu))))
        .collect();
    let openings: Vec<_> = in_lanes.iter().map(|(alpha, _)| *alpha).collect();
    let has_frictions = quantities.iter().any(|of| of.is_friction());
    let widths: Vec<Width> = Width::ALL.into_iter().filter(|width| width.is_here()).collect();
    let mut times = vec![Vec::new(); widths.len() + 2];
    let alone = ARCHES / 16;
    for _ in 0..ROUNDS {
        let (time, expected) = timed(alone, || one_by_one(&arches, alone, has_frictions));
        times[0].push(time);
        let (time, columns) = timed(ARCHES, || arches.columns(quantities).unwrap());
        times[1].push(time);
        assert!(expected.iter().enumerate().all(|(row, eta)| columns.double(0, row) == *eta));
        for (width, times) in widths.iter().zip(&mut times[2..]) {
            let lanes = Lanes { weight: M, width: *width };
            let work = || {
                let pieces = in_lanes.chunks(PIECE).zip(openings.chunks(PIECE));
                let proved = pieces.map(|(arches, openings)| {
                    let frictions = has_frictions.then(|| lanes.frictions(openings));
                    black_box(frictions);
                    lanes.states(arches).iter().flatten().count()
                });
                proved.sum::<usize>()
            };
            let (time, proved) = timed(ARCHES, work);
            times.push(time);
            assert!(proved > ARCHES * 9 / 10, "{width:?} {proved}");
        }
    }
    let names = ["one by one", "by columns"].map(str::to_owned);
    let names = names.into_iter().chain(widths.iter().map(|width| format!("lanes: {width:?}")));
    let least = |times: &[f64]| times.iter().copied().fold(f64::INFINITY, f64::min);
    let first = least(&times[0]);
    println!("| {name} | ns an arch | arches a second and core | ratio |\n|---|--:|--:|--:|");
    for (name, times) in names.zip(&times) {
        let time = least(times);
        println!("| {name} | {time:.0} | {:.0} | {:.1} |", 1e9 / time, first / time);
    }
    println!();
}

fn main() {
    use Quantity::{RotationalFriction, SlidingFriction, Thickness};
    let part = |k: usize, step: f64| ((k + 1) as f64 * step).fract();
    let spread = |from: f64, to: f64, step: f64| -> Vec<f64> {
        (0..ARCHES).map(|k| from + (to - from) * part(k, step)).collect()
    };
    let (one, other) = (0.754_877_666_246_692_8, 0.569_840_290_998_053_3);
    table("rotation alone", [&spread(0.3, 2.4, one), &vec![5.0; ARCHES]], &[Thickness]);
    let any = [&spread(0.2, 2.7, one)[..], &spread(0.0, 3.0, other)];
    table("any mode", any, &[Thickness]);
    table("any mode, both frictions", any, &[Thickness, SlidingFriction, RotationalFriction]);
    let wide = [&spread(2.4, 2.65, one)[..], &spread(0.8, 3.0, other)];
    table("wide arches", wide, &[Thickness]);
}
