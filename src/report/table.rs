//! Tables for a person at a terminal.

use super::{Audit, Constants, Proved, texts};
use crate::arch::SelfWeight;
use crate::certify::PrintedVerdict;
use std::io;

pub fn constants(report: &Constants, out: &mut dyn io::Write) -> io::Result<()> {
    let digits = report.digits;
    let plural = if digits == 1 { "" } else { "s" };
    writeln!(out, "Landmark constants, correctly rounded to {digits} significant digit{plural}")?;
    for entry in &report.landmarks {
        let (symbol, name) = (entry.landmark.symbol(), entry.landmark.name());
        let weight = match entry.weight {
            SelfWeight::Heyman => "Heyman-like",
            SelfWeight::Milankovitch => "Milankovitch-like",
        };
        writeln!(out, "\n{symbol}  {name}, {weight} self-weight")?;
        match &entry.outcome {
            Ok(proved) => landmark(proved, out)?,
            Err(reason) => writeln!(out, "   {reason}")?,
        }
    }
    Ok(())
}

fn landmark(proved: &Proved, out: &mut dyn io::Write) -> io::Result<()> {
    let equations: Vec<_> = proved.system.equations.iter().map(|e| e.label()).collect();
    let radii: Vec<String> = proved
        .system
        .unknowns
        .iter()
        .zip(&proved.relative_radii)
        .map(|(unknown, radius)| format!("{} ±{:.1}%", unknown.name(), 100.0 * radius))
        .collect();
    writeln!(out, "   proved: one solution of {}", equations.join(", "))?;
    writeln!(out, "   in the box {}", radii.join(", "))?;
    for constant in &proved.constants {
        let [value, ..] = texts(&constant.value);
        let exact = match constant.exact.as_deref() {
            Some(exact) if exact != value => format!("  = {exact}"),
            Some(_) => "  exactly".to_owned(),
            None => String::new(),
        };
        let (name, symbol) = (constant.quantity.name(), constant.quantity.symbol());
        writeln!(out, "   {name:<23} {symbol:<19} {value}{exact}")?;
    }
    Ok(())
}

pub fn audit(report: &Audit, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(
        out,
        "Printed numbers against certified values; errors in units of the last printed place\n"
    )?;
    writeln!(
        out,
        "{:<8} {:<12} {:<2} {:<20} {:<20} {:>8} {:>7}  verdict",
        "place", "weight", "", "quantity", "printed", "error", "digits"
    )?;
    for entry in &report.printed {
        let printed = entry.printed;
        writeln!(
            out,
            "{:<8} {:<12} {:<2} {:<20} {:<20} {:>8} {:>7}  {}",
            printed.place,
            printed.weight.name(),
            printed.landmark.symbol(),
            printed.quantity.name(),
            printed.text,
            entry.error_units.to_string(),
            entry.correct_digits,
            entry.verdict.name(),
        )?;
    }
    let count = |verdict| report.printed.iter().filter(|entry| entry.verdict == verdict).count();
    let (right, faithful, wrong) = (
        count(PrintedVerdict::CorrectlyRounded),
        count(PrintedVerdict::Faithful),
        count(PrintedVerdict::Wrong),
    );
    let all = report.printed.len();
    writeln!(
        out,
        "\n{all} printed numbers: {right} correctly rounded, {faithful} faithful, {wrong} wrong\n"
    )?;
    writeln!(out, "Milankovitch's weight compared with Heyman's\n")?;
    writeln!(out, "{:<2} {:<20} {:<8} {:<10} verdict", "", "quantity", "claimed", "certified")?;
    for entry in &report.comparisons {
        writeln!(
            out,
            "{:<2} {:<20} {:<8} {:<10} {}",
            entry.landmark.symbol(),
            entry.quantity.name(),
            entry.claimed.name(),
            entry.certified.name(),
            entry.verdict(),
        )?;
    }
    Ok(())
}
