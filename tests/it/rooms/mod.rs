//! The rooms of the house: a room uses itself and the rooms above it, no files go in circles, and the
//! equations stay pure.

mod circles;
mod english;
mod names;
mod purity;
mod scattered;
mod source;

use crate::house::{house, read};
use names::paths_in;
pub(crate) use source::{code, floors, room, sources};
use source::{has, tokens, whole};
use std::collections::BTreeSet;
use std::fmt::Debug;
use std::fs;
use std::path::Path;

/// From the top: what a room may use stands before it.
pub(crate) const ROOMS: [&str; 32] = [
    "number",
    "symbolic",
    "arch",
    "problem",
    "check",
    "ask",
    "picture",
    "sketch",
    "solve",
    "lanes",
    "prover",
    "certify",
    "stones",
    "survey",
    "judge",
    "atlas",
    "strategies",
    "claims",
    "study",
    "report",
    "charts",
    "pictures",
    "failure",
    "parse",
    "answer",
    "surveyed",
    "unfinished",
    "rows",
    "scene",
    "sweep",
    "door",
    "cli",
];

/// What is found is what is known: nothing more, and nothing less, so that no exception outlives its reason.
fn nothing_else<T: Ord + Debug>(found: BTreeSet<T>, known: BTreeSet<T>, what: &str) {
    let new: Vec<_> = found.difference(&known).collect();
    assert!(new.is_empty(), "{what}: {new:#?}");
    let gone: Vec<_> = known.difference(&found).collect();
    assert!(gone.is_empty(), "no longer {what}, so strike out of the list: {gone:#?}");
}

/// The rooms that a code names: as `crate::room` where that is not its own, as a room of another crate, or as the crate
/// that is one.
fn rooms_in(code: &str, is_own: impl Fn(&str) -> bool) -> Vec<String> {
    let named = |path: Vec<String>| match path[0].strip_prefix("couplet_") {
        Some(other) => {
            let room = whole(&house(&format!("crates/{other}/src"))).map(str::to_owned);
            room.or_else(|| path.get(1).cloned())
        }
        None => path.get(1).filter(|name| path[0] == "crate" && !is_own(name)).cloned(),
    };
    let rooms = paths_in(code).into_iter().filter_map(named);
    rooms.filter(|name| ROOMS.contains(&name.as_str())).collect()
}

/// The rooms that a file uses. In a crate that is one room, what stands beside its front is of that room.
pub(crate) fn rooms_used(path: &Path) -> Vec<String> {
    let floor = floors().into_iter().find(|floor| path.starts_with(floor)).unwrap();
    rooms_in(&code(path), |name| whole(&floor).is_some() && has(&floor, name))
}

#[test]
fn a_room_uses_only_rooms_above_it() {
    assert_eq!(rooms_in("use crate::solve::x; crate::nothing", |_| false), ["solve"]);
    assert_eq!(rooms_in("use couplet_ask as x; couplet_check::arch", |_| true), ["arch", "ask"]);
    assert_eq!(rooms_in("use crate::{cli, study::{a, b}}; crate::arch::c()", |_| false).len(), 4);
    for (level, name) in ROOMS.iter().enumerate() {
        for path in sources(&room(name)) {
            for used in rooms_used(&path) {
                let allowed = ROOMS[..=level].contains(&used.as_str());
                assert!(allowed, "{} uses {used}, which is below {name}", path.display());
            }
        }
    }
}

#[test]
fn every_file_is_in_a_room() {
    let floors = floors().into_iter().filter(|floor| whole(floor).is_none());
    for entry in floors.flat_map(|floor| fs::read_dir(floor).unwrap()) {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap();
        let known = ROOMS.contains(&name) || ["bin", "lib", "main"].contains(&name);
        assert!(known, "{} is in no room", path.display());
    }
}

#[test]
fn the_solver_proves_nothing() {
    for path in sources(&room("solve")) {
        assert!(!code(&path).contains("Certified"), "{}", path.display());
    }
}

/// How often a value of a type is made by its fields, in the file of the type: by its name anywhere, and as
/// `Self` in its own `impl` blocks.
fn constructions(code: &str, of: &str) -> usize {
    let made = |code: &str, name: &str| {
        let literal = |words: &&[&str]| {
            // Behind these words the brace begins a declaration or a body.
            let is_other = ["struct", "impl", "for", "->", "&"].contains(&words[0]);
            words[1..] == [name, "{"] && !is_other
        };
        tokens(code).windows(3).filter(literal).count()
    };
    let head = format!("\nimpl {of} {{");
    let blocks = code.split(&head).skip(1);
    let of_itself = blocks.map(|block| made(block.split("\n}").next().unwrap(), "Self"));
    made(code, of) + of_itself.sum::<usize>()
}

/// What is certified is made in one place, by the proof: its fields are private to its file, and there it
/// is made once.
#[test]
fn the_proof_is_the_only_constructor() {
    let twice = "struct A {\n}\nimpl A {\nfn b() -> Self { Self { c } }\n}\nfn d() -> A { A { c } }\n\
                 impl B {\nfn e() -> Self { Self {} }\n}";
    assert_eq!(constructions(twice, "A"), 2, "the test sees");
    let certify = sources(&room("certify"));
    let mut files = certify.iter().map(|path| code(path));
    let code = files.find(|code| code.contains("pub struct CertifiedLandmark {")).unwrap();
    let fields = code.split("pub struct CertifiedLandmark {").nth(1).unwrap();
    assert!(!fields.split('}').next().unwrap().contains("pub"), "{fields}");
    assert_eq!(constructions(&code, "CertifiedLandmark"), 1);
}

#[test]
fn the_program_is_thin() {
    let lines = read("src/main.rs").lines().count();
    assert!(lines < 60, "main.rs has {lines} lines");
}
