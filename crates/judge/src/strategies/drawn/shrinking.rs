//! Shrinking of a failure: to an arch that fails too, and is as ordinary as can be.

use super::queries::DrawnQuery;
use crate::arch::SelfWeight;
use crate::problem::Friction;
use proptest::prelude::*;
use proptest::strategy::{NewTree, ValueTree};
use proptest::test_runner::{Reason, TestRunner};
use std::fmt::{self, Debug};
use std::sync::Arc;

/// Half openings of ordinary arches, the simplest first.
const HALF_OPENINGS: &[&str] = &["1", "2", "0.5", "1.5", "2.5"];
/// Frictions of ordinary arches.
const FRICTIONS: &[&str] = &["inf", "1", "0.5"];
/// Places of the longest decimal.
const PLACES: usize = 17;

/// Proof of something about a query and what was drawn with it; none of one that does not belong here.
type QueryProof<X, T> = Arc<dyn Fn(&DrawnQuery, &X) -> Option<T>>;

/// Queries with what is proved of them, all others rejected.
#[derive(Clone)]
pub(super) struct Proving<S, X, T> {
    drawn: S,
    proved: QueryProof<X, T>,
    otherwise: Reason,
}

/// Makes queries, each drawn with something more, a strategy of those of which something is proved.
pub(super) fn proving<S: Strategy<Value = (DrawnQuery, X)>, X, T>(
    drawn: S,
    otherwise: impl Into<Reason>,
    proved: impl Fn(&DrawnQuery, &X) -> Option<T> + 'static,
) -> Proving<S, X, T> {
    Proving { drawn, proved: Arc::new(proved), otherwise: otherwise.into() }
}

impl<S: Debug, X, T> Debug for Proving<S, X, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.drawn.fmt(f)
    }
}

impl<S, X, T> Strategy for Proving<S, X, T>
where
    S: Strategy<Value = (DrawnQuery, X)>,
    T: Clone + Debug,
{
    type Tree = Shrinking<X, T>;
    type Value = (DrawnQuery, T);

    fn new_tree(&self, runner: &mut TestRunner) -> NewTree<Self> {
        loop {
            let (query, with) = self.drawn.new_tree(runner)?.current();
            if let Some(known) = (self.proved)(&query, &with) {
                let (current, proved) = ((query, known), self.proved.clone());
                return Ok(Shrinking {
                    with,
                    base: current.clone(),
                    current,
                    ahead: vec![],
                    proved,
                });
            }
            runner.reject_local(self.otherwise.clone())?;
        }
    }
}

/// A query on its way to a simpler one.
pub(super) struct Shrinking<X, T> {
    proved: QueryProof<X, T>,
    with: X,
    /// The simplest that is known to fail.
    base: (DrawnQuery, T),
    current: (DrawnQuery, T),
    /// Simpler ones than that, the simplest last.
    ahead: Vec<DrawnQuery>,
}

impl<X, T> Shrinking<X, T> {
    /// Goes on to the next of the simpler ones.
    fn advance(&mut self) -> bool {
        while let Some(query) = self.ahead.pop() {
            if let Some(known) = (self.proved)(&query, &self.with) {
                self.current = (query, known);
                return true;
            }
        }
        false
    }
}

impl<X, T: Clone + Debug> ValueTree for Shrinking<X, T> {
    type Value = (DrawnQuery, T);

    fn current(&self) -> Self::Value {
        self.current.clone()
    }

    fn simplify(&mut self) -> bool {
        self.base = self.current.clone();
        self.ahead = simpler(&self.base.0);
        self.ahead.reverse();
        self.advance()
    }

    fn complicate(&mut self) -> bool {
        let is_left = self.advance();
        if !is_left {
            self.current = self.base.clone();
        }
        is_left
    }
}

/// Queries that differ from this one in one thing and are simpler, the simplest first; not all of them make sense.
fn simpler(query: &DrawnQuery) -> Vec<DrawnQuery> {
    let heyman = DrawnQuery { weight: SelfWeight::Heyman, ..query.clone() };
    let (alpha, mu) = query.doubles();
    let frictions = texts(FRICTIONS, &query.friction.to_string(), mu);
    let frictions = frictions.into_iter().filter_map(|text| {
        let friction = text.parse().ok().filter(|mu| !matches!(mu, Friction::Angle(_)))?;
        Some(DrawnQuery { friction, ..query.clone() })
    });
    let openings = texts(HALF_OPENINGS, &query.half_opening.to_string(), alpha);
    let openings = openings
        .into_iter()
        .filter_map(|text| Some(DrawnQuery { half_opening: text.parse().ok()?, ..query.clone() }));
    let heyman = (query.weight != heyman.weight).then_some(heyman);
    heyman.into_iter().chain(frictions).chain(openings).collect()
}

/// Texts that are simpler than that of a number: ordinary ones before its own decimals, which get longer.
fn texts(ordinary: &[&str], text: &str, x: f64) -> Vec<String> {
    let before = ordinary.iter().position(|simple| *simple == text);
    let mut all: Vec<String> =
        ordinary[..before.unwrap_or(ordinary.len())].iter().map(ToString::to_string).collect();
    if before.is_none() {
        let decimals = (1..=PLACES).map(|places| format!("{x:.places$}"));
        all.extend(decimals.filter(|decimal| decimal.len() < text.len()));
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strategies::{collapsing, query};
    use proptest::test_runner::{Config, RngSeed, TestError};

    fn least<S: Strategy>(strategy: &S, holds: impl Fn(&S::Value) -> bool) -> S::Value {
        for seed in 0.. {
            let seed = RngSeed::Fixed(seed);
            let config = Config { failure_persistence: None, rng_seed: seed, ..Config::default() };
            let failed = TestRunner::new(config).run(strategy, |value| {
                prop_assert!(holds(&value));
                Ok(())
            });
            if let Err(TestError::Fail(_, value)) = failed {
                return value;
            }
        }
        unreachable!("some arch fails")
    }

    #[test]
    fn texts_get_no_longer_and_end() {
        assert_eq!(texts(&["1", "2"], "1", 1.0), Vec::<String>::new());
        assert_eq!(texts(&["1", "2"], "2", 2.0), ["1"]);
        assert_eq!(texts(&["1"], "2.3456", 2.3456), ["1", "2.3", "2.35", "2.346"]);
        assert_eq!(texts(&["1"], "5pi/12", 1.309), ["1", "1.3", "1.31", "1.309"]);
    }

    #[test]
    fn a_fault_above_an_opening_is_shown_at_an_ordinary_one() {
        let shown = least(&query(), |query| query.doubles().0 <= 1.9).to_string();
        assert_eq!(shown, "couplet state --weight heyman --half-opening 2 --friction inf");
        let fails = |(query, _): &(DrawnQuery, _)| query.doubles().0 <= 2.05;
        let shown = least(&collapsing(crate::problem::Mode::Rotational, 6), fails).0.to_string();
        assert_eq!(shown, "couplet state --weight heyman --half-opening 2.5 --friction inf");
        // Only one weight is wrong, and only with little friction.
        let fails =
            |query: &DrawnQuery| query.weight == SelfWeight::Heyman || query.doubles().1 > 0.75;
        let shown = least(&query(), fails).to_string();
        assert_eq!(shown, "couplet state --weight milankovitch --half-opening 1 --friction 0.5");
    }
}
