//! Many searches: a half opening, a friction and perhaps a thickness each.

use crate::asked::{target_of, wrong};
use crate::pool::on_threads;
use couplet::ask::{ArchAsked, Field, Spelling, notes};
use couplet::door::find as sought;
use couplet::problem::Friction;
use couplet::sweep::{answer, parse};
use pyo3::prelude::*;
use rayon::prelude::*;

/// Digits with which the nearest double is told.
const DIGITS: usize = 17;

/// Code of what became of a search, the double found with its bounds, and why there is none.
type Sought = (u8, [f64; 3], Option<String>);

/// What is found of each row: a half opening, a friction, a thickness, as far as they are given; behind a note, as of a
/// table.
#[pyfunction]
pub(crate) fn finds(
    py: Python<'_>,
    target: (&str, Option<&str>),
    weight: &str,
    rows: Vec<[Option<String>; 3]>,
    threads: usize,
) -> PyResult<(Option<String>, Vec<Sought>)> {
    let weight = parse::weight(weight).map_err(wrong)?;
    let target = target_of(target)?;
    let frictions = rows.iter().filter_map(|[_, friction, _]| friction.as_ref()?.parse().ok());
    let note = notes(&frictions.collect::<Vec<Friction>>()).into_iter().next();
    let sought = move |[half_opening, friction, thickness]: [Option<String>; 3]| {
        let mut asked = ArchAsked::default();
        *asked.at(Field::HalfOpening) = half_opening;
        *asked.at(Field::Friction) = friction;
        *asked.at(Field::Thickness) = thickness;
        let nothing = |code, why: Option<String>| (code, [f64::NAN; 3], why);
        let question = match sought::question(target, &asked, Spelling::Key) {
            Ok(question) => question,
            Err(failure) => return nothing(3, Some(failure.to_string())),
        };
        let answer = match answer::finding(1, (weight, &question), DIGITS) {
            Ok(answer) => answer,
            Err(refused) => return nothing(3, Some(refused.to_string())),
        };
        match (answer.values.first(), answer.is_undecided()) {
            (Some((_, value)), _) => {
                (0, [value.double, value.binary.lower, value.binary.upper], None)
            }
            (None, is_open) => {
                let why = answer.reason().map(Into::into).or(answer.proved);
                nothing(1 + u8::from(is_open), why)
            }
        }
    };
    Ok((note, on_threads(py, threads, move || rows.into_par_iter().map(sought).collect())?))
}
