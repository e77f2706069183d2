//! The program as a user has it: run, fed, refused, and with a folder of its own.

use std::process::{Command, Output};

/// The program with its arguments, to be started in a way of its own.
pub(crate) fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_couplet"));
    command.args(arguments);
    command
}

/// Runs the program without input.
pub(crate) fn couplet(arguments: &[&str]) -> Output {
    command(arguments).output().unwrap()
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

pub(crate) use whole::*;

/// What only the tests of the whole program need.
mod whole {
    use super::{command, couplet, text};
    use serde_json::Value;
    use std::io::Write;
    use std::process::{Child, Output, Stdio};

    /// Starts the program with all its streams in hand.
    pub(crate) fn start(arguments: &[&str]) -> Child {
        command(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    }

    /// Runs the program with an input of any size.
    pub(crate) fn fed(arguments: &[&str], input: impl AsRef<[u8]>) -> Output {
        let mut child = start(arguments);
        let mut stdin = child.stdin.take().unwrap();
        let input = input.as_ref().to_vec();
        let writer = std::thread::spawn(move || {
            // A command that refuses its input, or reads none, closes the pipe.
            let _ = stdin.write_all(&input);
        });
        let output = child.wait_with_output().unwrap();
        writer.join().unwrap();
        output
    }

    /// Exit code, standard output and standard error.
    pub(crate) fn said(output: &Output) -> (Option<i32>, String, String) {
        (output.status.code(), text(&output.stdout), text(&output.stderr))
    }

    /// What a command prints as JSON.
    pub(crate) fn json(arguments: &[&str]) -> Value {
        let output = couplet(arguments);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        serde_json::from_slice(&output.stdout).unwrap()
    }

    /// The program refuses its arguments or its input: exit code 2, nothing on standard output, and one
    /// line that holds the words.
    pub(crate) fn refused(arguments: &[&str], input: &str, words: &str) {
        let (code, output, message) = said(&fed(arguments, input));
        assert_eq!(code, Some(2), "{arguments:?}: {message}");
        assert_eq!(message.lines().count(), 1, "{arguments:?}: {message}");
        assert!(message.starts_with("couplet: "), "{arguments:?}: {message}");
        assert!(message.contains(words), "{arguments:?}: {message}");
        assert_eq!(output, "", "{arguments:?}");
    }

    /// A folder of a test's own, empty at first and removed at the end.
    pub(crate) struct Scratch(tempfile::TempDir);

    impl Scratch {
        pub(crate) fn new() -> Self {
            Self(tempfile::Builder::new().prefix("couplet-test-").tempdir().unwrap())
        }

        pub(crate) fn folder(&self) -> &std::path::Path {
            self.0.path()
        }

        /// The path of a file in it.
        pub(crate) fn path(&self, name: &str) -> String {
            self.folder().join(name).to_str().unwrap().to_owned()
        }

        pub(crate) fn read(&self, name: &str) -> String {
            std::fs::read_to_string(self.path(name)).unwrap()
        }

        pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) {
            std::fs::write(self.path(name), content).unwrap();
        }

        /// The names of the files in a folder of it, in order; none if it is not there.
        pub(crate) fn files(&self, folder: &str) -> Vec<String> {
            let Ok(entries) = std::fs::read_dir(self.path(folder)) else { return Vec::new() };
            let name = |entry: std::io::Result<std::fs::DirEntry>| entry.unwrap().file_name();
            let mut names: Vec<String> =
                entries.map(|entry| name(entry).into_string().unwrap()).collect();
            names.sort();
            names
        }
    }
}

/// One test for each wrong use of the program: its name, the arguments, and words of the one line that
/// it is refused with.
macro_rules! wrong_uses {
    ($($(#[$condition:meta])* $name:ident: $arguments:expr => $words:expr;)*) => {$(
        $(#[$condition])*
        #[test]
        fn $name() {
            crate::program::refused(&$arguments, "", $words);
        }
    )*};
}
