//! Arches, and arches with a certified state.

use super::numbers::{decimal, weight};
use super::queries::{DrawnQuery, any_query};
use crate::certify::Refused;
use crate::certify::state::{Answer, Certify, Digits};
use crate::number::ExactNumber;
use crate::problem::{Arch, Friction, Mode};
use crate::solve::start::quick_state;
use crate::strategies::places::{above_sliding, half_openings};
use proptest::prelude::*;
use std::fmt;

/// Any query of the domain: half opening in `(0, pi)`, friction in `[0, inf]`; one in five next to a landmark, of which
/// it shares 3 to 40 digits.
pub fn query() -> impl Strategy<Value = DrawnQuery> {
    any_query().prop_filter("is in the domain", |query| query.arch().is_ok())
}

/// Any arch of the domain; the arch of a [`query`].
pub fn arch() -> impl Strategy<Value = Arch> {
    any_query().prop_filter_map("is in the domain", |query| query.arch().ok())
}

/// Arches that stand, with their state at the least thickness, correctly rounded to `digits`
/// significant digits, 1 to [`MAX_DIGITS`](crate::certify::MAX_DIGITS); with others everything is
/// rejected. What falls, and what is undecided, is left out.
///
/// ```
/// use couplet_judge::strategies::standing;
/// use proptest::test_runner::TestRunner;
///
/// let mut runner = TestRunner::deterministic();
/// let verdict = runner.run(&standing(9), |(query, state)| {
///     // A solver of one's own would be asked about `query` here, and compared with `state`. As doubles
///     // some thicknesses are 0 (at an opening of 1e-100) or 2 (next to `L`), which they are not.
///     let thickness = state.thickness.double;
///     assert!((0.0..=2.0).contains(&thickness), "{query}: {thickness}");
///     Ok(())
/// });
/// assert!(verdict.is_ok());
/// ```
pub fn standing(digits: usize) -> impl Strategy<Value = (DrawnQuery, Box<Digits>)> {
    any_query().prop_filter_map(whence("stands", digits), move |query| {
        let state = stands(&query, digits)?;
        Some((query, state))
    })
}

/// Arches that stand and collapse in `mode` at their least thickness, with the state as in
/// [`standing`]. They are ordinary ones: the half opening is a decimal, and so is the friction, or it is
/// unlimited for [`Mode::Overturning`].
///
/// The purely sliding states are a curve of the map, on which no such arch lies: with
/// [`Mode::Sliding`] everything is rejected.
pub fn collapsing(mode: Mode, digits: usize) -> impl Strategy<Value = (DrawnQuery, Box<Digits>)> {
    weight()
        .prop_filter_map("has a place on the map", move |weight| {
            Some((weight, half_openings(mode, weight)?))
        })
        .prop_flat_map(|(weight, [low, high])| {
            (Just(weight), decimal(low, high), 1usize..=17, 0.0..1.0f64)
        })
        .prop_filter_map(
            whence("collapses otherwise", digits),
            move |(weight, alpha, places, part)| {
                let friction = match mode {
                    Mode::Overturning => Friction::Infinite,
                    _ => {
                        let mu = above_sliding(alpha.parse().ok()?, part);
                        Friction::Coefficient(format!("{mu:.places$}").parse().ok()?)
                    }
                };
                let query = DrawnQuery { weight, half_opening: alpha.parse().ok()?, friction };
                // A quick look: not everything that is drawn is worth a proof.
                let (alpha, mu) = query.doubles();
                let is_likely =
                    mode == Mode::Overturning || quick_state(weight, alpha, mu).mode == Some(mode);
                let state = is_likely.then(|| stands(&query, digits))??;
                (state.mode == mode).then_some((query, state))
            },
        )
}

/// An arch with a thickness, and whether it stands. It is shown as the command that answers it.
#[derive(Clone)]
pub struct DrawnThickness {
    /// The arch.
    pub query: DrawnQuery,
    /// The thickness, `t/r`.
    pub thickness: ExactNumber,
    /// Proved verdict: whether the arch stands with this thickness.
    pub stands: bool,
}

impl fmt::Display for DrawnThickness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let state = self.query.to_string();
        write!(f, "{} --thickness {}", state.replacen("state", "assess", 1), self.thickness)
    }
}

impl fmt::Debug for DrawnThickness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self} (it {})", if self.stands { "stands" } else { "falls" })
    }
}

/// Arches with a thickness and whether they stand: an oracle for solvers that answer yes or no. Those that stand at
/// some thickness have one next to the least, above or below it by a part of 1/2 to `5e-9`; the others fall with any.
///
/// ```
/// use couplet_judge::strategies::assessed;
/// use proptest::test_runner::TestRunner;
///
/// let mut runner = TestRunner::deterministic();
/// let verdict = runner.run(&assessed(), |drawn| {
///     // A solver of one's own would be asked about `drawn.query` and `drawn.thickness` here.
///     assert!(drawn.thickness.nearest_double().is_some_and(|eta| 0.0 < eta && eta <= 2.0));
///     Ok(())
/// });
/// assert!(verdict.is_ok());
/// ```
pub fn assessed() -> impl Strategy<Value = DrawnThickness> {
    let drawn = (any_query(), 0u32..=8, any::<bool>());
    drawn.prop_filter_map("is decided", |(query, power, is_above)| {
        let arch = query.arch().ok()?;
        let least = stands(&query, 12).map_or(1.0, |state| state.thickness.double);
        let part = 0.5 * f64::powi(10.0, -(power as i32));
        let eta = least * if is_above { 1.0 + part } else { 1.0 - part };
        let digits = power as usize + 2;
        let thickness: ExactNumber = format!("{eta:.digits$e}").parse().ok()?;
        let stands = arch.certify_thickness(&thickness, 1).ok()?.stands.ok()?;
        Some(DrawnThickness { query, thickness, stands })
    })
}

/// Reason why an arch is left out: because of the digits, if none can be had to so many.
fn whence(otherwise: &str, digits: usize) -> String {
    Refused::digits(digits).map_or_else(|refused| refused.to_string(), |()| otherwise.to_owned())
}

/// The proved state of an arch that stands.
fn stands(query: &DrawnQuery, digits: usize) -> Option<Box<Digits>> {
    match query.arch().ok()?.certify(digits) {
        Ok(Answer::Stands(state)) => Some(state),
        _ => None,
    }
}
