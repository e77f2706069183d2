//! Answers to rows, each of which is about one arch.

use super::arch::ArchReader;
use super::keep::ReadRow;
use super::roles::Role;
use super::source::Numbered;
use crate::answer;
use crate::arch::SelfWeight;
use crate::ask::{Spelling, given_thickness};
use crate::certify::batch::{LaneArch, SharedOpening, SharedOpenings};
use crate::certify::state::{Answer as Outcome, Balls, WithFrictions, states_in_lanes};
use crate::certify::{Error, Refused};
use crate::number::ExactNumber;
use crate::problem::measures::Measures;
use crate::problem::{Arch, Quantity};
use crate::report::{Answer, Answers, Beside, Extent, Format};
use rayon::prelude::*;

/// Up to so many digits rows are proved many at a time, and the others one by one.
const MOST_DIGITS: usize = 17;
/// Rows below which tables and half-filled lanes would cost more than they spare.
const FEW: usize = 16;
/// Rows that are proved at a time.
const PIECE: usize = 128;

/// Question that is asked of every row of a file.
pub struct RowQuestion {
    digits: usize,
    quantities: Vec<Quantity>,
    with: WithFrictions,
    /// True if given values are shown as doubles.
    doubles: bool,
    /// Proofs that arches share; none where each row is what it is alone, down to the error of each double.
    openings: Option<SharedOpenings>,
}

/// An arch that is asked of, with its thickness and its measures where it has any.
type Asked = (Arch, Option<ExactNumber>, Option<Measures>);

impl RowQuestion {
    /// Question to whose answers a format is given.
    pub fn new(answers: &Answers, format: &Format, beside: Beside) -> Result<Self, Refused> {
        let (digits, quantities) = (answers.digits, answers.quantities.clone());
        let frictions = quantities.iter().any(|quantity| quantity.is_friction());
        let with = match frictions {
            false => WithFrictions::None,
            true if format.name == "jsonl" => WithFrictions::AndRemedies,
            true => WithFrictions::OfModes,
        };
        let openings = SharedOpenings::new(Balls::DoubleDoubles, digits, frictions)?;
        let openings = (!format.has_errors).then_some(openings);
        let doubles = format.name != "csv" || beside.doubles;
        Ok(Self { digits, quantities, with, doubles, openings })
    }

    /// The answers to some rows, in their order, on all cores. A row is asked what it asks: about its thickness if it
    /// has one.
    pub fn answers(&self, reader: &ArchReader, rows: Vec<Numbered<ReadRow>>) -> Vec<Answer> {
        let read =
            |(_, row): &Numbered<ReadRow>| asked(reader, row.as_ref().map_err(Clone::clone)?);
        let all: Vec<Result<Asked, String>> = rows.par_iter().map(read).collect();
        let states: Vec<Option<Outcome>> = match self.openings {
            Some(_) if all.len() < FEW => vec![None; all.len()],
            _ if self.digits > MOST_DIGITS => vec![None; all.len()],
            _ => all.par_chunks(PIECE).flat_map_iter(|all| self.states(all)).collect(),
        };
        let answer = |(((line, row), asked), state): ((Numbered<ReadRow>, _), _)| {
            let answer = match asked {
                Ok(asked) => self.answer(line, &asked, state),
                Err(error) => Answer::refused(line, error),
            };
            let kept = row.map_or_else(|_| Vec::new(), |row| row.kept);
            Answer { kept, ..answer.only(&self.quantities) }
        };
        rows.into_par_iter().zip(all).zip(states).map(answer).collect()
    }

