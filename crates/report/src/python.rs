//! Python: a module of floats and `Decimal`s.

use super::answers::Answers;
use super::listing::{comments, listing};
use super::names::{Named, preface};
use super::words::hexadecimal;
use std::io;

const NOTES: &str = "
NAME_DECIMAL is a decimal.Decimal with all digits; arithmetic on it rounds to decimal.getcontext().prec.
\"\"\"

from decimal import Decimal
";

pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    write!(out, "\"\"\"")?;
    comments(preface(report), "", out)?;
    write!(out, "{NOTES}")?;
    listing(report, "# ", out, value)
}

fn value(named: &Named, out: &mut dyn io::Write) -> io::Result<()> {
    let name = named.capitals();
    writeln!(out, "# {}", named.remark())?;
    for (suffix, x) in named.doubles() {
        writeln!(out, "{name}{suffix} = float.fromhex(\"{}\")", hexadecimal(x))?;
    }
    writeln!(out, "{name}_DECIMAL = Decimal(\"{}\")", named.value.text())
}
