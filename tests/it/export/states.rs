//! Arches in every format, by the same code: with text from outside that is as bad as it can be.

use super::has;
use crate::arches::{H, arch};
use crate::program::Scratch;
use couplet::Undecided;
use couplet::certify::state::{Answer as State, Certify, Fall};
use couplet::report::{Answer, Answers, Format, Reported, Subject};

/// Ends comments and strings of every language, and starts commands.
const HOSTILE: &str =
    "pi/2 */ \"\"\" ' \" \\ \n\r%} =# -- $(x) ??/\n \\input{/etc/passwd} # ! & \u{2028}é½橋±|";

/// Something that cannot be told.
fn doubt() -> Undecided {
    Undecided::new("whether the thickness is enough")
}

fn report() -> Answers {
    let slides = arch(H, "pi/2", "0.38");
    let answer = |line, found| {
        let mut answer = Answer::state(line, &slides, &found);
        if let Subject::Arch { half_opening, friction, .. } = &mut answer.subject {
            (*half_opening, *friction) = (HOSTILE.into(), HOSTILE.into());
        }
        answer
    };
    let list = vec![
        answer(2, slides.certify(40)),
        answer(3, Ok(State::Falls { fall: Fall::Sliding, enough: None })),
        answer(4, Err(doubt().into())),
        Answer::refused(5, HOSTILE.into()),
    ];
    Answers { list, ..Answers::arches(40, false) }
}

fn text(format: &str) -> String {
    let mut text = Vec::new();
    let format = Format::named(Answers::content(), format).unwrap();
    report().write(format, &mut text).unwrap();
    String::from_utf8(text).unwrap()
}

/// What is proved has values; the rest is named and has none.
#[test]
fn only_what_is_proved_has_values() {
    for format in ["c", "rust", "python", "julia"] {
        let text = text(format);
        assert!(text.contains("STATE_2_THICKNESS") && !text.contains("STATE_4"), "{text}");
        assert!(text.contains(&format!("undecided, no values: {}", doubt().reason)), "{text}");
        assert!(text.contains("proved, no values: sliding"), "{text}");
        assert!(text.contains("refused, no values: pi/2"), "{text}");
    }
}

/// A folder with the hostile file of a format.
fn hostile(format: &str, name: &str) -> Scratch {
    let scratch = Scratch::new();
    scratch.write(name, text(format));
    scratch
}

#[test]
fn hostile_text_stays_in_a_comment_of_rust() {
    let scratch = hostile("rust", "constants.rs");
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    scratch.run(rustc, &["--crate-type", "lib", "-D", "warnings", "constants.rs"]);
}

#[test]
fn hostile_text_stays_in_a_comment_of_c() {
    if has("gcc", "--version") {
        let scratch = hostile("c", "constants.h");
        scratch.write("main.c", "#include \"constants.h\"\ndouble x = COUPLET_STATE_2_THRUST;\n");
        let strict = ["-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror"];
        scratch.run("gcc", &[&strict[..], &["-c", "main.c"]].concat());
    }
}

#[test]
fn hostile_text_stays_in_a_comment_of_python() {
    if has("python3", "--version") {
        let scratch = hostile("python", "constants.py");
        let print = "import constants as c; print([n for n in dir(c) if n[0] != '_'])";
        let names = scratch.run("python3", &["-c", print]);
        assert!(names.contains("STATE_2_THICKNESS_DECIMAL"), "{names}");
        let commas = names.matches(',').count();
        assert_eq!(commas, 6 * 5, "nothing but Decimal and the values: {names}");
    }
}

#[test]
fn hostile_text_stays_in_a_comment_of_fortran() {
    if has("gfortran", "--version") {
        let scratch = hostile("fortran", "constants.f90");
        scratch.run("gfortran", &["-Wall", "-Werror", "-c", "constants.f90"]);
    }
}

#[test]
fn hostile_text_stays_in_a_comment_of_octave() {
    if has("octave-cli", "--version") {
        let scratch = hostile("matlab", "couplet_constants.m");
        let program = "c = couplet_constants(); disp(fieldnames(c))";
        let printed = scratch.run("octave-cli", &["--norc", "--quiet", "--eval", program]);
        assert!(printed.contains("state_2"), "{printed}");
    }
}

#[test]
fn hostile_text_stays_in_a_table_of_latex() {
    if has("pdflatex", "--version") && has("kpsewhich", "siunitx.sty") {
        let scratch = hostile("latex", "table.tex");
        scratch.write(
            "main.tex",
            "\\documentclass{article}\\usepackage{booktabs,longtable,siunitx}\n\
             \\begin{document}\\input{table}\\end{document}\n",
        );
        // As a draft: a font that is made for the first time says so on standard error.
        scratch.run(
            "pdflatex",
            &["-draftmode", "-interaction=nonstopmode", "-halt-on-error", "main.tex"],
        );
    }
}

/// A document may hold any text, because it knows how to quote.
#[test]
fn documents_keep_the_text_as_it_was() {
    let json: serde_json::Value = serde_json::from_str(&text("json")).unwrap();
    let toml: toml::Table = toml::from_str(&text("toml")).unwrap();
    assert_eq!(json["arches"][0]["half_opening"], HOSTILE);
    assert_eq!(toml["proofs"][0]["half_opening"].as_str(), Some(HOSTILE));
    assert_eq!(json["arches"][0]["mode"], "[s,r,r]");
    assert_eq!(toml["constants"][0]["line"].as_integer(), Some(2));
    assert_eq!(json["arches"][2]["verdict"], "undecided");
    assert_eq!(toml["proofs"][2]["verdict"].as_str(), Some("undecided"));
    assert_eq!(json["arches"][3]["error"], HOSTILE);
}
