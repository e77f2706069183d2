//! One question at a time. Every argument is text, read by what reads the command's, so that the same input gets the
//! same sentence.

use crate::pool::on_threads;
use crate::{CoupletError, UndecidedError, told};
use couplet::Error;
use couplet::arch::SelfWeight;
use couplet::atlas::{NoSketch, Sketch};
use couplet::certify::state::find as seek;
use couplet::certify::state::{Balls, Certify};
use couplet::certify::{self, CertifiedLandmark, asymmetric_thicknesses, quantities};
use couplet::check::{Certificate, Refusal};
use couplet::cli;
use couplet::problem::{Arch, Landmark, Mode, Quantity};
use couplet::report::{Answer, Claims, Content, Format, Report, Sketched, Style};
use couplet::sweep::parse;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use std::ffi::OsString;
use std::fmt::Display;

/// The error of a question that makes no sense.
fn wrong(error: impl Display) -> PyErr {
    CoupletError::new_err(error.to_string())
}

/// The arch of three texts.
fn arch(weight: &str, half_opening: &str, friction: &str) -> PyResult<Arch> {
    parse::arch([weight, half_opening, friction]).map_err(wrong)
}

/// The name of a quantity, of which a letter may be given.
#[pyfunction(name = "quantity")]
pub(crate) fn quantity_name(name: &str) -> PyResult<&'static str> {
    parse::quantity(name).map(|quantity| quantity.name()).map_err(wrong)
}

/// A quantity of those that there are.
pub(crate) fn quantity(name: &str, possible: &[Quantity]) -> PyResult<Quantity> {
    parse::quantity_of(name, possible).map_err(wrong)
}

/// The labels of the modes, in the order of their codes.
#[pyfunction]
pub(crate) fn modes() -> Vec<&'static str> {
    Mode::ALL.map(Mode::label).to_vec()
}

#[pyfunction]
pub(crate) fn constants<'py>(
    py: Python<'py>,
    landmarks: Vec<String>,
    weight: &str,
    names: Vec<String>,
    digits: &str,
    threads: usize,
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let read = |name: &String| parse::landmark(name).map_err(wrong);
    let landmarks: Vec<Landmark> = match landmarks.is_empty() {
        true => Landmark::ALL.to_vec(),
        false => landmarks.iter().map(read).collect::<PyResult<_>>()?,
    };
    let weights = parse::weights(weight).map_err(wrong)?.all();
    let wanted = names.iter().map(|name| parse::quantity(name).map_err(wrong));
    let wanted: Vec<Quantity> = wanted.collect::<PyResult<_>>()?;
    let digits = parse::digits(digits).map_err(wrong)?;
    let is_wanted = |of: &Quantity| wanted.is_empty() || wanted.contains(of);
    let answer = |(landmark, weight): (Landmark, SelfWeight)| {
        let asked: Vec<_> = quantities(landmark).filter(is_wanted).map(|of| (of, digits)).collect();
        let proved = || -> Result<Answer, Error> {
            let point = CertifiedLandmark::new(landmark, weight)?;
            let constants = point.constants_of(&asked)?;
            Ok(Answer::landmark((landmark, weight), Ok((&point, constants))))
        };
        proved().unwrap_or_else(|error| Answer::landmark((landmark, weight), Err(&error)))
    };
    let points: Vec<_> =
        weights.iter().flat_map(|&weight| landmarks.iter().map(move |&of| (of, weight))).collect();
    let found: Vec<Answer> =
        py.detach(|| on_threads(threads, || points.into_par_iter().map(answer).collect()))?;
    found.iter().map(|found| told::answer(py, found)).collect()
}

#[pyfunction]
pub(crate) fn state<'py>(
    py: Python<'py>,
    weight: &str,
    half_opening: &str,
    friction: &str,
    digits: &str,
    frictions: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let arch = arch(weight, half_opening, friction)?;
    let digits = parse::state_digits(digits).map_err(wrong)?;
    let found = py.detach(|| {
        on_threads(1, || {
            let found = Balls::DoubleDoubles.state(&arch, digits, frictions);
            let answer = Answer::state(1, &arch, &found);
            answer.with_asymmetric(|| asymmetric_thicknesses(&arch, digits))
        })
    })?;
    told::answer(py, &found)
}

