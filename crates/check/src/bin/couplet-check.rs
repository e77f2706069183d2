//! `couplet-check`: files in, a line for each out. The lines are those of `couplet check`; the arguments are read
//! here, so that nothing more has to be trusted.

use couplet_check::check::{
    AcceptedFile, CheckFailure, Engine, Words, check_files, print, visible,
};
use std::ffi::OsString;
use std::process::ExitCode;

const HELP: &str = "\
Check certificates: that the equations have the root claimed, and that every digit is right.

The checker trusts nothing that a certificate says: it computes residuals, slopes and roundings from the claim. Each file
gets one line: `accepted`, `refused` with the reason, `not checked` if it has more digits than the arithmetic is meant for,
`not read` if it cannot be. `-` is standard input.

The arithmetic is pure Rust, shares nothing with MPFR, and is meant for up to 50000 digits.

Usage: couplet-check [--statement] FILE...

  --statement    the whole statement of each accepted file in one sentence, with every digit
  -h, --help     this page
  -V, --version  the version

Exit codes: 0 every file was accepted; 1 a file was refused; 2 bad usage; 3 none was refused, but one was not checked or
not read.
";

/// The arithmetic that takes more digits.
const LARGER: &str = "`couplet check --engine mpfr`";

/// Request that the arguments make.
enum CheckRequest {
    Check(Vec<OsString>, Words),
    Page(&'static str),
}

fn main() -> ExitCode {
    let asked = match asked(std::env::args_os().skip(1)) {
        Ok(asked) => asked,
        Err(said) => return failed(&said, 2),
    };
    let done = match asked {
        CheckRequest::Check(files, words) => check_files(&files, Engine::ASTRO, words, LARGER),
        CheckRequest::Page(page) => print(page.as_bytes()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(CheckFailure::Refused(said)) => failed(&said, 1),
        Err(CheckFailure::Open(said)) => failed(&said, 3),
    }
}

/// One line on standard error; it may quote what others wrote.
fn failed(said: &str, code: u8) -> ExitCode {
    eprintln!("couplet-check: {}", visible(said));
    ExitCode::from(code)
}

/// Reads the arguments; else says what is wrong with them.
fn asked(mut arguments: impl Iterator<Item = OsString>) -> Result<CheckRequest, String> {
    let (mut files, mut words): (_, Words) = (Vec::new(), AcceptedFile::summary);
    while let Some(argument) = arguments.next() {
        match argument.to_str() {
            Some("-h" | "--help") => return Ok(CheckRequest::Page(HELP)),
            Some("-V" | "--version") => {
                return Ok(CheckRequest::Page(concat!(
                    "couplet-check ",
                    env!("CARGO_PKG_VERSION"),
                    "\n"
                )));
            }
            Some("--statement") => words = AcceptedFile::statement,
            Some("--") => files.extend(arguments.by_ref()),
            Some(text) if text.starts_with('-') && text != "-" => {
                return Err(format!(
                    "unexpected argument '{text}' found; --help lists the options"
                ));
            }
            _ => files.push(argument),
        }
    }
    match files.is_empty() {
        true => Err("<FILE>... is missing; usage: couplet-check FILE...".into()),
        false => Ok(CheckRequest::Check(files, words)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(words: &[&str]) -> Result<CheckRequest, String> {
        asked(words.iter().map(OsString::from))
    }

    fn files(words: &[&str]) -> Vec<OsString> {
        match read(words) {
            Ok(CheckRequest::Check(files, ..)) => files,
            _ => panic!("{words:?}"),
        }
    }

    #[test]
    fn files_are_read() {
        assert_eq!(files(&["a.json", "-", "b.json"]), ["a.json", "-", "b.json"]);
        assert_eq!(files(&["a.json", "--statement"]), ["a.json"]);
        assert_eq!(files(&["--", "--statement", "-h"]), ["--statement", "-h"]);
    }

    #[test]
    fn pages_need_no_file() {
        for (word, start) in [("-h", "Check certificates: "), ("--version", "couplet-check ")] {
            assert!(
                matches!(read(&[word, "a"]), Ok(CheckRequest::Page(page)) if page.starts_with(start))
            );
        }
    }

    #[test]
    fn what_makes_no_sense_is_one_line() {
        let cases: [(&[&str], &str); 3] = [
            (&[], "<FILE>... is missing"),
            (&["--engine", "mpfr", "a"], "unexpected argument '--engine' found"),
            (&["--digits", "a"], "unexpected argument '--digits' found"),
        ];
        for (words, said) in cases {
            let error = read(words).err().unwrap();
            assert!(error.contains(said) && !error.contains('\n'), "{words:?}: {error}");
        }
    }
}
