//! One question at a time. Every argument is text, read by what reads the command's, so that the same input gets the
//! same sentence.

use crate::pool::{on_one_thread, on_threads};
use crate::{CoupletError, UndecidedError, told};
use couplet::ask::{ArchAsked, ArchGiven, ArchQuestion, Field, Spelling, SurveyGiven, notes};
use couplet::certify::quantities;
use couplet::certify::state::{Balls, Certify};
use couplet::cli::{self, doors};
use couplet::door::find::{self as sought, FindTarget};
use couplet::problem::{Arch, Line, Mode, Quantity};
use couplet::report::{Answer, Claims, Extent, Format, Reported, Style, TiltDrawing, Understood};
use couplet::sweep::failure::Failure;
use couplet::sweep::{answer, parse, surveyed as survey};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fmt::Display;

/// The error of a question that makes no sense.
pub(crate) fn wrong(error: impl Display) -> PyErr {
    CoupletError::new_err(error.to_string())
}

/// The error of a command that failed.
fn failed(failure: Failure) -> PyErr {
    match failure {
        Failure::Undecided(_) => UndecidedError::new_err(failure.to_string()),
        Failure::Input(_) | Failure::Io(_) => wrong(failure),
    }
}

/// The name of a quantity, of which a letter may be given.
#[pyfunction(name = "quantity")]
pub(crate) fn quantity_name(name: &str) -> PyResult<&'static str> {
    parse::quantity(name).map(|quantity| quantity.name()).map_err(wrong)
}

/// The labels of the modes, in the order of their codes.
#[pyfunction]
pub(crate) fn modes() -> Vec<&'static str> {
    Mode::ALL.map(Mode::label).to_vec()
}

#[pyfunction]
pub(crate) fn constants<'py>(
    py: Python<'py>,
    landmark: &str,
    weight: &str,
    names: Vec<String>,
    digits: &str,
    threads: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let landmark = parse::landmark(landmark).map_err(wrong)?;
    let &[weight] = parse::weights(weight).map_err(wrong)? else {
        return Err(wrong("one weight at a time: heyman or milankovitch"));
    };
    let wanted = names.iter().map(|name| parse::quantity(name).map_err(wrong));
    let wanted: Vec<Quantity> = wanted.collect::<PyResult<_>>()?;
    let digits = parse::digits(digits).map_err(wrong)?;
    let found = on_threads(py, threads, move || {
        let is_wanted = |of: &Quantity| wanted.is_empty() || wanted.contains(of);
        let asked: Vec<_> = quantities(landmark).filter(is_wanted).map(|of| (of, digits)).collect();
        let found = answer::landmark((landmark, weight), &asked);
        found.unwrap_or_else(|error| Answer::landmark((landmark, weight), Err(&error)))
    })?;
    told::answer(py, &found)
}

/// The texts of an arch, by the names of its fields.
pub(crate) type Texts = BTreeMap<String, String>;

/// An arch that is asked about.
pub(crate) fn asked(texts: &Texts) -> ArchAsked {
    ArchAsked::of(texts.iter().filter_map(|(name, text)| Some((Field::named(name)?, &**text))))
}

/// Warns of what may have been meant otherwise.
pub(crate) fn warn(py: Python<'_>, notes: impl IntoIterator<Item: AsRef<str>>) -> PyResult<()> {
    for note in notes {
        py.import("couplet._asked")?.call_method1("warn", (note.as_ref(),))?;
    }
    Ok(())
}

/// What is understood of an arch, and the arch.
pub(crate) fn given(
    py: Python<'_>,
    question: &ArchQuestion,
    weight: &str,
    texts: &Texts,
) -> PyResult<(ArchGiven, Arch)> {
    let weight = parse::weight(weight).map_err(wrong)?;
    let given = ArchGiven::read(question, &asked(texts), Spelling::Key).map_err(wrong)?;
    let arch = given.arch(weight).map_err(wrong)?;
    warn(py, given.notes())?;
    Ok((given, arch))
}

/// The names of the fields of an arch, in their order.
#[pyfunction]
pub(crate) fn fields() -> Vec<&'static str> {
    Field::ALL.iter().map(|field| field.name()).collect()
}

#[pyfunction]
pub(crate) fn state<'py>(
    py: Python<'py>,
    weight: &str,
    texts: Texts,
    digits: &str,
    frictions: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let (measures, arch) = match (texts.get("half_opening"), texts.get("friction")) {
        // There is nothing to be understood of most arches.
        (Some(half_opening), Some(friction)) if texts.len() == 2 => {
            let arch = parse::arch([weight, half_opening, friction]).map_err(wrong)?;
            warn(py, notes([arch.friction()]))?;
            (None, arch)
        }
        _ => {
            let (given, arch) = given(py, &doors::STATE, weight, &texts)?;
            (given.measures, arch)
        }
    };
    let digits = parse::digits(digits).map_err(wrong)?;
    let found = on_one_thread(py, digits, move || {
        let found = Balls::DoubleDoubles.state(&arch, digits, frictions);
        answer::state(1, (&arch, measures.as_ref().map(|of| (of, digits))), digits, &found)
    })?;
    told::answer(py, &found)
}

#[pyfunction]
pub(crate) fn assess<'py>(
    py: Python<'py>,
    weight: &str,
    texts: Texts,
    digits: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let (given, arch) = given(py, &doors::ASSESS, weight, &texts)?;
    let ArchGiven { thickness, measures, .. } = given;
    let eta = thickness.ok_or_else(|| wrong("thickness is missing"))?;
    let digits = parse::digits(digits).map_err(wrong)?;
    let found = on_one_thread(py, digits, move || {
        let found = arch.certify_thickness(&eta, digits);
        let measures = measures.as_ref().map(|of| (of, digits));
        answer::assessment(Extent::ALL, 1, (&arch, &eta, measures), digits, &found)
    })?;
    told::answer(py, &found)
}

