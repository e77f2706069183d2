//! C: a header of macros, which are constant expressions in C and in C++.

use super::answers::Answers;
use super::names::{Named, about, preface};
use super::words::hexadecimal;
use std::io;

const NOTES: &[&str] = &[
    "",
    "Hexadecimal constants are exact; they are part of C99 and of C++17 (and an extension of most",
    "compilers before). COUPLET_..._TEXT has all digits, for a library of many digits.",
];

pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    comment(preface(report).iter().map(String::as_str).chain(NOTES.iter().copied()), out)?;
    writeln!(out, "#ifndef COUPLET_CONSTANTS_H\n#define COUPLET_CONSTANTS_H")?;
    let is_infinite = |named: Named| named.doubles().iter().any(|(_, x)| x.is_infinite());
    if report.list.iter().flat_map(Named::all).any(is_infinite) {
        writeln!(out, "\n#include <math.h> /* HUGE_VAL, infinity */")?;
    }
    for answer in &report.list {
        writeln!(out)?;
        comment(about(answer).iter().map(String::as_str), out)?;
        Named::all(answer).try_for_each(|named| value(&named, out))?;
    }
    writeln!(out, "\n#endif")
}

fn value(named: &Named, out: &mut dyn io::Write) -> io::Result<()> {
    let name = named.capitals();
    writeln!(out, "/* {} */", named.remark())?;
    for (suffix, x) in named.doubles() {
        writeln!(out, "#define COUPLET_{name}{suffix} {}", literal(x))?;
    }
    writeln!(out, "#define COUPLET_{name}_TEXT \"{}\"", named.value.text())
}

fn literal(x: f64) -> String {
    match x {
        f64::INFINITY => "HUGE_VAL".into(),
        f64::NEG_INFINITY => "(-HUGE_VAL)".into(),
        x if x < 0.0 => format!("({})", hexadecimal(x)),
        x => hexadecimal(x),
    }
}

fn comment<'a>(lines: impl Iterator<Item = &'a str>, out: &mut dyn io::Write) -> io::Result<()> {
    for (index, line) in lines.enumerate() {
        let start = if index == 0 { "/*" } else { "\n  " };
        write!(out, "{}", format!("{start} {line}").trim_end_matches(' '))?;
    }
    writeln!(out, " */")
}
