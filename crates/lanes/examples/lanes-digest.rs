//! Digest of the states of many arches, both numbers and radius of each value bit for bit: the same on every processor.

use couplet_check::arch::SelfWeight;
use couplet_lanes::{FromFriction, LaneAnswer, LaneArch, Lanes};
use couplet_number::number::{DoubleDouble, DoubleDoubleBall};
use std::collections::BTreeMap;

/// Hash of Fowler, Noll and Vo, of 64 bits: what differs is seen, and no library is asked for.
struct Digest(u64);

impl Digest {
    fn add(&mut self, x: &DoubleDoubleBall) {
        for byte in x.to_bits().map(u64::to_le_bytes).as_flattened() {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}

fn number(x: f64) -> DoubleDoubleBall {
    DoubleDoubleBall::exact(DoubleDouble::exact(x))
}

/// Arches all over the map, one in twenty without limit of friction.
fn arches(count: usize) -> Vec<LaneArch> {
    let part = |k: usize, step: f64| ((k + 1) as f64 * step).fract();
    let arch = |k| {
        let (x, y) = (part(k, 0.754_877_666), part(k, 0.569_840_291));
        (number(2.8 * x), (k % 20 > 0).then(|| number(4.0 * y)))
    };
    (0..count).map(arch).collect()
}

fn main() {
    let count =
        std::env::args().nth(1).map_or(100_000, |text| text.parse().expect("a number of arches"));
    let mut digest = Digest(0xcbf2_9ce4_8422_2325);
    let mut met: BTreeMap<&str, usize> = BTreeMap::new();
    let arches = arches(count / 2);
    for weight in SelfWeight::ALL {
        for answer in Lanes::of(weight).states(&arches) {
            let mode = match answer {
                None => "open",
                Some(LaneAnswer::Falls) => "falls",
                Some(LaneAnswer::Stands(state)) => {
                    let all = [
                        state.thickness,
                        state.thrust,
                        state.intrinsic_thrust,
                        state.rotation_joint,
                    ];
                    all.iter().chain(&state.sliding_joint).for_each(|x| digest.add(x));
                    state.mode.label()
                }
            };
            *met.entry(mode).or_default() += 1;
        }
        let openings: Vec<_> = arches.iter().map(|(alpha, _)| *alpha).collect();
        for frictions in Lanes::of(weight).frictions(&openings) {
            frictions.sliding.iter().for_each(|x| digest.add(x));
            if let Some(FromFriction::From(x)) = &frictions.rotational {
                digest.add(x);
            }
        }
    }
    println!("{:016x} {met:?}", digest.0);
}
