//! The rows of a table: doubles or exact texts in each column, read as `couplet states` reads those of a file.

use crate::asked::wrong;
use crate::pool::{is_short, on_threads};
use bytemuck::{cast_slice, pod_collect_to_vec};
use couplet::arch::SelfWeight;
use couplet::ask::{Field, array_note, notes};
use couplet::certify::Refused;
use couplet::certify::batch::{
    Batch, BatchArches, BatchColumns, DoubleArches, DoubleUnits, InLanes, SharedOpening, Threads,
    grouped,
};
use couplet::number::ExactNumber;
use couplet::problem::{Arch, Friction, Quantity};
use couplet::sweep::rows::{ArchReader, Cells, Columns, NumberStyle, Purpose, Role, RowColumn};
use couplet::sweep::{parse, rows};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use std::borrow::Cow;

/// With so many digits a decimal number tells the double.
const DIGITS: usize = 17;

/// The cells of a column: doubles, as the bytes of an array, or texts.
#[derive(Clone, FromPyObject)]
pub(crate) enum Column {
    Doubles(#[pyo3(from_py_with = of_bytes)] Vec<f64>),
    Texts(Vec<String>),
}

fn of_bytes(bytes: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    Ok(pod_collect_to_vec(&bytes.extract::<PyBackedBytes>()?))
}

/// The bytes of an array.
type Bytes<'py> = Bound<'py, PyBytes>;

/// Verdicts and modes, for each quantity the nearest doubles with their bounds, as bytes of arrays; and the reasons of
/// the rows without a verdict.
type Answered<'py> = (Bytes<'py>, Bytes<'py>, Vec<Vec<Bytes<'py>>>, Vec<(usize, String)>);

/// The quantities of these names, of those that arches with or without a thickness have.
fn quantities(names: &[String], has_thickness: bool) -> PyResult<Vec<Quantity>> {
    let possible =
        if has_thickness { &Quantity::ASSESSMENT_ROW[..] } else { &Quantity::STATE_ROW[..] };
    let named = |name: &String| parse::quantity_of(name, possible).map_err(wrong);
    names.iter().map(named).collect()
}

/// The arches of the rows of a table, whose columns are named as for `couplet states`, `theirs=ours:deg`; behind a note
/// on what may have been meant otherwise, of which whoever asks in pieces warns once.
#[pyfunction]
pub(crate) fn table<'py>(
    py: Python<'py>,
    weight: &str,
    columns: Vec<String>,
    cells: Vec<Column>,
    names: Vec<String>,
    threads: usize,
) -> PyResult<(Option<String>, Answered<'py>)> {
    let weight = parse::weight(weight).map_err(wrong)?;
    let columns = Columns::named(&columns, Purpose::Ask).map_err(wrong)?;
    let quantities = quantities(&names, columns.has(Field::Thickness))?;
    let is_short = is_short(cells.first().map_or(0, Column::len), &quantities);
    let table = Table { columns, cells, weight };
    let (note, answer) = (table.note(), move || table.answers(&quantities));
    let found = if is_short { py.detach(answer) } else { on_threads(py, threads, answer)? };
    let found = found.map_err(wrong)?;
    let bytes = |column: &Vec<f64>| PyBytes::new(py, cast_slice(column));
    let values = found.values.iter().map(|columns| columns.iter().map(bytes).collect()).collect();
    let [verdicts, modes] =
        [found.verdict_codes(), found.modes].map(|codes| PyBytes::new(py, &codes));
    Ok((note, (verdicts, modes, values, found.reasons.into_iter().collect())))
}

/// Why a column asks what no row of a table is asked; nothing of other names.
#[pyfunction]
pub(crate) fn unanswered(name: &str) -> Option<String> {
    let read = [Field::HalfOpening, Field::Friction, Field::FrictionAngle, Field::Thickness];
    rows::unanswered(name, |field| read.contains(&field) || field == Field::MeasuredAt)
}

/// A table with its columns.
struct Table {
    columns: Columns,
    cells: Vec<Column>,
    /// The weight of the rows that have none.
    weight: SelfWeight,
}

impl Table {
    /// Answers with the quantities.
    fn answers(&self, quantities: &[Quantity]) -> Result<BatchColumns, Refused> {
        let weights = self.columns.all.iter().position(|column| column.role == Role::Weight);
        let Some(place) = weights.filter(|_| self.arrays(Role::Weight).is_some()) else {
            return self.of_one_weight(quantities);
        };
        // Rows of doubles are answered as arrays of doubles, one weight after the other; a row of none says why.
        let weight = |row| match self.cells[place].text(row) {
            text if text.is_empty() => Some(self.weight),
            text => parse::weight(&text).ok(),
        };
        let rows: Vec<usize> = (0..self.cells[place].len()).collect();
        let mut all = BatchColumns::open(rows.len(), quantities.len());
        for rows in grouped(&rows, |row| Some(weight(row))) {
            let known = rows.first().and_then(|row| weight(*row));
            let mut part = Self {
                columns: self.columns.clone(),
                cells: self.cells.iter().map(|cells| cells.of(&rows)).collect(),
                weight: known.unwrap_or(self.weight),
            };
            if known.is_some() {
                part.columns.all.remove(place);
                part.cells.remove(place);
            }
            all.put_all(&rows, part.of_one_weight(quantities)?);
        }
        Ok(all)
    }

    /// The same of a table without weights, or with exact cells; those of doubles as arrays of doubles are answered.
    fn of_one_weight(&self, quantities: &[Quantity]) -> Result<BatchColumns, Refused> {
        match self.arrays(Role::Given(Field::HalfOpening)) {
            Some(arches) => arches.columns(quantities),
            None => Ok(self.exact().answers(quantities)),
        }
    }

