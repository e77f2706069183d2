//! Python: a module of floats and `Decimal`s.

use super::listing::subjects;
use super::names::{capitals, doubles, preface, remark};
use super::{Export, Exported, Subject};
use crate::report::hexadecimal;
use std::io;

const NOTES: &str = "
NAME_DECIMAL is a decimal.Decimal with all digits; arithmetic on it rounds to decimal.getcontext().prec.
\"\"\"

from decimal import Decimal
";

pub fn write(export: &Export, out: &mut dyn io::Write) -> io::Result<()> {
    write!(out, "\"\"\"")?;
    for line in preface(export) {
        writeln!(out, "{line}")?;
    }
    write!(out, "{NOTES}")?;
    subjects(export, "# ", out, value)
}

fn value(subject: &Subject, value: &Exported, out: &mut dyn io::Write) -> io::Result<()> {
    let name = capitals(subject, value);
    writeln!(out, "# {}", remark(value))?;
    for (suffix, x) in doubles(value) {
        writeln!(out, "{name}{suffix} = float.fromhex(\"{}\")", hexadecimal(x))?;
    }
    writeln!(out, "{name}_DECIMAL = Decimal(\"{}\")", value.texts()[0])
}
