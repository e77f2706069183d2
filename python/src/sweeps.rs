//! Sweeps: a part of one is a function of the folder and of a number, which any process may call.

use crate::CoupletError;
use crate::pool::on_threads;
use couplet::scene::{Fault, read_sweep};
use couplet::sweep::failure::Failure;
use couplet::sweep::sweep::{Sweep, verify};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

fn wrong(failure: Failure) -> PyErr {
    match failure {
        Failure::Input(message) | Failure::Undecided(message) => CoupletError::new_err(message),
        Failure::Io(message) => PyOSError::new_err(message),
    }
}

/// The sweep that was opened last, by its folder and the one where its paths begin: its record may be long.
static OPENED: Mutex<Option<(PathBuf, PathBuf, Arc<Sweep>)>> = Mutex::new(None);

fn opened(folder: &Path, base: &Path) -> PyResult<Arc<Sweep>> {
    let mut opened = OPENED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((of, at, sweep)) = opened.as_ref()
        && (of.as_path(), at.as_path()) == (folder, base)
    {
        return Ok(Arc::clone(sweep));
    }
    let sweep = Arc::new(Sweep::open(folder, base).map_err(wrong)?);
    *opened = Some((folder.to_owned(), base.to_owned(), Arc::clone(&sweep)));
    Ok(sweep)
}

/// The folder of a sweep, other sweeps beside it, the files of a data set that cannot be read, and remarks on the plan.
type Begun = (PathBuf, Vec<String>, Vec<String>, Vec<String>);

/// Begins the sweep of a plan, or goes on with it.
#[pyfunction]
pub(crate) fn sweep_begin(
    py: Python<'_>,
    plan: &[u8],
    base: PathBuf,
    output: PathBuf,
) -> PyResult<Begun> {
    let lines = |faults: &[Fault]| -> Vec<String> {
        let line = |Fault { place, message }: &Fault| {
            format!("line {}, column {}: {message}", place.line, place.column)
        };
        faults.iter().map(line).collect()
    };
    let (plan, notes) =
        read_sweep(plan).map_err(|faults| CoupletError::new_err(lines(&faults).join("\n")))?;
    let notes = lines(&notes);
    py.detach(|| {
        let sweep = Sweep::new(plan, &base, &output).map_err(wrong)?;
        let others = sweep.others();
        sweep.prepare().map_err(wrong)?;
        Ok((sweep.folder().to_owned(), others, sweep.bad_files(), notes))
    })
}

/// A part, its rows, and the counts of its verdicts if it is there.
type Surveyed = (usize, u64, Option<[u64; 4]>);

/// For each part of a share its number, its rows, and the counts of its verdicts if it is there.
#[pyfunction]
pub(crate) fn sweep_survey(
    py: Python<'_>,
    folder: PathBuf,
    base: PathBuf,
    share: (usize, usize),
    threads: usize,
) -> PyResult<Vec<Surveyed>> {
    let sweep = opened(&folder, &base)?;
    let parts = sweep.share(share.0, share.1);
    let of = Arc::clone(&sweep);
    let survey = on_threads(py, threads, move || of.survey(&parts, false))?.map_err(wrong)?;
    let rows = |part: usize| sweep.rows(part).end - sweep.rows(part).start;
    Ok(survey.into_iter().map(|(part, counts)| (part, rows(part), counts)).collect())
}

/// Computes and writes a part; the counts of its verdicts.
#[pyfunction]
pub(crate) fn sweep_part(
    py: Python<'_>,
    folder: PathBuf,
    base: PathBuf,
    part: usize,
    threads: usize,
) -> PyResult<[u64; 4]> {
    let sweep = opened(&folder, &base)?;
    if part >= sweep.parts() {
        return Err(CoupletError::new_err(format!("the sweep has no part {part}")));
    }
    on_threads(py, threads, move || sweep.compute(part))?.map_err(wrong)
}

/// What was looked through: parts, rows, rows proved again, rows certified, faults.
type Looked = (usize, u64, usize, usize, Vec<String>);

/// Looks through the parts of a share.
#[pyfunction]
pub(crate) fn sweep_verify(
    py: Python<'_>,
    folder: PathBuf,
    base: PathBuf,
    share: (usize, usize),
    sample: usize,
    threads: usize,
) -> PyResult<Looked> {
    let sweep = opened(&folder, &base)?;
    let parts = sweep.share(share.0, share.1);
    let look = move || verify(&sweep, &parts, sample, &|_| ());
    let found = on_threads(py, threads, look)?.map_err(wrong)?;
    Ok((found.parts, found.rows, found.again, found.certified, found.faults))
}
