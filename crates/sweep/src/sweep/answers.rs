//! What is proved of the rows of a part. Rows of one half opening share its proofs, wherever they stand in the part;
//! no bit depends on it.

use super::query::{Arches, Grid, Listed, Queries};
use crate::arch::SelfWeight;
use crate::certify::state::{Answer, Certify, Column, Figure};
use crate::certify::{Error, asymmetric_thicknesses};
use crate::number::{DoubleDoubleBall, ExactNumber};
use crate::problem::{Arch, Friction, Mode, Quantity};
use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use std::ptr;

/// As many rows of a half opening as cost less together.
const SHARED: usize = 4;

/// The verdicts on rows, in the order in which they are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    Stands,
    Falls,
    Undecided,
    Refused,
}

impl Verdict {
    pub const ALL: [Self; 4] = [Self::Stands, Self::Falls, Self::Undecided, Self::Refused];

    /// The name used in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stands => "stands",
            Self::Falls => "falls",
            Self::Undecided => "undecided",
            Self::Refused => "refused",
        }
    }
}

/// What is known of a row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Found {
    pub verdict: Verdict,
    pub mode: Option<Mode>,
    /// For each quantity its value, where there is one.
    pub values: Vec<Option<Value>>,
    /// Why it is undecided or refused.
    pub reason: Option<String>,
}

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Value {
    /// The nearest double.
    pub double: f64,
    /// Where the true value lies: -1 below the double, 0 on it, 1 above it; none where that is not proved.
    pub side: Option<i32>,
    /// The digits, where there are more than a double tells.
    pub text: Option<String>,
}

/// What is asked of every row.
pub(super) struct Wanted {
    pub quantities: Vec<Quantity>,
    pub digits: usize,
    /// Whether values are written as text too.
    pub has_texts: bool,
}

impl Wanted {
    fn value(&self, figure: Option<&Figure>) -> Value {
        let Some(figure) = figure else {
            let text = self.has_texts.then(|| "inf".to_owned());
            return Value { double: f64::INFINITY, side: Some(0), text };
        };
        let (double, binary) = (figure.double, &figure.binary);
        let side = match (binary.lower >= double, binary.upper <= double) {
            (true, true) => Some(0),
            (true, false) => Some(1),
            (false, true) => Some(-1),
            (false, false) => None,
        };
        Value { double, side, text: self.has_texts.then(|| figure.to_string()) }
    }

    fn without(&self, verdict: Verdict, reason: Option<String>) -> Found {
        Found { verdict, mode: None, values: vec![None; self.quantities.len()], reason }
    }

    fn found(&self, answer: Result<&Answer, &Error>) -> Found {
        match answer {
            Ok(Answer::Stands(digits)) => {
                let value = |of: &Quantity| {
                    let (_, figure) = digits.figures().find(|(quantity, _)| quantity == of)?;
                    Some(self.value(figure))
                };
                let values = self.quantities.iter().map(value).collect();
                Found { verdict: Verdict::Stands, mode: Some(digits.mode), values, reason: None }
            }
            Ok(Answer::Falls { enough, .. }) => {
                let sliding = enough.as_ref().and_then(|enough| enough.sliding_friction.as_ref());
                let mut found = self.without(Verdict::Falls, None);
                let place = self.quantities.iter().position(|of| *of == Quantity::SlidingFriction);
                if let Some(place) = place {
                    found.values[place] = sliding.map(|figure| self.value(Some(figure)));
                }
                found
            }
            Err(Error::Undecided(undecided)) => {
                self.without(Verdict::Undecided, Some(undecided.reason.clone().into_owned()))
            }
            Err(Error::Refused(refused)) => {
                self.without(Verdict::Refused, Some(refused.to_string()))
            }
        }
    }

    /// Of a row by itself, without what others share.
    pub(super) fn alone(&self, arch: &Result<Arch, String>) -> Found {
        let found = self.single(arch);
        self.with_asymmetric(&found, || arch.clone().ok()).unwrap_or(found)
    }

    /// The same with the asymmetric thickness of its arch, if it stands, has one, and that is asked.
    fn with_asymmetric(&self, found: &Found, arch: impl FnOnce() -> Option<Arch>) -> Option<Found> {
        let place = self.quantities.iter().position(|of| *of == Quantity::AsymmetricThickness);
        let place = place.filter(|_| found.verdict == Verdict::Stands)?;
        let all = asymmetric_thicknesses(&arch()?, self.digits).ok()?;
        let mut found = found.clone();
        found.values[place] = Some(self.value(Some(all.first()?)));
        Some(found)
    }

    fn single(&self, arch: &Result<Arch, String>) -> Found {
        let answer = match arch {
            Ok(arch) if self.asks_frictions() => arch.certify(self.digits),
            Ok(arch) => arch.certify_alone(self.digits),
            Err(reason) => return self.without(Verdict::Refused, Some(reason.clone())),
        };
        self.found(answer.as_ref())
    }

    fn asks_frictions(&self) -> bool {
        self.quantities.iter().any(|of| of.is_friction())
    }

    /// Of the rows of a part; those that share an answer share it here.
    pub(super) fn all(&self, queries: &Queries) -> Answers {
        let mut answers = match &queries.arches {
            Arches::Grid(grid) => self.grid(grid),
            Arches::Listed(listed) => self.listed(listed),
        };
        for row in 0..answers.len() {
            if let Some(found) = self.with_asymmetric(answers.of(row), || queries.arch(row).ok()) {
                answers.put(row, found);
            }
        }
        answers
    }