#[pyfunction]
pub(crate) fn assess<'py>(
    py: Python<'py>,
    weight: &str,
    half_opening: &str,
    friction: &str,
    thickness: &str,
    digits: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let arch = arch(weight, half_opening, friction)?;
    let eta = parse::thickness(thickness).map_err(wrong)?;
    let digits = parse::state_digits(digits).map_err(wrong)?;
    let found = py.detach(|| {
        on_threads(1, || {
            let found = arch.certify_thickness(&eta, digits);
            let answer = Answer::assessment(1, (&arch, &eta), &found);
            answer.with_asymmetric(|| asymmetric_thicknesses(&arch, digits))
        })
    })?;
    told::answer(py, &found)
}

/// The question is the one for which everything is given that it needs: the package sees to that.
#[pyfunction]
pub(crate) fn find<'py>(
    py: Python<'py>,
    weight: &str,
    modes: Option<&str>,
    half_opening: Option<&str>,
    friction: Option<&str>,
    thickness: Option<&str>,
    digits: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let weight = parse::weight(weight).map_err(wrong)?;
    let question = parse::question(modes, (half_opening, friction), thickness).map_err(wrong)?;
    let digits = parse::state_digits(digits).map_err(wrong)?;
    let found = py.detach(|| on_threads(1, || seek::find(weight, &question, digits)))?;
    if let Err(Error::Refused(refused)) = &found {
        return Err(wrong(refused));
    }
    told::answer(py, &Answer::finding(1, (weight, &question), &found))
}

/// A certificate as a file has it.
fn written(made: Result<Certificate, Error>) -> PyResult<String> {
    let made = made.map_err(|error| match error {
        Error::Undecided(undecided) => UndecidedError::new_err(undecided.to_string()),
        Error::Refused(refused) => wrong(refused),
    })?;
    let mut bytes = Vec::new();
    made.write(&mut bytes)?;
    Ok(String::from_utf8(bytes)?)
}

#[pyfunction]
pub(crate) fn certify_landmark(
    py: Python<'_>,
    landmark: &str,
    weight: &str,
    digits: &str,
    threads: usize,
) -> PyResult<String> {
    let landmark = parse::landmark(landmark).map_err(wrong)?;
    let weight = parse::weight(weight).map_err(wrong)?;
    let digits = parse::digits(digits).map_err(wrong)?;
    written(
        py.detach(|| on_threads(threads, || certify::certify_landmark(landmark, weight, digits)))?,
    )
}

#[pyfunction]
pub(crate) fn certify_arch(
    py: Python<'_>,
    weight: &str,
    half_opening: &str,
    friction: &str,
    thickness: Option<&str>,
    digits: &str,
) -> PyResult<String> {
    let arch = arch(weight, half_opening, friction)?;
    let eta = thickness.map(|text| parse::thickness(text).map_err(wrong)).transpose()?;
    let digits = parse::state_digits(digits).map_err(wrong)?;
    written(py.detach(|| on_threads(1, || certify::certify_arch(&arch, eta.as_ref(), digits)))?)
}

