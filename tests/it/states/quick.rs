//! Balls of doubles: whatever they decide, balls of MPFR and of astro-float decide too, and in the same way.

use crate::arches::number;
use crate::hard::{config, fixed};
use couplet::certify::state::{Answer, Certify, Figure, Inquiry, Outcome, Wanted};
use couplet::number::{AstroInterval, Dyadic, Enclosure, Engine, ExactNumber, Field};
use couplet::problem::{Arch, Mode, Problem};
use couplet::strategies::{DrawnQuery, query};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use rug::Float;
use std::collections::HashSet;

/// The digits and the double of a value. Bounds of the double depend on the enclosure where digits are few.
fn shown(figure: Option<&Figure>) -> String {
    figure.map_or("inf".into(), |x| {
        assert!(x.binary.lower <= x.double && x.double <= x.binary.upper);
        format!("{} {:?} {:?} {:?}", x.decimal.value, x.decimal.lower, x.decimal.upper, x.double)
    })
}

/// An answer in full.
fn state(answer: &Answer) -> String {
    match answer {
        Answer::Stands(state) => {
            let figures = state.figures().map(|(of, x)| (of, shown(x)));
            format!("{} {:?}", state.mode, figures.collect::<Vec<_>>())
        }
        Answer::Falls { fall, enough } => {
            let enough = enough.as_ref().unwrap();
            let all = [&enough.sliding_friction, &enough.friction, &enough.half_opening];
            format!("{fall:?} {:?}", all.map(|x| x.as_ref().map(|x| shown(Some(x)))))
        }
    }
}

/// The same answers with balls of MPFR alone.
fn agree(query: &DrawnQuery, digits: usize) {
    let arch = query.arch().unwrap();
    let by_mpfr = Inquiry::new(&arch, digits, true).state(digits, true);
    match (arch.certify(digits), by_mpfr) {
        (Ok(found), Ok(by_mpfr)) => assert_eq!(state(&found), state(&by_mpfr), "{query}"),
        (Err(found), Err(by_mpfr)) => assert_eq!(found, by_mpfr, "{query}"),
        (found, by_mpfr) => panic!("{query}: {found:?}, {by_mpfr:?}"),
    }
}

/// The same of an arch with a thickness.
fn agree_at(query: &DrawnQuery, thickness: &ExactNumber, digits: usize) {
    let arch = query.arch().unwrap();
    let found = arch.certify_thickness(thickness, digits).unwrap();
    let inquiry = Inquiry::new(&arch, digits, false);
    let by_mpfr = inquiry.assess(thickness, digits, Wanted::Everything).unwrap();
    let all = |x: &couplet::certify::state::AssessmentDigits| {
        let figures: Vec<_> = x.figures().map(|(of, x)| (of, shown(x))).collect();
        let limits = x.limits().map(|limit| limit.map(|limit| limit.touch.name()));
        format!("{:?} {:?} {figures:?} {limits:?} {:?}", x.stands, x.fall, x.open().count())
    };
    assert_eq!(all(&found), all(&by_mpfr), "{query} {thickness}");
}

proptest! {
    #![proptest_config(config(1500))]

    /// Half openings and frictions of every size, one in five next to a landmark.
    #[test]
    fn a_state_is_the_same_in_balls_of_mpfr(query in query(), digits in 1usize..27) {
        agree(&query, digits);
    }

    #[test]
    fn an_assessment_is_the_same_in_balls_of_mpfr(
        query in query(), thousandths in 1u32..2000, digits in 1usize..20,
    ) {
        agree_at(&query, &number(&format!("{thousandths}/1000")), digits);
    }

    /// In balls of doubles alone: the mode, and enclosures that hold the digits.
    #[test]
    fn what_balls_of_doubles_prove_is_true(query in query()) {
        let arch = query.arch().unwrap();
        let Ok(found) = arch.state_in_doubles() else { return Ok(()) };
        match (found, arch.certify_alone(17).unwrap()) {
            (Outcome::Stands(found), Answer::Stands(state)) => {
                prop_assert_eq!(found.mode, state.mode);
                for (ball, figure) in [
                    (found.thickness, &state.thickness),
                    (found.thrust, &state.thrust),
                    (found.rotation_joint, &state.rotation_joint),
                ] {
                    prop_assert!(ball.lower() <= figure.binary.upper, "{ball:?}");
                    prop_assert!(figure.binary.lower <= ball.upper(), "{ball:?}");
                }
            }
            (Outcome::Falls(found), Answer::Falls { fall, .. }) => prop_assert_eq!(found, fall),
            other => panic!("{query}: {other:?}"),
        }
    }
}

/// The mode of a state that is checked over astro-float: the equations hold within the digits, and every condition of
/// the mode does. None if doubles do not decide it.
fn over_astro_float(query: &DrawnQuery) -> Option<Mode> {
    const BITS: u32 = 192;
    let arch: Arch = query.arch().unwrap();
    // Of small half openings twenty digits do not tell the thrust from one.
    if query.doubles().0 < 0.1 {
        return None;
    }
    let Ok(Outcome::Stands(quick)) = arch.state_in_doubles() else { return None };
    let Ok(Answer::Stands(state)) = arch.certify_alone(20) else { panic!("{query}") };
    assert_eq!(quick.mode, state.mode, "{query}");
    let problem = Problem::State { mode: state.mode, arch };
    let system = problem.system();
    let enclosed = |figure: &Figure| {
        let [low, high] = [&figure.decimal.lower, &figure.decimal.upper].map(|end| {
            let low = Float::with_val(400, end.to_rational());
            (low, Float::with_val(400, 1) >> 380)
        });
        AstroInterval::between(&(low.0 - low.1), &(high.0 + high.1), BITS as usize)
    };
    let values: Vec<AstroInterval> = system
        .unknowns
        .iter()
        .map(|unknown| {
            let mut figures = state.figures();
            let found = figures.find(|(of, _)| of.variable() == Some(*unknown));
            enclosed(found.unwrap().1.unwrap())
        })
        .collect();
    let at = system.place(problem.given(BITS), &values);
    let zero = at.thrust.int(0);
    for residual in system.residuals(&at) {
        assert!(residual.overlaps(&zero), "{query}: {residual:?}");
        // Not because nothing is known.
        let small = AstroInterval::zero(64).widened_by(&Dyadic::new(false, vec![1], -30));
        assert!(residual.lies_inside(&small), "{query}: {residual:?}");
    }
    let failure = problem.first_failure(&at, BITS);
    assert!(failure.is_none(), "{query}: {failure:?}");
    Some(state.mode)
}

proptest! {
    #![proptest_config(config(200))]

    #[test]
    fn a_state_holds_over_astro_float(query in query()) {
        over_astro_float(&query);
    }
}

#[test]
fn five_hundred_states_of_four_modes_hold_over_astro_float() {
    let mut runner = TestRunner::new(fixed(1));
    let mut drawn = || query().new_tree(&mut runner).unwrap().current();
    let modes = std::iter::repeat_with(|| over_astro_float(&drawn())).flatten().take(500);
    assert!(modes.map(Mode::label).collect::<HashSet<_>>().len() >= 4);
}
