//! Completions and manual pages: each knows every command, and the programs that read them do not complain.

use crate::program::{couplet, printed, said, shell};
use std::process::{Command, Stdio};

/// The commands of this build, from its help.
pub(super) fn commands() -> Vec<String> {
    let help = String::from_utf8(couplet("--help").stdout).unwrap();
    let (groups, _) = help.split_once("\nOptions:").unwrap();
    let lines = groups.lines().skip(4).filter_map(|line| line.strip_prefix("  "));
    lines.map(|line| line.split_whitespace().next().unwrap().to_owned()).collect()
}

/// The help of each command ends with examples, and they work, one after the other in a folder that was empty.
#[test]
fn the_examples_of_the_help_work() {
    let all = commands();
    assert!(all.len() >= 20 && all.contains(&"state".to_owned()), "{all:?}");
    for name in all.iter().filter(|name| !["completions", "man"].contains(&name.as_str())) {
        let help = String::from_utf8(couplet([name, "--help"]).stdout).unwrap();
        let (_, examples) = help.split_once("\nExamples:\n").unwrap_or_else(|| panic!("{name}"));
        let folder = tempfile::tempdir().unwrap();
        assert!(examples.lines().all(|line| line.chars().count() <= 78), "{examples}");
        for example in examples.replace(" \\\n", " ").lines() {
            let (code, _, said) = said(&shell(example, folder.path()));
            assert_eq!(code, Some(0), "{example}: {said}");
            assert!(example.contains(&format!("couplet {name}")), "{example}");
        }
    }
}

/// What is typed first by who does not know a command's name is that command.
#[test]
fn other_words_for_a_command_are_it() {
    for (word, name) in [
        ("plot", "map"),
        ("mechanism", "state"),
        ("thrust", "assess"),
        ("safety", "assess"),
        ("compare", "judge"),
        ("arch", "assess"),
        ("bridge", "assess"),
    ] {
        assert_eq!(couplet([word, "--help"]).stdout, couplet([name, "--help"]).stdout, "{word}");
    }
}

/// Runs a program if it is there; what it complains of.
fn complaint(program: &str, arguments: &[&str]) -> Option<String> {
    let mut command = Command::new(program);
    let output = command.args(arguments).stdin(Stdio::null()).output().ok()?;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    (!output.status.success() || !said.is_empty()).then_some(said)
}

#[test]
fn the_completions_name_every_command() {
    let folder = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let output = couplet(["completions", shell]);
        assert_eq!(output.status.code(), Some(0), "{shell}");
        let script = String::from_utf8(output.stdout).unwrap();
        for name in commands() {
            assert!(script.contains(&name), "{shell}: {name}");
        }
        let file = folder.path().join(shell).to_str().unwrap().to_owned();
        std::fs::write(&file, script).unwrap();
        // Those of the shells that can read a script without running it.
        if ["bash", "zsh", "fish"].contains(&shell) {
            assert_eq!(complaint(shell, &["-n", &file]), None, "{shell}");
        }
    }
}

#[test]
fn every_command_has_a_page() {
    let scratch = tempfile::tempdir().unwrap();
    let folder = scratch.path().join("made/man1").to_str().unwrap().to_owned();
    printed(["man", &folder]);
    let mut pages: Vec<String> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    pages.sort();
    assert!(pages.contains(&"couplet.1".into()));
    assert!(pages.iter().all(|page| !page.contains("help")), "{pages:?}");
    for name in commands() {
        assert!(pages.contains(&format!("couplet-{name}.1")), "{name}: {pages:?}");
    }
    for page in &pages {
        let path = format!("{folder}/{page}");
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.contains(".SH NAME") && text.contains(".SH DESCRIPTION"), "{page}");
        assert_eq!(complaint("man", &["--warnings", "-E", "UTF-8", "-l", "-Z", &path]), None);
        assert_eq!(complaint("mandoc", &["-T", "lint", "-W", "error", &path]), None, "{page}");
    }
}

#[test]
fn the_page_of_couplet_itself_goes_to_standard_output() {
    let output = couplet("man");
    let page = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success() && page.contains("Exit codes: 0 everything asked was proved"));
    for name in commands() {
        // A hyphen is escaped in a page.
        assert!(page.replace('\\', "").contains(&format!("couplet-{name}(1)")), "{name}");
    }
}

#[test]
fn what_cannot_be_written_is_named() {
    let output = couplet("man /dev/null/pages");
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(3));
    assert!(said.lines().count() == 1 && said.contains("/dev/null/pages"), "{said}");
}
