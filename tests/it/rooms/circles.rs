//! Files of a room do not go in circles: of two files one can be read without the other.

use super::names::{Module, Tree};
use super::nothing_else;
use std::collections::{BTreeMap, BTreeSet};

type Uses = BTreeMap<Module, BTreeSet<Module>>;

/// The files of its room that each file uses.
fn uses(tree: &Tree) -> Uses {
    let in_room = |module: &Module| {
        let mut used = tree.used_by(module);
        used.retain(|other| other != module && other.first() == module.first());
        (module.clone(), used)
    };
    tree.files()
        .map(|(module, _)| module)
        .filter(|module| !module.is_empty())
        .map(in_room)
        .collect()
}

/// Everything that can be reached from a file, by one step or more.
fn reached<'a>(uses: &'a Uses, from: &Module) -> BTreeSet<&'a Module> {
    let (mut reached, mut next) = (BTreeSet::new(), Vec::from_iter(&uses[from]));
    while let Some(module) = next.pop() {
        if reached.insert(module) {
            next.extend(&uses[module]);
        }
    }
    reached
}

/// The files that reach each other, circle by circle.
fn circles(uses: &Uses) -> BTreeSet<BTreeSet<&Module>> {
    let reached: BTreeMap<&Module, _> = uses.keys().map(|m| (m, reached(uses, m))).collect();
    let circle = |module| {
        let both = |other: &&&Module| reached[**other].contains(module);
        reached[module].iter().filter(both).copied().collect::<BTreeSet<_>>()
    };
    uses.keys().map(circle).filter(|circle| !circle.is_empty()).collect()
}

/// Whether one of two files is the front of a folder around the other.
fn is_front(a: &Module, b: &Module) -> bool {
    a.starts_with(b) || b.starts_with(a)
}

/// The circles of files beside each other. What a front shares with its files does not count here.
fn circles_of_files(tree: &Tree) -> BTreeSet<Vec<String>> {
    let mut uses = uses(tree);
    uses.iter_mut().for_each(|(module, used)| used.retain(|other| !is_front(module, other)));
    let places =
        |circle: BTreeSet<&Module>| circle.iter().map(|m| tree.place(m).to_owned()).collect();
    circles(&uses).into_iter().map(places).collect()
}

/// The fronts that are in a circle with files of their folder: what these share belongs in a file of its own.
fn fronts_in_circles(tree: &Tree) -> BTreeSet<String> {
    let uses = uses(tree);
    let circles = circles(&uses);
    let fronts = circles.iter().flat_map(|circle| {
        let is_front_here = |front: &&&Module| {
            circle.iter().any(|other| other.len() > front.len() && other.starts_with(front))
        };
        circle.iter().filter(is_front_here).map(|front| tree.place(front).to_owned())
    });
    fronts.collect()
}

#[test]
fn no_files_go_in_circles() {
    nothing_else(circles_of_files(&Tree::of_the_house()), BTreeSet::new(), "files in a circle");
}

#[test]
fn no_front_goes_in_a_circle_with_its_files() {
    let fronts = fronts_in_circles(&Tree::of_the_house());
    nothing_else(fronts, BTreeSet::new(), "fronts that use what uses them");
}

/// The circles of a room with a front and these files.
fn found(front: &str, files: &[(&str, &str)]) -> Vec<Vec<String>> {
    Vec::from_iter(circles_of_files(&room(front, files)))
}

fn room(front: &str, files: &[(&str, &str)]) -> Tree {
    let rest = files.iter().map(|(name, text)| (format!("room/{name}.rs"), *text));
    Tree::new(
        [("lib.rs".to_owned(), "mod room;"), ("room/mod.rs".to_owned(), front)]
            .into_iter()
            .chain(rest),
    )
}

const AB: [&str; 2] = ["room/a.rs", "room/b.rs"];

#[test]
fn a_circle_of_two_files_is_seen() {
    let a = ("a", "pub struct A(super::b::B);");
    let b = ("b", "use crate::room::a::A;\npub struct B;\nfn f(_: A) {}");
    assert_eq!(found("mod a; mod b;", &[a, b]), [AB]);
    let by_macro = ("a", "words! { pub enum A { X => \"x\" } }\nfn f(_: super::b::B) {}");
    assert_eq!(found("mod a; mod b;", &[by_macro, b]), [AB]);
    assert_eq!(found("mod a; mod b;", &[a, ("b", "pub struct B;")]), [[""; 0]; 0]);
}

#[test]
fn a_circle_through_the_front_is_seen() {
    let front = "mod a; mod b; pub use a::A; pub use b::*;";
    let files =
        [("a", "use super::B;\npub struct A(B);"), ("b", "pub struct B; fn f() -> super::A {}")];
    assert_eq!(found(front, &files), [AB]);
}

#[test]
fn a_chain_is_a_circle_too() {
    let front = "mod a; mod b; mod c; mod d;";
    let a = ("a", "use super::{b::{self, Other as Name}, d::D};\npub fn a() -> Name { b::b() }");
    let b = ("b", "pub struct Other; pub fn b() { crate::room::c::C::new() }");
    let c = ("c", "pub struct C; impl C { fn new() { crate::room::a::a() } }");
    let d = ("d", "pub struct D;");
    assert_eq!(found(front, &[a, b, c, d]), [["room/a.rs", "room/b.rs", "room/c.rs"]]);
}

#[test]
fn words_tests_and_namesakes_make_no_circle() {
    let a = ("a", "use super::b::B;\npub struct A; pub fn f(b: B) {}");
    let b = (
        "b",
        "// super::a::A\npub struct B; fn g(a: &str) { a.f(); \"super::a::f\"; other::a::A }\n\
         #[cfg(test)]\nmod tests { use crate::room::a::A; }",
    );
    assert_eq!(found("mod a; mod b;", &[a, b]), [[""; 0]; 0]);
}

#[test]
fn a_front_that_uses_what_uses_it_is_seen() {
    let user = [("a", "pub fn a() -> super::Shared {}")];
    let front = "mod a; pub use a::a; pub struct Shared;";
    assert_eq!(fronts_in_circles(&room(front, &user)), BTreeSet::new(), "handing on is no use");
    let front = "mod a; pub struct Shared; pub fn b() { a::a() }";
    assert_eq!(fronts_in_circles(&room(front, &user)), BTreeSet::from(["room/mod.rs".to_owned()]));
    assert_eq!(found(front, &user), [[""; 0]; 0]);
}
