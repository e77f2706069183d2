//! Many roots of the equations with right witnesses, and the one that is meant.

use super::originals::{find_root, is_near, landmark_problem, root, state_problem, to_value};
use crate::hard::random;
use couplet::arch::{SelfWeight, Unknown};
use couplet::certify::certify_landmark;
use couplet::check::{Refusal, check_certificate};
use couplet::number::Ball;
use couplet::problem::{Landmark, Mode, Problem};
use std::collections::BTreeSet;

/// Newton's method from many starts finds many roots, all with right witnesses; the only one that is
/// accepted is the one that is meant.
#[test]
fn of_all_the_roots_one_is_accepted() {
    let mut random = random(1);
    let mut problems: Vec<(Problem, usize)> = Vec::new();
    for weight in SelfWeight::ALL {
        problems.extend(Landmark::ALL.map(|landmark| (landmark_problem(landmark, weight), 40)));
        let modes =
            Mode::ALL.into_iter().filter(|mode| !matches!(mode, Mode::Sliding | Mode::Overturning));
        for (half_opening, friction) in
            [("pi/2", "0.38"), ("2.45", "1.35"), ("2.6", "2"), ("3", "50"), ("2.9", "0.3")]
        {
            problems.extend(
                modes.clone().map(|mode| (state_problem(weight, mode, half_opening, friction), 12)),
            );
        }
    }
    let (mut refused, mut accepted, mut reasons) = (0, 0, BTreeSet::new());
    for (problem, starts) in &problems {
        let mut known: Option<Vec<f64>> = None;
        for _ in 0..*starts {
            let alpha = 1.5 + 1.6 * random();
            let start = problem.system().unknowns.iter().map(|unknown| match unknown {
                Unknown::HalfOpening => alpha,
                Unknown::RotationJoint | Unknown::SlidingJoint => alpha * random() / 2.0,
                Unknown::Thickness => 2.0 * random(),
                Unknown::Thrust => random(),
                Unknown::Friction => 3.0 * random(),
                other => panic!("{other:?} is of no symmetric state"),
            });
            let start: Vec<f64> = start.collect();
            let Some(certificate) = find_root(problem, &start) else { continue };
            // Without a value everything else is examined.
            match check_certificate::<Ball>(&certificate, 5) {
                Err(Refusal::NoValues) => {
                    accepted += 1;
                    let root = root(&to_value(&certificate));
                    let known = known.get_or_insert_with(|| root.clone());
                    is_near(known, &root, 1e-12);
                }
                Err(Refusal::Condition(words)) => {
                    refused += 1;
                    reasons.insert(words);
                }
                other => assert!(other.is_err(), "{problem:?} {other:?}"),
            }
        }
        if let (Problem::Landmark { landmark, weight }, Some(root)) = (problem, &known) {
            let certified = certify_landmark(*landmark, *weight, 12).unwrap();
            let expected = self::root(&to_value(&certified));
            is_near(root, &expected, 1e-11);
        }
    }
    assert!(refused > 200 && accepted > 200, "{refused} {accepted}");
    let words = ["a positive thickness", "a thrust below one", "a positive thrust"];
    assert!(words.iter().all(|words| reasons.contains(*words)), "{reasons:?}");
}