    /// The states of some rows, where they are proved together.
    fn states(&self, all: &[Result<Asked, String>]) -> Vec<Option<Outcome>> {
        let mut states = vec![None; all.len()];
        for weight in SelfWeight::ALL {
            let arch = |(row, asked): (usize, &Result<Asked, String>)| match asked {
                Ok((arch, None, _)) if arch.weight() == weight => {
                    Some((row, SharedOpening::enclosed_arch(arch)))
                }
                _ => None,
            };
            let (rows, arches): (Vec<usize>, Vec<LaneArch>) =
                all.iter().enumerate().filter_map(arch).unzip();
            let found = states_in_lanes((weight, &arches), self.digits, self.with);
            rows.into_iter().zip(found).for_each(|(row, found)| states[row] = found);
        }
        states
    }

    /// The answer to a row, whose state may be known.
    fn answer(&self, line: u64, (arch, eta, measures): &Asked, state: Option<Outcome>) -> Answer {
        let (digits, frictions) = (self.digits, self.with != WithFrictions::None);
        let sizes = measures.as_ref().map(|of| (of, digits));
        match eta {
            None => {
                let alone = || match &self.openings {
                    Some(openings) => openings.state(arch),
                    None => Balls::DoubleDoubles.state(arch, digits, frictions),
                };
                let found: Result<Outcome, Error> = state.map_or_else(alone, Ok);
                let quantities = Some(&self.quantities[..]);
                let extent = Extent { quantities, doubles: self.doubles };
                answer::state_to(extent, line, (arch, sizes), digits, &found)
            }
            Some(eta) => {
                let found = Balls::DoubleDoubles.assess(arch, eta, digits);
                answer::assessment(line, (arch, eta, sizes), digits, &found)
            }
        }
    }
}

/// The arch of a row.
fn asked(reader: &ArchReader, row: &ReadRow) -> Result<Asked, String> {
    let (arch, measures) = reader.measured_arch(&row.cells)?;
    let thickness = reader.given(&row.cells, Role::GivenThickness).map(|(text, _)| {
        let eta = given_thickness(&reader.spelling.exact(text), measures.as_ref(), Spelling::Key);
        eta.map_err(|misfit| misfit.message)
    });
    Ok((arch, thickness.transpose()?, measures))
}

#[cfg(test)]
mod tests {
    use super::super::{Columns, Purpose, Spelling};
    use super::*;
    use crate::report::{Content, open_rows};

    fn reader() -> ArchReader {
        let mut columns = Columns::own(Purpose::Ask);
        columns.places(&["weight", "alpha", "mu", "eta"].map(str::to_owned)).unwrap();
        let (weight, spelling) = (SelfWeight::Heyman, Spelling::default());
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
            let eta = if k.is_multiple_of(31) { "0.1" } else { "" };
            // In the order of the columns of the reader.
            let cells = columns.iter().map(|column| {
                let cell = match column.role {
                    Role::Weight => SelfWeight::ALL[k as usize % 2].name(),
                    Role::HalfOpening => &alpha,
                    Role::Friction => &mu,
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
            ("csv", 18, &[Quantity::Thickness]),
        ] {
            let format = Format::named(Content::ROWS, name).unwrap();
            let answers = Answers { quantities: quantities.to_vec(), ..Answers::mixed(digits) };
            let asked = RowQuestion::new(&answers, format, Beside::ALL).unwrap();
            let mut file = open_rows(answers, format, Beside::ALL).unwrap();
            let all: Vec<_> = rows().iter().map(|(_, row)| asked_of(&reader, row)).collect();
            let known = asked.states(&all).iter().flatten().count();
            assert!(digits > 17 || known * 2 > all.len(), "{name} {known} of {}", all.len());
            let together = asked.answers(&reader, rows());
            let alone = rows().into_iter().flat_map(|row| asked.answers(&reader, vec![row]));
            for (together, alone) in together.into_iter().zip(alone) {
                let [together, alone] = [together, alone]
                    .map(|of| String::from_utf8(file.group(vec![of]).unwrap()).unwrap());
                assert_eq!(together, alone);
            }
        }
    }

    fn asked_of(reader: &ArchReader, row: &Result<ReadRow, String>) -> Result<Asked, String> {
        asked(reader, row.as_ref().map_err(Clone::clone)?)
    }
}
