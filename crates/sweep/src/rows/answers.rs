//! Answers to rows, each of which is about one arch.

use super::arch::{ArchReader, RowArch};
use super::keep::ReadRow;
use super::source::Numbered;
use crate::answer;
use crate::certify::Refused;
use crate::certify::batch::{SharedOpening, SharedOpenings};
use crate::certify::state::{Answer as Outcome, Balls, RowAnswer, Tier, Wanted, answers_in_lanes};
use crate::problem::Quantity;
use crate::report::{Answer, Answers, Beside, Extent, Format};
use rayon::prelude::*;

/// Rows that are proved at a time.
const PIECE: usize = 128;

/// Question that is asked of every row of a file.
pub struct RowQuestion {
    digits: usize,
    quantities: Vec<Quantity>,
    frictions: bool,
    /// True if what would be enough for an arch that falls is shown.
    remedies: bool,
    /// True if given values are shown as doubles.
    doubles: bool,
    /// Proofs that arches share; none where each row is what it is alone, down to the error of each double.
    openings: Option<SharedOpenings>,
}

impl RowQuestion {
    /// Question to whose answers a format is given.
    pub fn new(answers: &Answers, format: &Format, beside: Beside) -> Result<Self, Refused> {
        let (digits, quantities) = (answers.digits, answers.quantities.clone());
        let frictions = quantities.iter().any(|quantity| quantity.is_friction());
        let remedies = frictions && format.name == "jsonl";
        let openings = SharedOpenings::new(Balls::DoubleDoubles, digits, frictions)?;
        let openings = (!format.has_errors).then_some(openings);
        let doubles = format.name != "csv" || beside.doubles;
        Ok(Self { digits, quantities, frictions, remedies, doubles, openings })
    }

    /// The answers to some rows, in their order, on all cores. A row is asked what it asks: about its thickness if it
    /// has one.
    pub fn answers(&self, reader: &ArchReader, rows: Vec<Numbered<ReadRow>>) -> Vec<Answer> {
        let read =
            |(_, row): &Numbered<ReadRow>| reader.arch(&row.as_ref().map_err(Clone::clone)?.cells);
        let all: Vec<Result<RowArch, String>> = rows.par_iter().map(read).collect();
        let known: Vec<Option<RowAnswer>> = match Tier::Lanes.has(self.digits) {
            true => all.par_chunks(PIECE).flat_map_iter(|all| self.known(all)).collect(),
            false => vec![None; all.len()],
        };
        let answer = |(((line, row), asked), known): ((Numbered<ReadRow>, _), _)| {
            let answer = match asked {
                Ok(asked) => self.answer(line, &asked, known),
                Err(error) => Answer::refused(line, error),
            };
            let kept = row.map_or_else(|_| Vec::new(), |row| row.kept);
            Answer { kept, ..answer.only(&self.quantities) }
        };
        rows.into_par_iter().zip(all).zip(known).map(answer).collect()
    }

    /// Answers to some rows, where they are proved together.
    fn known(&self, all: &[Result<RowArch, String>]) -> Vec<Option<RowAnswer>> {
        let row = |asked: &Result<RowArch, String>| {
            let (arch, eta, _) = asked.as_ref().ok()?;
            let eta = eta.as_ref().map(SharedOpening::enclosed_number);
            Some((arch.weight(), (SharedOpening::enclosed_arch(arch), eta)))
        };
        answers_in_lanes(all.iter().map(row), self.digits, &self.quantities, self.remedies)
    }

    /// The answer to a row, of which something may be known.
    fn answer(
        &self,
        line: u64,
        (arch, eta, measures): &RowArch,
        known: Option<RowAnswer>,
    ) -> Answer {
        let (digits, frictions) = (self.digits, self.frictions);
        let sizes = measures.as_ref().map(|of| (of, digits));
        let extent = Extent { quantities: Some(&self.quantities[..]), doubles: self.doubles };
        if let Some(eta) = eta {
            let found = match known {
                Some(RowAnswer::Assessment(found)) => Ok(*found),
                _ => Balls::DoubleDoubles.assess(arch, eta, digits, Wanted::of(&self.quantities)),
            };
            return answer::assessment(extent, line, (arch, eta, sizes), digits, &found);
        }
        let shown = |found: Outcome| found.map(|state| state.only(|of| extent.shows(of)));
        let found = match (known, &self.openings) {
            (Some(RowAnswer::State(found)), _) => Ok(found),
            (_, Some(openings)) => openings.state(arch).map(shown),
            (_, None) => Balls::DoubleDoubles.state(arch, digits, frictions).map(shown),
        };
        answer::state_to(extent, line, (arch, sizes), digits, found)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Columns, NumberStyle, Purpose, Role};
    use super::*;
    use crate::arch::SelfWeight;
    use crate::ask::Field;
    use crate::report::{Content, open_rows};

