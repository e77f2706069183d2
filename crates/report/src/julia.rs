//! Julia: a module of `Float64` and `BigFloat`.

use super::answers::Answers;
use super::listing::{comments, listing};
use super::names::{Named, preface};
use super::words::hexadecimal;
use crate::number::bits_of;
use std::io;

/// Bits of a `BigFloat` beyond those of its digits, so that they can be printed again.
const GUARD: u32 = 8;

pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "\"\"\"")?;
    comments(preface(report), "", out)?;
    writeln!(out, "\nNAME_BIG is a `BigFloat` of all digits, at the precision they need.")?;
    writeln!(out, "\"\"\"\nmodule CoupletConstants")?;
    listing(report, "# ", out, |named, out| value(named, report.digits, out))?;
    writeln!(out, "\nend # module")
}

fn value(named: &Named, digits: usize, out: &mut dyn io::Write) -> io::Result<()> {
    let name = named.capitals();
    writeln!(out, "# {}", named.remark())?;
    for (suffix, x) in named.doubles() {
        writeln!(out, "const {name}{suffix} = {}", literal(x))?;
    }
    let (text, bits) = (&named.value.text(), bits_of(digits) + GUARD);
    writeln!(out, "const {name}_BIG = BigFloat(\"{text}\"; precision = {bits})")
}

fn literal(x: f64) -> String {
    match x {
        f64::INFINITY => "Inf".into(),
        f64::NEG_INFINITY => "-Inf".into(),
        x => hexadecimal(x),
    }
}
