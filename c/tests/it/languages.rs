//! The examples print what the command says of the same arches, in every language that is installed.

use crate::library::{Scratch, built, couplet, here};
use crate::tool::{has, skipped};
use std::path::Path;
use std::process::{Command, Output};

/// What couplet says.
fn said(arguments: &[&str], input: &[u8]) -> Output {
    let scratch = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(scratch.path(), input).unwrap();
    let table = scratch.path().to_str().unwrap();
    let arguments = arguments.iter().map(|word| if *word == "TABLE" { table } else { word });
    Command::new(couplet()).args(arguments).output().unwrap()
}

/// The arches of the arrays of the examples: all are doubles.
const ROWS: [(&str, &str); 5] =
    [("0.5", "0.5"), ("1.375", "0.0625"), ("1.375", "0.25"), ("2.4375", "1.375"), ("4.0", "0.5")];

/// What an example has to print.
fn expected() -> String {
    let arch = |half_opening| {
        let arch = ["state", "--half-opening", half_opening, "--friction", "0.25"];
        said(&[&arch[..], &["--digits", "40", "--format", "json"]].concat(), b"")
    };
    let state: serde_json::Value = serde_json::from_slice(&arch("80deg").stdout).unwrap();
    let text = |value: &serde_json::Value| value.as_str().unwrap().to_owned();
    let mut lines =
        vec![format!("{} {}", text(&state["mode"]), text(&state["thickness"]["value"]))];
    let refused = arch("4");
    assert_eq!(refused.status.code(), Some(2));
    let sentence = String::from_utf8(refused.stderr).unwrap();
    lines.push(sentence.trim().strip_prefix("couplet: ").unwrap().to_owned());
    let table = ROWS.map(|(alpha, mu)| format!("{alpha},{mu}\n")).concat();
    let states = said(
        &["states", "TABLE", "--digits", "17", "--format", "jsonl"],
        format!("alpha,mu\n{table}").as_bytes(),
    );
    let states = String::from_utf8(states.stdout).unwrap();
    assert_eq!(states.lines().count(), ROWS.len(), "{states}");
    for line in states.lines() {
        let row: serde_json::Value = serde_json::from_str(line).unwrap();
        let bits = |of: &str| row[of]["value"].as_str().unwrap().parse::<f64>().unwrap().to_bits();
        lines.push(match row["can_stand"].as_bool() {
            Some(true) => format!(
                "0 {} {:016x} {:016x}",
                text(&row["mode"]),
                bits("thickness"),
                bits("thrust")
            ),
            Some(false) => "1 ".to_owned(),
            None => "3 ".to_owned(),
        });
    }
    assert_eq!(lines.iter().map(|line| &line[..1]).collect::<String>(), "[t01003", "{lines:?}");
    lines.join("\n") + "\n"
}

#[track_caller]
pub(crate) fn is_as_expected(printed: &str) {
    // Fortran writes large hexadecimal digits, and leaves no space at an end.
    let plain = |text: &str| -> String {
        text.lines().map(|line| line.trim_end().to_lowercase() + "\n").collect()
    };
    assert_eq!(plain(printed), plain(&expected()));
}

pub(crate) fn path(path: &Path) -> String {
    path.to_str().unwrap().to_owned()
}

/// The options with which a compiler finds the shared library, also when the program runs.
fn shared() -> Vec<String> {
    let lib = path(&built().join("lib"));
    vec![
        format!("-I{}", path(&built().join("include"))),
        format!("-L{lib}"),
        "-lcouplet_c".into(),
        format!("-Wl,-rpath,{lib}"),
    ]
}

/// The same of the static one.
fn linked() -> Vec<String> {
    let library = path(&built().join("lib/libcouplet_c.a"));
    let include = format!("-I{}", path(&built().join("include")));
    [&include, &library, "-lpthread", "-ldl"].map(str::to_owned).to_vec()
}

const STRICT: [&str; 5] = ["-Wall", "-Wextra", "-pedantic", "-Werror", "-g"];