    fn reader() -> ArchReader {
        let mut columns = Columns::own(Purpose::Ask);
        columns.places(&["weight", "alpha", "mu", "eta"].map(str::to_owned)).unwrap();
        let (weight, spelling) = (SelfWeight::Heyman, NumberStyle::default());
        ArchReader { columns, weight, doubles: false, spelling }
    }

    /// Arches of every mode, some of which fall, slide by a hair, make no sense or have a thickness.
    fn rows() -> Vec<Numbered<ReadRow>> {
        let columns = reader().columns.all;
        let part = |k: u32, step: f64| (f64::from(k) * step).fract();
        let row = |k: u32| {
            let (x, y) = (part(k, 0.754_877_666), part(k, 0.569_840_291));
            let (alpha, mu) = match k % 7 {
                0 => (format!("{}deg", 2 * k % 170), "tan(40deg)".to_owned()),
                1 => (format!("{}", 2.4 + 0.4 * x), format!("{}", 1.0 + 3.0 * y)),
                2 => (format!("{}", 2.6 * x), "inf".to_owned()),
                3 => ("80deg".to_owned(), format!("0.2193941786949380{}", k % 10)),
                _ => (format!("{}", 2.8 * x), format!("{}", 2.0 * y - 0.05)),
            };
            let eta = ["", "0.1", "", "0.9", "1.999", ""][k as usize % 6];
            // In the order of the columns of the reader.
            let cells = columns.iter().map(|column| {
                let cell = match column.role {
                    Role::Weight => SelfWeight::ALL[k as usize % 2].name(),
                    Role::Given(Field::HalfOpening) => &alpha,
                    Role::Given(Field::Friction) => &mu,
                    _ => eta,
                };
                Some(cell.to_owned())
            });
            (u64::from(k), Ok(ReadRow { cells: cells.collect(), kept: Vec::new() }))
        };
        (1..500).map(row).collect()
    }

    /// Rows are what they are alone, to the last digit, in each format and with each number of digits.
    #[test]
    fn many_rows_are_answered_as_each_alone() {
        let reader = reader();
        for (name, digits, quantities) in [
            ("csv", 17, &Quantity::STATE[..]),
            ("jsonl", 17, &Quantity::STATE),
            ("jsonl", 17, &[Quantity::Thrust]),
            ("csv", 3, &[Quantity::Thickness, Quantity::SlidingFriction]),
            ("csv", 17, &Quantity::ASSESSMENT),
            ("csv", 17, &[Quantity::GeometricSafety]),
            ("csv", 17, &[Quantity::LeastThickness, Quantity::RotationalFriction]),
            ("jsonl", 17, &[Quantity::RequiredFriction]),
            ("jsonl", 12, &[Quantity::GeometricSafety, Quantity::LargestThrust]),
        ] {
            let format = Format::named(Content::ROWS, name).unwrap();
            let answers = Answers { quantities: quantities.to_vec(), ..Answers::mixed(digits) };
            let asked = RowQuestion::new(&answers, format, Beside::ALL).unwrap();
            let mut file = open_rows(answers, format, Beside::ALL).unwrap();
            let all: Vec<_> = rows().iter().map(|(_, row)| asked_of(&reader, row)).collect();
            let known = asked.known(&all).iter().flatten().count();
            assert!(known * 2 > all.len(), "{name} {known} of {}", all.len());
            let mut text = |of: Answer| {
                String::from_utf8(file.group(vec![of.only(quantities)]).unwrap()).unwrap()
            };
            let together = asked.answers(&reader, rows());
            for ((line, of), together) in (1..).zip(&all).zip(together) {
                let alone = match of {
                    Ok(of) => asked.answer(line, of, None),
                    Err(error) => Answer::refused(line, error.clone()),
                };
                assert_eq!(text(together), text(alone));
            }
        }
    }

    fn asked_of(reader: &ArchReader, row: &Result<ReadRow, String>) -> Result<RowArch, String> {
        reader.arch(&row.as_ref().map_err(Clone::clone)?.cells)
    }
}
