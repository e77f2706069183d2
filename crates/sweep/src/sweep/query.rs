//! The rows of a part as they are asked.

use crate::arch::SelfWeight;
use crate::certify::batch::{BatchArches, InLanes, SharedOpening, grouped};
use crate::number::{DoubleDoubleBall, ExactNumber};
use crate::problem::{Arch, Friction};
use crate::report::{GivenDoubles, Texts};
use ::parquet::data_type::ByteArray;
use std::borrow::Cow;

/// The rows of a part as they are asked; they follow each other in the sweep.
pub(super) struct PartQueries<'a> {
    /// The place of the first one in the sweep, from 0.
    pub first: u64,
    pub arches: PartArches<'a>,
}

/// The arches of a part.
pub(super) enum PartArches<'a> {
    /// Arches of a grid: every half opening with every friction.
    Grid(PartGrid<'a>),
    /// Arches that are listed one by one.
    Listed(Box<Listed>),
}

/// Half openings with their weights, and the frictions that each of them has.
pub(super) struct PartGrid<'a> {
    pub columns: Vec<(SelfWeight, AxisNumber<ExactNumber>)>,
    pub frictions: &'a [AxisNumber<Friction>],
}

/// A number of an axis: its text, the nearest double, an enclosure, and itself.
#[derive(Debug)]
pub(super) struct AxisNumber<T> {
    pub text: ByteArray,
    pub double: Option<f64>,
    /// Nothing encloses a friction without a limit.
    pub enclosed: Option<DoubleDoubleBall>,
    pub number: T,
}

/// Arches of which each has numbers of its own.
#[derive(Default)]
pub(super) struct Listed {
    /// File of the data set, if there is one, and the lines or the rows of it.
    pub origin: Option<(ByteArray, Vec<u64>)>,
    /// The texts of weights, half openings and frictions.
    pub texts: [Texts; 3],
    /// The half openings (rad) and the frictions nearest to what is given.
    pub doubles: [Vec<Option<f64>>; 2],
    /// The arches, or why they cannot be read.
    pub arches: Vec<Result<Arch, String>>,
}

impl<'a> PartGrid<'a> {
    /// Weight, half opening and friction of a row.
    pub(super) fn at(
        &self,
        row: usize,
    ) -> (SelfWeight, &AxisNumber<ExactNumber>, &'a AxisNumber<Friction>) {
        let (weight, half_opening) = &self.columns[row / self.frictions.len()];
        (*weight, half_opening, &self.frictions[row % self.frictions.len()])
    }
}

impl BatchArches for PartQueries<'_> {
    fn count(&self) -> usize {
        match &self.arches {
            PartArches::Grid(PartGrid { columns, frictions }) => columns.len() * frictions.len(),
            PartArches::Listed(listed) => listed.arches.len(),
        }
    }

    fn openings(&self, rows: &[usize]) -> Vec<Vec<usize>> {
        match &self.arches {
            PartArches::Grid(PartGrid { frictions, .. }) => {
                grouped(rows, |row| Some(row / frictions.len()))
            }
            PartArches::Listed(listed) => grouped(rows, |row| {
                Some((listed.arches[row].as_ref().ok()?.weight(), listed.texts[1].of(row)))
            }),
        }
    }

    fn in_lanes(&self, row: usize) -> Option<(SelfWeight, InLanes)> {
        match &self.arches {
            PartArches::Grid(grid) => {
                let (weight, half_opening, friction) = grid.at(row);
                Some((weight, ((half_opening.enclosed?, friction.enclosed), None)))
            }
            PartArches::Listed(listed) => {
                let arch = listed.arches[row].as_ref().ok()?;
                Some((arch.weight(), (SharedOpening::enclosed_arch(arch), None)))
            }
        }
    }

    fn arch(&self, row: usize) -> Result<Cow<'_, Arch>, String> {
        match &self.arches {
            PartArches::Grid(grid) => {
                let (weight, half_opening, friction) = grid.at(row);
                let arch = Arch::new(weight, half_opening.number.clone(), friction.number.clone());
                arch.map(Cow::Owned).map_err(|error| error.to_string())
            }
            PartArches::Listed(listed) => {
                listed.arches[row].as_ref().map(Cow::Borrowed).map_err(Clone::clone)
            }
        }
    }
}

impl Listed {
    /// Adds an arch.
    pub(super) fn push(&mut self, arch: Arch) {
        let friction = match arch.friction() {
            Friction::Coefficient(mu) => mu.nearest_double(),
            Friction::Infinite => Some(f64::INFINITY),
            Friction::Angle(_) => GivenDoubles::new(&arch, None).friction,
        };
        let texts: [&dyn std::fmt::Display; 3] =
            [&arch.weight().name(), arch.half_opening(), arch.friction()];
        texts.iter().zip(&mut self.texts).for_each(|(text, all)| all.push(text));
        self.doubles[0].push(arch.half_opening().nearest_double());
        self.doubles[1].push(friction);
        self.arches.push(Ok(arch));
    }

    /// Adds a row that cannot be read, with its texts as they are.
    pub(super) fn refuse(&mut self, texts: &[String; 3], error: String) {
        texts.iter().zip(&mut self.texts).for_each(|(text, all)| all.push(text));
        self.doubles.iter_mut().for_each(|all| all.push(None));
        self.arches.push(Err(error));
    }
}
