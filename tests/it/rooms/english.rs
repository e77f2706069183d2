//! The English of the sources: the first sentence of a doc names the thing and stands on its own, as it is read
//! alone in lists and beside names; comments keep to a width.

use super::{floors, sources};
use crate::house::house;
use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

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
    floors().iter().flat_map(|folder| sources(folder)).collect()
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

/// Names that a front's table of files has and its folder has not, or the other way round.
fn strangers(front: &str, files: &BTreeSet<String>) -> Vec<String> {
    let rows = front.lines().filter_map(|line| line.strip_prefix("//! | ")).skip(1);
    let names = |cell: &str| -> BTreeSet<String> {
        let names = cell.split('`').skip(1).step_by(2);
        names.map(|name| name.trim_end_matches(".rs").to_owned()).collect()
    };
    let (mut listed, mut mentioned) = (BTreeSet::new(), BTreeSet::new());
    for row in rows {
        listed.extend(names(row.split(" | ").next().unwrap_or_default()));
        mentioned.extend(names(row));
    }
    if listed.is_empty() {
        return Vec::new();
    }
    listed.difference(files).chain(files.difference(&mentioned)).cloned().collect()
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
    let tests = sources(&house("tests"));
    none(crates().into_iter().chain(tests).collect(), long);
}

#[test]
fn tables_name_each_file_of_their_folder() {
    let is_front = |path: &PathBuf| path.ends_with("mod.rs") || path.ends_with("lib.rs");
    for front in crates().into_iter().filter(is_front) {
        let text = fs::read_to_string(&front).unwrap();
        if !text.contains("//! | file |") {
            continue;
        }
        let is_module = |name: &String| {
            let declared = format!("mod {name};");
            text.contains(&declared) && !text.contains(&format!("#[cfg(test)]\n{declared}"))
        };
        let folder = fs::read_dir(front.parent().unwrap()).unwrap();
        let name = |path: PathBuf| Some(path.file_stem()?.to_str()?.to_owned());
        let files = folder.filter_map(|entry| name(entry.unwrap().path())).filter(is_module);
        assert_eq!(strangers(&text, &files.collect()), [""; 0], "{}", front.display());
    }
    let made = "//! | file | what |\n//! |---|---|\n//! | `a`, [`b`] | with `c` |";
    let files = |names: &[&str]| names.iter().map(ToString::to_string).collect();
    assert_eq!(strangers(made, &files(&["a", "b", "c"])), [""; 0]);
    assert_eq!(strangers(made, &files(&["a", "c", "d"])), ["b", "d"]);
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