/// Of the asymmetric solution of a kind; of that which is found, if it is one alone.
#[pyfunction]
pub(crate) fn certify_asymmetric(
    py: Python<'_>,
    weight: &str,
    half_opening: &str,
    friction: &str,
    mode: Option<&str>,
    digits: &str,
) -> PyResult<String> {
    let arch = arch(weight, half_opening, friction)?;
    if !arch.is_limited() {
        return Err(wrong("an asymmetric solution needs a limited friction"));
    }
    let mode = mode.map(parse::asymmetric_mode).transpose();
    let mode = mode.map_err(|error| wrong(format!("asymmetric: {error}, or True")))?;
    let digits = parse::state_digits(digits).map_err(wrong)?;
    let kinds = || certify::asymmetric_kinds(&arch);
    let mode = match mode {
        Some(mode) => mode,
        None => match py.detach(|| on_threads(1, kinds))?[..] {
            [kind] => kind,
            [] => return Err(UndecidedError::new_err("no asymmetric solution is found")),
            ref several => {
                let names: Vec<String> =
                    several.iter().map(|kind| format!("asymmetric='{}'", kind.name())).collect();
                return Err(wrong(format!("it has several: give {}", names.join(" or "))));
            }
        },
    };
    written(py.detach(|| on_threads(1, || certify::certify_asymmetric(&arch, mode, digits)))?)
}

#[pyfunction]
pub(crate) fn check<'py>(
    py: Python<'py>,
    certificate: &[u8],
    engine: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let engine = parse::engine(engine).map_err(wrong)?;
    let found = py.detach(|| on_threads(1, || engine.check(certificate)))?;
    match found {
        Ok(accepted) => told::checked(py, ("accepted", None), Some(&accepted)),
        Err(limit @ Refusal::Limit(..)) => {
            told::checked(py, ("not checked", Some(limit.to_string())), None)
        }
        Err(refusal) => told::checked(py, ("refused", Some(refusal.to_string())), None),
    }
}

/// What a report writes in a format.
fn report(report: &Report, content: Content, format: &str) -> PyResult<String> {
    let format = Format::named(content, format).ok_or_else(|| wrong("there is no such format"))?;
    let mut bytes = Vec::new();
    report.write(format, &mut bytes)?;
    Ok(String::from_utf8(bytes)?)
}

/// The identifiers of the claims, their places in the paper and their statements.
#[pyfunction]
pub(crate) fn claims() -> Vec<(&'static str, &'static str, &'static str)> {
    couplet::claims::claims().iter().map(|claim| (claim.id, claim.place, claim.statement)).collect()
}

/// `couplet.claims/3`.
#[pyfunction]
pub(crate) fn prove(py: Python<'_>, names: Vec<String>, threads: usize) -> PyResult<String> {
    let chosen = parse::claims_named(&names)
        .map_err(|error| wrong(format!("{error}; couplet.claims() lists the claims")))?;
    let decisions = py.detach(|| {
        on_threads(threads, || chosen.par_iter().map(|claim| claim.decide()).collect())
    })?;
    report(&Report::Claims(Claims { decisions, show: true, timed: true }), Content::Claims, "json")
}

/// The picture of an arch as SVG; none where nothing stands or nothing is proved.
#[pyfunction]
pub(crate) fn drawing(
    py: Python<'_>,
    weight: &str,
    half_opening: &str,
    friction: &str,
    thickness: Option<&str>,
) -> PyResult<Option<String>> {
    let arch = arch(weight, half_opening, friction)?;
    let eta = thickness.map(|text| parse::thickness(text).map_err(wrong)).transpose()?;
    let sketch = py.detach(|| {
        on_threads(1, || match &eta {
            Some(eta) => Sketch::standing(&arch, eta),
            None => Sketch::least(&arch, false),
        })
    })?;
    let sketch = match sketch {
        Ok(sketch) => sketch,
        Err(NoSketch::Falls(_) | NoSketch::Undecided(_)) => return Ok(None),
        Err(error) => return Err(wrong(error)),
    };
    let style = Style::default();
    let mut command = format!(
        "couplet draw --half-opening {half_opening} --friction {friction} --weight {weight}"
    );
    if let Some(eta) = thickness {
        command += &format!(" --thickness {eta}");
    }
    let sketched = Sketched { sketches: vec![sketch], style, measures: None, command };
    report(&Report::Sketched(sketched), Content::Drawing, "svg").map(Some)
}

/// The command with these arguments; its exit code.
#[pyfunction]
pub(crate) fn run(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| cli::run_from(arguments))
}
