//! Hard arches in all the lanes that this machine has.

use crate::tool::skipped;
use couplet::arch::SelfWeight;
use couplet::certify::batch::SharedOpening;
use couplet::lanes::{LaneArch, Lanes, Width};
use couplet::strategies::samples;

/// No bit depends on how many arches go through a proof at a time; what this processor lacks is named.
#[test]
fn hard_arches_have_the_same_bits_in_all_lanes() {
    let arches = samples(1, true).take(4_000).map(|of| SharedOpening::enclosed_arch(&of.arch));
    let arches: Vec<LaneArch> = arches.collect();
    for weight in SelfWeight::ALL {
        // In this form two doubles are the same text if they are the same bits.
        let found = |width| {
            let answers = Lanes { weight, width }.states(&arches).into_iter();
            answers.map(|answer| format!("{answer:?}")).collect::<Vec<_>>()
        };
        let any = found(Width::Any);
        let is_proved = any.iter().filter(|answer| answer.starts_with("Some")).count();
        assert!(is_proved > 400 && is_proved < 4_000, "{is_proved}");
        for width in [Width::Four, Width::Eight].into_iter().filter(|width| width.is_here()) {
            assert!(found(width) == any, "{width:?}");
        }
    }
    for (width, what) in [(Width::Four, "AVX2"), (Width::Eight, "AVX-512 and Rust 1.89")] {
        if !width.is_here() {
            skipped(&format!("{width:?} lanes beside one, bit for bit; they need {what}"));
        }
    }
}
