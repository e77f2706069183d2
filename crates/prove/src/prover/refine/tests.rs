use super::*;
use crate::arch::SelfWeight;
use crate::number::{Enclosure, Magnitude};
use crate::problem::Landmark;
use crate::prover::isolate::isolate;
use crate::solve::start;

fn isolated(landmark: Landmark, weight: SelfWeight) -> Isolated {
    let system = landmark.system(weight);
    let candidate = crate::solve::newton(&system, start::landmark(landmark, weight), 64);
    isolate(landmark, weight, &candidate.unwrap()).unwrap()
}

fn all() -> impl Iterator<Item = Isolated> {
    Landmark::ALL.into_iter().flat_map(|landmark| {
        SelfWeight::ALL.into_iter().map(move |weight| isolated(landmark, weight))
    })
}

fn overlap(isolated: &Isolated, a: &Refined, b: &Refined) {
    for &unknown in isolated.system().unknowns {
        let (a, b) = (a.value(unknown).unwrap(), b.value(unknown).unwrap());
        assert!(a.overlaps(&b), "{unknown:?} {a:?} {b:?}");
    }
    let (a, b) = (a.friction_angle(), b.friction_angle());
    assert!(a.zip(b).is_none_or(|(a, b)| a.overlaps(&b)));
}

#[test]
fn precisions_overlap_and_have_the_bits_asked_for() {
    for isolated in all() {
        let sizes = [256, 700, 1061, 5000, 12_000];
        let refined = sizes.map(|bits| refine(&isolated, bits).unwrap());
        for (bits, one) in sizes.into_iter().zip(&refined) {
            overlap(&isolated, one, &refined[4]);
            for &unknown in isolated.system().unknowns {
                let value = one.value(unknown).unwrap();
                assert!(value.rad() < Magnitude::power_of_two(-i64::from(bits)), "{value:?}");
            }
        }
    }
}

/// By MPFR's sines and the Jacobian at all bits: another way to the same root.
#[test]
fn the_ladder_and_plain_newton_overlap() {
    for isolated in all() {
        for bits in [300, 2500] {
            let plain = plainly(&isolated, bits).unwrap();
            assert!(plain.half_opening.rad.rad() < Magnitude::power_of_two(-i64::from(bits)));
            let plain = Refined::new(*isolated.system(), plain);
            overlap(&isolated, &plain, &refine(&isolated, bits).unwrap());
        }
    }
}
