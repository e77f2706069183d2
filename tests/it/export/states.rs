//! Arches in every format, by the same code: with text from outside that is as bad as it can be.

use crate::{Scratch, has};
use couplet::arch::SelfWeight;
use couplet::certify::state::{Answer, Arch, Doubt, Fall, Friction};
use couplet::report::export::{Export, ExportFormat, Subject, write};
use couplet::report::{StateOf, StateReport};

/// Ends comments and strings of every language, and starts commands.
const HOSTILE: &str =
    "pi/2 */ \"\"\" ' \" \\ \n\r%} =# -- $(x) ??/\n \\input{/etc/passwd} # ! & \u{2028}";

/// Something that cannot be told: an arch thicker than twice its radius.
fn doubt() -> Doubt {
    let arch = Arch::new(SelfWeight::Heyman, "pi/2".parse().unwrap(), Friction::Infinite).unwrap();
    arch.certify_thickness(&"3".parse().unwrap(), 10).unwrap_err()
}

fn export() -> Export {
    let friction = Friction::Coefficient("0.38".parse().unwrap());
    let arch = Arch::new(SelfWeight::Heyman, "pi/2".parse().unwrap(), friction).unwrap();
    let Ok(Answer::Stands(state)) = arch.certify(40) else { panic!() };
    let doubt = doubt();
    let report = |outcome| StateReport {
        weight: SelfWeight::Heyman,
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

#[test]
fn hostile_text_stays_in_its_comment() {
    let scratch = Scratch::new("export-hostile");
    scratch.write("constants.rs", text(ExportFormat::Rust));
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    scratch.run(rustc, &["--crate-type", "lib", "-D", "warnings", "constants.rs"]);
    if has("gcc", "--version") {
        scratch.write("constants.h", text(ExportFormat::C));
        scratch.write("main.c", "#include \"constants.h\"\ndouble x = COUPLET_STATE_2_THRUST;\n");
        let strict = ["-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror"];
        scratch.run("gcc", &[&strict[..], &["-c", "main.c"]].concat());
    }
    if has("python3", "--version") {
        scratch.write("constants.py", text(ExportFormat::Python));
        let print = "import constants as c; print([n for n in dir(c) if n[0] != '_'])";
        let names = scratch.run("python3", &["-c", print]);
        assert!(names.contains("STATE_2_THICKNESS_DECIMAL"), "{names}");
        assert_eq!(
            names.matches(',').count(),
            6 * 5,
            "nothing but Decimal and the values: {names}"
        );
    }
    if has("gfortran", "--version") {
        scratch.write("constants.f90", text(ExportFormat::Fortran));
        scratch.run("gfortran", &["-Wall", "-Werror", "-c", "constants.f90"]);
    }
    if has("octave-cli", "--version") {
        scratch.write("couplet_constants.m", text(ExportFormat::Matlab));
        let program = "c = couplet_constants(); disp(fieldnames(c))";
        let printed = scratch.run("octave-cli", &["--norc", "--quiet", "--eval", program]);
        assert!(printed.contains("state_2"), "{printed}");
    }
    if has("pdflatex", "--version") && has("kpsewhich", "siunitx.sty") {
        scratch.write("table.tex", text(ExportFormat::Latex));
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
