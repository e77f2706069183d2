//! Rows of which each is about all arches between its ends, written as they come.
//!
//! Both columns of a quantity are there before the first row is read, and a row without ranges has one value in both:
//! so a table has one header whatever its rows ask.

use super::columns::{kept_cells, kept_names};
use super::csv::line;
use super::json;
use super::kept::Kept;
use super::record::{NOTE, Record};
use super::survey::{SCHEMA, SurveyedArches};
use super::words::labels;
use crate::arch::SelfWeight;
use crate::ask::{Field, Range};
use crate::number::BETWEEN;
use crate::problem::survey::Shape;
use crate::problem::{Mode, Quantity};
use couplet_survey::{EndValue, ModesFound, RangeEnd, SurveyAnswer};
use std::fmt::Display;
use std::io;

/// Row about all arches between its ends.
#[derive(Debug)]
pub struct SurveyedRow {
    /// Line of the query.
    pub line: u64,
    /// Values that are handed on.
    pub kept: Vec<(String, Kept)>,
    /// Answer, or the error of a row that cannot be read.
    pub found: Result<SurveyedArches, String>,
}

/// Answer about all arches of a row, in the texts of its cells: of many the rest would fill the memory.
#[derive(Clone, Debug)]
pub struct SurveyedCell {
    /// The self-weight model.
    pub weight: SelfWeight,
    /// Word for what is proved of all of them.
    pub outcome: &'static str,
    /// Reason why something stays open, if anything does.
    pub reason: Option<String>,
    /// Half opening, friction and thickness.
    given: [Option<String>; 3],
    /// Both ends of each quantity.
    ends: Vec<[Option<String>; 2]>,
    modes: Option<ModesFound>,
    /// The measure whose tolerance alone moves the geometric safety most.
    measure_first: Option<&'static str>,
    note: Option<String>,
}

/// Writer of such rows.
#[derive(Clone, Debug)]
pub struct SurveyedRows {
    /// Quantities of which the ends are told.
    pub quantities: Vec<Quantity>,
    /// True if arches may have a thickness.
    pub have_thickness: bool,
    /// True if it is told what to measure better.
    pub tells_measures: bool,
    /// Names of what is handed on, where the rows are those of one table.
    pub kept: Vec<String>,
    /// True if each row is an object of JSON, and not a line of a table.
    pub are_objects: bool,
}

impl SurveyedRow {
    /// Tells whether the row cannot be read.
    pub fn is_refused(&self) -> bool {
        self.found.is_err()
    }

    /// Tells whether not everything could be told.
    pub fn is_undecided(&self) -> bool {
        self.found.as_ref().is_ok_and(|found| found.first_open().is_some())
    }
}

impl SurveyedRows {
    /// Rows of a table with these quantities, and nothing that is handed on.
    pub fn new(quantities: Vec<Quantity>, have_thickness: bool) -> Self {
        let (tells_measures, kept, are_objects) = (false, Vec::new(), false);
        Self { quantities, have_thickness, tells_measures, kept, are_objects }
    }

    /// The header, which objects have not.
    pub fn header(&self) -> io::Result<Vec<u8>> {
        if self.are_objects {
            return Ok(Vec::new());
        }
        let own: Vec<String> = self.columns(None).names().map(str::to_owned).collect();
        line([kept_names(&self.kept, &own), own].concat())
    }

    /// A row.
    pub fn row(&self, row: &SurveyedRow) -> io::Result<Vec<u8>> {
        match self.are_objects {
            true => json::line(&self.object(row)),
            false => {
                let kept = kept_cells(&self.kept, &row.kept);
                line(kept.chain(self.columns(Some(row)).texts()))
            }
        }
    }

    /// The object of a row.
    fn object(&self, row: &SurveyedRow) -> Record {
        let mut fields = Record::of(if row.is_refused() { "couplet.refused/1" } else { SCHEMA });
        fields.add("line", row.line);
        fields.keep(&row.kept);
        match &row.found {
            Ok(found) => fields.append(found.fields()),
            Err(error) => fields.add("error", error.as_str()),
        }
        fields
    }

    /// The cells of a row; without one their names.
    fn columns(&self, row: Option<&SurveyedRow>) -> Record {
        let of = row.and_then(|row| row.found.as_ref().ok());
        let mut cells = self.answer(of.map(|of| self.cell(of)).as_ref());
        cells.add("line", row.map(|row| row.line));
        cells.add("error", row.and_then(|row| row.found.as_ref().err()).map(String::as_str));
        cells
    }

