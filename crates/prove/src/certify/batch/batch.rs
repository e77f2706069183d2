//! The one way in which arches that are there are answered: those of one half opening together.

use super::arches::{BatchArches, Threads};
use super::columns::BatchColumns;
use super::in_lanes;
use super::opening::{PAYS_FROM, SharedOpening};
use super::row::{BatchRow, RowValue, RowVerdict};
use crate::certify::asymmetric_thickness::asymmetric_thicknesses;
use crate::certify::state::{Answer, Balls, Figure, Tier, Wanted};
use crate::number::ExactNumber;
use crate::problem::{Arch, Quantity};
use crate::prover::Error;
use std::borrow::Cow;

/// Question that is asked of every arch of a batch.
#[derive(Clone, Debug)]
pub struct Batch {
    /// Quantities of each row.
    pub quantities: Vec<Quantity>,
    /// Significant digits.
    pub digits: usize,
    /// True if values are kept as text too.
    pub has_texts: bool,
}

impl Batch {
    /// Tells whether the frictions at which the mode changes are asked for.
    pub fn has_frictions(&self) -> bool {
        self.quantities.iter().any(|of| of.is_friction())
    }

    /// Columns of states at the least thickness, or of arches that have one: first those that are proved many at a
    /// time, then the others, with the proofs of one half opening at a time.
    pub fn columns(&self, arches: &impl BatchArches, threads: Threads) -> BatchColumns {
        // Lanes have neither the asymmetric thickness nor texts.
        let is_asymmetric = self.quantities.contains(&Quantity::AsymmetricThickness);
        let go_into_lanes = Tier::Lanes.has(self.digits) && !self.has_texts && !is_asymmetric;
        let mut all = match go_into_lanes {
            true => in_lanes::columns(&self.quantities, arches, threads),
            false => self.open(arches.count()),
        };
        let is_open = |row: &usize| all.verdicts[*row] == RowVerdict::Undecided;
        let open: Vec<usize> = (0..arches.count()).filter(is_open).collect();
        for (row, found) in self.one_by_one(&open, arches, threads) {
            all.put(row, &found);
        }
        all
    }

    /// Some rows, each with its place.
    pub(super) fn one_by_one(
        &self,
        rows: &[usize],
        arches: &impl BatchArches,
        threads: Threads,
    ) -> Vec<(usize, BatchRow)> {
        if arches.have_thicknesses() {
            let asked = |row| Ok((arches.arch(row)?.into_owned(), arches.thickness(row)?));
            return threads.each(rows, |&row| (row, self.assessment(asked(row))));
        }
        let pays = |rows: &Vec<usize>| rows.len() >= PAYS_FROM;
        let (mut groups, few): (Vec<_>, Vec<_>) = arches.openings(rows).into_iter().partition(pays);
        let shared = groups.len();
        groups.push(few.concat());
        let places: Vec<usize> = (0..groups.len()).collect();
        let found = threads.each(&places, |&place| {
            let first = groups[place].iter().find_map(|row| arches.arch(*row).ok());
            let opening = first.filter(|_| place < shared).and_then(|arch| {
                SharedOpening::new(arch.weight(), arch.half_opening().clone(), self.digits).ok()
            });
            threads.each(&groups[place], |&row| self.alone(arches.arch(row), opening.as_ref()))
        });
        let found = found.into_iter().flatten();
        groups.iter().flatten().copied().zip(found).collect()
    }

    /// Columns of so many rows of which nothing is known.
    fn open(&self, rows: usize) -> BatchColumns {
        let texts = self.quantities.iter().filter(|_| self.has_texts);
        let texts = texts.map(|_| vec![None; rows]).collect();
        BatchColumns { texts, ..BatchColumns::open(rows, self.quantities.len()) }
    }

    /// Columns of one arch, which shares nothing.
    pub fn one(&self, arch: &Arch) -> BatchColumns {
        let mut one = self.open(1);
        one.put(0, &self.alone(Ok(Cow::Borrowed(arch)), None));
        one
    }

