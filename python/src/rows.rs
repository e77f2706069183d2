//! Many arches, in arrays of doubles: a half opening, a friction and perhaps a thickness each.

use crate::asked::warn;
use crate::pool::{is_short, on_threads};
use crate::{CoupletError, asked};
use bytemuck::{cast_slice, pod_collect_to_vec};
use couplet::ask::{ArchAsked, Field, Spelling, array_note, notes};
use couplet::certify::Refused;
use couplet::certify::batch::{DoubleArches, DoubleUnits};
use couplet::door::find as sought;
use couplet::problem::{Friction, Quantity};
use couplet::sweep::{answer, parse};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use rayon::prelude::*;

/// The bytes of an array.
pub(crate) type Bytes<'py> = Bound<'py, PyBytes>;

/// Verdicts, modes, and for each quantity the nearest doubles with their bounds, as bytes of arrays.
type Columns<'py> = (Bytes<'py>, Bytes<'py>, Vec<Vec<Bytes<'py>>>);

/// The quantities of these names, of those that arches with or without a thickness have.
pub(crate) fn quantities(names: &[String], has_thickness: bool) -> PyResult<Vec<Quantity>> {
    let possible =
        if has_thickness { &Quantity::ASSESSMENT_ROW[..] } else { &Quantity::STATE_ROW[..] };
    let named = |name: &String| parse::quantity_of(name, possible).map_err(asked::wrong);
    names.iter().map(named).collect()
}

/// The arches of arrays of doubles of one length, as bytes.
#[pyfunction]
pub(crate) fn states<'py>(
    py: Python<'py>,
    weight: &str,
    arrays: (PyBackedBytes, PyBackedBytes, Option<PyBackedBytes>),
    names: Vec<String>,
    threads: usize,
) -> PyResult<Columns<'py>> {
    let weight = parse::weight(weight).map_err(CoupletError::new_err)?;
    let quantities = quantities(&names, arrays.2.is_some())?;
    let is_short = is_short(arrays.0.len() / size_of::<f64>(), &quantities);
    let [half_openings, frictions] = [&arrays.0, &arrays.1].map(|bytes| pod_collect_to_vec(bytes));
    let thicknesses = arrays.2.as_deref().map(pod_collect_to_vec);
    warn(py, array_note(&frictions))?;
    let answer = move || {
        let arches = DoubleArches {
            weight,
            half_openings: &half_openings,
            frictions: &frictions,
            thicknesses: thicknesses.as_deref(),
            units: DoubleUnits::default(),
        };
        arches.columns(&quantities)
    };
    let found = if is_short { py.detach(answer) } else { on_threads(py, threads, answer)? };
    let found = found.map_err(|refused: Refused| CoupletError::new_err(refused.to_string()))?;
    let bytes = |column: &Vec<f64>| PyBytes::new(py, cast_slice(column));
    let values = found.values.iter().map(|columns| columns.iter().map(bytes).collect()).collect();
    Ok((PyBytes::new(py, &found.verdict_codes()), PyBytes::new(py, &found.modes), values))
}

/// Digits with which the nearest double is told.
const DIGITS: usize = 17;

/// Code of what became of a search, the double found with its bounds, and why there is none.
type Sought = (u8, [f64; 3], Option<String>);

/// What is found of each row: a half opening, a friction, a thickness, as far as they are given.
#[pyfunction]
pub(crate) fn finds(
    py: Python<'_>,
    target: (&str, Option<&str>),
    weight: &str,
    rows: Vec<[Option<String>; 3]>,
    threads: usize,
) -> PyResult<Vec<Sought>> {
    let wrong = CoupletError::new_err::<String>;
    let weight = parse::weight(weight).map_err(wrong)?;
    let target = asked::target_of(target)?;
    let frictions = rows.iter().filter_map(|[_, friction, _]| friction.as_ref()?.parse().ok());
    warn(py, notes(&frictions.collect::<Vec<Friction>>()).first())?;
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
    on_threads(py, threads, move || rows.into_par_iter().map(sought).collect())
}
