//! Claims for a person at a terminal.

use super::decided::{Claims, as_printed, lead, remarks};
use crate::claims::Decision;
use crate::record::Record;

/// Characters of a line.
const WIDTH: usize = 100;
const INDENT: &str = "           ";

/// Lines on a claim.
pub(super) fn say(report: &Claims, decision: &Decision, record: &mut Record) {
    let claim = &decision.claim;
    let (verdict, id, place) = (as_printed(decision), claim.id, claim.place);
    let time = 1000.0 * decision.time.as_secs_f64();
    record.say(match report.timed {
        true => format!("{verdict:<10} {id:<22} {place:<28} {time:>8.1} ms"),
        false => format!("{verdict:<10} {id:<22} {place}"),
    });
    let beside = decision.derivation.beside_checks().map(|beside| format!("by checks{beside}"));
    let remarks = remarks(decision).into_iter().map(|(kind, words)| format!("{kind}: {words}"));
    for words in [claim.statement.to_owned()].into_iter().chain(beside).chain(remarks) {
        record.say_all(lines(&words, INDENT, INDENT));
    }
    if report.show {
        record.say(format!("           by {}", decision.derivation.method()));
        for step in decision.derivation.steps() {
            let [mark, _] = lead(step.support);
            record.say_all(lines(&step.words, &format!("    {mark:<6} "), INDENT));
            record.say_all(step.formula.iter().map(|of| format!("             {}", of.text)));
        }
        record.say("");
    }
}

/// Words in lines of at most [`WIDTH`] characters, with another beginning of the first line.
pub(super) fn lines(words: &str, first: &str, indent: &str) -> Vec<String> {
    let (mut lines, mut line, mut gap) = (Vec::new(), first.to_owned(), "");
    for word in words.split_whitespace() {
        if !gap.is_empty() && line.chars().count() + 1 + word.chars().count() > WIDTH {
            lines.push(std::mem::replace(&mut line, indent.to_owned()));
            gap = "";
        }
        line.extend([gap, word]);
        gap = " ";
    }
    lines.push(line);
    lines
}
