//! The source as text: its code without comments, words and tests, and the tokens of that.

use super::ROOMS;
use crate::house::house;
use std::fs;
use std::path::{Path, PathBuf};

/// The folders of the sources: of the face, and of each crate.
pub(crate) fn floors() -> Vec<PathBuf> {
    let crates = fs::read_dir(house("crates")).unwrap();
    let crates = crates.map(|entry| entry.unwrap().path().join("src"));
    let mut floors: Vec<PathBuf> = crates.chain([house("src")]).collect();
    floors.sort();
    floors
}

/// Whether a crate has a file or a folder of this name beside its front.
pub(super) fn has(floor: &Path, name: &str) -> bool {
    ["", ".rs"].iter().any(|end| floor.join(format!("{name}{end}")).exists())
}

/// The room that a crate is as a whole: one of its name, without a folder or a file in it.
pub(super) fn whole(floor: &Path) -> Option<&'static str> {
    // The face is in the folder of the checkout, which may have any name.
    let home =
        floor.parent().filter(|home| home.parent().is_some_and(|of| of.ends_with("crates")))?;
    let name = home.file_name()?.to_str()?;
    let room = ROOMS.into_iter().find(|room| *room == name)?;
    (!has(floor, name)).then_some(room)
}

/// The folder or the file of a room.
pub(crate) fn room(name: &str) -> PathBuf {
    let within = |floor: PathBuf| match whole(&floor) {
        Some(room) => Vec::from_iter((room == name).then_some(floor)),
        None => ["", ".rs"].map(|end| floor.join(format!("{name}{end}"))).into(),
    };
    let mut places = floors().into_iter().flat_map(within).filter(|place| place.exists());
    let place = places.next().unwrap_or_else(|| panic!("there is no room {name}"));
    assert_eq!(places.next(), None, "{name} is there twice");
    place
}

/// All files of a folder and below, or the file itself.
pub(crate) fn sources(folder: &Path) -> Vec<PathBuf> {
    if folder.is_file() {
        return vec![folder.to_owned()];
    }
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found
}

/// The code of a file.
pub(crate) fn code(path: &Path) -> String {
    bare(&fs::read_to_string(path).unwrap())
}

/// A text without comments, what is between quotes, and what is compiled for tests only.
pub(super) fn bare(text: &str) -> String {
    without_tests(&without_words(text))
}

/// Without comments, of which none is in a block, and with empty quotes.
fn without_words(text: &str) -> String {
    let (mut code, mut rest) = (String::new(), text);
    while let Some(c) = rest.chars().next() {
        let in_name = code.ends_with(|c: char| c.is_alphanumeric() || c == '_');
        let (kept, length) = if rest.starts_with("//") {
            ("", rest.find('\n').unwrap_or(rest.len()))
        } else if let Some(length) = raw_string(rest).filter(|_| !in_name) {
            ("\"\"", length)
        } else if c == '"' {
            ("\"\"", quoted(rest, '"'))
        } else if c == '\'' && is_character(rest) {
            ("' '", quoted(rest, '\''))
        } else {
            (&rest[..c.len_utf8()], c.len_utf8())
        };
        code += kept;
        rest = &rest[length..];
    }
    code
}

/// The length of `r"…"` or `r#"…"#`, if the text begins with one.
fn raw_string(text: &str) -> Option<usize> {
    let marks = text.strip_prefix("br").or_else(|| text.strip_prefix('r'))?;
    let inside = marks.trim_start_matches('#');
    let close = format!("\"{}", &marks[..marks.len() - inside.len()]);
    let inside = inside.strip_prefix('"')?;
    Some(text.len() - inside.len() + inside.find(&close)? + close.len())
}

/// The length of a text in quotes.
fn quoted(text: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            c if c == quote => return at + c.len_utf8(),
            _ => {}
        }
    }
    text.len()
}

/// Whether a quote begins a character, and not the name of a lifetime.
fn is_character(text: &str) -> bool {
    let mut next = text.chars().skip(1);
    next.next() == Some('\\') || next.next() == Some('\'')
}

/// Without the items that only tests have.
fn without_tests(code: &str) -> String {
    let Some(start) = code.find("#[cfg(test)]").or_else(|| code.find("#[cfg(all(test")) else {
        return code.to_owned();
    };
    let mut depth = 0;
    let end = code[start..].find(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth == 0 && (c == '}' || c == ';')
    });
    let end = end.map_or(code.len(), |length| start + length + 1);
    code[..start].to_owned() + &without_tests(&code[end..])
}

/// The names and signs of a code; a lifetime is one of them.
pub(super) fn tokens(code: &str) -> Vec<&str> {
    let (mut tokens, mut rest) = (Vec::new(), code.trim_start());
    while let Some(c) = rest.chars().next() {
        let name = |text: &str| {
            text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len())
        };
        let is_pair = ["::", "->", "=>"].iter().any(|pair| rest.starts_with(pair));
        let length = match c {
            '\'' => 1 + name(&rest[1..]),
            _ if is_pair => 2,
            _ => name(rest).max(c.len_utf8()),
        };
        tokens.push(&rest[..length]);
        rest = rest[length..].trim_start();
    }
    tokens
}

#[test]
fn words_and_tests_are_no_code() {
    let text = "fn a<'b>() { // it's\n \"a \\\" {\" r#\"{\"}\"# '\"' '\\'' }\n\
                #[cfg(test)]\nmod tests { fn c() { \"}\" } }\n\
                #[cfg(all(test, feature = \"x\"))]\nuse d;\nfn e() {}";
    assert_eq!(bare(text), "fn a<'b>() { \n \"\" \"\" ' ' ' ' }\n\n\nfn e() {}");
    assert_eq!(tokens("a::b -> &'c D<e>"), ["a", "::", "b", "->", "&", "'c", "D", "<", "e", ">"]);
}