    fn grid(&self, Grid { columns, frictions }: &Grid) -> Answers {
        let mut answers = Answers::new(columns.len() * frictions.len());
        // The same for every half opening.
        let enclosed: Vec<_> =
            frictions.iter().map(|friction| Column::enclosed(&friction.number)).collect();
        for (place, (weight, half_opening)) in columns.iter().enumerate() {
            let first = place * frictions.len();
            match self.column(frictions.len(), *weight, &half_opening.number) {
                Some(column) => {
                    let rows = frictions.iter().zip(&enclosed).zip(first..);
                    let rows = rows.map(|((mu, enclosed), row)| (row, &mu.number, *enclosed));
                    self.together(&column, rows, &mut answers);
                }
                None => {
                    for (row, mu) in (first..).zip(frictions) {
                        let half_opening = half_opening.number.clone();
                        let arch = Arch::new(*weight, half_opening, mu.number.clone());
                        let arch = arch.map_err(|error| error.to_string());
                        answers.put(row, self.single(&arch));
                    }
                }
            }
        }
        answers
    }

    fn listed(&self, listed: &Listed) -> Answers {
        let arches = &listed.arches;
        let mut answers = Answers::new(arches.len());
        // The rows of each half opening that has enough of them; one after the other, so that one column is held at a
        // time.
        let mut group_of: HashMap<(SelfWeight, &[u8]), usize> =
            HashMap::with_capacity(arches.len());
        let mut counts: Vec<usize> = Vec::new();
        let group = |(row, arch): (usize, &Result<Arch, String>)| {
            let key = (arch.as_ref().ok()?.weight(), listed.texts[1].of(row));
            let group = *group_of.entry(key).or_insert(counts.len());
            match counts.get_mut(group) {
                Some(count) => *count += 1,
                None => counts.push(1),
            }
            Some(group)
        };
        let groups: Vec<Option<usize>> = arches.iter().enumerate().map(group).collect();
        let mut shared: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (row, group) in groups.into_iter().enumerate() {
            match group.filter(|group| counts[*group] >= SHARED && !self.asks_frictions()) {
                Some(group) => shared.entry(group).or_default().push(row),
                None => answers.put(row, self.single(&arches[row])),
            }
        }
        for rows in shared.into_values() {
            let row = |&row: &usize| Some((row, arches[row].as_ref().ok()?));
            let all = || rows.iter().filter_map(row);
            let column = all()
                .next()
                .and_then(|(_, arch)| self.column(rows.len(), arch.weight(), arch.half_opening()));
            match column {
                Some(column) => {
                    let rows = all().map(|(row, arch)| (row, arch.friction()));
                    let rows = rows.map(|(row, mu)| (row, mu, Column::enclosed(mu)));
                    self.together(&column, rows, &mut answers);
                }
                None => rows.iter().for_each(|&row| answers.put(row, self.single(&arches[row]))),
            }
        }
        answers
    }

    /// The column of so many rows of one half opening, where it is cheaper.
    fn column(&self, rows: usize, weight: SelfWeight, alpha: &ExactNumber) -> Option<Column> {
        let is_cheaper = rows >= SHARED && !self.asks_frictions();
        is_cheaper.then(|| Column::new(weight, alpha.clone(), self.digits).ok())?
    }

    /// Of some rows of a column, each with its friction and an enclosure of it.
    fn together<'a>(
        &self,
        column: &Column,
        rows: impl Iterator<Item = (usize, &'a Friction, Option<DoubleDoubleBall>)>,
        answers: &mut Answers,
    ) {
        let mut last: Option<(&Answer, u32)> = None;
        for (row, friction, enclosed) in rows {
            let shared = enclosed.and_then(|mu| column.shared(&mu));
            let answer = match shared {
                Some(answer) => Ok(Cow::Borrowed(answer)),
                None => column.certify_alone(friction.clone()),
            };
            match (answer, last) {
                (Ok(Cow::Borrowed(answer)), Some((of, place))) if ptr::eq(of, answer) => {
                    answers.places[row] = place;
                }
                (Ok(Cow::Borrowed(answer)), _) => {
                    answers.put(row, self.found(Ok(answer)));
                    last = Some((answer, answers.places[row]));
                }
                (answer, _) => answers.put(row, self.found(answer.as_deref())),
            }
        }
    }
}

/// What is known of the rows of a part; rows that share an answer have it once.
pub(super) struct Answers {
    found: Vec<Found>,
    /// For each row the place of its answer.
    places: Vec<u32>,
}

impl Answers {
    fn new(rows: usize) -> Self {
        Self { found: Vec::new(), places: vec![0; rows] }
    }

    /// Of one row.
    pub(super) fn one(found: Found) -> Self {
        Self { found: vec![found], places: vec![0] }
    }

    /// Adds what is found of a row; others that share it have its place.
    fn put(&mut self, row: usize, found: Found) {
        // A part has fewer rows.
        self.places[row] = u32::try_from(self.found.len()).unwrap_or(u32::MAX);
        self.found.push(found);
    }

    /// How many rows there are.
    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// What is known of a row.
    pub(super) fn of(&self, row: usize) -> &Found {
        &self.found[self.places[row] as usize]
    }

    /// How many rows have which verdict, in the order of [`Verdict::ALL`].
    pub(super) fn counts(&self) -> [u64; 4] {
        let mut counts = [0; 4];
        (0..self.len()).for_each(|row| counts[self.of(row).verdict as usize] += 1);
        counts
    }
}
