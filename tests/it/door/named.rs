//! What the pages name is there: every file once, every target of make, every option.

use crate::house::{house, read};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Folders that hold what is built or stored elsewhere.
const NOT_OURS: [&str; 3] = ["target", ".git", "node_modules"];
/// Ends of the names that are looked up.
const ENDS: [&str; 6] = [".rs", ".v", ".py", ".sh", ".ml", ".mli"];

/// All files below a folder, from the top of the house.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let is_ours = !NOT_OURS.iter().any(|name| path.ends_with(name));
        match path.is_dir() {
            true if is_ours => files(&path, found),
            true => {}
            false => found.push(path.strip_prefix(house("")).unwrap().to_owned()),
        }
    }
}

fn all() -> Vec<PathBuf> {
    let mut all = Vec::new();
    files(&house(""), &mut all);
    all
}

/// Each page with its text, but for what has been: the changelog.
fn pages(all: &[PathBuf]) -> Vec<(&PathBuf, String)> {
    let pages = all.iter().filter(|path| path.extension().is_some_and(|end| end == "md"));
    let pages = pages.filter(|path| !path.ends_with("CHANGELOG.md"));
    pages.map(|path| (path, fs::read_to_string(house("").join(path)).unwrap())).collect()
}

/// What stands between backquotes in a line of a text.
fn quoted(text: &str) -> impl Iterator<Item = &str> {
    text.lines().flat_map(|line| line.split('`').skip(1).step_by(2))
}

/// How often a name is the end of a path, if it is not there beside its page. It may leave out `src`.
fn places(name: &str, page: &Path, all: &[PathBuf]) -> usize {
    let is_beside = page.parent().is_some_and(|folder| house("").join(folder).join(name).exists());
    let is_it = |path: &&PathBuf| {
        let short: PathBuf = path.iter().filter(|part| *part != "src").collect();
        path.ends_with(name) || short.ends_with(name)
    };
    if is_beside { 1 } else { all.iter().filter(is_it).count() }
}

/// Names of files in a text: words that end as such names do, with no letter that stands for others.
fn named_files(text: &str) -> BTreeSet<&str> {
    let is_name = |name: &&str| {
        let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || "./_-".contains(c));
        plain && ENDS.iter().any(|end| name.len() > end.len() && name.ends_with(end))
    };
    quoted(text).filter(is_name).filter(|name| !name.contains("NAME")).collect()
}

#[test]
fn every_file_that_a_page_names_is_there_once() {
    let all = all();
    let page = Path::new("docs/x.md");
    let named: Vec<_> =
        named_files("`mod.rs`, `a b.rs`, `*.v`\n`no.rs` no.py").into_iter().collect();
    assert_eq!(named, ["mod.rs", "no.rs"], "the test sees");
    assert!(places("mod.rs", page, &all) > 1 && places("no.rs", page, &all) == 0);
    assert_eq!(places("prover/count.rs", page, &all), 1);
    assert_eq!(places("report/columns.rs", page, &all), 1, "src is left out");
    let mut wrong = Vec::new();
    for (page, text) in pages(&all) {
        for name in named_files(&text) {
            match places(name, page, &all) {
                1 => {}
                count => wrong.push(format!("{}: {name} is there {count} times", page.display())),
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn every_target_and_option_that_a_page_names_is_there() {
    let all = all();
    let makefile = read("Makefile");
    let heads = makefile.lines().filter(|line| !line.starts_with(['\t', '#', ' ', '@']));
    let targets: BTreeSet<&str> = heads
        .filter_map(|line| line.split_once(':').filter(|(_, rest)| !rest.starts_with('=')))
        .flat_map(|(names, _)| names.split_whitespace())
        .collect();
    let helps = all.iter().filter(|path| {
        let name = path.file_name().and_then(|name| name.to_str());
        name.is_some_and(|name| name.starts_with("help_"))
    });
    let helps: String =
        helps.map(|path| fs::read_to_string(house("").join(path)).unwrap()).collect();
    let mut options = options_in(&helps);
    // Of every program, and so in no list.
    options.insert("--version");
    assert!(targets.contains("test") && options.contains("--half-opening"), "the test sees");
    let mut wrong = Vec::new();
    for (page, text) in pages(&all) {
        for code in quoted(&text).chain(text.lines().filter_map(|line| line.strip_prefix("$ "))) {
            if let Some(names) = code.strip_prefix("make ") {
                let names = names.split_whitespace();
                let names = names.take_while(|name| !name.contains('=') && !name.starts_with('-'));
                let unknown = names.filter(|name| !targets.contains(name));
                wrong.extend(unknown.map(|name| format!("{}: make {name}", page.display())));
            }
            if code.starts_with("couplet ") {
                let unknown = options_in(code).difference(&options).copied().collect::<Vec<_>>();
                wrong.extend(unknown.iter().map(|name| format!("{}: {name}", page.display())));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// The long options in a text.
fn options_in(text: &str) -> BTreeSet<&str> {
    let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'));
    words
        .filter(|word| word.len() > 3 && word.starts_with("--") && !word.starts_with("---"))
        .collect()
}
