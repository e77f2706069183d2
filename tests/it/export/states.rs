//! Arches in every format, by the same code: with text from outside that is as bad as it can be.

use super::has;
use crate::arches::{H, arch, number};
use crate::program::Scratch;
use couplet::certify::state::{Answer, Doubt, Fall};
use couplet::report::export::{Export, ExportFormat, Subject, write};
use couplet::report::{StateOf, StateReport};

/// Ends comments and strings of every language, and starts commands.
const HOSTILE: &str =
    "pi/2 */ \"\"\" ' \" \\ \n\r%} =# -- $(x) ??/\n \\input{/etc/passwd} # ! & \u{2028}";

/// Something that cannot be told: an arch thicker than twice its radius.
fn doubt() -> Doubt {
    arch(H, "pi/2", "inf").certify_thickness(&number("3"), 10).unwrap_err()
}

fn export() -> Export {
    let Ok(Answer::Stands(state)) = arch(H, "pi/2", "0.38").certify(40) else { panic!() };
    let doubt = doubt();
    let report = |outcome| StateReport {
        weight: H,
        half_opening: HOSTILE.into(),
        friction: HOSTILE.into(),
        doubles: true,
        outcome,
    };
    Export {
        title: "Arches",
        schema: "couplet.states/1",
        digits: 40,
        subjects: vec![
            Subject::state(2, &report(StateOf::Stands(&state))),
            Subject::state(3, &report(StateOf::Falls(Fall::Sliding))),
            Subject::state(4, &report(StateOf::Undecided(&doubt))),
            Subject::refused(5, HOSTILE),
        ],
    }
}

fn text(format: ExportFormat) -> String {
    let mut text = Vec::new();
    write(format, &export(), &mut text).unwrap();
    String::from_utf8(text).unwrap()
}

/// What is proved has values; the rest is named and has none.
#[test]
fn only_what_is_proved_has_values() {
    for format in [ExportFormat::C, ExportFormat::Rust, ExportFormat::Python, ExportFormat::Julia] {
        let text = text(format);
        assert!(text.contains("STATE_2_THICKNESS") && !text.contains("STATE_4"), "{text}");
        assert!(text.contains(&format!("undecided, no values: {}", doubt().question)), "{text}");
        assert!(text.contains("proved, no values: sliding"), "{text}");
        assert!(text.contains("refused, no values: pi/2"), "{text}");
    }
}

/// A folder with the hostile file of a format.
fn hostile(format: ExportFormat, name: &str) -> Scratch {
    let scratch = Scratch::new();
    scratch.write(name, text(format));
    scratch
}

#[test]
fn hostile_text_stays_in_a_comment_of_rust() {
    let scratch = hostile(ExportFormat::Rust, "constants.rs");
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    scratch.run(rustc, &["--crate-type", "lib", "-D", "warnings", "constants.rs"]);
}

#[test]
fn hostile_text_stays_in_a_comment_of_c() {
    if has("gcc", "--version") {
        let scratch = hostile(ExportFormat::C, "constants.h");
        scratch.write("main.c", "#include \"constants.h\"\ndouble x = COUPLET_STATE_2_THRUST;\n");
        let strict = ["-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror"];
        scratch.run("gcc", &[&strict[..], &["-c", "main.c"]].concat());
    }
}

#[test]
fn hostile_text_stays_in_a_comment_of_python() {
    if has("python3", "--version") {
        let scratch = hostile(ExportFormat::Python, "constants.py");
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
        let scratch = hostile(ExportFormat::Fortran, "constants.f90");
        scratch.run("gfortran", &["-Wall", "-Werror", "-c", "constants.f90"]);
    }
}

#[test]
fn hostile_text_stays_in_a_comment_of_octave() {
    if has("octave-cli", "--version") {
        let scratch = hostile(ExportFormat::Matlab, "couplet_constants.m");
        let program = "c = couplet_constants(); disp(fieldnames(c))";
        let printed = scratch.run("octave-cli", &["--norc", "--quiet", "--eval", program]);
        assert!(printed.contains("state_2"), "{printed}");
    }
}

#[test]
fn hostile_text_stays_in_a_table_of_latex() {
    if has("pdflatex", "--version") && has("kpsewhich", "siunitx.sty") {
        let scratch = hostile(ExportFormat::Latex, "table.tex");
        scratch.write(
            "main.tex",
            "\\documentclass{article}\\usepackage{booktabs,longtable,siunitx}\n\
             \\begin{document}\\input{table}\\end{document}\n",
        );
        scratch.run("pdflatex", &["-interaction=nonstopmode", "-halt-on-error", "main.tex"]);
    }
}

/// A document may hold any text, because it knows how to quote.
#[test]
fn documents_keep_the_text_as_it_was() {
    let json: serde_json::Value = serde_json::from_str(&text(ExportFormat::Json)).unwrap();
    let toml: toml::Table = toml::from_str(&text(ExportFormat::Toml)).unwrap();
    assert_eq!(json["proofs"][0]["half_opening"], HOSTILE);
    assert_eq!(toml["proofs"][0]["half_opening"].as_str(), Some(HOSTILE));
    assert_eq!(json["proofs"][0]["mode"], "[s,r,r]");
    assert_eq!(json["constants"][0]["line"], 2);
    assert_eq!(json["proofs"][2]["verdict"], "undecided");
}
