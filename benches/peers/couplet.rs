//! couplet's side of the comparison with its peers: `run.py` in this folder calls it, as it calls them.
//!
//!     couplet.rs METHOD DIGITS     warm up, time, one line of JSON
//!
//! One thread; CPU time.

use couplet::arch::{SelfWeight, Unknown};
use couplet::certify::{CertifiedLandmark, Constant, Value, quantities};
use couplet::number::bits_of;
use couplet::problem::Landmark;
use couplet::solve::{newton, start};
use cpu_time::ProcessTime;
use rug::Float;
use std::hint::black_box;

const WEIGHT: SelfWeight = SelfWeight::Milankovitch;
const GUARD: u32 = 32;

// As in harness.py.
const SAMPLE: f64 = 0.05;
const SAMPLES: usize = 7;
const BUDGET: f64 = 60.0;

/// CPU seconds of the process, all threads.
fn cpu(job: &dyn Fn(), calls: usize) -> f64 {
    let start = ProcessTime::now();
    (0..calls).for_each(|_| job());
    start.elapsed().as_secs_f64()
}

/// The median CPU time of a call, after a call to warm up.
fn measure(job: &dyn Fn()) -> f64 {
    job();
    let mut calls = 1;
    while cpu(job, calls) < SAMPLE {
        calls *= 2;
    }
    let mut samples = Vec::new();
    while samples.len() < SAMPLES && samples.iter().sum::<f64>() < BUDGET {
        samples.push(cpu(job, calls));
    }
    samples.sort_by(f64::total_cmp);
    samples[samples.len() / 2] / calls as f64
}

fn triple() -> CertifiedLandmark {
    CertifiedLandmark::new(Landmark::Triple, WEIGHT).unwrap()
}

/// The six unknowns in the order of the peers.
fn unknowns(constants: &[Constant]) -> Vec<String> {
    let system = Landmark::Triple.system(WEIGHT);
    let value = |unknown: &Unknown| {
        let named = |constant: &&Constant| constant.quantity.name() == unknown.name();
        match &constants.iter().find(named).unwrap().value {
            Value::Finite(rounded) => rounded.value.to_string(),
            Value::Infinite => unreachable!(),
        }
    };
    system.unknowns.iter().map(value).collect()
}

fn angles(point: &CertifiedLandmark, bits: u32) -> Vec<Float> {
    let refined = point.enclosure(bits).unwrap();
    [Unknown::HalfOpening, Unknown::RotationJoint, Unknown::SlidingJoint]
        .map(|unknown| Float::with_val(bits, refined.value(unknown).unwrap().mid()))
        .to_vec()
}

fn main() {
    let arguments: Vec<String> =
        std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let [method, digits] = arguments.as_slice() else {
        println!("peers: the comparison with other programs is benches/peers/run.py (make peers)");
        return;
    };
    let digits: usize = digits.parse().unwrap();
    let bits = bits_of(digits) + GUARD;
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let (seconds, values) = one_thread.install(|| match method.as_str() {
        "isolate" => (measure(&|| drop(black_box(triple()))), None),
        "enclosure" => {
            let point = triple();
            let seconds = measure(&|| drop(black_box(point.enclosure(bits).unwrap())));
            (seconds, Some(unknowns(&point.constants(digits).unwrap())))
        }
        "enclosures" => {
            let point = triple();
            let quantities = || {
                let enclosed = point.enclosure(bits).unwrap();
                quantities(point.landmark()).for_each(|q| drop(black_box(enclosed.quantity(q))));
            };
            (measure(&quantities), Some(unknowns(&point.constants(digits).unwrap())))
        }
        "constants" => {
            let point = triple();
            let constants = || point.constants(digits).unwrap();
            (measure(&|| drop(black_box(constants()))), Some(unknowns(&constants())))
        }
        // All that `couplet constants T` does but start and print.
        "everything" => {
            let constants = || triple().constants(digits).unwrap();
            (measure(&|| drop(black_box(constants()))), Some(unknowns(&constants())))
        }
        "newton" => {
            let system = Landmark::Triple.system(WEIGHT);
            let root = || newton(&system, start::landmark(Landmark::Triple, WEIGHT), 64).unwrap();
            let values = root().0.iter().map(|x| x.to_f64().to_string()).collect();
            (measure(&|| drop(black_box(root()))), Some(values))
        }
        "bare" => {
            let angles = angles(&triple(), bits);
            let sines = || angles.iter().map(|x| x.clone().sin_cos(Float::new(bits))).collect();
            (measure(&|| drop(black_box::<Vec<_>>(sines()))), None)
        }
        other => panic!("no method {other}"),
    });
    let result = serde_json::json!({ "seconds": seconds, "warm": true, "values": values });
    println!("{result}");
}
