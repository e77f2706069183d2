//! The English of the sources: the first sentence of a doc names the thing and stands on its own, as it is read
//! alone in lists and beside names; comments keep to a width.

use super::sources;
use std::fs;
use std::path::{Path, PathBuf};

/// Beginnings that refer to another doc, or ask in place of naming.
const FRAGMENTS: [&str; 16] = [
    "How", "It", "Its", "So many", "That", "The same", "Their", "Then", "These", "They", "This",
    "Those", "What", "Whether", "Which", "Who",
];
/// Derived traits whose docs are the help of the command: an output, held where the help is.
const HELP: [&str; 4] = ["Args", "Parser", "Subcommand", "ValueEnum"];
/// Characters of a line of comment.
const WIDTH: usize = 120;

/// The sources of all crates of the house.
fn crates() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let inner = fs::read_dir(root.join("crates")).into_iter().flatten();
    let inner = inner.map(|entry| entry.unwrap().path().join("src"));
    inner.chain([root.join("src")]).flat_map(|folder| sources(&folder)).collect()
}

/// The mark of a line of doc, and its text.
fn doc(line: &str) -> Option<(&str, &str)> {
    let mark = line.trim_start().get(..3).filter(|mark| ["///", "//!"].contains(mark))?;
    Some((mark, line.trim_start()[3..].trim_start()))
}

fn is_fragment(text: &str) -> bool {
    let is_word = |rest: &str| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '-');
    FRAGMENTS.iter().any(|fragment| text.strip_prefix(fragment).is_some_and(is_word))
}

fn derives_help(line: &str) -> bool {
    let traits = line.trim_start().strip_prefix("#[derive(");
    traits.is_some_and(|traits| {
        traits.split(|c: char| !c.is_alphanumeric()).any(|name| HELP.contains(&name))
    })
}

/// Docs that begin with a fragment, each with its line, without those in types of help.
fn fragments(text: &str) -> Vec<(usize, &str)> {
    let (mut found, mut before, mut help_ends) = (Vec::new(), None, None);
    for (place, line) in text.lines().enumerate() {
        let item = text.lines().skip(place).find(|line| doc(line).is_none()).unwrap_or_default();
        if derives_help(item) {
            help_ends = Some(format!("{}}}", &item[..item.len() - item.trim_start().len()]));
        } else if help_ends.as_deref() == Some(line) {
            help_ends = None;
        }
        let doc = doc(line);
        let begins = doc.filter(|(mark, _)| before != Some(*mark));
        let text = begins.map(|(_, text)| text).filter(|text| is_fragment(text));
        found.extend(text.filter(|_| help_ends.is_none()).map(|text| (place + 1, text)));
        before = doc.map(|(mark, _)| mark);
    }
    found
}

/// Lines of comment that are too long, but for those of tables.
fn long(text: &str) -> Vec<(usize, &str)> {
    let is_long = |(_, line): &(usize, &str)| {
        let comment = line.trim_start().strip_prefix("//");
        let comment = comment.map(|text| text.trim_start_matches(['/', '!', ' ']));
        comment.is_some_and(|text| !text.starts_with('|')) && line.chars().count() > WIDTH
    };
    text.lines().enumerate().map(|(place, line)| (place + 1, line)).filter(is_long).collect()
}

/// Fails with what is found in any of some files.
fn none(paths: Vec<PathBuf>, find: fn(&str) -> Vec<(usize, &str)>) {
    let mut all = String::new();
    for path in paths {
        let text = fs::read_to_string(&path).unwrap();
        for (line, text) in find(&text) {
            all += &format!("{}:{line}: {text}\n", path.display());
        }
    }
    assert!(all.is_empty(), "{all}");
}

#[test]
fn first_sentences_name_the_thing() {
    none(crates(), fragments);
}

#[test]
fn comments_keep_to_a_width() {
    let tests = sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests"));
    none(crates().into_iter().chain(tests).collect(), long);
}

#[test]
fn fragments_and_long_comments_are_seen() {
    let made = "//! What a file is.\n\n/// A number.\n/// Its second line.\nstruct A {\n    /// Its.\n    a: u8,\n}\n\n\
        /// Whichever is named.\n/// It.\nstruct D;\n\
        /// How.\n#[derive(Debug, clap::Args)]\nstruct B {\n    /// How many.\n    b: u8,\n}\n\
        /// The same.\n/// Itself.\nfn c() {}\n";
    let lines = |found: Vec<(usize, &str)>| Vec::from_iter(found.into_iter().map(|(line, _)| line));
    assert_eq!(lines(fragments(made)), [1, 6, 19]);
    let word = "x".repeat(WIDTH - 4);
    let made = format!("/// {word}\n/// é{word}\n    // {word}\n//! | {word} |\nlet {word} = 1;\n");
    assert_eq!(lines(long(&made)), [2, 3]);
}
