use super::*;
use crate::arch::SelfWeight;
use crate::number::Dual;
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
        let astray = |_| Err(Undecided::new("forced"));
        for bits in [300, 2500] {
            let plain = refine_by(&isolated, bits, &|| (), astray).unwrap();
            overlap(&isolated, &plain, &refine(&isolated, bits).unwrap());
            let thickness = plain.configuration().half_opening.rad.rad();
            assert!(thickness < Magnitude::power_of_two(-i64::from(bits)));
        }
    }
}

/// Without the steps on the stack the first bits are Newton's.
#[test]
fn the_ladder_stands_without_its_quick_start() {
    let quick = isolated(Landmark::Triple, SelfWeight::Milankovitch);
    let slow = quick.clone().without_approach();
    for bits in [300, 2500] {
        overlap(&quick, &refine(&slow, bits).unwrap(), &refine(&quick, bits).unwrap());
        LadderLevel::new(&slow, bits, &|| ()).unwrap().enclose(&slow).unwrap();
    }
}

/// A box that does not hold the image proves nothing, nor does one beyond the box of uniqueness: then Newton's method
/// at all bits proves the root.
#[test]
fn a_last_step_that_proves_nothing_is_repeated_plainly() {
    let isolated = isolated(Landmark::Triple, SelfWeight::Milankovitch);
    type Spoil = fn(&mut LadderLevel);
    let cases: [(Spoil, &str); 4] = [
        (|level| level.around[1] = level.around[1].midpoint(), "not mapped into itself"),
        (|level| level.centre[2] += 1e-9, "not mapped into itself"),
        (|level| level.around[0] = Ball::whole(64), "leaves the box of uniqueness"),
        (
            |level| {
                // Slopes that say nothing.
                let wide = level.around.iter().map(|x| x.clone() * Ball::integer(9, 64));
                let wide: Vec<Ball> = wide.collect();
                level.jacobian = Eliminated::new(&Dual::variables(&wide)).unwrap();
                level.centre[0] += 1e-30;
            },
            "not mapped into itself",
        ),
    ];
    for (spoil, reason) in cases {
        let spoiled = |bits| {
            let mut level = LadderLevel::new(&isolated, bits, &|| ())?;
            spoil(&mut level);
            Ok(level)
        };
        let undecided = spoiled(600).unwrap().enclose(&isolated).unwrap_err();
        assert!(undecided.to_string().contains(reason), "{undecided}");
        let refined = refine_by(&isolated, 600, &|| (), spoiled).unwrap();
        overlap(&isolated, &refined, &refine(&isolated, 2000).unwrap());
    }
}

/// To the second order: what is left out shows where the way is long.
#[test]
fn angles_moved_back_hold_the_true_ones() {
    let from = Angle::new(Ball::exact(Float::with_val(300, 1.25), 300));
    for far in [3i32, 40, 140, 200] {
        for side in [-1.0, 1.0] {
            let d = Ball::exact(Float::with_val(300, 1.1 * side) >> far, 300);
            let there = back(&from, &d, &(from.rad.clone() - &d));
            let truth = Float::with_val(900, from.rad.mid() - d.mid());
            let truth = Angle::new(Ball::exact(truth, 900));
            assert!(truth.sin.lies_inside(&there.sin) && truth.cos.lies_inside(&there.cos));
            assert!(there.sin.rad() < Magnitude::power_of_two(i64::from(-2 * far).max(-298)));
        }
    }
}

#[test]
fn a_climb_ends_at_its_goal_in_few_stages() {
    for (start, goal) in [(100, 112), (100, 300), (100, 301), (333, 11_000), (33_000, 1_100_000)] {
        let bits = climb(start, goal);
        assert!(bits[0] <= SPAN * start && bits.last() == Some(&goal));
        assert!(bits.windows(2).all(|pair| pair[0] < pair[1] && pair[1] <= SPAN * pair[0]));
    }
    assert!(climb(128, 128).is_empty());
}