    /// What may have been meant otherwise of its frictions.
    fn note(&self) -> Option<String> {
        let friction = Role::Given(Field::Friction);
        let is_coefficient = |of: &RowColumn| of.role == friction && of.unit.is_empty();
        let place = self.columns.all.iter().position(is_coefficient)?;
        match &self.cells[place] {
            Column::Doubles(numbers) => array_note(numbers).map(str::to_owned),
            Column::Texts(texts) => {
                let frictions = texts.iter().filter_map(|text| text.trim().parse().ok());
                notes(&frictions.collect::<Vec<Friction>>()).into_iter().next()
            }
        }
    }

    /// The arches of a table of doubles; none if it has anything else, but for a column of the role `beside`.
    fn arrays(&self, beside: Role) -> Option<DoubleArches<'_>> {
        let (mut half_openings, mut frictions, mut thicknesses) = (None, None, None);
        let mut units = DoubleUnits::default();
        for (column, cells) in self.columns.all.iter().zip(&self.cells) {
            if !["", "rad", "deg"].contains(&column.unit) {
                return None;
            }
            let array = match column.role {
                Role::Given(Field::HalfOpening) => {
                    units.has_degrees = column.unit == "deg";
                    &mut half_openings
                }
                Role::Given(field @ (Field::Friction | Field::FrictionAngle)) => {
                    let is_angle = field == Field::FrictionAngle || column.unit == "deg";
                    units.friction_angles = is_angle.then_some(column.unit == "deg");
                    &mut frictions
                }
                Role::Given(Field::Thickness) => &mut thicknesses,
                role if role == beside => continue,
                _ => return None,
            };
            let Column::Doubles(numbers) = cells else { return None };
            *array = Some(numbers.as_slice());
        }
        let (half_openings, frictions) = (half_openings?, frictions?);
        Some(DoubleArches { weight: self.weight, half_openings, frictions, thicknesses, units })
    }

    /// The arches as numbers that are exactly what the cells say.
    fn exact(&self) -> ExactArches {
        let (columns, spelling) = (self.columns.clone(), NumberStyle::default());
        let reader = ArchReader { columns, weight: self.weight, doubles: false, spelling };
        let row = |row: &usize| {
            let cells: Cells = self.cells.iter().map(|cells| Some(cells.text(*row))).collect();
            reader.arch(&cells).map(|(arch, thickness, _)| (arch, thickness))
        };
        let rows: Vec<usize> = (0..self.cells.iter().map(Column::len).min().unwrap_or(0)).collect();
        let arches = Threads::Pool.each(&rows, row);
        ExactArches { arches, has_thickness: self.columns.has(Field::Thickness) }
    }
}

impl Column {
    fn len(&self) -> usize {
        match self {
            Self::Doubles(numbers) => numbers.len(),
            Self::Texts(texts) => texts.len(),
        }
    }

    /// The cells of some rows.
    fn of(&self, rows: &[usize]) -> Self {
        match self {
            Self::Doubles(numbers) => Self::Doubles(rows.iter().map(|row| numbers[*row]).collect()),
            Self::Texts(texts) => Self::Texts(rows.iter().map(|row| texts[*row].clone()).collect()),
        }
    }

    /// The text of a row; that of a double is the fraction that it is.
    fn text(&self, row: usize) -> String {
        match self {
            Self::Doubles(numbers) => {
                let x = numbers[row];
                ExactNumber::try_from(x).map_or_else(|_| x.to_string(), |x| x.to_string())
            }
            Self::Texts(texts) => texts[row].trim().to_owned(),
        }
    }
}

/// An arch with the thickness that it has, if it has one; or why it cannot be read.
type ExactArch = Result<(Arch, Option<ExactNumber>), String>;

/// Arches that are exactly what the cells of their rows say.
struct ExactArches {
    arches: Vec<ExactArch>,
    /// True if each shall have a thickness.
    has_thickness: bool,
}

impl ExactArches {
    fn answers(&self, quantities: &[Quantity]) -> BatchColumns {
        let batch = Batch { quantities: quantities.to_vec(), digits: DIGITS, has_texts: false };
        batch.columns(self, Threads::Pool)
    }
}

impl BatchArches for ExactArches {
    fn count(&self) -> usize {
        self.arches.len()
    }

    fn openings(&self, rows: &[usize]) -> Vec<Vec<usize>> {
        grouped(rows, |row| {
            let (arch, _) = self.arches[row].as_ref().ok()?;
            Some((arch.weight(), arch.half_opening().clone()))
        })
    }

    fn in_lanes(&self, row: usize) -> Option<(SelfWeight, InLanes)> {
        let (arch, eta) = self.arches[row].as_ref().ok()?;
        // A row that shall have a thickness and has none is refused.
        let eta = eta.as_ref().map(SharedOpening::enclosed_number);
        (eta.is_some() == self.has_thickness)
            .then(|| (arch.weight(), (SharedOpening::enclosed_arch(arch), eta)))
    }

    fn have_thicknesses(&self) -> bool {
        self.has_thickness
    }

    fn thickness(&self, row: usize) -> Result<ExactNumber, String> {
        let (_, eta) = self.arches[row].as_ref().map_err(Clone::clone)?;
        eta.clone().ok_or_else(|| "the thickness is empty".to_owned())
    }

    fn arch(&self, row: usize) -> Result<Cow<'_, Arch>, String> {
        self.arches[row].as_ref().map(|(arch, _)| Cow::Borrowed(arch)).map_err(Clone::clone)
    }
}
