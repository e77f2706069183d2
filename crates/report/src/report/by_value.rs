//! States by another quantity than the half opening: for a person, a shell, CSV, and JSON (`couplet.states_of/1`).

use super::fields::Fields;
use super::words::{apart, model, reason};
use super::{csv, json};
use crate::arch::SelfWeight;
use crate::certify::Undecided;
use crate::certify::state::Figure;
use crate::certify::state::find::{OtherState, StateOfValue, StatesByValue, StatesOfValue};
use crate::problem::Quantity;
use std::io;

/// A question for the states with a value, and what is proved.
#[derive(Debug)]
pub struct ByValue {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// The question.
    pub asked: StatesByValue,
    /// Quantities that are shown.
    pub quantities: Vec<Quantity>,
    /// Result that is proved.
    pub found: Result<StatesOfValue, Undecided>,
}

impl ByValue {
    /// Reason why something stays open, if anything does.
    pub fn first_open(&self) -> Option<&Undecided> {
        self.found.as_ref().map_or_else(Some, StatesOfValue::first_open)
    }

    fn states(&self) -> impl Iterator<Item = &StateOfValue> {
        self.found.iter().flat_map(|found| &found.states).flatten()
    }

    fn others(&self) -> impl Iterator<Item = &OtherState> {
        self.found.iter().flat_map(|found| &found.others).flatten()
    }

    /// Reasons why something stays open.
    fn open(&self) -> Vec<&Undecided> {
        match &self.found {
            Err(undecided) => vec![undecided],
            Ok(found) => {
                let states = found.states.iter().filter_map(|of| of.as_ref().err());
                states.chain(found.others.iter().filter_map(|of| of.as_ref().err())).collect()
            }
        }
    }

    /// Reason why there is no state; not where anything stays open.
    fn none(&self) -> Option<&'static str> {
        self.found.as_ref().ok()?.none
    }

    /// Quantities of a state that are shown.
    fn shown<'a>(
        &'a self,
        state: &'a StateOfValue,
    ) -> impl Iterator<Item = &'a (Quantity, Figure)> {
        state.values.iter().filter(|(of, _)| self.quantities.contains(of))
    }
}

pub(super) fn table(all: &[ByValue], out: &mut dyn io::Write) -> io::Result<()> {
    apart(all, out, one)
}

fn one(of: &ByValue, out: &mut dyn io::Write) -> io::Result<()> {
    let ((quantity, value), friction) = (of.asked.given(), of.asked.friction());
    let (name, weight) = (quantity.name(), model(of.weight));
    writeln!(out, "All states with {name} = {value} at friction {friction}, {weight}\n")?;
    if let Some(none) = of.none() {
        writeln!(out, "there is none, proved: {none}\n")?;
    }
    for state in of.states() {
        writeln!(out, "collapses as {}", state.mode.label())?;
        for (quantity, figure) in of.shown(state) {
            writeln!(out, "   {:<20} {:<18} {figure}", quantity.name(), quantity.symbol())?;
        }
        writeln!(out)?;
    }
    for other in of.others() {
        let alpha = &other.half_opening;
        let what = match other.mode {
            Ok(mode) => format!("collapses as {mode}"),
            Err(fall) => format!("stands at no thickness ({})", reason(fall)),
        };
        let words = "has this value with unlimited friction; with the friction given it";
        writeln!(out, "the half opening {alpha} {words} {what}\n")?;
    }
    of.open().into_iter().try_for_each(|undecided| writeln!(out, "{undecided}"))?;
    match &of.found {
        Ok(found) if found.first_open().is_none() => {
            let proved = "each state is admissible on the whole half arch, none thinner; there are no others:";
            writeln!(out, "proved: {proved}\n   {}", found.proved)
        }
        _ => Ok(()),
    }
}

pub(super) fn plain(all: &[ByValue], out: &mut dyn io::Write) -> io::Result<()> {
    let states = all.iter().flat_map(|of| of.states().map(move |state| (of, state)));
    let mut values = states.flat_map(|(of, state)| of.shown(state));
    values.try_for_each(|(_, figure)| writeln!(out, "{figure}"))
}

const COLUMNS: &str = "weight friction outcome mode half_opening half_opening_degrees A thickness thrust \
                       intrinsic_thrust rotation_joint sliding_joint reason";

pub(super) fn csv(all: &[ByValue], out: &mut dyn io::Write) -> io::Result<()> {
    let rows = |of: &ByValue| {
        let mut rows: Vec<Fields> = Vec::new();
        let row = |outcome: &str| {
            let mut row = Fields::named("outcome", [outcome.into()]);
            row.add("weight", of.weight.name());
            row.add("friction", of.asked.friction().to_string());
            row
        };
        for state in of.states() {
            let mut row = row("state");
            row.append(of_state(of, state));
            rows.push(row);
        }
        for other in of.others() {
            let mut row = row("not_with_this_friction");
            row.append(of_other(other));
            rows.push(row);
        }
        for undecided in of.open() {
            let mut row = row("undecided");
            row.add("reason", undecided.reason.to_string());
            rows.push(row);
        }
        if let Some(none) = of.none() {
            let mut row = row("none");
            row.add("reason", none);
            rows.push(row);
        }
        rows
    };
    csv::table(COLUMNS, all.iter().flat_map(rows), out)
}

pub(super) fn json(all: &[ByValue], out: &mut dyn io::Write) -> io::Result<()> {
    json::write_all(all.iter().map(fields), out)
}

fn fields(of: &ByValue) -> Fields {
    let mut fields = Fields::of("couplet.states_of/1");
    let (quantity, value) = of.asked.given();
    fields.add("weight", of.weight.name());
    fields.add("given", quantity.name());
    fields.add("value", value.to_string());
    fields.add("friction", of.asked.friction().to_string());
    let open = of.first_open();
    fields.add("verdict", if open.is_some() { "undecided" } else { "proved" });
    fields.add("reason", open.map(|open| open.reason.as_ref()).or(of.none()));
    fields.add_list("states", of.states().map(|state| of_state(of, state)));
    fields.add_list("others", of.others().map(of_other));
    fields.add("proved", of.found.as_ref().ok().filter(|_| open.is_none()).map(|of| of.proved));
    fields
}

fn of_state(of: &ByValue, state: &StateOfValue) -> Fields {
    let mut fields = Fields::default();
    fields.add("mode", state.mode.label());
    for (quantity, figure) in of.shown(state) {
        fields.add_bounds(quantity.name(), Some(figure));
    }
    fields
}

fn of_other(other: &OtherState) -> Fields {
    let mut fields = Fields::default();
    fields.add_bounds("half_opening", Some(&other.half_opening));
    fields.add("mode", other.mode.ok().map(|mode| mode.label()));
    fields.add("reason", other.mode.err().map(reason));
    fields
}
