//! An answer as Python gets it: dictionaries, texts and doubles, from which the classes of the package are made.

use couplet::check::Accepted;
use couplet::problem::{Mode, Quantity};
use couplet::report::{Answer, Status, Subject, Value};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The text of a value, its bounds as text, the nearest double with its bounds, the exact value, what limits
/// a thrust.
type Told<'a> = (String, String, String, f64, f64, f64, Option<&'a str>, Option<&'static str>);

fn told(value: &Value) -> Told<'_> {
    let [text, lower, upper] = value.texts();
    let (double, binary) = (value.double, &value.binary);
    let (exact, limited_by) = (value.closed_form(), value.limited_by);
    (text, lower, upper, double, binary.lower, binary.upper, exact, limited_by)
}

/// All of an answer.
pub(crate) fn answer<'py>(py: Python<'py>, answer: &Answer) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    let labels = |modes: &[Mode]| modes.iter().map(|mode| mode.label()).collect::<Vec<_>>();
    let (landmark, weight) = (answer.subject.landmark(), answer.subject.weight());
    all.set_item("landmark", landmark.map(|landmark| landmark.symbol()))?;
    all.set_item("weight", weight.map(|weight| weight.name()))?;
    if let Subject::Arch { half_opening, friction, thickness, .. } = &answer.subject {
        all.set_item("given", (half_opening, friction, thickness.as_ref()))?;
    }
    all.set_item("status", answer.status.name())?;
    all.set_item("can_stand", answer.can_stand)?;
    all.set_item("stands", answer.stands)?;
    all.set_item("modes", labels(&answer.modes))?;
    let values = PyDict::new(py);
    for (of, value) in &answer.values {
        values.set_item(of.name(), told(value))?;
    }
    all.set_item("values", values)?;
    let open = answer.open.iter().map(|(of, why)| (of.name(), why.reason.as_ref()));
    all.set_item("open", open.collect::<Vec<_>>())?;
    let enough = PyDict::new(py);
    for (of, value) in [Quantity::Friction, Quantity::HalfOpening].iter().zip(&answer.enough) {
        enough.set_item(of.name(), value.as_ref().map(told))?;
    }
    all.set_item("enough", enough)?;
    all.set_item("reason", answer.reason())?;
    all.set_item("proved", answer.proved.as_deref())?;
    all.set_item("some_may_move", answer.some_may_move)?;
    let (between, gap) = match &answer.status {
        Status::Undecided(undecided) => (labels(&undecided.between), undecided.gap),
        _ => (Vec::new(), None),
    };
    all.set_item("between", between)?;
    all.set_item("gap", gap)?;
    Ok(all)
}

/// What became of a certificate: the verdict, the reason, and what is accepted.
pub(crate) fn checked<'py>(
    py: Python<'py>,
    (verdict, reason): (&str, Option<String>),
    accepted: Option<&Accepted>,
) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    all.set_item("verdict", verdict)?;
    all.set_item("reason", reason)?;
    all.set_item("digits", accepted.map(|accepted| accepted.digits))?;
    let values = PyDict::new(py);
    for (of, text) in accepted.iter().flat_map(|accepted| &accepted.values) {
        values.set_item(of.name(), text)?;
    }
    all.set_item("values", values)?;
    Ok(all)
}
