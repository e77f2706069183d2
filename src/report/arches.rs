//! Many arches with the values that were asked for: the same as one by one, without the rest.

use super::csv::{
    ASSESS_COLUMNS, ASSESS_VALUES, STATE_COLUMNS, STATE_VALUES, assess_record, state_record,
    state_values,
};
use super::json::{AssessEntry, StateEntry};
use super::{AssessReport, Format, StateReport, hexadecimal};
use serde::Serialize;
use std::io;

/// What was found of many arches.
#[derive(Debug)]
pub struct Arches<'a> {
    /// Significant digits of each value.
    pub digits: usize,
    /// The values that are asked for, of [`STATE_VALUES`] or [`ASSESS_VALUES`].
    pub quantities: Vec<&'static str>,
    /// The arches, all of one kind.
    pub entries: ArchEntries<'a>,
}

/// The arches in the order in which they were asked about.
#[derive(Debug)]
pub enum ArchEntries<'a> {
    /// At their least thickness.
    States(Vec<StateReport<'a>>),
    /// With a given thickness.
    Assessments(Vec<AssessReport<'a>>),
}

impl Arches<'_> {
    /// Writes the report.
    pub fn write(&self, format: Format, out: &mut dyn io::Write) -> io::Result<()> {
        match format {
            Format::Table => self.table(out),
            Format::Json => self.json(out),
            Format::Csv => self.csv(out),
        }
    }

    /// The columns without the values that are not asked for, and the rows.
    fn rows(&self) -> (Vec<String>, Vec<Vec<String>>) {
        let (columns, records): (&[&str], Vec<Vec<String>>) = match &self.entries {
            ArchEntries::States(states) => {
                (&STATE_COLUMNS, states.iter().map(state_record).collect())
            }
            ArchEntries::Assessments(all) => {
                (&ASSESS_COLUMNS, all.iter().map(assess_record).collect())
            }
        };
        let asked = |column: &str| match column {
            "limited_by" => self.asks("least_thrust") || self.asks("largest_thrust"),
            _ => !is_value(column) || self.asks(column),
        };
        let kept: Vec<usize> = (0..columns.len()).filter(|&k| asked(columns[k])).collect();
        let header = kept.iter().map(|&k| columns[k].to_owned()).collect();
        let row = |record: Vec<String>| kept.iter().map(|&k| record[k].clone()).collect();
        (header, records.into_iter().map(row).collect())
    }

    fn asks(&self, quantity: &str) -> bool {
        self.quantities.contains(&quantity)
    }

    fn csv(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let (mut header, mut rows) = self.rows();
        if let ArchEntries::States(states) = &self.entries
            && states.iter().any(|state| state.doubles)
        {
            let asked: Vec<usize> =
                (0..STATE_VALUES.len()).filter(|&k| self.asks(STATE_VALUES[k])).collect();
            header.extend(asked.iter().flat_map(|&k| {
                [format!("{}_double", STATE_VALUES[k]), format!("{}_hex", STATE_VALUES[k])]
            }));
            for (row, state) in rows.iter_mut().zip(states) {
                let values = state_values(state);
                row.extend(asked.iter().flat_map(|&k| match values[k] {
                    Some(figure) => [format!("{:?}", figure.double), hexadecimal(figure.double)],
                    None => [const { String::new() }; 2],
                }));
            }
        }
        let mut csv = ::csv::Writer::from_writer(out);
        csv.write_record(&header).map_err(super::csv::io_error)?;
        for row in &rows {
            csv.write_record(row).map_err(super::csv::io_error)?;
        }
        csv.flush()
    }

    fn table(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let (header, rows) = self.rows();
        let plural = if self.digits == 1 { "" } else { "s" };
        let what = match self.entries {
            ArchEntries::States(_) => "Arches at their least thickness",
            ArchEntries::Assessments(_) => "Arches of given thickness",
        };
        writeln!(out, "{what}, correctly rounded to {} significant digit{plural}\n", self.digits)?;
        let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
        // A column without a value in any row says nothing.
        let columns: Vec<(usize, usize)> = (0..header.len())
            .filter(|&k| width(k) > 0)
            .map(|k| (k, width(k).max(header[k].len())))
            .collect();
        for row in std::iter::once(&header).chain(&rows) {
            let cells: Vec<String> =
                columns.iter().map(|&(k, width)| format!("{:<width$}", row[k])).collect();
            writeln!(out, "{}", cells.join("  ").trim_end())?;
        }
        Ok(())
    }

    fn json(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let quantities = &self.quantities;
        match &self.entries {
            ArchEntries::States(states) => self
                .json_of(states.iter().map(|state| StateEntry::new(state).only(quantities)), out),
            ArchEntries::Assessments(all) => {
                self.json_of(all.iter().map(|one| AssessEntry::new(one).only(quantities)), out)
            }
        }
    }

    fn json_of<T: Serialize>(
        &self,
        arches: impl Iterator<Item = T>,
        out: &mut dyn io::Write,
    ) -> io::Result<()> {
        let file = ArchesFile {
            schema: "couplet.arches/1",
            digits: self.digits,
            quantities: &self.quantities,
            arches: arches.collect(),
        };
        serde_json::to_writer_pretty(&mut *out, &file)?;
        writeln!(out)
    }
}

fn is_value(column: &str) -> bool {
    STATE_VALUES.contains(&column) || ASSESS_VALUES.contains(&column)
}

/// `couplet.arches/1`: what is not among the quantities is null.
#[derive(Serialize)]
struct ArchesFile<'a, T> {
    schema: &'static str,
    digits: usize,
    quantities: &'a [&'static str],
    arches: Vec<T>,
}
