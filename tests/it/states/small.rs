//! Small openings, where the thickness is far below the precision of a double.

use super::{BOTH, digits, frictions, proved_twice};
use crate::arches::{arch, number};
use couplet::certify::state::{Answer, Certify, Figure, Outcome};
use couplet::number::{Ball, ExactNumber};
use couplet::problem::{Equation, Mode, tally};
use rug::Rational;

#[test]
fn tiny_openings_keep_full_relative_accuracy() {
    for weight in BOTH {
        for half_opening in ["1e-3", "1e-30", "1e-100"] {
            assert_eq!(proved_twice(weight, half_opening, "0.5"), Some(Mode::Rotational));
            let state = digits(weight, half_opening, "0.5", 12);
            let alpha = number(half_opening).enclosure::<Ball>(64).mid().to_f64();
            // alpha⁴/48, of which a double can only hold the first.
            if alpha > 1e-50 {
                let (eta, limit) = (state.thickness.double, alpha.powi(4) / 48.0);
                approx::assert_relative_eq!(eta, limit, max_relative = 1e-5);
            }
        }
        // Between alpha³/12 and alpha³/6 the shoulder slides.
        assert_eq!(proved_twice(weight, "1e-40", "1.2e-121"), Some(Mode::SlidingRotational));
        assert_eq!(proved_twice(weight, "1e-40", "0.8e-121"), None);
    }
}

/// Small openings are proved in scaled variables, with as few bits as any other; with very many bits the
/// printed equations are used, and say the same.
#[test]
fn small_openings_need_no_more_bits_and_agree_with_the_printed_equations() {
    for weight in BOTH {
        for (half_opening, part) in
            [("0.18", "0.001"), ("0.01", "1.1e-7"), ("1e-9", "1.1e-28"), ("1e-40", "1.1e-121")]
        {
            for friction in ["inf", "0.3", part] {
                let arch = arch(weight, half_opening, friction);
                let (answer, cost) = tally::measure(|| arch.certify(20));
                let Ok(Answer::Stands(small)) = answer else { panic!("{half_opening} {friction}") };
                // Those of three words at the most.
                assert!(cost.working_bits <= 150, "{half_opening} {friction}: {cost:?}");
                let printed = |bits| match tally::measure(|| arch.state(bits)) {
                    (Ok(Outcome::Stands(state)), cost) => (state, cost),
                    other => panic!("{half_opening} {friction}: {other:?}"),
                };
                let (large, cost_of_printed) = printed(8_000 + arch.bits_lost());
                assert!(cost_of_printed.of(Equation::Tangency) > 0);
                assert_eq!(small.mode, large.mode);
                let (of_small, of_large) = (frictions(&small), large.frictions.as_ref().unwrap());
                for (figure, ball) in [
                    (&small.thickness, &large.thickness),
                    (&small.thrust, &large.thrust),
                    (&small.rotation_joint, &large.rotation_joint),
                    (&of_small.sliding, &of_large.sliding),
                    (of_small.rotational.as_ref().unwrap(), of_large.rotational.as_ref().unwrap()),
                ] {
                    let again = Figure::new(ball, 20).unwrap();
                    let (value, again) = (&figure.decimal.value, again.decimal.value);
                    assert_eq!(*value, again, "{half_opening} {friction}");
                }
            }
        }
    }
}

/// The range of thrusts of a tiny arch, next to its least thickness and far from it.
#[test]
fn the_thrusts_of_tiny_openings_are_found() {
    for weight in BOTH {
        for (half_opening, friction) in [
            ("0.24", "inf"),
            ("0.2", "0.3"),
            ("0.01", "inf"),
            ("1e-4", "1.1e-13"),
            ("1e-8", "0.3"),
            ("1e-36", "1.1e-109"),
            ("1e-50", "inf"),
            ("1e-50", "1e-30"),
            ("1e-200", "1.1e-601"),
        ] {
            let arch = arch(weight, half_opening, friction);
            let Ok(Outcome::Stands(state)) = arch.state_alone(400) else { panic!() };
            for part in [(1_000_001, 1_000_000), (3, 2), (4, 1)] {
                let thickness = state.thickness.mid().to_rational().unwrap() * Rational::from(part);
                let found = arch.certify_thickness(&ExactNumber::from(&thickness), 12);
                let found =
                    found.unwrap_or_else(|doubt| panic!("{half_opening} {part:?}: {doubt:?}"));
                let [least, largest] = found
                    .limits()
                    .map(|end| end.unwrap().thrust.as_ref().unwrap().decimal.value.to_rational());
                assert!(found.stands.unwrap() && least <= largest);
            }
        }
    }
}
