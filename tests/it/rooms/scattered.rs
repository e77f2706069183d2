//! All methods of a type live in its file; what needs more is a free function over it.

use super::names::{File, Module, Names, Tree, is_name, path};
use super::nothing_else;
use std::collections::BTreeSet;

/// Methods that are still in another file than their type, to be moved. Nothing is added here.
const KNOWN: &[(&str, &str)] = &[
    ("number/engine.rs", "From for Dyadic"),
    ("number/gmp/interval.rs", "AstroInterval"),
    ("symbolic/display.rs", "Fraction"),
    ("symbolic/display.rs", "Polynomial"),
    ("symbolic/division.rs", "Polynomial"),
];

/// Traits that may be implemented in a file that declares neither the trait nor the type: one file has
/// the text of several algebraic types, one what the prover asks of a task, one Stumpff's functions of
/// several numbers, one the real functions of balls, by what is made of balls; how a result is reported
/// uses the files of its formats, and these use the result.
const ANYWHERE: &[&str] = &["Display", "Equations", "Real", "Reported", "Stumpff"];

/// The first path in some tokens.
fn head(tokens: &[String]) -> Names {
    let is_head = |token: &String| is_name(token) && !["dyn", "mut"].contains(&token.as_str());
    tokens.iter().position(is_head).map_or(Vec::new(), |begin| path(&tokens[begin..]))
}

/// What stands behind the generics that an `impl` may begin with.
fn without_generics(header: &[String]) -> &[String] {
    let mut depth = 0;
    let is_outside = |token: &String| {
        depth += i32::from(token == "<") - i32::from(token == ">");
        depth == 0
    };
    let end = header.iter().position(is_outside).filter(|_| header[0] == "<");
    &header[end.map_or(0, |end| end + 1)..]
}

/// What an `impl` block of a type of the crate is of, if the file declares nothing of it: the type, or the
/// trait and the type.
fn stranger(tree: &Tree, module: &Module, header: &[String]) -> Option<String> {
    let header = without_generics(header);
    let is_home = |names: &[String]| tree.owner(module, names).as_ref() == Some(module);
    // `for<'a>` names no type.
    let Some(middle) = header.windows(2).position(|pair| pair[0] == "for" && pair[1] != "<") else {
        let of_type = head(header);
        tree.owner(module, &of_type)?;
        return if is_home(&of_type) { None } else { of_type.last().cloned() };
    };
    let (of_trait, of_type) = (head(&header[..middle]), head(&header[middle + 1..]));
    tree.owner(module, &of_type)?;
    let (of_trait, of_type) = (of_trait.last()?, of_type.last()?);
    let is_known = header.iter().any(|name| is_home(std::slice::from_ref(name)));
    let is_allowed = is_known || ANYWHERE.contains(&of_trait.as_str());
    (!is_allowed).then(|| format!("{of_trait} for {of_type}"))
}

/// The file of each such block, and what the block is of.
fn scattered(tree: &Tree) -> BTreeSet<(String, String)> {
    let of = |(module, file): (&Module, &File)| {
        let strangers = file.impls.iter().filter_map(|header| stranger(tree, module, header));
        strangers.map(|name| (file.place.clone(), name)).collect::<Vec<_>>()
    };
    tree.files().flat_map(of).collect()
}

#[test]
fn methods_live_in_the_file_of_their_type() {
    let known = KNOWN.iter().map(|(file, name)| ((*file).to_owned(), (*name).to_owned()));
    nothing_else(scattered(&Tree::of_the_house()), known.collect(), "methods away from their type");
}

#[test]
fn a_scattered_method_is_seen() {
    let tree = Tree::new([
        ("lib.rs", "mod a; mod b;"),
        (
            "a.rs",
            "pub struct A<'a>(&'a u8); impl A<'_> {} impl<'a> Iterator for A<'a> {} pub struct C;",
        ),
        (
            "b.rs",
            "use crate::a::{A, C}; pub struct B; pub trait T {}\n\
             impl<'a> A<'a> { fn f() -> impl Fn(B) {} }\n\
             impl T for C {} impl From<B> for C {} impl Default for C {} impl<X: T> Clone for A<'_> {}",
        ),
    ]);
    let found = scattered(&tree).into_iter().map(|(file, name)| format!("{file}: {name}"));
    assert_eq!(Vec::from_iter(found), ["b.rs: A", "b.rs: Clone for A", "b.rs: Default for C"]);
}
