//! Threads of a call, which end with it: the library keeps none, so that a process can be forked at any time.

use crate::failure::Failure;
use couplet::door::pool::{MAX_THREADS, usual_threads};
use couplet::rug::float::{FreeCache, free_cache};
use rayon::ThreadPoolBuilder;

/// Runs work on so many threads, 0 for one on each core. Every parallel loop inside stays there.
pub(crate) fn on_threads<T: Send>(
    threads: usize,
    work: impl FnOnce() -> T + Send,
) -> Result<T, Failure> {
    let failed = |error| {
        let message = format!("cannot start threads ({error}); one thread asks for fewer");
        Failure::Resource(message)
    };
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_scoped(
            |thread| {
                give_back_at_the_end();
                thread.run();
            },
            |pool| pool.install(work),
        )
        .map_err(failed)
}

/// A number of threads that makes sense.
pub(crate) fn checked(threads: usize) -> Result<usize, Failure> {
    let wrong = || {
        let message = "threads are a whole number from 1 to 1024, or 0 for one on each core";
        Failure::Usage(message.into())
    };
    match threads {
        0 => usual_threads().map_err(Failure::Usage),
        1..=MAX_THREADS => Ok(threads),
        _ => Err(wrong()),
    }
}

/// What MPFR keeps for a thread, as the digits of pi.
struct Kept;

impl Drop for Kept {
    fn drop(&mut self) {
        free_cache(FreeCache::Local);
    }
}

/// Has what MPFR keeps for this thread given back when the thread ends.
pub(crate) fn give_back_at_the_end() {
    thread_local! {
        static KEPT: Kept = const { Kept };
    }
    // A thread that is ending has given back.
    let _ = KEPT.try_with(|_| ());
}
