//! A range cut into boxes, each a survey, and how many of them stand: `couplet.cells/2`.

use super::record::Record;
use super::reported::Reported;
use super::survey::MEANING;
use super::surveyed_rows::{SurveyedCell, SurveyedRows};
use super::tabular::Tabular;
use super::understood::Understood;
use super::words::{aligned, count, list};
use crate::arch::SelfWeight;
use crate::ask::Field;
use std::sync::Arc;

/// Boxes of one self-weight, each with what is proved of every arch inside.
#[derive(Debug)]
pub struct SurveyedCells {
    /// Question about all of them, as it is understood.
    pub asked: Understood,
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Fields that are cut, with the numbers of parts.
    pub cut: Vec<(Field, usize)>,
    /// The boxes, one field after the other, the last one fastest.
    pub cells: Vec<Arc<SurveyedCell>>,
    /// Columns of a table of them.
    pub rows: SurveyedRows,
}

/// Answers that a box has, in words, of arches with and without a thickness.
const WITH_THICKNESS: [[&str; 2]; 4] = [
    ["all_stand", "every arch stands"],
    ["none_stands", "no arch stands"],
    ["both_occur", "some stand, others do not"],
    ["undecided", "undecided"],
];
const WITHOUT: [[&str; 2]; 4] = [
    ["all_can_stand", "every arch can stand at some thickness"],
    ["none_can_stand", "no arch can stand, however thick"],
    ["both_occur", "some can stand, others cannot"],
    ["undecided", "undecided"],
];

impl SurveyedCells {
    fn outcomes(&self) -> [[&'static str; 2]; 4] {
        if self.rows.have_thickness { WITH_THICKNESS } else { WITHOUT }
    }

    /// Numbers of boxes with each of the outcomes.
    fn counts(&self) -> [usize; 4] {
        let of =
            |[name, _]: [&str; 2]| self.cells.iter().filter(|cell| cell.outcome == name).count();
        self.outcomes().map(of)
    }

    fn say(&self, record: &mut Record) {
        record.say(format!("Every arch of {}\n", self.asked.with_weight(self.weight)));
        let cut: Vec<String> = self
            .cut
            .iter()
            .map(|(field, parts)| format!("{} in {parts}", field.name().replace('_', " ")))
            .collect();
        let boxes = count(self.cells.len(), "box", "boxes");
        record.say(format!("{boxes}: {}", list(cut.iter().map(String::as_str))));
        record.say(MEANING);
        record.say("");
        let row =
            |([_, words], boxes): ([&str; 2], usize)| vec![words.to_owned(), boxes.to_string()];
        let rows: Vec<Vec<String>> =
            self.outcomes().into_iter().zip(self.counts()).map(row).collect();
        record.say_all(aligned(&rows).map(|line| format!("   {line}")));
        record.say("   A box is decided by a proof about every arch inside, its borders too.");
    }
}

impl Reported for SurveyedCells {
    fn records(&self) -> Vec<Record> {
        let mut record = Record::of("couplet.cells/2");
        self.say(&mut record);
        self.asked.add_to(&mut record);
        record.add("meaning", MEANING);
        record.add("weight", self.weight.name());
        let mut cut = Record::default();
        self.cut.iter().for_each(|(field, parts)| cut.add(field.name(), *parts));
        record.add_record("cut", Some(cut));
        record.add("boxes", self.cells.len());
        let outcome = |([name, _], boxes): ([&'static str; 2], usize)| {
            let mut outcome = Record::default();
            outcome.add("outcome", name);
            outcome.add("boxes", boxes);
            outcome
        };
        record.add_list("outcomes", self.outcomes().into_iter().zip(self.counts()).map(outcome));
        record.add_list("cells", self.cells.iter().map(|cell| self.rows.answer(Some(cell))));
        vec![record]
    }

    fn tabular(&self) -> Tabular {
        Tabular::of_all(self.cells.iter().map(|cell| self.rows.answer(Some(cell))))
    }
}