/// Compiles files of this crate and runs the program; what it prints.
fn run(compiler: &str, options: &[&str], files: &[&str], library: Vec<String>) -> String {
    let (scratch, program) = compiled(compiler, options, files, library);
    scratch.run(&program, &[])
}

/// Compiles files of this crate; where the program is.
fn compiled(
    compiler: &str,
    options: &[&str],
    files: &[&str],
    library: Vec<String>,
) -> (Scratch, String) {
    let scratch = Scratch::new();
    let files: Vec<String> = files.iter().map(|file| path(&here().join(file))).collect();
    let program = scratch.path("program");
    let mut all: Vec<&str> = options.to_vec();
    all.extend(STRICT);
    all.extend(files.iter().map(String::as_str));
    // Libraries stand behind what needs them.
    all.extend(["-o", &program, "-pthread"]);
    all.extend(library.iter().map(String::as_str));
    all.push("-lm");
    scratch.run(compiler, &all);
    (scratch, program)
}

/// A program of C, shared and static.
fn is_well(file: &str) {
    if has("gcc", "--version") {
        for library in [shared(), linked()] {
            assert_eq!(run("gcc", &["-std=c11"], &[file], library), "well\n");
        }
    }
}

#[test]
fn c_says_what_the_command_says() {
    if has("gcc", "--version") {
        is_as_expected(&run("gcc", &["-std=c99"], &["examples/arches.c"], shared()));
        is_as_expected(&run("gcc", &["-std=c99"], &["examples/arches.c"], linked()));
    }
}

/// What is asked of the library, and the command that asks the same.
const SAME: [(&str, &str); 14] = [
    ("state milankovitch 80deg 0.25 40", "state --half-opening 80deg --friction 0.25 --digits 40"),
    (
        "state heyman 80deg 0.1 17",
        "state --weight heyman --half-opening 80deg --friction 0.1 --digits 17",
    ),
    ("state milankovitch 3 31deg 5", "state --half-opening 3 --friction 31deg --digits 5"),
    (
        "assess milankovitch 80deg 0.6 3/25 17",
        "assess --half-opening 80deg --friction 0.6 --thickness 3/25 --digits 17",
    ),
    (
        "assess heyman 2 inf 0.01 9",
        "assess --weight heyman --half-opening 2 --friction inf --thickness 0.01 --digits 9",
    ),
    (
        "find milankovitch - - 0.6 0.15 12",
        "find half-opening --friction 0.6 --thickness 0.15 --digits 12",
    ),
    ("find milankovitch - 80deg - - 12", "find friction --half-opening 80deg --digits 12"),
    ("find milankovitch rrs/rsr - 1.6 - 17", "find boundary rrs/rsr --friction 1.6 --digits 17"),
    ("landmark T heyman 25", "certify T --weight heyman --digits 25"),
    (
        "arch milankovitch 80deg 0.6 - 10",
        "certify state --half-opening 80deg --friction 0.6 --digits 10",
    ),
    (
        "arch milankovitch 80deg 0.6 0.12 10",
        "certify arch --half-opening 80deg --friction 0.6 --thickness 0.12 --digits 10",
    ),
    (
        "state heyman 79deg..81deg 0.5..inf 6",
        "state --weight heyman --half-opening 79deg..81deg --friction 0.5..inf --digits 6",
    ),
    (
        "assess milankovitch 80deg±1deg 0.6+-10% 0.1..0.12 9",
        "assess --half-opening 80deg±1deg --friction 0.6+-10% --thickness 0.1..0.12 --digits 9",
    ),
    (
        "arch milankovitch 78deg..80deg 0.6 0.06..0.12 10",
        "certify survey --half-opening 78deg..80deg --friction 0.6 --thickness 0.06..0.12 --digits 10",
    ),
];

