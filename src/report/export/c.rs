//! C: a header of macros, which are constant expressions in C and in C++.

use super::names::{about, capitals, doubles, preface, remark};
use super::{Export, Exported, Subject};
use crate::report::hexadecimal;
use std::io;

const NOTES: &[&str] = &[
    "",
    "Hexadecimal constants are exact; they are part of C99 and of C++17 (and an extension of most",
    "compilers before). COUPLET_..._TEXT has all digits, for a library of many digits.",
];

pub fn write(export: &Export, out: &mut dyn io::Write) -> io::Result<()> {
    comment(preface(export).iter().map(String::as_str).chain(NOTES.iter().copied()), out)?;
    writeln!(out, "#ifndef COUPLET_CONSTANTS_H\n#define COUPLET_CONSTANTS_H")?;
    let mut values = export.subjects.iter().flat_map(|subject| &subject.values);
    if values.any(|value| doubles(value).iter().any(|(_, x)| x.is_infinite())) {
        writeln!(out, "\n#include <math.h> /* HUGE_VAL, infinity */")?;
    }
    for subject in &export.subjects {
        writeln!(out)?;
        comment(about(subject).iter().map(String::as_str), out)?;
        for value in &subject.values {
            self::value(subject, value, out)?;
        }
    }
    writeln!(out, "\n#endif")
}

fn value(subject: &Subject, value: &Exported, out: &mut dyn io::Write) -> io::Result<()> {
    let name = capitals(subject, value);
    writeln!(out, "/* {} */", remark(value))?;
    for (suffix, x) in doubles(value) {
        writeln!(out, "#define COUPLET_{name}{suffix} {}", literal(x))?;
    }
    writeln!(out, "#define COUPLET_{name}_TEXT \"{}\"", value.texts()[0])
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
