//! States by another quantity than the half opening, `couplet.states_of/1`.

use super::format::Content;
use super::record::Record;
use super::reported::Reported;
use super::tabular::Tabular;
use super::understood::joined;
use super::words::{model, reason};
use crate::arch::SelfWeight;
use crate::ask::notes;
use crate::certify::Undecided;
use crate::certify::state::find::{OtherState, StateOfValue, StatesByValue, StatesOfValue};
use crate::problem::Quantity;

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
        Some(self.found.as_ref().ok()?.none?.reason())
    }

    /// A state, with the quantities that are shown.
    fn state(&self, state: &StateOfValue) -> Record {
        let mut record = Record::default();
        record.say(format!("collapses as {}", state.mode.label()));
        record.add("mode", state.mode.label());
        for (quantity, figure) in state.values.iter().filter(|(of, _)| self.quantities.contains(of))
        {
            record.show(*quantity, 18, &figure.decimal);
        }
        record.say("");
        record
    }

    /// A row of the table.
    fn row(&self, outcome: &'static str, record: Record) -> Record {
        let mut row = Record::named("outcome", [outcome.into()]);
        row.add("weight", self.weight.name());
        row.add("friction", self.asked.friction().to_string());
        row.append(record);
        row.note(self.note().as_deref());
        row
    }

    /// Note on what may have been meant otherwise.
    fn note(&self) -> Option<String> {
        joined(notes([self.asked.friction()]))
    }
}

fn other(of: &OtherState) -> Record {
    let mut record = Record::default();
    let words = "has this value with unlimited friction; with the friction given it";
    let what = match of.mode {
        Ok(mode) => format!("collapses as {mode}"),
        Err(fall) => format!("stands at no thickness ({})", reason(fall)),
    };
    record.say(format!("the half opening {} {words} {what}\n", of.half_opening));
    record.add_bounds("half_opening", Some(&of.half_opening));
    record.add("mode", of.mode.ok().map(|mode| mode.label()));
    record.add("reason", of.mode.err().map(reason));
    record
}

impl Reported for ByValue {
    fn content() -> Content {
        Content(&["table", "plain", "json", "csv", "csv2", "latex", "markdown"])
    }

    fn records(&self) -> Vec<Record> {
        let mut record = Record::of("couplet.states_of/1");
        let ((quantity, value), friction) = (self.asked.given(), self.asked.friction());
        let (name, weight) = (quantity.name(), model(self.weight));
        record.say(format!("All states with {name} = {value} at friction {friction}, {weight}\n"));
        record.add("weight", self.weight.name());
        record.add("given", name);
        record.add("value", value.to_string());
        record.add("friction", friction.to_string());
        if let Some(none) = self.none() {
            record.say(format!("there is none, proved: {none}\n"));
        }
        record.note(self.note().as_deref());
        let open = self.first_open();
        record.add("verdict", if open.is_some() { "undecided" } else { "proved" });
        record.add("reason", open.map(|open| open.reason.as_ref()).or(self.none()));
        record.add_list("states", self.states().map(|state| self.state(state)));
        record.add_list("others", self.others().map(other));
        record.say_all(self.open().into_iter().map(ToString::to_string));
        let proved = self.found.as_ref().ok().filter(|_| open.is_none()).map(|of| of.proved);
        if let Some(proved) = proved.filter(|_| self.none().is_none()) {
            record.say("proved: each state is admissible on the whole half arch, none thinner; there are no others:");
            record.say(format!("   {proved}"));
        }
        record.add("proved", proved);
        vec![record]
    }

    fn tabular(&self) -> Tabular {
        let states = self.states().map(|state| self.row("state", self.state(state)));
        let others = self.others().map(|of| self.row("not_with_this_friction", other(of)));
        let because =
            |outcome, reason: String| self.row(outcome, Record::named("reason", [reason.into()]));
        let open = self.open().into_iter().map(|of| because("undecided", of.reason.to_string()));
        let none = self.none().map(|reason| because("none", reason.to_owned()));
        let columns = "weight friction outcome mode half_opening half_opening_degrees A thickness thrust \
                       intrinsic_thrust rotation_joint sliding_joint reason";
        Tabular::of(columns, states.chain(others).chain(open).chain(none))
    }
}
