//! What a purely rotational state in doubles costs, many at a time: 16,384 arches of Milankovitch's weight, half
//! openings from 0.3 to 2.4 and a friction of 5, one thread; processor time, in turns, so that the ratios are those of
//! one run. One by one is what proves every other arch.

use couplet::arch::SelfWeight;
use couplet::certify::batch::DoubleArches;
use couplet::certify::state::{Answer, Certify};
use couplet::lanes::Width;
use couplet::number::ExactNumber;
use couplet::problem::{Arch, Friction, Quantity};
use cpu_time::ThreadTime;
use std::hint::black_box;

const ARCHES: usize = 16_384;
const ROUNDS: usize = 21;
const M: SelfWeight = SelfWeight::Milankovitch;

/// The processor time of some work, ns an arch, and what it tells.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = ThreadTime::now();
    let found = black_box(work());
    (start.elapsed().as_secs_f64() * 1e9 / ARCHES as f64, found)
}

/// The thicknesses of arches one by one.
fn one_by_one(half_openings: &[f64], frictions: &[f64]) -> Vec<Option<f64>> {
    let exact = |x: &f64| ExactNumber::try_from(*x).unwrap();
    let thickness = |(alpha, mu)| {
        let arch = Arch::new(M, exact(alpha), Friction::Coefficient(exact(mu))).unwrap();
        match arch.certify_alone(17) {
            Ok(Answer::Stands(state)) => Some(state.thickness.double),
            _ => None,
        }
    };
    half_openings.iter().zip(frictions).map(thickness).collect()
}

fn main() {
    let part = |k: usize| ((k + 1) as f64 * 0.754_877_666_246_692_8).fract();
    let half_openings: Vec<f64> = (0..ARCHES).map(|k| 0.3 + 2.1 * part(k)).collect();
    let frictions = vec![5.0; ARCHES];
    let arches = DoubleArches {
        weight: M,
        half_openings: &half_openings,
        frictions: &frictions,
        thicknesses: None,
    };
    let widths: Vec<Width> = Width::ALL.into_iter().filter(|width| width.is_here()).collect();
    let mut times = vec![Vec::new(); widths.len() + 2];
    for _ in 0..ROUNDS {
        let (time, expected) = timed(|| one_by_one(&half_openings, &frictions));
        times[0].push(time);
        let (time, rows) = timed(|| arches.rows(&[Quantity::Thickness]).unwrap());
        times[1].push(time);
        assert!(rows.iter().zip(&expected).all(|(row, eta)| Some(row.doubles(0)[0]) == *eta));
        for (width, times) in widths.iter().zip(&mut times[2..]) {
            let (time, states) = timed(|| width.rotational(M, &half_openings, &frictions));
            times.push(time);
            let same = |(state, eta): (&Option<_>, &Option<f64>)| {
                let state: &Option<couplet::lanes::RotationalState> = state;
                state.as_ref().and_then(|state| state.thickness.nearest_double()) == *eta
            };
            assert!(states.iter().zip(&expected).all(same), "{width:?}");
        }
    }
    let names = ["one by one", "as rows, with the thickness"].map(str::to_owned);
    let names = names.into_iter().chain(widths.iter().map(|width| format!("lanes: {width:?}")));
    let least = |times: &[f64]| times.iter().copied().fold(f64::INFINITY, f64::min);
    let first = least(&times[0]);
    println!(
        "| {ARCHES} arches | ns an arch | arches a second and core | ratio |\n|---|--:|--:|--:|"
    );
    for (name, times) in names.zip(&times) {
        let time = least(times);
        println!("| {name} | {time:.0} | {:.0} | {:.1} |", 1e9 / time, first / time);
    }
}
