//! Rust: a module of constants.

use super::answers::Answers;
use super::listing::{comments, listing};
use super::names::{Named, bits, preface};
use std::io;

pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    comments(preface(report), "//! ", out)?;
    writeln!(out, "//!\n//! `…_TEXT` has all digits.")?;
    writeln!(out, "#![allow(dead_code)]")?;
    listing(report, "// ", out, value)
}

fn value(named: &Named, out: &mut dyn io::Write) -> io::Result<()> {
    let name = named.capitals();
    for (suffix, x) in named.doubles() {
        let doc = match suffix {
            "_LOWER" => format!("Not above the true [`{name}`]: `{x:?}`."),
            "_UPPER" => format!("Not below the true [`{name}`]: `{x:?}`."),
            "_ERROR" => format!("A bound of the error of [`{name}`]: `{x:?}`."),
            _ => format!("`{}`: the double nearest to it, `{x:?}`.", named.remark()),
        };
        writeln!(out, "/// {doc}")?;
        writeln!(out, "pub const {name}{suffix}: f64 = f64::from_bits(0x{});", bits(x))?;
    }
    writeln!(out, "/// All digits of [`{name}`].")?;
    writeln!(out, "pub const {name}_TEXT: &str = \"{}\";", named.value.text())
}
