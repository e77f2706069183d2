//! A solver of one's own, tested against certified states: `cargo run --example own_solver`.
//!
//! The solver knows purely rotational collapse only, in doubles and by bisection, and takes nothing from
//! couplet. The strategy draws arches that collapse so, with the state that is proved of them.

use couplet::arch::SelfWeight;
use couplet::problem::Mode;
use couplet::strategies::collapsing;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestError, TestRunner};

/// The least thickness `t/r` of an arch of half opening `alpha` (rad) with all the friction it needs.
/// `at_centroids`: whether the weight acts at the true centroids (Milankovitch) or on the centreline.
fn least_thickness(alpha: f64, at_centroids: bool) -> f64 {
    let stands = |eta: f64| {
        let (inner, outer) = (1.0 - eta / 2.0, 1.0 + eta / 2.0);
        let centroid = if at_centroids { 1.0 + eta * eta / 12.0 } else { 1.0 };
        // The moment of the weight above the angle `b`, about a point at the radius `r` there; and the
        // thrust, applied at the crown's extrados, that holds it.
        let moment = |b: f64, r: f64| b * r * b.sin() - centroid * (1.0 - b.cos());
        let least = |b: f64| moment(b, inner) / (outer - inner * b.cos());
        let most = moment(alpha, outer) / (outer * (1.0 - alpha.cos()));
        // Every joint has to be held, the shoulder must not be overturned.
        most >= largest(least, 0.0, alpha)
    };
    let (mut falls, mut standing) = (0.0, 2.0);
    for _ in 0..60 {
        let middle = (falls + standing) / 2.0;
        if stands(middle) { standing = middle } else { falls = middle }
    }
    standing
}

/// The largest value of a function with one maximum, by golden sections.
fn largest(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let golden = (5f64.sqrt() - 1.0) / 2.0;
    for _ in 0..80 {
        let (a, b) = (high - golden * (high - low), low + golden * (high - low));
        if f(a) < f(b) { low = a } else { high = b }
    }
    f((low + high) / 2.0)
}

/// How the test of a solver ends: over so many arches, the worst relative error, or the arch that fails.
fn tested(solver: impl Fn(f64, SelfWeight) -> f64, tolerance: f64) -> Result<f64, String> {
    let config = Config {
        cases: 200,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0),
        ..Config::default()
    };
    let worst = std::cell::Cell::new(0f64);
    let verdict =
        TestRunner::new(config).run(&collapsing(Mode::Rotational, 17), |(query, state)| {
            let (alpha, _) = query.doubles();
            // The thickness falls like alpha⁴/48: below this a solver in doubles has nothing to say.
            prop_assume!(alpha > 0.2);
            let truth = state.thickness.double;
            let error = (solver(alpha, query.weight) / truth - 1.0).abs();
            worst.set(worst.get().max(error));
            prop_assert!(error < tolerance, "{error:e} from {truth}");
            Ok(())
        });
    match verdict {
        Ok(()) => Ok(worst.get()),
        Err(TestError::Fail(reason, (query, _))) => Err(format!("{query}: {reason}")),
        Err(TestError::Abort(reason)) => Err(reason.to_string()),
    }
}

fn main() {
    let right =
        tested(|alpha, weight| least_thickness(alpha, weight == SelfWeight::Milankovitch), 1e-9);
    println!("the solver            {right:?}");
    assert!(right.is_ok());

    // One that forgets that the centroids are not on the centreline is found out.
    let wrong = tested(|alpha, _| least_thickness(alpha, false), 1e-9);
    println!("with a usual mistake  {wrong:?}");
    assert!(wrong.is_err_and(|arch| arch.contains("milankovitch")));
}
