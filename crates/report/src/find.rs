//! Answer to a question asked the other way round: a half opening or a friction, with what goes with it.

use super::answer::{Answer, Status};
use super::answers::Answers;
use super::record::Record;
use super::subject::Subject;
use super::words::{apart, labels, model, reason};
use crate::certify::Undecided;
use crate::problem::Quantity;
use serde_json::Value as Json;
use std::io;

/// Given values, in words: `thickness 0.15, friction 0.6`.
fn given(subject: &Subject) -> String {
    let [half_opening, friction, thickness] = subject.given();
    let parts = [("half opening", half_opening), ("thickness", thickness), ("friction", friction)];
    let said = parts.into_iter().filter_map(|(name, text)| Some(format!("{name} {}", text?)));
    said.collect::<Vec<_>>().join(", ")
}

/// The question in words: `widest half opening for thickness 0.15, friction 0.6`.
pub(super) fn asked(subject: &Subject) -> String {
    let Subject::Sought { sought, boundary, .. } = subject else { return String::new() };
    let sought = sought.name().replace('_', " ");
    let what = match (boundary, &sought[..]) {
        (Some(line), sought) => format!("{sought} at the boundary {line}"),
        (None, "friction") => "least friction".to_owned(),
        (None, sought) => format!("widest {sought}"),
    };
    format!("{what} for {}", given(subject))
}

pub(super) fn table(report: &Answers, out: &mut dyn io::Write) -> io::Result<()> {
    apart(&report.list, out, |answer, out| one(report, answer, out))
}

fn one(report: &Answers, answer: &Answer, out: &mut dyn io::Write) -> io::Result<()> {
    let Subject::Sought { weight, boundary, .. } = &answer.subject else { return Ok(()) };
    writeln!(out, "The {}, {}\n", asked(&answer.subject), model(*weight))?;
    match &answer.status {
        Status::Undecided(undecided) => return self::undecided(undecided, out),
        Status::Falls(fall) => {
            return writeln!(out, "there is none, proved: nothing stands ({})", reason(*fall));
        }
        _ => {}
    }
    for &quantity in &report.quantities {
        if let Some(value) = answer.value(quantity) {
            let (name, symbol) = (quantity.name(), quantity.symbol());
            writeln!(out, "   {name:<20} {symbol:<12} {}", value.text())?;
        }
    }
    match (boundary, &labels(&answer.modes)[..]) {
        (_, []) => {}
        (Some(_), modes) => writeln!(out, "\nbetween {}", modes.join(" and "))?,
        (None, ["[s,s]"]) => writeln!(out, "\nslides there as [s,s], whatever the thickness")?,
        (None, modes) => writeln!(out, "\ncollapses there as {}", modes.join(" "))?,
    }
    match answer.proved_in_words() {
        Some(proved) => writeln!(out, "proved: {proved}"),
        None => Ok(()),
    }
}

/// Writes why nothing is known, and the modes between which that is.
pub(super) fn undecided(undecided: &Undecided, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "{undecided}")?;
    let between = labels(&undecided.between);
    match undecided.gap.filter(|_| !between.is_empty()) {
        Some(gap) => {
            let place = match &between[..] {
                [mode] => format!("at the edge of {mode}"),
                modes => format!("between {}", modes.join(" and ")),
            };
            writeln!(out, "   {place}; the difference is below {gap:.1e}")
        }
        None => Ok(()),
    }
}

/// The fields of an answer: what is given as text, what is found as `value` makes it.
pub(super) fn fields(
    answer: &Answer,
    modes: impl Into<Json>,
    value: impl Fn(&mut Record, Quantity),
) -> Record {
    let mut fields = Record::default();
    let Subject::Sought { weight, sought, boundary, .. } = &answer.subject else { return fields };
    let [half_opening, friction, thickness] = answer.subject.given();
    fields.add("weight", weight.name());
    fields.add("sought", sought.name());
    fields.add("boundary", boundary.map(|line| line.to_string()));
    let given = [
        (Quantity::HalfOpening, half_opening),
        (Quantity::Friction, friction),
        (Quantity::Thickness, thickness),
    ];
    for (quantity, text) in given {
        match text {
            Some(text) => fields.add(quantity.name(), text),
            None => value(&mut fields, quantity),
        }
    }
    fields.add("verdict", answer.status.name());
    fields.add("modes", modes);
    for quantity in Quantity::FOUND {
        if !given.iter().any(|(name, _)| *name == quantity) {
            value(&mut fields, quantity);
        }
    }
    fields.add("proved", answer.proved.as_deref());
    fields.add("some_may_move", answer.some_may_move);
    fields.add("reason", answer.reason());
    fields.note(answer.note.as_deref());
    fields
}