#[test]
fn the_json_is_that_of_the_command_to_the_last_byte() {
    if !has("gcc", "--version") {
        return;
    }
    let (scratch, program) = compiled("gcc", &["-std=c11"], &["tests/programs/ask.c"], shared());
    for (asked, command) in SAME {
        let printed = scratch.run(&program, &asked.split(' ').collect::<Vec<_>>());
        let format: &[&str] =
            if command.starts_with("certify") { &[] } else { &["--format", "json"] };
        let words: Vec<&str> = command.split(' ').chain(format.iter().copied()).collect();
        let said = String::from_utf8(said(&words, b"").stdout).unwrap();
        assert_eq!(printed, said, "{asked}");
        assert!(printed.len() > 200, "{asked}");
    }
}

/// A sentence of the command in the words of fields, without the example.
fn in_fields(sentence: &str) -> String {
    let sentence = sentence.trim().strip_prefix("couplet: ").unwrap();
    let (sentence, _) = sentence.split_once("; for example").unwrap_or((sentence, ""));
    let words = sentence.split(' ').map(|word| match word.contains("--") {
        true => word.replacen("--", "", 1).replace('-', "_"),
        false => word.to_owned(),
    });
    words.collect::<Vec<_>>().join(" ")
}

/// Every question of `tests/questions.txt`: the answer of the command, or its sentence.
#[test]
fn every_question_has_the_answer_of_the_command() {
    if !has("gcc", "--version") {
        return;
    }
    let (scratch, program) = compiled("gcc", &["-std=c11"], &["tests/programs/ask.c"], shared());
    let questions = std::fs::read_to_string(here().join("../tests/questions.txt")).unwrap();
    let questions: Vec<&str> = questions.lines().filter(|line| !line.starts_with('#')).collect();
    assert!(questions.len() > 20);
    for line in questions {
        let (question, arch) = line.trim_start_matches("! ").split_once(' ').unwrap();
        let fields = arch.replace(' ', "; ");
        let printed = scratch.run(&program, &["any", "milankovitch", &fields, "12"]);
        let options = arch.split(' ').flat_map(|pair| {
            let (name, text) = pair.split_once('=').unwrap();
            [format!("--{}", name.replace('_', "-")), text.to_owned()]
        });
        let options: Vec<String> = options.collect();
        let mut words = vec![question, "--digits", "12", "--format", "json"];
        words.extend(options.iter().map(String::as_str));
        let output = said(&words, b"");
        if line.starts_with('!') {
            let sentence = in_fields(&String::from_utf8(output.stderr).unwrap());
            assert_eq!(printed.trim(), sentence, "{line}");
        } else {
            assert_eq!(printed, String::from_utf8(output.stdout).unwrap(), "{line}");
        }
    }
}

/// The first program of the manual, by the commands beside it.
#[test]
fn the_manual_prints_what_it_shows() {
    if !has("gcc", "--version") || !has("pkg-config", "--version") {
        return;
    }
    let page = std::fs::read_to_string(here().join("../docs/c.md")).unwrap();
    let program = page.split("```c\n").nth(1).unwrap().split("```").next().unwrap();
    let shown = page.split("    ./arch\n").nth(1).unwrap().lines().next().unwrap();
    let scratch = Scratch::new();
    std::fs::write(scratch.path("arch.c"), program).unwrap();
    let lib = path(&built().join("lib"));
    let compile = format!(
        "PKG_CONFIG_PATH={lib}/pkgconfig; export PKG_CONFIG_PATH; gcc -Wall -Werror arch.c \
         $(pkg-config --cflags --libs couplet_c) -Wl,-rpath,{lib} -o arch"
    );
    scratch.run("sh", &["-c", &compile]);
    assert_eq!(scratch.run(&scratch.path("arch"), &[]).trim(), shown.trim());
}

#[test]
fn cpp_says_what_the_command_says() {
    if has("g++", "--version") {
        is_as_expected(&run("g++", &["-std=c++17", "-x", "c++"], &["examples/arches.c"], shared()));
    }
}

#[test]
fn fortran_says_what_the_command_says() {
    if has("gfortran", "--version") {
        let files = ["include/couplet_c.f90", "examples/arches.f90"];
        // The module file is written where the compiler runs.
        is_as_expected(&run("gfortran", &["-std=f2018"], &files, shared()));
    }
}

