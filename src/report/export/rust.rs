//! Rust: a module of constants.

use super::listing::{comments, subjects};
use super::names::{bits, capitals, doubles, preface, remark};
use super::{Export, Exported, Subject};
use std::io;

pub fn write(export: &Export, out: &mut dyn io::Write) -> io::Result<()> {
    comments(preface(export), "//! ", out)?;
    writeln!(out, "//!\n//! `…_TEXT` has all digits.")?;
    writeln!(out, "#![allow(dead_code)]")?;
    subjects(export, "// ", out, value)
}

fn value(subject: &Subject, value: &Exported, out: &mut dyn io::Write) -> io::Result<()> {
    let name = capitals(subject, value);
    for (suffix, x) in doubles(value) {
        let doc = match suffix {
            "_LOWER" => format!("Not above the true [`{name}`]: `{x:?}`."),
            "_UPPER" => format!("Not below the true [`{name}`]: `{x:?}`."),
            "_ERROR" => format!("A bound of the error of [`{name}`]: `{x:?}`."),
            _ => format!("`{}`: the double nearest to it, `{x:?}`.", remark(value)),
        };
        writeln!(out, "/// {doc}")?;
        writeln!(out, "pub const {name}{suffix}: f64 = f64::from_bits(0x{});", bits(x))?;
    }
    writeln!(out, "/// All digits of [`{name}`].")?;
    writeln!(out, "pub const {name}_TEXT: &str = \"{}\";", value.texts()[0])
}
