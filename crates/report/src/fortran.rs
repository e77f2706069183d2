//! Fortran: a module of parameters of two kinds.

use super::answers::Answers;
use super::listing::{comments, listing};
use super::names::{Named, preface};
use std::io;

const NOTES: &str = "!
! name_quad is the nearest number of kind real128, an IEEE quadruple. Literals have 17 and 36 significant
! digits, which tell every number of the kind from its neighbours. All digits are in the comments.
module couplet_constants
  use, intrinsic :: iso_fortran_env, only: int64, real64, real128
  implicit none
  private :: int64
";

/// Digits of a comment's line.
const WIDTH: usize = 100;

pub(super) fn answers(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    comments(preface(report), "! ", out)?;
    write!(out, "{NOTES}")?;
    listing(report, "  ! ", out, value)?;
    writeln!(out, "end module couplet_constants")
}

fn value(named: &Named, out: &mut dyn io::Write) -> io::Result<()> {
    let name = named.capitals().to_lowercase();
    writeln!(out, "  ! {}", named.remark())?;
    let text = &named.value.text();
    for (index, piece) in text.as_bytes().chunks(WIDTH).enumerate() {
        let start = if index == 0 { "" } else { "  " };
        writeln!(out, "  ! {start}{}", String::from_utf8_lossy(piece))?;
    }
    for (suffix, x) in named.doubles() {
        let suffix = suffix.to_lowercase();
        writeln!(out, "  real(real64), parameter :: {name}{suffix} = {}", literal(x))?;
    }
    let quad = match named.value.quad() {
        Some(quad) => format!("{}_real128", decimal(&quad)),
        // Its bits depend on the order of the bytes.
        None if named.value.decimal.is_none() => {
            return writeln!(out, "  ! no {name}_quad: at run time real({name}, real128)");
        }
        None => return writeln!(out, "  ! no {name}_quad: not known to the digits it needs"),
    };
    // With the longest name and literal it would be too long for one line.
    writeln!(out, "  real(real128), parameter :: {name}_quad = &\n    {quad}")
}

/// Infinity has no literal: its bits are given.
fn literal(x: f64) -> String {
    match x {
        x if x.is_infinite() => format!("transfer({}_int64, 0.0_real64)", x.to_bits() as i64),
        x => format!("{x:.16e}_real64"),
    }
}

/// A real literal has a point.
fn decimal(text: &str) -> String {
    let (digits, power) = text.split_once('e').unwrap_or((text, "0"));
    let point = if digits.contains('.') { "" } else { "." };
    format!("{digits}{point}e{power}")
}
