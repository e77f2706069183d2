//! Looks through a sweep that was made: its parts, its rows, and what is proved of some of them.

use super::part_file::ReadPart;
use super::queries::PartQueries;
use super::store::PartState;
use super::strategies::Draw;
use super::sweep::Sweep;
use super::table::{answered, asked, is_same};
use crate::certify::batch::{BatchArches, RowVerdict};
use crate::certify::certify_arch;
use crate::check::{Accepted, verify as check};
use crate::failure::Failure;
use crate::number::ExactNumber;
use crate::problem::{Arch, Problem};
use crate::report::{ParquetColumn, ParquetTable};
use rayon::prelude::*;
use rug::{Integer, Rational};
use std::collections::BTreeSet;
use std::fs::File;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Result of looking through a sweep, and what is wrong.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Verified {
    /// Parts that are there and whole.
    pub parts: usize,
    /// Number of rows in them.
    pub rows: u64,
    /// Rows that were proved again, and are the same bit for bit.
    pub again: usize,
    /// Rows with a certificate that the second arithmetic accepts.
    pub certified: usize,
    /// Faults that were found.
    pub faults: Vec<String>,
}

/// The most rows that are certified.
const CERTIFIED: usize = 20;
/// Digits of a certificate: a double is told by them, and nearly always on which side of it the truth is.
const DIGITS: usize = 20;

/// Looks through some parts: name, content and notes of each, its inputs, and that its rows are complete. `sample`
/// rows, drawn from the name of the sweep, are proved again without what rows share, and some of them certified.
pub fn verify(
    sweep: &Sweep,
    parts: &[usize],
    sample: usize,
    tick: &(dyn Fn(u64) + Sync),
) -> Result<Verified, Failure> {
    let files = sweep.store.files(sweep.parts())?;
    let ranges: Vec<Range<u64>> = parts.iter().map(|&part| sweep.rows(part)).collect();
    let chosen = chosen(&ranges, sample, &sweep.store.plan);
    let look = Look { sweep, chosen, certified: AtomicUsize::new(0) };
    let none = Vec::new();
    let each = |&part: &usize| {
        let rows = sweep.rows(part);
        let of = files.parts.get(&part).unwrap_or(&none);
        let found = match sweep.store.there(of, &rows, true, false)? {
            PartState::Missing => Verified::wrong(format!("part {part} is missing or spoiled")),
            PartState::Foreign(name) => Verified::wrong(format!("{name} does not belong here")),
            PartState::Whole(name, counts) => {
                let found = look.part(part, &name, counts);
                found.unwrap_or_else(|fault| Verified::wrong(format!("{name}: {fault}")))
            }
        };
        tick(rows.end - rows.start);
        Ok(found)
    };
    let each = parts.par_iter().map(each).collect::<Result<Vec<_>, Failure>>()?;
    let mut all = Verified::default();
    all.faults.extend(files.strays.iter().map(|name| format!("{name} is no part of the sweep")));
    for found in each {
        all.parts += found.parts;
        all.rows += found.rows;
        all.again += found.again;
        all.certified += found.certified;
        all.faults.extend(found.faults);
    }
    Ok(all)
}

/// A look through the parts of a sweep.
struct Look<'s> {
    sweep: &'s Sweep,
    /// Rows that are proved again.
    chosen: BTreeSet<u64>,
    /// Number of rows that were to be certified so far.
    certified: AtomicUsize,
}

impl Look<'_> {
    /// Looks through a part that is whole, by its path, whose name has these counts.
    fn part(&self, part: usize, path: &str, counts: [u64; 4]) -> Result<Verified, String> {
        let sweep = self.sweep;
        let rows = sweep.rows(part);
        let file = File::open(sweep.folder().join(path)).map_err(|error| error.to_string())?;
        let file = ReadPart::of(file).map_err(|error| error.to_string())?;
        let groups = sweep.record.groups(&rows);
        if groups.len() != file.groups() {
            return Err("it has not the row groups that the plan makes".into());
        }
        let (mut all, mut there) = (Verified { parts: 1, ..Verified::default() }, [0; 4]);
        for (place, rows) in groups.into_iter().enumerate() {
            let table = file.group(place).map_err(|error| error.to_string())?;
            let queries = sweep.queries(&rows)?;
            let asked = asked(&queries);
            for (name, column) in &asked.columns {
                let there = column_of(&table, name);
                let are_same = |cells: &ParquetColumn| {
                    (0..asked.rows).all(|row| is_same((column, row), (cells, row)))
                };
                let is_whole = |n: usize| n as u64 == rows.end - rows.start;
                if ![asked.rows, table.rows].into_iter().all(is_whole)
                    || !there.is_some_and(are_same)
                {
                    return Err(format!("its column {name} is not what the plan asks"));
                }
            }
            let Some(ParquetColumn::Text(verdicts)) = column_of(&table, "verdict") else {
                return Err("it has no verdicts".into());
            };
            for verdict in (0..table.rows).filter_map(verdicts) {
                let is = |of: &&RowVerdict| verdict.data() == of.name().as_bytes();
                if let Some(of) = RowVerdict::ALL.iter().find(is) {
                    there[*of as usize] += 1;
                }
            }
            all.rows += rows.end - rows.start;
            for &number in self.chosen.range(rows.clone()) {
                match self.row(&queries, &table, (number - rows.start) as usize) {
                    Ok(has_certificate) => {
                        all.again += 1;
                        all.certified += usize::from(has_certificate);
                    }
                    Err(fault) => all.faults.push(format!("{path}: row {number}: {fault}")),
                }
            }
        }
        match there == counts {
            true => Ok(all),
            false => Err("its rows are not counted right".into()),
        }
    }

    /// Proves a row again; whether it was certified too.
    fn row(
        &self,
        queries: &PartQueries,
        table: &ParquetTable,
        place: usize,
    ) -> Result<bool, String> {
        let Ok(arch) = queries.arch(place) else { return Ok(false) };
        let batch = &self.sweep.batch;
        let (found, quantities) = (batch.one(&arch), &batch.quantities);
        let again = answered(quantities, &found);
        for (name, column) in &again.columns {
            let there = column_of(table, name);
            if !there.is_some_and(|there| is_same((column, 0), (there, place))) {
                return Err(format!("its {name} is not what is proved"));
            }
        }
        let verdict = found.verdicts[0];
        let is_known = matches!(verdict, RowVerdict::Stands | RowVerdict::Falls);
        if !is_known || self.certified.fetch_add(1, Ordering::Relaxed) >= CERTIFIED {
            return Ok(false);
        }
        let Some(accepted) = accepted(&arch)? else { return Ok(false) };
        let is_so = match (&accepted.problem, verdict) {
            (Problem::State { mode, .. }, RowVerdict::Stands) => Some(*mode) == found.mode(0),
            (Problem::Verdict { .. }, RowVerdict::Falls) => true,
            _ => false,
        };
        if !is_so {
            return Err("its certificate is of another verdict or mode".into());
        }
        for (place, quantity) in quantities.iter().enumerate() {
            let of = accepted.values.iter().find(|(of, _)| of == quantity);
            if let (Some(double), Some((_, text))) = (found.double(place, 0), of)
                && !agrees(text, double, found.side(place, 0))
            {
                return Err(format!("its {} is not that of its certificate", quantity.name()));
            }
        }
        Ok(true)
    }
}

