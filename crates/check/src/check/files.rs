//! Lines that `couplet check` and `couplet-check` print on files, one for each, and the exit code.

use super::accepted_file::AcceptedFile;
use super::checker::MAX_DIGITS;
use super::engine::Engine;
use super::refusal::Refusal;
use super::visible::visible_name;
use std::ffi::{OsStr, OsString};
use std::fs::File;
use std::io::{self, Read, Write};

/// A certificate of a million digits has about 25 MB.
const MAX_BYTES: u64 = 64 << 20;

/// Words of an acceptance: its summary or its statement.
pub type Words = fn(&AcceptedFile) -> String;

/// Reason why a file, or one of several, was not accepted, in one line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CheckFailure {
    /// At least one was refused.
    Refused(String),
    /// None was refused; one was not read or not checked, or a line could not be written.
    Open(String),
}

/// Checks files in the arithmetic `engine`; `-` is standard input. Each gets one line on standard output: `accepted`,
/// `refused`, `not checked` or `not read`. `words` are those of an acceptance, `larger` those for an arithmetic that
/// takes more digits.
pub fn check_files(
    names: &[OsString],
    engine: Engine,
    words: Words,
    larger: &str,
) -> Result<(), CheckFailure> {
    let (mut refused, mut open) = (0, 0);
    for name in names {
        let checked = check_one(name, engine, words, larger);
        refused += usize::from(matches!(checked, Err(CheckFailure::Refused(_))));
        open += usize::from(matches!(checked, Err(CheckFailure::Open(_))));
        let (Ok(said) | Err(CheckFailure::Refused(said) | CheckFailure::Open(said))) = checked;
        print(format!("{}: {said}\n", visible_name(name)).as_bytes())?;
    }
    let all = names.len();
    match (refused, open) {
        (0, 0) => Ok(()),
        (0, open) => Err(CheckFailure::Open(format!("{open} of {all} not checked"))),
        (refused, 0) => Err(CheckFailure::Refused(format!("{refused} of {all} refused"))),
        (refused, open) => {
            Err(CheckFailure::Refused(format!("{refused} of {all} refused, {open} not checked")))
        }
    }
}

/// The words on a file that is accepted, or why it is not.
fn check_one(
    name: &OsStr,
    engine: Engine,
    words: Words,
    larger: &str,
) -> Result<String, CheckFailure> {
    let unread = |error| CheckFailure::Open(format!("not read: {}", reason(&error)));
    let bytes = read(name).map_err(unread)?;
    let refused = |why: String| CheckFailure::Refused(format!("refused: {why}"));
    if bytes.len() as u64 > MAX_BYTES {
        return Err(refused(format!("the file has more than {MAX_BYTES} bytes")));
    }
    let accepted = engine.check(&bytes).map_err(|refusal| match refusal {
        Refusal::Limit(..) => CheckFailure::Open(format!(
            "not checked: {refusal}; {larger} checks up to {MAX_DIGITS}"
        )),
        _ => refused(refusal.to_string()),
    })?;
    Ok(format!("accepted  {}", words(&accepted)))
}

/// The bytes of a file or of standard input, `-`: a little more than the most that is allowed at the most.
pub fn read(name: &OsStr) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    if name == "-" {
        io::stdin().lock().take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    } else {
        let file = File::open(name)?;
        // A file of this size is read into memory of this size.
        let size = file.metadata().map_or(0, |file| file.len()).min(MAX_BYTES);
        bytes.reserve_exact(usize::try_from(size).unwrap_or(0) + 1);
        file.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    }
    Ok(bytes)
}

/// The kind of an error in plain words. Its own text may name a temporary file, which the user does not know.
pub fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file or folder".into(),
        io::ErrorKind::AlreadyExists | io::ErrorKind::NotADirectory => {
            "expected a folder, found a file".into()
        }
        io::ErrorKind::Other => error.to_string(),
        kind => kind.to_string(),
    }
}

/// Writes to standard output. A reader that closes the pipe early is no failure.
pub fn print(bytes: &[u8]) -> Result<(), CheckFailure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(CheckFailure::Open(format!("cannot write to standard output: {}", reason(&error))))
        }
        _ => Ok(()),
    }
}
