//! A row as it is asked.

use crate::arch::SelfWeight;
use crate::cli::commands::rows::{Cells, Reader};
use crate::number::ExactNumber;
use crate::problem::{Arch, Friction};
use crate::report::GivenDoubles;
use ::parquet::data_type::ByteArray;
use std::sync::Arc;

/// A row as it is asked.
#[derive(Clone)]
pub(super) struct Query {
    /// Its place in the sweep, from 0.
    pub row: u64,
    /// In a data set the file, and the line or the row of it.
    pub origin: Option<(ByteArray, u64)>,
    /// The texts of weight, half opening and friction.
    pub texts: [ByteArray; 3],
    /// The half opening (rad) and the friction nearest to what is given.
    pub doubles: [Option<f64>; 2],
    /// The arch, or why it cannot be read.
    pub asked: Result<Asked, String>,
}

/// An arch; many share their half openings and frictions.
#[derive(Clone)]
pub(super) struct Asked {
    pub weight: SelfWeight,
    pub half_opening: Arc<ExactNumber>,
    pub friction: Arc<Friction>,
}

impl Query {
    /// Of an arch.
    pub(super) fn new(row: u64, arch: &Arch) -> Self {
        let friction = match arch.friction() {
            Friction::Coefficient(mu) => mu.nearest_double(),
            Friction::Infinite => Some(f64::INFINITY),
            Friction::Angle(_) => GivenDoubles::new(arch, None).friction,
        };
        let texts = [
            arch.weight().name().to_owned(),
            arch.half_opening().to_string(),
            arch.friction().to_string(),
        ];
        Self {
            row,
            origin: None,
            texts: texts.map(|text| ByteArray::from(text.into_bytes())),
            doubles: [arch.half_opening().nearest_double(), friction],
            asked: Ok(Asked {
                weight: arch.weight(),
                half_opening: Arc::new(arch.half_opening().clone()),
                friction: Arc::new(arch.friction().clone()),
            }),
        }
    }

    /// Of a row of a data set.
    pub(super) fn of_row(reader: &Reader, cells: &Cells) -> Self {
        match reader.arch(cells) {
            Ok(arch) => Self::new(0, &arch),
            Err(error) => Self::refused(reader.described(cells), error),
        }
    }

    /// A row that cannot be read, with its texts as they are.
    pub(super) fn refused(texts: [String; 3], error: String) -> Self {
        let texts = texts.map(|text| ByteArray::from(text.into_bytes()));
        Self { row: 0, origin: None, texts, doubles: [None; 2], asked: Err(error) }
    }
}
