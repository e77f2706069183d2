//! The threads that work is shared among.

use super::failure::Failure;
use rayon::ThreadPoolBuilder;
use std::thread;

/// Starts so many, one for each core if not given, and sees whether one more could be, as for a progress bar: later a
/// thread that cannot start would be a panic.
pub(super) fn start(threads: Option<usize>) -> Result<(), Failure> {
    let failed = |error: &dyn std::fmt::Display| {
        Failure::Io(format!("cannot start threads ({error}); --threads 1 asks for fewer"))
    };
    let pool = ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0));
    pool.build_global().map_err(|error| failed(&error))?;
    let spare = thread::Builder::new().spawn(|| ()).map_err(|error| failed(&error))?;
    spare.join().map_err(|_| failed(&"it ended"))
}
