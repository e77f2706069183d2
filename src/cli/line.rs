//! The command of this run: what a picture or a record says of how it was made, and who hears what it writes and says.

use crate::ask::quoted;
use crate::check::visible;
use std::cell::RefCell;
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::Path;

thread_local! {
    /// The command that began last in this thread.
    static RUN: RefCell<Run> = RefCell::default();
}

#[derive(Default)]
struct Run {
    words: Vec<OsString>,
    heard: Option<Heard>,
}

/// Output and messages of a command that a program ran within itself.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Heard {
    /// Bytes for standard output.
    pub written: Vec<u8>,
    /// Lines for standard error.
    pub said: Vec<String>,
}

/// Keeps the arguments of a command that begins.
pub(super) fn keep(arguments: &[OsString]) {
    RUN.with_borrow_mut(|run| run.words = arguments.to_vec());
}

/// The command as it was typed, but for the folder of the file that it writes, which is of one machine.
pub(super) fn typed() -> String {
    let mut before = OsString::new();
    let mut word = |word: &OsString| {
        let text = word.to_string_lossy();
        let (option, file) = match text.strip_prefix("--output=") {
            Some(file) => ("--output=", Some(file)),
            None => ("", (before == "-o" || before == "--output").then_some(&*text)),
        };
        before.clone_from(word);
        let name = file.and_then(|file| Path::new(file).file_name());
        name.map_or_else(|| text.to_string(), |name| format!("{option}{}", name.to_string_lossy()))
    };
    let words: Vec<String> =
        RUN.with_borrow(|run| run.words.iter().map(|text| quoted(&word(text))).collect());
    format!("couplet {}", words.join(" "))
}

/// Hears what a command writes and says. One may begin while this thread waits in another.
pub(super) fn heard<T>(command: impl FnOnce() -> T) -> (T, Heard) {
    let around = RUN.replace(Run { words: Vec::new(), heard: Some(Heard::default()) });
    let done = command();
    (done, RUN.replace(around).heard.unwrap_or_default())
}

/// Tells whether a program hears the command.
pub(super) fn is_heard() -> bool {
    RUN.with_borrow(|run| run.heard.is_some())
}

/// Says a line to who hears, or to standard error; nobody may be reading that.
pub(crate) fn say(text: &str) {
    let line = visible(text);
    let unheard = RUN.with_borrow_mut(|run| match &mut run.heard {
        Some(heard) => {
            heard.said.push(line);
            None
        }
        None => Some(line),
    });
    if let Some(line) = unheard {
        let _ = writeln!(io::stderr(), "{line}");
    }
}

/// Writes for who hears, or to standard output.
pub(super) fn write(report: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    if !is_heard() {
        return report(&mut io::stdout().lock());
    }
    let mut written = Vec::new();
    let result = report(&mut written);
    RUN.with_borrow_mut(|run| {
        if let Some(heard) = &mut run.heard {
            heard.written.append(&mut written);
        }
    });
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_command_is_heard_by_who_ran_it() {
        let bytes = |text: &'static [u8]| write(|out| out.write_all(text)).unwrap();
        let (inner, outer) = heard(|| {
            keep(&["map".into()]);
            bytes(b"a");
            let ((), inner) = heard(|| {
                keep(&["draw", "-o", "folder/a.svg", "--output=/b.svg"].map(OsString::from));
                say(&typed());
                bytes(b"b");
            });
            say(&typed());
            bytes(b"c");
            inner
        });
        let of = |written: &[u8], said: &str| Heard {
            written: written.to_vec(),
            said: vec![said.into()],
        };
        assert_eq!(inner, of(b"b", "couplet draw -o a.svg --output=b.svg"));
        assert_eq!(outer, of(b"ac", "couplet map"));
        assert!(!is_heard());
    }
}
