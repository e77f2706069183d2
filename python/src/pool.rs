//! The threads that work is shared among: of our own, and of this process.
//!
//! A child that is forked has the memory of rayon's global pool and none of its threads, and would wait for
//! them for ever. So nothing runs in the global pool, and a pool is of the process that made it.

use crate::CoupletError;
use couplet::sweep::pool::{MAX_THREADS, usual_threads};
use pyo3::PyResult;
use pyo3::exceptions::PyRuntimeError;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::collections::HashMap;
use std::process;
use std::sync::{Arc, Mutex, PoisonError};

/// The pools of a process, by their threads.
struct Pools {
    process: u32,
    by_threads: HashMap<usize, Arc<ThreadPool>>,
}

static POOLS: Mutex<Option<Pools>> = Mutex::new(None);

/// Runs work on so many threads, 0 for one on each core; every parallel loop inside stays there.
pub(crate) fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let threads = match threads.min(MAX_THREADS) {
        0 => usual_threads().map_err(CoupletError::new_err)?,
        threads => threads,
    };
    Ok(pool(threads)?.install(work))
}

/// Digits of an arch up to which nothing is shared among threads: to wait for another costs as much as the work.
const FEW_DIGITS: usize = 1000;

/// Runs work on an arch to so many digits, on no more than one thread: on this one, if they are few.
pub(crate) fn on_one_thread<T: Send>(
    digits: usize,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    if digits <= FEW_DIGITS { Ok(work()) } else { on_threads(1, work) }
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