#[test]
fn julia_says_what_the_command_says() {
    if has("julia", "--version") {
        let lib = format!("LD_LIBRARY_PATH={}", path(&built().join("lib")));
        let example = path(&here().join("examples/arches.jl"));
        let scratch = Scratch::new();
        is_as_expected(&scratch.run("env", &[&lib, "julia", "--startup-file=no", &example]));
    }
}

#[test]
fn octave_says_what_the_command_says() {
    if !has("octave-cli", "--version") || !has("mkoctfile", "--version") {
        return;
    }
    let scratch = Scratch::new();
    let library = shared();
    for name in ["couplet_state", "couplet_states"] {
        let file = path(&here().join(format!("examples/{name}.cc")));
        let mut options = vec![file.as_str(), "-o", name];
        options.extend(library.iter().map(String::as_str));
        scratch.run("mkoctfile", &options);
    }
    let example = path(&here().join("examples/arches.m"));
    is_as_expected(&scratch.run("octave-cli", &["--norc", "--quiet", &example]));
}

#[test]
fn what_makes_no_sense_is_refused() {
    is_well("tests/programs/refused.c");
}

#[test]
#[cfg(target_os = "linux")]
fn what_is_made_to_do_harm_does_none() {
    is_well("tests/programs/attacked.c");
}

/// The same beside what sees memory that is used or freed wrongly, or not freed; and that it would see it.
#[test]
#[cfg(target_os = "linux")]
fn what_is_made_to_do_harm_leaves_the_memory_as_it_was() {
    if !has("gcc", "--version") {
        return;
    }
    let scratch = Scratch::new();
    let library = scratch.path("empty.so");
    let empty = ["-fsanitize=address", "-x", "c", "/dev/null", "-shared", "-o", &library];
    if !Command::new("gcc").args(empty).status().is_ok_and(|status| status.success()) {
        return skipped("the library for C under an address sanitizer; install gcc with libasan");
    }
    let options = ["-std=c11", "-fsanitize=address"];
    let (scratch, program) = compiled("gcc", &options, &["tests/programs/attacked.c"], shared());
    assert_eq!(scratch.run(&program, &[]), "well\n");
    let twice = Command::new(program).arg("twice").output().unwrap();
    assert!(!twice.status.success(), "an answer that is freed twice is seen");
    let said = String::from_utf8_lossy(&twice.stderr);
    assert!(said.contains("AddressSanitizer: attempting double-free"), "{said}");
}

/// The libraries are not led astray by functions of the same name.
#[test]
#[cfg(target_os = "linux")]
fn a_program_may_have_a_gmp_of_its_own() {
    if has("gcc", "--version") {
        let file = "tests/programs/own_gmp.c";
        for library in [shared(), linked()] {
            assert_eq!(run("gcc", &["-std=c11", "-rdynamic"], &[file], library), "well\n");
        }
    }
}

/// Whichever of the two stands first: of what both have by a name, a linker may keep the first one's.
#[test]
#[cfg(target_os = "linux")]
fn a_program_may_have_another_library_made_by_rust() {
    if has("gcc", "--version") {
        let scratch = Scratch::new();
        let (other, source) = (scratch.path("libother.a"), here().join("tests/programs/other.rs"));
        scratch.run("rustc", &["--edition=2024", "-O", &path(&source), "-o", &other]);
        let program = "tests/programs/beside_rust.c";
        let other = vec![other];
        for libraries in [[shared(), other.clone()], [linked(), other.clone()], [other, linked()]] {
            assert_eq!(run("gcc", &["-std=c11"], &[program], libraries.concat()), "well\n");
        }
    }
}

#[test]
fn every_function_answers() {
    is_well("tests/programs/answers.c");
}

#[test]
fn arrays_are_answered_bit_for_bit_whatever_the_threads() {
    is_well("tests/programs/arrays.c");
}

#[test]
fn threads_ask_and_read_at_once() {
    is_well("tests/programs/threads.c");
}

#[test]
fn a_forked_process_goes_on() {
    is_well("tests/programs/forked.c");
}
