//! The program as a user has it: run, fed, refused, and with a folder of its own.

use std::process::{Command, Output};

/// What a command is given: a list of words, or the line of them that is typed.
pub(crate) trait Words {
    fn words(&self) -> Vec<&str>;
}

impl Words for str {
    fn words(&self) -> Vec<&str> {
        self.split_whitespace().collect()
    }
}

impl Words for String {
    fn words(&self) -> Vec<&str> {
        self.as_str().words()
    }
}

impl Words for [&str] {
    fn words(&self) -> Vec<&str> {
        self.to_vec()
    }
}

impl<const N: usize> Words for [&str; N] {
    fn words(&self) -> Vec<&str> {
        self.to_vec()
    }
}

impl Words for Vec<&str> {
    fn words(&self) -> Vec<&str> {
        self.clone()
    }
}

impl<W: Words + ?Sized> Words for &W {
    fn words(&self) -> Vec<&str> {
        (**self).words()
    }
}

/// The program with its arguments, to be started in a way of its own.
pub(crate) fn command(arguments: impl Words) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_couplet"));
    command.args(arguments.words());
    command
}

/// Runs the program without input.
pub(crate) fn couplet(arguments: impl Words) -> Output {
    command(arguments).output().unwrap()
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

pub(crate) use crate::json::*;
pub(crate) use whole::*;

/// What only the tests of the whole program need.
mod whole {
    use super::{Words, command, text};
    use serde_json::Value;
    use std::collections::BTreeMap;
    use std::io::Write;
    use std::path::Path;
    use std::process::{Child, Command, Output, Stdio};

    /// Starts the program with all its streams in hand.
    pub(crate) fn start(arguments: impl Words) -> Child {
        command(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    }

    /// Runs the program with an input of any size.
    pub(crate) fn fed(arguments: impl Words, input: impl AsRef<[u8]>) -> Output {
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

    /// Runs a line of the shell, which knows `couplet`, in a folder.
    pub(crate) fn shell(line: &str, folder: &Path) -> Output {
        let program = Path::new(env!("CARGO_BIN_EXE_couplet")).parent().unwrap();
        let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap());
        let mut shell = Command::new("sh");
        shell.args(["-c", line]).env("PATH", path).current_dir(folder).output().unwrap()
    }

    /// Runs the program under a limit that a shell sets.
    pub(crate) fn limited(limit: &str, arguments: impl Words) -> Output {
        let line = format!("{limit}; exec \"$0\" \"$@\"");
        let mut shell = Command::new("sh");
        shell.args(["-c", &line, env!("CARGO_BIN_EXE_couplet")]);
        shell.args(arguments.words()).output().unwrap()
    }

    /// Exit code, standard output and standard error.
    pub(crate) fn said(output: &Output) -> (Option<i32>, String, String) {
        (output.status.code(), text(&output.stdout), text(&output.stderr))
    }

    /// What a command prints, and what it says, that ends with this exit code.
    #[track_caller]
    pub(crate) fn ended(
        code: i32,
        arguments: impl Words,
        input: impl AsRef<[u8]>,
    ) -> (String, String) {
        let (found, output, message) = said(&fed(&arguments, input));
        assert_eq!(found, Some(code), "{:?}: {output}{message}", arguments.words());
        (output, message)
    }

    /// What a command prints that does all that it is asked.
    #[track_caller]
    pub(crate) fn printed(arguments: impl Words) -> String {
        ended(0, arguments, "").0
    }

    /// A text has all these words.
    #[track_caller]
    pub(crate) fn tells<W: AsRef<str>>(text: &str, words: impl IntoIterator<Item = W>) {
        for words in words {
            assert!(text.contains(words.as_ref()), "no '{}' in: {text}", words.as_ref());
        }
    }

    /// What a command prints as JSON.
    pub(crate) fn json(arguments: impl Words) -> Value {
        serde_json::from_str(&printed(arguments)).unwrap()
    }

    /// The same, where it is asked for JSON.
    pub(crate) fn object(line: impl Words) -> Value {
        json([&line.words()[..], &["--format", "json"]].concat())
    }

    /// What a command makes of an input, as lines of JSON.
    pub(crate) fn lines(arguments: impl Words, input: impl AsRef<[u8]>) -> Vec<Value> {
        let all = [&arguments.words()[..], &["--format", "jsonl"]].concat();
        of_lines(&text(&fed(all, input).stdout))
    }

    /// Lines of JSON.
    pub(crate) fn of_lines(text: &str) -> Vec<Value> {
        text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    }

    /// The rows of a table, by the names of its columns.
    pub(crate) fn rows(csv: impl AsRef<[u8]>) -> Vec<BTreeMap<String, String>> {
        csv::Reader::from_reader(csv.as_ref()).deserialize().map(Result::unwrap).collect()
    }

    /// The first line of what a command makes of an input.
    pub(crate) fn header(arguments: impl Words, input: impl AsRef<[u8]>) -> String {
        text(&fed(arguments, input).stdout).lines().next().unwrap().to_owned()
    }

    /// The program refuses its arguments or its input: exit code 2, nothing on standard output, and one
    /// line that holds the words.
    pub(crate) fn refused(arguments: impl Words, input: &str, words: &str) {
        let (output, message) = ended(2, &arguments, input);
        let arguments = arguments.words();
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

        pub(crate) fn folder(&self) -> &Path {
            self.0.path()
        }

        /// The path of a file in it.
        pub(crate) fn path(&self, name: &str) -> String {
            self.folder().join(name).to_str().unwrap().to_owned()
        }

        pub(crate) fn read(&self, name: &str) -> String {
            std::fs::read_to_string(self.path(name)).unwrap()
        }

        /// The JSON in a file of it.
        pub(crate) fn json(&self, name: &str) -> Value {
            serde_json::from_str(&self.read(name)).unwrap()
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