/// The cells of a column, if there is one of that name.
fn column_of<'t>(table: &'t ParquetTable, name: &str) -> Option<&'t ParquetColumn<'t>> {
    table.columns.iter().find(|(of, _)| of == name).map(|(_, cells)| cells)
}

impl Verified {
    fn wrong(fault: String) -> Self {
        Self { faults: vec![fault], ..Self::default() }
    }
}

/// A certificate of an arch that the second arithmetic accepts; none where none can be made.
fn accepted(arch: &Arch) -> Result<Option<Accepted>, String> {
    let Ok(certificate) = certify_arch(arch, None, DIGITS) else { return Ok(None) };
    let mut bytes = Vec::new();
    certificate.write(&mut bytes).map_err(|error| error.to_string())?;
    check(&bytes).map(Some).map_err(|refusal| format!("its certificate is refused: {refusal}"))
}

/// Tells whether a double, with the side on which the truth is, is compatible with a value that is correctly
/// rounded to [`DIGITS`] digits.
fn agrees(text: &str, double: f64, side: Option<i32>) -> bool {
    let value = text.parse::<ExactNumber>().map(|value| value.to_rational());
    let (Ok(value), Some(exact)) = (value, Rational::from_f64(double)) else { return false };
    // More than half a unit of the last digit.
    let rounding = value.clone().abs() / Integer::from(Integer::u_pow_u(10, DIGITS as u32 - 1));
    let [low, high] = [Rational::from(&value - &rounding), value + rounding];
    let nearest = |end: &Rational| ExactNumber::from(end).nearest_double();
    let is_near = nearest(&low) <= Some(double) && Some(double) <= nearest(&high);
    is_near
        && match side {
            Some(1) => high > exact,
            Some(-1) => low < exact,
            Some(_) => low <= exact && exact <= high,
            None => true,
        }
}

/// Rows of some ranges, drawn from the name of a sweep.
fn chosen(ranges: &[Range<u64>], count: usize, name: &str) -> BTreeSet<u64> {
    let all: u64 = ranges.iter().map(|rows| rows.end - rows.start).sum();
    let mut chosen = BTreeSet::new();
    let mut draw = Draw(u64::from_str_radix(&name[..16], 16).unwrap_or_default());
    while (chosen.len() as u64) < all.min(count as u64) {
        let mut place = draw.between(0, all - 1);
        for rows in ranges {
            let length = rows.end - rows.start;
            if place < length {
                chosen.insert(rows.start + place);
                break;
            }
            place -= length;
        }
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_agrees_with_its_double_and_with_no_other() {
        // 1/10 is below its nearest double.
        let (text, tenth) = ("0.10000000000000000000", 0.1f64);
        assert!(agrees(text, tenth, Some(-1)) && agrees(text, tenth, None));
        assert!(!agrees(text, tenth, Some(1)) && !agrees(text, tenth, Some(0)));
        assert!(
            !agrees(text, tenth.next_up(), Some(-1)) && !agrees(text, tenth.next_down(), Some(1))
        );
        assert!(agrees("0.50000000000000000000", 0.5, Some(0)) && !agrees("x", 0.5, None));
    }

    #[test]
    fn as_many_rows_are_drawn_as_are_asked_and_there_are() {
        let ranges = [0..10, 20..25];
        let name = "0123456789abcdef";
        let drawn = chosen(&ranges, 7, name);
        assert_eq!((drawn.len(), &drawn), (7, &chosen(&ranges, 7, name)));
        assert!(drawn.iter().all(|row| ranges.iter().any(|rows| rows.contains(row))));
        assert_eq!(chosen(&ranges, 100, name).len(), 15);
        assert_eq!(chosen(&[], 5, name).len(), 0);
    }
}
