//! Description in a file of TOML, a scene or a sweep: read whole, its faults told.

use crate::cli::line::say;
use crate::report::words::count;
use crate::sweep::failure::Failure;
use crate::sweep::scene::{Fault, MAX_BYTES};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Name of a file in a message.
fn name(path: &Path) -> String {
    if path == Path::new("-") { "standard input".into() } else { path.display().to_string() }
}

/// Writes faults, or what is worth a remark, with their places in a file, a line each.
pub(crate) fn remark(path: &Path, faults: &[Fault]) {
    let name = name(path);
    for Fault { place, message } in faults {
        say(&format!("{name}:{}:{}: {message}", place.line, place.column));
    }
}

/// Content that a file, or standard input where it is `-`, describes; its faults go to standard error, a line each.
pub(crate) fn described<T>(
    path: &Path,
    read: impl FnOnce(&[u8]) -> Result<T, Vec<Fault>>,
) -> Result<T, Failure> {
    let standard = path == Path::new("-");
    let name = name(path);
    let failed = |error: io::Error| Failure::reading(&name, &error);
    let mut bytes = Vec::new();
    let file: Box<dyn Read> = match standard {
        true => Box::new(io::stdin()),
        false => Box::new(File::open(path).map_err(failed)?),
    };
    // One more than is allowed, so that more is seen.
    file.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes).map_err(failed)?;
    read(&bytes).map_err(|faults| {
        remark(path, &faults);
        let errors = count(faults.len(), "error", "errors");
        Failure::Input(format!("{name} has {errors}; nothing was computed"))
    })
}
