//! Equations neither loop nor compare nor round.

use super::source::{bare, code, room, sources};

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
    // `impl X for Y` and `for<'a>` are no loops.
    code.lines().filter(|line| !line.contains("impl")).find_map(|line| {
        forbidden.into_iter().find(|word| line.contains(word)).or_else(|| {
            line.split(|c: char| !c.is_ascii_digit() && c != '.').find(literal).map(|_| line)
        })
    })
}

#[test]
fn equations_neither_loop_nor_compare_nor_round() {
    assert!(impurity("let x = 0.1;").is_some() && impurity("if a > b {").is_some());
    let words = "// if\nconst WORDS: &str = \"0.1 if a > b\";\nimpl<T: for<'a> A<'a>> B for C {}";
    assert_eq!(impurity(&bare(words)), None);
    let files = sources(&room("arch"));
    assert!(files.len() > 8);
    for path in files {
        assert_eq!(impurity(&code(&path)), None, "{}", path.display());
    }
}
