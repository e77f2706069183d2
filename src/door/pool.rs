//! The threads that work is shared among.

use crate::sweep::failure::Failure;
use rayon::ThreadPoolBuilder;
use std::{env, thread};

/// The most threads that are started.
pub const MAX_THREADS: usize = 1024;

/// Reads a number of threads.
pub fn read(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|number| (1..=MAX_THREADS).contains(number));
    number.ok_or_else(|| format!("threads are a whole number from 1 to {MAX_THREADS}"))
}

/// The threads where nobody says how many: 0 for one on each core, or what the environment says to rayon, which would
/// start any number.
pub fn usual_threads() -> Result<usize, String> {
    let said = |name: &'static str| {
        let text = env::var(name).ok()?;
        Some((name, text)).filter(|(_, text)| text.parse::<usize>().is_ok_and(|number| number > 0))
    };
    match said("RAYON_NUM_THREADS").or_else(|| said("RAYON_RS_NUM_CPUS")) {
        Some((name, text)) => read(&text).map_err(|error| format!("{name}={text}: {error}")),
        None => Ok(0),
    }
}

/// Starts the pool (by default one thread per core) and probes that another thread can start, as for a progress
/// bar: later that would be a panic.
pub fn start(threads: Option<usize>) -> Result<(), Failure> {
    let failed = |error: &dyn std::fmt::Display| {
        Failure::Io(format!("cannot start threads ({error}); --threads 1 asks for fewer"))
    };
    let threads = threads.map_or_else(usual_threads, Ok).map_err(Failure::Input)?;
    let pool = ThreadPoolBuilder::new().num_threads(threads);
    pool.build_global().map_err(|error| failed(&error))?;
    let spare = thread::Builder::new().spawn(|| ()).map_err(|error| failed(&error))?;
    spare.join().map_err(|_| failed(&"it ended"))
}
