//! The rooms of the house: a room uses itself and the rooms above it, and the equations stay pure.

use std::fs;
use std::path::{Path, PathBuf};

/// From the top: what a room may use stands before it.
const ROOMS: [&str; 14] = [
    "number",
    "symbolic",
    "arch",
    "problem",
    "check",
    "solve",
    "certify",
    "judge",
    "claims",
    "study",
    "strategies",
    "report",
    "scene",
    "cli",
];

fn sources(folder: &Path) -> Vec<PathBuf> {
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

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// The code of a file without its unit tests and comments.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).unwrap();
    let mut text = text.as_str();
    for condition in ["#[cfg(test)]", "#[cfg(all(test, feature = \"mpfr\"))]"] {
        text = text.split(&format!("{condition}\nmod tests")).next().unwrap_or_default();
    }
    text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

/// The rooms that a text names as `crate::room`.
fn rooms_used(code: &str) -> Vec<&str> {
    code.split("crate::")
        .skip(1)
        .map(|rest| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap())
        .filter(|name| ROOMS.contains(name))
        .collect()
}

#[test]
fn a_room_uses_only_rooms_above_it() {
    assert_eq!(rooms_used("use crate::solve::x; crate::nothing"), ["solve"], "the test sees");
    for (level, room) in ROOMS.iter().enumerate() {
        for path in sources(&root().join(room)) {
            for used in rooms_used(&code(&path)) {
                let allowed = ROOMS[..=level].contains(&used);
                assert!(allowed, "{} uses {used}, which is below {room}", path.display());
            }
        }
    }
}

#[test]
fn every_file_is_in_a_room() {
    for entry in fs::read_dir(root()).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let known =
            ROOMS.contains(&name.as_str()) || ["lib.rs", "main.rs"].contains(&name.as_str());
        assert!(known, "src/{name} is in no room");
    }
}

/// What an equation must not contain.
fn impurity(code: &str) -> Option<&str> {
    let forbidden = [
        "for ",
        "while ",
        "loop ",
        "if ",
        " < ",
        " > ",
        " <= ",
        " >= ",
        "epsilon",
        "tolerance",
        "f64",
        "f32",
        "Float",
    ];
    let literal = |word: &&str| {
        word.split_once('.').is_some_and(|(a, b)| {
            !a.is_empty() && !b.is_empty() && (a.to_owned() + b).bytes().all(|c| c.is_ascii_digit())
        })
    };
    // `impl X for Y` and `for<'a>` are no loops, and a `&str` is text.
    code.lines().find_map(|line| {
        let line = if line.contains("impl") || line.contains('"') { "" } else { line };
        forbidden.into_iter().find(|word| line.contains(word)).or_else(|| {
            line.split(|c: char| !c.is_ascii_digit() && c != '.').find(literal).map(|_| line)
        })
    })
}

#[test]
fn equations_neither_loop_nor_compare_nor_round() {
    assert!(impurity("let x = 0.1;").is_some() && impurity("if a > b {").is_some());
    for file in [
        "thrust",
        "cubic",
        "closed_form",
        "statics",
        "sliding",
        "overturning",
        "weight",
        "quotient",
    ] {
        let path = root().join("arch").join(format!("{file}.rs"));
        assert_eq!(impurity(&code(&path)), None, "{}", path.display());
    }
}

#[test]
fn the_solver_proves_nothing_and_the_proof_is_the_only_constructor() {
    for path in sources(&root().join("solve")) {
        assert!(!code(&path).contains("Certified"), "{}", path.display());
    }
    let constant = code(&root().join("certify").join("landmark.rs"));
    assert_eq!(constant.matches("Self { landmark, weight, isolated:").count(), 1);
}

#[test]
fn the_program_is_thin() {
    let lines = fs::read_to_string(root().join("main.rs")).unwrap().lines().count();
    assert!(lines < 60, "main.rs has {lines} lines");
}
