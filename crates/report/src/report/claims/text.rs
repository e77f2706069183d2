//! Claims for a person at a terminal.

use super::decided::{Claims, as_printed, lead, remarks, summary};
use crate::claims::Decision;
use std::io;

/// Writes all claims.
pub(crate) fn claims(report: &Claims, out: &mut dyn io::Write) -> io::Result<()> {
    for decision in &report.decisions {
        heading(decision, report.timed, out)?;
        if report.show {
            steps(decision, out)?;
            writeln!(out)?;
        }
    }
    writeln!(out, "{}", summary(&report.decisions))
}

/// Characters of a line.
const WIDTH: usize = 100;
const INDENT: &str = "           ";

fn heading(decision: &Decision, timed: bool, out: &mut dyn io::Write) -> io::Result<()> {
    let claim = &decision.claim;
    let (verdict, id, place) = (as_printed(decision), claim.id, claim.place);
    if timed {
        let time = 1000.0 * decision.time.as_secs_f64();
        writeln!(out, "{verdict:<10} {id:<22} {place:<28} {time:>8.1} ms")?;
    } else {
        writeln!(out, "{verdict:<10} {id:<22} {place}")?;
    }
    wrapped(claim.statement, INDENT, out)?;
    if let Some(argument) = decision.derivation.argument() {
        wrapped(&format!("by checks {}", argument.words()), INDENT, out)?;
    }
    remarks(decision)
        .into_iter()
        .try_for_each(|(kind, words)| wrapped(&format!("{kind}: {words}"), INDENT, out))
}

fn steps(decision: &Decision, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "           by {}", decision.derivation.method())?;
    for step in decision.derivation.steps() {
        let [mark, _] = lead(step.support);
        lines(&step.words, &format!("    {mark:<6} "), INDENT, out)?;
        if let Some(formula) = &step.formula {
            writeln!(out, "             {}", formula.text)?;
        }
    }
    Ok(())
}

/// Words in lines of at most [`WIDTH`] characters.
fn wrapped(words: &str, indent: &str, out: &mut dyn io::Write) -> io::Result<()> {
    lines(words, indent, indent, out)
}

/// Lines of a claim, with another beginning of the first line.
pub(super) fn lines(
    words: &str,
    first: &str,
    indent: &str,
    out: &mut dyn io::Write,
) -> io::Result<()> {
    let mut line = first.to_owned();
    let mut fresh = true;
    for word in words.split_whitespace() {
        if !fresh && line.chars().count() + 1 + word.chars().count() > WIDTH {
            writeln!(out, "{line}")?;
            line = indent.to_owned();
            fresh = true;
        }
        if !fresh {
            line.push(' ');
        }
        line += word;
        fresh = false;
    }
    writeln!(out, "{line}")
}
