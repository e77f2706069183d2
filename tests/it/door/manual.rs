//! Completions and manual pages: each knows every command, and the programs that read them do not complain.

use crate::program::{Scratch, ended, printed, said, shell, tells};
use std::process::{Command, Stdio};

/// The commands of this build, from its help.
pub(super) fn commands() -> Vec<String> {
    let help = printed("--help");
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
        let help = printed([name, "--help"]);
        let (_, examples) = help.split_once("\nExamples:\n").unwrap_or_else(|| panic!("{name}"));
        assert!(examples.lines().all(|line| line.chars().count() <= 78), "{examples}");
        let scratch = Scratch::new();
        for example in examples.replace(" \\\n", " ").lines() {
            let (code, _, said) = said(&shell(example, scratch.folder()));
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
        assert_eq!(printed([word, "--help"]), printed([name, "--help"]), "{word}");
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
    let scratch = Scratch::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = printed(["completions", shell]);
        tells(&script, commands());
        scratch.write(shell, script);
        // Those of the shells that can read a script without running it.
        if ["bash", "zsh", "fish"].contains(&shell) {
            assert_eq!(complaint(shell, &["-n", &scratch.path(shell)]), None, "{shell}");
        }
    }
}

#[test]
fn every_command_has_a_page() {
    let scratch = Scratch::new();
    let folder = scratch.path("made/man1");
    printed(["man", &folder]);
    let pages = scratch.files("made/man1");
    assert!(pages.contains(&"couplet.1".into()));
    assert!(pages.iter().all(|page| !page.contains("help")), "{pages:?}");
    for name in commands() {
        assert!(pages.contains(&format!("couplet-{name}.1")), "{name}: {pages:?}");
    }
    for page in &pages {
        let path = format!("{folder}/{page}");
        let text = scratch.read(&format!("made/man1/{page}"));
        assert!(text.contains(".SH NAME") && text.contains(".SH DESCRIPTION"), "{page}");
        assert_eq!(complaint("man", &["--warnings", "-E", "UTF-8", "-l", "-Z", &path]), None);
        assert_eq!(complaint("mandoc", &["-T", "lint", "-W", "error", &path]), None, "{page}");
    }
}

#[test]
fn the_page_of_couplet_itself_goes_to_standard_output() {
    let page = printed("man");
    assert!(page.contains("Exit codes: 0 everything asked was proved"));
    for name in commands() {
        // A hyphen is escaped in a page.
        assert!(page.replace('\\', "").contains(&format!("couplet-{name}(1)")), "{name}");
    }
}

#[test]
fn what_cannot_be_written_is_named() {
    let (_, said) = ended(3, "man /dev/null/pages", "");
    assert!(said.lines().count() == 1 && said.contains("/dev/null/pages"), "{said}");
}
