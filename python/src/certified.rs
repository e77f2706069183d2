//! Certificates, as the text of a file has them, and their check.

use crate::asked::{Texts, asked, given, warn, wrong};
use crate::pool::on_threads;
use crate::{UndecidedError, told};
use couplet::Error;
use couplet::ask::{ArchAsked, Spelling, SurveyGiven, notes};
use couplet::certify;
use couplet::check::{Certificate, Refusal, SurveyCertificate};
use couplet::cli::doors;
use couplet::sweep::parse;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::io;

/// A certificate as a file has it.
fn written<T>(made: Result<T, Error>, write: Writer<T>) -> PyResult<String> {
    let made = made.map_err(|error| match error {
        Error::Undecided(undecided) => UndecidedError::new_err(undecided.to_string()),
        Error::Refused(refused) => wrong(refused),
    })?;
    let mut bytes = Vec::new();
    write(&made, &mut bytes)?;
    Ok(String::from_utf8(bytes)?)
}

type Writer<T> = fn(&T, &mut dyn io::Write) -> io::Result<()>;

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
    let made = move || certify::certify_landmark(landmark, weight, digits);
    written(on_threads(py, threads, made)?, Certificate::write)
}

/// Of an arch, or of the verdict on all arches of a question with ranges, which threads share.
#[pyfunction]
pub(crate) fn certify_arch(
    py: Python<'_>,
    weight: &str,
    texts: Texts,
    digits: &str,
    threads: usize,
) -> PyResult<String> {
    let ranges = asked(&texts);
    if ranges.has_range() {
        return certify_survey(py, weight, &ranges, digits, threads);
    }
    let has_thickness = texts.contains_key("thickness");
    let question = if has_thickness { &doors::CERTIFY_ARCH } else { &doors::CERTIFY_STATE };
    let (given, arch) = given(py, question, weight, &texts)?;
    let digits = parse::digits(digits).map_err(wrong)?;
    let made = move || certify::certify_arch(&arch, given.thickness.as_ref(), digits);
    written(on_threads(py, 1, made)?, Certificate::write)
}

fn certify_survey(
    py: Python<'_>,
    weight: &str,
    asked: &ArchAsked,
    digits: &str,
    threads: usize,
) -> PyResult<String> {
    let weight = parse::weight(weight).map_err(wrong)?;
    let given = SurveyGiven::read(&doors::CERTIFY_SURVEY, asked, Spelling::Key).map_err(wrong)?;
    let survey = given.survey(weight).map_err(wrong)?;
    warn(py, notes(&given.friction))?;
    let digits = parse::digits(digits).map_err(wrong)?;
    let made = on_threads(py, threads, move || certify::certify_survey(&survey, digits))?;
    written(made, SurveyCertificate::write)
}

/// Of the asymmetric solution of a kind; of that which is found, if it is one alone.
#[pyfunction]
pub(crate) fn certify_asymmetric(
    py: Python<'_>,
    weight: &str,
    texts: Texts,
    mode: Option<&str>,
    digits: &str,
) -> PyResult<String> {
    let (_, arch) = given(py, &doors::CERTIFY_ASYMMETRIC, weight, &texts)?;
    if !arch.is_limited() {
        return Err(wrong("an asymmetric solution needs a limited friction"));
    }
    let mode = mode.map(parse::asymmetric_mode).transpose();
    let mode = mode.map_err(|error| wrong(format!("asymmetric: {error}, or True")))?;
    let digits = parse::digits(digits).map_err(wrong)?;
    let of = arch.clone();
    let kinds = move || certify::asymmetric_kinds(&of);
    let mode = match mode {
        Some(mode) => mode,
        None => match on_threads(py, 1, kinds)?[..] {
            [kind] => kind,
            [] => return Err(UndecidedError::new_err("no asymmetric solution is found")),
            ref several => {
                let names: Vec<String> =
                    several.iter().map(|kind| format!("asymmetric='{}'", kind.name())).collect();
                return Err(wrong(format!("it has several: give {}", names.join(" or "))));
            }
        },
    };
    let made = move || certify::certify_asymmetric(&arch, mode, digits);
    written(on_threads(py, 1, made)?, Certificate::write)
}

#[pyfunction]
pub(crate) fn check<'py>(
    py: Python<'py>,
    certificate: Vec<u8>,
    engine: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let engine = parse::engine(engine).map_err(wrong)?;
    let found = on_threads(py, 1, move || engine.check(&certificate))?;
    match found {
        Ok(accepted) => told::checked(py, ("accepted", None), Some(&accepted)),
        Err(limit @ Refusal::Limit(..)) => {
            told::checked(py, ("not checked", Some(limit.to_string())), None)
        }
        Err(refusal) => told::checked(py, ("refused", Some(refusal.to_string())), None),
    }
}
