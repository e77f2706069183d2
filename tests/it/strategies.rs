//! The strategies draw what they promise, hard arches too, and a failure shrinks to one that can be read.

use crate::arches::at_landmark;
use crate::hard::{config, fixed};
use couplet::arch::{SelfWeight, Unknown};
use couplet::certify::state::{Answer, Certify};
use couplet::number::{Ball, ExactNumber};
use couplet::problem::{Friction, Landmark, Mode};
use couplet::strategies::{DrawnQuery, arch, assessed, collapsing, query, standing};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{TestError, TestRunner};
use std::collections::HashSet;

/// The first values that a strategy draws.
fn drawn<S: Strategy>(count: usize, strategy: &S) -> Vec<S::Value> {
    let mut runner = TestRunner::new(fixed(1));
    (0..count).map(|_| strategy.new_tree(&mut runner).unwrap().current()).collect()
}

/// The failure that is left after shrinking.
fn smallest<S: Strategy>(strategy: &S, holds: impl Fn(&S::Value) -> bool) -> S::Value
where
    S::Value: Clone,
{
    let shrinking = ProptestConfig { max_shrink_iters: 10_000, ..fixed(2000) };
    let test = |value: S::Value| match holds(&value) {
        true => Ok(()),
        false => Err(TestCaseError::fail("")),
    };
    match TestRunner::new(shrinking).run(strategy, test) {
        Err(TestError::Fail(_, value)) => value,
        other => panic!("{other:?}"),
    }
}

#[test]
fn every_query_is_in_the_domain_and_hard_ones_are_among_them() {
    let queries = drawn(2000, &query());
    assert!(queries.iter().all(|query| query.arch().is_ok()));
    let met = |what: &dyn Fn(f64, f64) -> bool| {
        queries.iter().filter(|query| what(query.doubles().0, query.doubles().1)).count()
    };
    for (hard, at_least) in [
        (met(&|alpha, _| alpha < 1e-6), 50),
        (met(&|alpha, _| alpha > std::f64::consts::PI - 1e-6), 50),
        (met(&|_, mu| mu == 0.0), 30),
        (met(&|_, mu| mu > 1e6 && mu.is_finite()), 30),
        (met(&|_, mu| mu.is_infinite()), 50),
        (met(&|alpha, mu| alpha > 0.2 && alpha < 2.6 && mu > 0.1 && mu < 5.0), 300),
    ] {
        assert!(hard >= at_least, "{hard} of {at_least}");
    }
    assert!(queries.iter().any(|query| matches!(query.friction, Friction::Angle(_))));
    for landmark in Landmark::ALL {
        for weight in SelfWeight::ALL {
            let at = at_landmark(landmark, weight, Unknown::HalfOpening, 128);
            let near = |query: &&DrawnQuery| {
                let gap = query.half_opening.enclosure::<Ball>(128) - &at;
                query.weight == weight && gap.mid().to_f64().abs() < 1e-8
            };
            assert!(queries.iter().filter(near).count() > 5, "{landmark:?} {weight:?}");
        }
    }
}

proptest! {
    #![proptest_config(config(300))]

    /// No query is too hard to be answered.
    #[test]
    fn every_arch_is_decided(arch in arch()) {
        let answer = arch.certify(9);
        prop_assert!(answer.is_ok(), "{:?}", answer.unwrap_err());
    }

    /// The text of a query is the query.
    #[test]
    fn a_query_is_its_text(query in query()) {
        let text = query.to_string();
        let after = |option: &str| {
            let rest = text.split(&format!("{option} ")).nth(1)?;
            rest.split(' ').next()?.parse::<ExactNumber>().ok()
        };
        prop_assert_eq!(after("--half-opening"), Some(query.half_opening.clone()));
        match &query.friction {
            Friction::Coefficient(mu) => prop_assert_eq!(after("--friction"), Some(mu.clone())),
            Friction::Angle(phi) => prop_assert_eq!(after("--friction-angle"), Some(phi.clone())),
            Friction::Infinite => prop_assert!(text.ends_with("--friction inf")),
        }
    }
}

#[test]
fn every_mode_is_drawn_for_both_weights() {
    for mode in Mode::ALL.into_iter().filter(|mode| *mode != Mode::Sliding) {
        let found = drawn(20, &collapsing(mode, 6));
        assert!(found.iter().all(|(_, state)| state.mode == mode));
        let weights: HashSet<SelfWeight> = found.iter().map(|(query, _)| query.weight).collect();
        assert_eq!(weights.len(), 2, "{mode:?}");
    }
    let mut runner = TestRunner::new(fixed(1));
    assert!(collapsing(Mode::Sliding, 6).new_tree(&mut runner).is_err());
}

#[test]
fn what_stands_has_its_own_state() {
    for (query, state) in drawn(60, &standing(7)) {
        let Ok(Answer::Stands(again)) = query.arch().unwrap().certify(7) else { panic!("{query}") };
        assert_eq!(again.thickness.decimal.value, state.thickness.decimal.value, "{query}");
    }
}

#[test]
fn an_oracle_says_yes_and_no_next_to_the_least_thickness() {
    let all = drawn(200, &assessed());
    let standing = all.iter().filter(|drawn| drawn.stands).count();
    assert!((40..160).contains(&standing), "{standing} of 200");
    for drawn in &all {
        let arch = drawn.query.arch().unwrap();
        let told = arch.certify_thickness(&drawn.thickness, 3).unwrap();
        assert_eq!(told.stands, Ok(drawn.stands), "{drawn}");
    }
    let falling = smallest(&assessed(), |drawn| drawn.stands || drawn.query.doubles().0 < 0.7);
    assert!(falling.to_string().starts_with("couplet assess --weight heyman --half-opening 1 "));
    assert!(format!("{falling:?}").ends_with(" (it falls)") && falling.to_string().len() < 90);
}

#[test]
fn a_failure_shrinks_to_an_arch_that_can_be_read() {
    let query = smallest(&query(), |query| query.doubles().0 <= 1.0);
    assert_eq!(query.weight, SelfWeight::Heyman);
    assert!(query.to_string().len() < 70, "{query}");
    let (query, _) = smallest(&standing(6), |(_, state)| state.thickness.double <= 0.2);
    assert!(query.to_string().len() < 75, "{query}");
    let mode = Mode::SlidingRotational;
    let (query, _) = smallest(&collapsing(mode, 6), |(query, _)| query.doubles().0 < 1.5);
    assert!(query.to_string().len() < 75, "{query}");
}
