//! Programs that a test needs and a machine may lack.

use std::fs::OpenOptions;
use std::io::Write;
use std::process::Command;

/// The Debian package of a program; the tests ask for no other programs.
fn package(program: &str) -> &'static str {
    match program {
        "chromium" => "chromium",
        "cmake" => "cmake",
        "gcc" => "gcc",
        "g++" => "g++",
        "gfortran" => "gfortran",
        "julia" => "julia (from julialang.org)",
        "mkoctfile" => "octave-dev",
        "kpsewhich" => "texlive-science",
        "octave-cli" => "octave",
        "pdflatex" => "texlive-latex-recommended",
        "pkg-config" => "pkg-config",
        "python3" => "python3",
        "Rscript" => "r-base-core",
        "sha256sum" => "coreutils",
        other => panic!("{other} has no package here"),
    }
}

/// Whether a program is there. A test that needs one that is not says so, past the capture of the test
/// harness, and passes; `make test` repeats it in its last lines.
pub(crate) fn has(program: &str, question: &str) -> bool {
    there(&[program, question], program, package(program))
}

/// The same of a module of Python.
pub(crate) fn has_module(module: &str) -> bool {
    let package = match module {
        "flint" => "python-flint (from PyPI)".to_owned(),
        _ => format!("python3-{module}"),
    };
    there(&["python3", "-c", &format!("import {module}")], module, &package)
}

fn there(question: &[&str], what: &str, package: &str) -> bool {
    let asked = Command::new(question[0]).args(&question[1..]).output();
    let found = asked.is_ok_and(|output| output.status.success());
    if !found {
        skipped(&format!("what needs {what}; install {package}"));
    }
    found
}

/// Says that a test did not do something.
pub(crate) fn skipped(what: &str) {
    let line = format!("skipped: {what}\n");
    let _ = std::io::stderr().write_all(line.as_bytes());
    if let Some(list) = std::env::var_os("COUPLET_SKIPPED") {
        let list = OpenOptions::new().create(true).append(true).open(list);
        list.and_then(|mut list| list.write_all(line.as_bytes())).unwrap();
    }
}
