//! The threads that work is shared among: of our own, and of this process.
//!
//! A child that is forked has the memory of rayon's global pool and none of its threads, and would wait for
//! them for ever. So nothing runs in the global pool, and a pool is of the process that made it.

//!
//! The thread that calls waits, and looks for signals meanwhile: so Ctrl-C ends a long call within a moment. Work that
//! is given up goes on until it ends by itself, in a pool of its own from then on, and its result is dropped.

use crate::CoupletError;
use couplet::door::pool::{MAX_THREADS, usual_threads};
use couplet::problem::Quantity;
use pyo3::exceptions::PyRuntimeError;
use pyo3::{PyResult, Python};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use std::{process, thread};

/// The pools of a process, by their threads.
struct Pools {
    process: u32,
    by_threads: HashMap<usize, Arc<ThreadPool>>,
}

static POOLS: Mutex<Option<Pools>> = Mutex::new(None);

/// Time after which a call looks for signals.
const MOMENT: Duration = Duration::from_millis(100);

/// What work leaves: its result, or what it panicked with.
type Left<T> = thread::Result<T>;

/// Runs work on so many threads, 0 for one on each core; every parallel loop inside stays there.
pub(crate) fn on_threads<T: Send + 'static>(
    py: Python<'_>,
    threads: usize,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let threads = match threads.min(MAX_THREADS) {
        0 => usual_threads().map_err(CoupletError::new_err)?,
        threads => threads,
    };
    let (sender, receiver) = channel();
    pool(threads)?.spawn(move || leave(work, &sender));
    waited(py, receiver).inspect_err(|_| give_up(threads))
}

/// Digits of an arch up to which nothing is shared among threads: to wait for another costs as much as the work.
const FEW_DIGITS: usize = 1000;

/// Runs work on an arch to so many digits, on no more than one thread: on this one, if they are few.
pub(crate) fn on_one_thread<T: Send + 'static>(
    py: Python<'_>,
    digits: usize,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    if digits <= FEW_DIGITS { Ok(py.detach(work)) } else { on_threads(py, 1, work) }
}

/// Rows that the thread that calls answers itself: to wait for another costs as much as they do.
const FEW_ROWS: usize = 16;

/// Tells whether so many rows with these quantities are not worth a thread; an asymmetric thickness may take a while.
pub(crate) fn is_short(rows: usize, quantities: &[Quantity]) -> bool {
    rows <= FEW_ROWS && !quantities.contains(&Quantity::AsymmetricThickness)
}

fn leave<T>(work: impl FnOnce() -> T, sender: &Sender<Left<T>>) {
    // Nobody waits any more if the call was ended by a signal.
    let _ = sender.send(catch_unwind(AssertUnwindSafe(work)));
}

/// The result of work, unless a signal ends the call first.
fn waited<T: Send>(py: Python<'_>, receiver: Receiver<Left<T>>) -> PyResult<T> {
    let receiver = Mutex::new(receiver);
    let wait = || receiver.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(MOMENT);
    loop {
        match py.detach(wait) {
            Ok(Ok(found)) => return Ok(found),
            Ok(Err(panic)) => resume_unwind(panic),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the work ended without a result"));
            }
        }
    }
}

/// Leaves a pool to the work that is given up there.
fn give_up(threads: usize) {
    let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
    pools.as_mut().and_then(|pools| pools.by_threads.remove(&threads));
}

fn pool(threads: usize) -> PyResult<Arc<ThreadPool>> {
    let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
    if pools.as_ref().is_some_and(|pools| pools.process != process::id()) {
        // Their threads are the parent's: they cannot be ended from here.
        std::mem::forget(pools.take());
    }
    let pools =
        pools.get_or_insert_with(|| Pools { process: process::id(), by_threads: HashMap::new() });
    if let Some(pool) = pools.by_threads.get(&threads) {
        return Ok(Arc::clone(pool));
    }
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| {
        PyRuntimeError::new_err(format!("cannot start threads ({error}); threads=1 asks for fewer"))
    })?;
    let pool = Arc::new(pool);
    pools.by_threads.insert(threads, Arc::clone(&pool));
    Ok(pool)
}