    /// Row of an arch, or of none; with the proofs of its half opening, if they are given.
    fn alone(
        &self,
        arch: Result<Cow<'_, Arch>, String>,
        opening: Option<&SharedOpening>,
    ) -> BatchRow {
        let arch = match arch {
            Ok(arch) => arch,
            Err(reason) => return self.without(RowVerdict::Refused, reason),
        };
        let frictions = self.has_frictions();
        let alone = || Balls::DoubleDoubles.state(&arch, self.digits, frictions).map(Cow::Owned);
        let found = opening.map_or_else(alone, |opening| opening.state(&arch, frictions));
        self.row(found.as_deref(), || Some(arch))
    }

    /// Row of an arch of a thickness, or of none.
    fn assessment(&self, asked: Result<(Arch, ExactNumber), String>) -> BatchRow {
        let wanted = Wanted::of(&self.quantities);
        let found = asked.and_then(|(arch, eta)| {
            let found = Balls::DoubleDoubles.assess(&arch, &eta, self.digits, wanted);
            Ok((found.map_err(|refused| refused.to_string())?, arch))
        });
        let (digits, arch) = match found {
            Ok(found) => found,
            Err(reason) => return self.without(RowVerdict::Refused, reason),
        };
        let (verdict, reason) = match &digits.stands {
            Ok(true) => (RowVerdict::Stands, None),
            Ok(false) => (RowVerdict::Falls, None),
            Err(open) => (RowVerdict::Undecided, Some(open.reason.to_string())),
        };
        let row = self.with(verdict, digits.figures(), || Some(Cow::Owned(arch)));
        BatchRow { reason, ..row }
    }

    /// Row of the answer to an arch, which is looked at only where its asymmetric thickness is asked for.
    fn row<'a>(
        &self,
        found: Result<&Answer, &Error>,
        arch: impl FnOnce() -> Option<Cow<'a, Arch>>,
    ) -> BatchRow {
        match found {
            Ok(Answer::Stands(digits)) => {
                let mode = Some(digits.mode);
                BatchRow { mode, ..self.with(RowVerdict::Stands, digits.figures(), arch) }
            }
            Ok(Answer::Falls { enough, .. }) => {
                let sliding = enough.as_ref().and_then(|enough| enough.sliding_friction.as_ref());
                let sliding = sliding.map(|figure| (Quantity::SlidingFriction, Some(figure)));
                self.with(RowVerdict::Falls, sliding, arch)
            }
            Err(Error::Undecided(open)) => self.without(RowVerdict::Undecided, &open.reason),
            Err(Error::Refused(refused)) => self.without(RowVerdict::Refused, refused),
        }
    }

    fn without(&self, verdict: RowVerdict, reason: impl ToString) -> BatchRow {
        let (values, reason) = (vec![None; self.quantities.len()], Some(reason.to_string()));
        BatchRow { verdict, mode: None, values, reason }
    }

    /// Row with those of the figures that are asked for, and the asymmetric thickness of an arch that stands.
    fn with<'a, 'b>(
        &self,
        verdict: RowVerdict,
        figures: impl IntoIterator<Item = (Quantity, Option<&'a Figure>)>,
        arch: impl FnOnce() -> Option<Cow<'b, Arch>>,
    ) -> BatchRow {
        let mut values = vec![None; self.quantities.len()];
        let mut put = |of: Quantity, figure: Option<&Figure>| {
            let places = self.quantities.iter().zip(&mut values).filter(|(asked, _)| **asked == of);
            places.for_each(|(_, value)| *value = Some(RowValue::new(figure, self.has_texts)));
        };
        figures.into_iter().for_each(|(of, figure)| put(of, figure));
        if self.asks_asymmetric(verdict)
            && let Some(arch) = arch()
            && let Ok(all) = asymmetric_thicknesses(&arch, self.digits)
            && let Some(largest) = all.first()
        {
            put(Quantity::AsymmetricThickness, Some(largest));
        }
        BatchRow { verdict, mode: None, values, reason: None }
    }

    /// Tells whether rows of a verdict are asked for the asymmetric thickness of each of their arches.
    fn asks_asymmetric(&self, verdict: RowVerdict) -> bool {
        let of = Quantity::AsymmetricThickness;
        verdict == RowVerdict::Stands && self.quantities.contains(&of)
    }
}