/// JSON of all arches of a question with ranges; none if it has no range.
#[pyfunction]
pub(crate) fn surveyed(
    py: Python<'_>,
    question: &str,
    weight: &str,
    texts: Texts,
    digits: &str,
) -> PyResult<Option<String>> {
    let asked = asked(&texts);
    if !asked.has_range() {
        return Ok(None);
    }
    let question = if question == "assess" { &doors::ASSESS } else { &doors::STATE };
    let weight = parse::weight(weight).map_err(wrong)?;
    let given = SurveyGiven::read(question, &asked, Spelling::Key).map_err(wrong)?;
    warn(py, notes(&given.friction))?;
    let digits = parse::digits(digits).map_err(wrong)?;
    let found = on_threads(py, 1, move || {
        let quantities = survey::quantities(&asked);
        survey::surveyed(&asked, &given, weight, (&quantities, digits))
    })?;
    report(&found.map_err(failed)?, "json").map(Some)
}

/// JSON of arches of stones, with the values of each and those at its thickness.
#[pyfunction]
pub(crate) fn voussoirs<'py>(
    py: Python<'py>,
    question: &str,
    weight: &str,
    texts: Texts,
    digits: &str,
) -> PyResult<(String, Vec<[Bound<'py, PyDict>; 2]>)> {
    let question = match question {
        "state" => &doors::STATE,
        "assess" => &doors::ASSESS,
        _ => &doors::VOUSSOIRS,
    };
    let (given, arch) = given(py, question, weight, &texts)?;
    let understood = Understood::new(&asked(&texts), &given);
    let digits = parse::digits(digits).map_err(wrong)?;
    let made = on_threads(py, 1, move || {
        doors::of_stones((understood, &given), &[arch], (digits, digits))
    })?;
    let made = made.map_err(failed)?;
    let values = made.arches.iter().map(|arch| told::voussoirs(py, arch));
    let values = values.collect::<PyResult<_>>()?;
    Ok((report(&made, "json")?, values))
}

/// JSON of an arch under an acceleration, or its picture, which names a command; and the largest acceleration.
#[pyfunction]
pub(crate) fn tilted<'py>(
    py: Python<'py>,
    weight: &str,
    texts: Texts,
    digits: &str,
    command: Option<String>,
) -> PyResult<(String, Bound<'py, PyDict>)> {
    let (given, arch) = given(py, &doors::ASSESS, weight, &texts)?;
    let understood = Understood::new(&asked(&texts), &given);
    let (Some(eta), Some(tilt)) = (given.thickness.clone(), given.tilt.clone()) else {
        return Err(wrong("thickness, tilt are missing"));
    };
    let stones = doors::divisions(&given).map_err(failed)?;
    let digits = parse::digits(digits).map_err(wrong)?;
    let measures = given.measures;
    let sizes = measures.clone();
    let found = on_threads(py, 1, move || {
        let measures = sizes.as_ref().map(|measures| (measures, digits));
        doors::tilted((&understood, &arch), (&eta, &tilt, stones.first()), (digits, measures))
    })?;
    let mut found = found.map_err(failed)?;
    let values = told::tilted(py, &found)?;
    let told = match command {
        Some(command) => {
            found.command = command;
            let amplitude = Style::default().amplitude;
            report(&TiltDrawing { arches: vec![found], measures, amplitude }, "svg")?
        }
        None => report(&found, "json")?,
    };
    Ok((told, values))
}

/// What is found, and the modes of a boundary.
pub(crate) fn target_of(
    (what, modes): (&str, Option<&str>),
) -> PyResult<(FindTarget, Option<Line>)> {
    let modes = modes.map(sought::line).transpose();
    Ok((sought::what(what).map_err(wrong)?, modes.map_err(wrong)?))
}

#[pyfunction]
pub(crate) fn find<'py>(
    py: Python<'py>,
    target: (&str, Option<&str>),
    weight: &str,
    texts: Texts,
    digits: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let weight = parse::weight(weight).map_err(wrong)?;
    let question = sought::question(target_of(target)?, &asked(&texts), Spelling::Key);
    let question = question.map_err(failed)?;
    warn(py, notes(question.friction()))?;
    let digits = parse::digits(digits).map_err(wrong)?;
    let found = on_threads(py, 1, move || answer::finding(1, (weight, &question), digits))?;
    told::answer(py, &found.map_err(wrong)?)
}

/// What a report writes in a format.
fn report<R: Reported>(report: &R, format: &str) -> PyResult<String> {
    let format =
        Format::named(R::content(), format).ok_or_else(|| wrong("there is no such format"))?;
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
    let decide = move || chosen.par_iter().map(|claim| claim.decide()).collect();
    let decisions = on_threads(py, threads, decide)?;
    report(&Claims { decisions, show: true, timed: true }, "json")
}

/// The command within this process: its exit code, what it writes, and the lines that it says.
#[pyfunction]
pub(crate) fn command(
    py: Python<'_>,
    arguments: Vec<OsString>,
    threads: usize,
) -> PyResult<(u8, Bound<'_, PyBytes>, Vec<String>)> {
    let (code, heard) = on_threads(py, threads, move || cli::heard(arguments))?;
    Ok((code, PyBytes::new(py, &heard.written), heard.said))
}

/// The command as a process of its own has it; its exit code.
#[pyfunction]
pub(crate) fn run(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| cli::run_from(arguments))
}