    /// The texts of an answer.
    pub fn cell(&self, of: &SurveyedArches) -> SurveyedCell {
        let ends = |quantity: &Quantity| match &of.found {
            Ok(found) => ends(found, *quantity),
            Err(_) => [OPEN, OPEN].map(|open| Some(open.to_owned())),
        };
        SurveyedCell {
            weight: of.weight,
            outcome: of.outcome()[0],
            reason: of.first_open().map(|open| open.reason.to_string()),
            given: given(of),
            ends: self.quantities.iter().map(ends).collect(),
            modes: of.found.as_ref().ok().and_then(|found| found.modes.clone()),
            measure_first: of.measure_first(),
            note: of.asked.note().map(str::to_owned),
        }
    }

    /// The cells of an answer; without one their names.
    pub(super) fn answer(&self, of: Option<&SurveyedCell>) -> Record {
        let [half_opening, friction, thickness] =
            of.map_or([None, None, None], |of| of.given.each_ref().map(Option::as_deref));
        let mut cells = Record::default();
        cells.add("weight", of.map(|of| of.weight.name()));
        cells.add("half_opening", half_opening);
        cells.add("friction", friction);
        if self.have_thickness {
            cells.add("thickness", thickness);
        }
        let is_open = |of: &SurveyedCell| if of.reason.is_some() { "undecided" } else { "proved" };
        cells.add("verdict", of.map(is_open));
        cells.add("outcome", of.map(|of| of.outcome));
        for (place, quantity) in self.quantities.iter().enumerate() {
            let ends = of.and_then(|of| of.ends.get(place));
            for (k, end) in ["lower", "upper"].into_iter().enumerate() {
                let text = ends.and_then(|ends| ends[k].as_deref());
                cells.add(format!("{}_{end}", quantity.name()), text);
            }
        }
        if self.tells_measures {
            cells.add("measure_first", of.and_then(|of| of.measure_first));
        }
        let modes = of.and_then(|of| of.modes.as_ref());
        let listed = |of: fn(&ModesFound) -> &Vec<Mode>| modes.map(|modes| labels(of(modes)));
        cells.add("modes", listed(|modes| &modes.occur));
        cells.add("other_modes", listed(|modes| &modes.may_occur));
        cells.add("some_fall", modes.and_then(|modes| modes.some_fall));
        cells.add("reason", of.and_then(|of| of.reason.as_deref()));
        cells.add(NOTE, of.and_then(|of| of.note.as_deref()));
        cells
    }
}

/// Text of an end that is not proved.
const OPEN: &str = "undecided";

/// Texts of both ends of a quantity; none where it is not told, or nothing is enough.
fn ends(found: &SurveyAnswer, quantity: Quantity) -> [Option<String>; 2] {
    let text = |end: &RangeEnd| match &end.value {
        EndValue::Number(number) => Some(number.to_string()),
        EndValue::NotEnough => None,
        EndValue::AnyIsEnough => Some("any".to_owned()),
        EndValue::Unbounded => Some("inf".to_owned()),
    };
    match found.ranges.iter().find(|range| range.of == quantity) {
        Some(range) => [&range.lower, &range.upper].map(text),
        None => [(); 2].map(|()| found.open.as_ref().map(|_| OPEN.to_owned())),
    }
}

/// Half opening, friction and thickness as they are understood: texts that can be asked again.
fn given(of: &SurveyedArches) -> [Option<String>; 3] {
    let thickness = match &of.given.shape {
        Shape::Free { thickness, .. } => thickness.as_ref().map(between),
        Shape::Spanned { .. } => of.asked.text(Field::Thickness).map(|text| {
            let range = Range::read(text).ok().flatten();
            range.map_or_else(|| text.to_owned(), |Range { lower, upper }| between(&[lower, upper]))
        }),
    };
    [Some(between(&of.given.half_opening())), Some(between(&of.given.friction)), thickness]
}

/// Text of a range, or of the one value that it has.
fn between([lower, upper]: &[impl Display; 2]) -> String {
    let [lower, upper] = [lower.to_string(), upper.to_string()];
    match lower == upper {
        true => lower,
        false => format!("{lower}{BETWEEN}{upper}"),
    }
}
