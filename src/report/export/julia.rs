//! Julia: a module of `Float64` and `BigFloat`.

use super::listing::subjects;
use super::names::{capitals, doubles, preface, remark};
use super::{Export, Exported, Subject};
use crate::number::bits_of;
use crate::report::hexadecimal;
use std::io;

/// Bits of a `BigFloat` beyond those of its digits, so that they can be printed again.
const GUARD: u32 = 8;

pub fn write(export: &Export, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "\"\"\"")?;
    for line in preface(export) {
        writeln!(out, "{line}")?;
    }
    writeln!(out, "\nNAME_BIG is a `BigFloat` of all digits, at the precision they need.")?;
    writeln!(out, "\"\"\"\nmodule CoupletConstants")?;
    subjects(export, "# ", out, |subject, one, out| value(subject, one, export.digits, out))?;
    writeln!(out, "\nend # module")
}

fn value(
    subject: &Subject,
    value: &Exported,
    digits: usize,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let name = capitals(subject, value);
    writeln!(out, "# {}", remark(value))?;
    for (suffix, x) in doubles(value) {
        writeln!(out, "const {name}{suffix} = {}", literal(x))?;
    }
    let (text, bits) = (&value.texts()[0], bits_of(digits) + GUARD);
    writeln!(out, "const {name}_BIG = BigFloat(\"{text}\"; precision = {bits})")
}

fn literal(x: f64) -> String {
    match x {
        f64::INFINITY => "Inf".into(),
        f64::NEG_INFINITY => "-Inf".into(),
        x => hexadecimal(x),
    }
}
