//! An answer as Python gets it: dictionaries, texts and doubles, from which the classes of the package are made.

use couplet::certify::VoussoirStanding;
use couplet::certify::state::Figure;
use couplet::check::AcceptedFile;
use couplet::problem::Quantity;
use couplet::report::words::labels;
use couplet::report::{Answer, Sizes, Status, TiltedArch, Value, VoussoirArch};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The text of a value, its bounds as text, the nearest double with its bounds, the exact value, what limits
/// a thrust.
type Told<'a> = (String, String, String, f64, f64, f64, Option<&'a str>, Option<&'static str>);

fn told(value: &Value) -> Told<'_> {
    let [text, lower, upper] = value.texts().map(ToString::to_string);
    let (double, binary) = (value.double, &value.binary);
    let (exact, limited_by) = (value.closed_form(), value.limited_by);
    (text, lower, upper, double, binary.lower, binary.upper, exact, limited_by)
}

/// All of an answer.
pub(crate) fn answer<'py>(py: Python<'py>, answer: &Answer) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    let (landmark, weight) = (answer.subject.landmark(), answer.subject.weight());
    all.set_item("landmark", landmark.map(|landmark| landmark.symbol()))?;
    all.set_item("weight", weight.map(|weight| weight.name()))?;
    all.set_item("measured_at", answer.measured_at.map(|circle| circle.name()))?;
    all.set_item("status", answer.status.name())?;
    all.set_item("search", answer.search())?;
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

/// The values of figures; one that is infinite has no figure.
fn figures<'py, 'a>(
    py: Python<'py>,
    figures: impl IntoIterator<Item = (&'static str, Option<&'a Figure>)>,
) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    for (name, figure) in figures {
        all.set_item(name, told(&Value::figure(figure)))?;
    }
    Ok(all)
}

/// Sizes of an arch that is measured, by their names.
fn sizes(of: Option<&Sizes>) -> impl Iterator<Item = (&'static str, Option<&Figure>)> {
    let found = of.and_then(|of| of.found.as_ref().ok());
    found.into_iter().flatten().map(|(of, figure)| (of.name(), figure.as_ref()))
}

/// The values of an arch of stones at its least thickness, and of it at a thickness that is given.
pub(crate) fn voussoirs<'py>(
    py: Python<'py>,
    arch: &VoussoirArch,
) -> PyResult<[Bound<'py, PyDict>; 2]> {
    let known = |(of, figure): (Quantity, Option<_>)| Some((of.name(), Some(figure?)));
    let mut least: Vec<_> = arch.figures().into_iter().filter_map(known).collect();
    let mut at_thickness: Vec<(&str, Option<&Figure>)> = Vec::new();
    if let Some(found) = arch.given.as_ref().map(|given| &given.found) {
        let all = [
            ("geometric_safety", &found.geometric_safety),
            ("required_friction", &found.required_friction),
            ("friction_safety", &found.friction_safety),
        ];
        for (name, value) in all {
            at_thickness.extend(value.iter().flatten().map(|figure| (name, Some(figure))));
        }
        if let Ok(VoussoirStanding::Stands([from, to])) = &found.standing {
            let ends = [("least_thrust", from), ("largest_thrust", to)];
            at_thickness.extend(ends.map(|(name, end)| (name, end.thrust.as_ref())));
        }
        at_thickness.extend(least.first().map(|(_, eta)| ("least_thickness", *eta)));
        at_thickness.extend(sizes(arch.sizes.as_ref()));
    } else {
        least.extend(sizes(arch.sizes.as_ref()));
    }
    least.extend(arch.continuous.iter().map(|eta| ("continuous_thickness", Some(eta))));
    Ok([figures(py, least)?, figures(py, at_thickness)?])
}

/// The largest acceleration of an arch, where it is known.
pub(crate) fn tilted<'py>(py: Python<'py>, arch: &TiltedArch) -> PyResult<Bound<'py, PyDict>> {
    let largest = arch.largest().map(|_| ("largest_tilt", arch.figure()));
    let beside = arch.at_largest();
    let beside = beside.iter().map(|(name, figure)| (*name, Some(figure)));
    figures(py, largest.into_iter().chain(beside).chain(sizes(arch.sizes.as_ref())))
}

/// What became of a certificate: the verdict, the reason, and what is accepted.
pub(crate) fn checked<'py>(
    py: Python<'py>,
    (verdict, reason): (&str, Option<String>),
    accepted: Option<&AcceptedFile>,
) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    all.set_item("verdict", verdict)?;
    all.set_item("reason", reason)?;
    all.set_item("summary", accepted.map(AcceptedFile::summary))?;
    // A survey has no values of its own.
    let accepted = accepted.and_then(AcceptedFile::certificate);
    all.set_item("digits", accepted.map(|accepted| accepted.digits))?;
    let values = PyDict::new(py);
    for (of, text) in accepted.iter().flat_map(|accepted| &accepted.values) {
        values.set_item(of.name(), text)?;
    }
    all.set_item("values", values)?;
    Ok(all)
}
