//! Arches that are listed one by one: those of a file, or of a sample.

use crate::problem::{Arch, Friction};
use crate::report::{GivenDoubles, Texts};
use ::parquet::data_type::ByteArray;
use std::fmt::Display;

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

impl Listed {
    /// Adds an arch.
    pub(super) fn push(&mut self, arch: Arch) {
        let friction = match arch.friction() {
            Friction::Coefficient(mu) => mu.nearest_double(),
            Friction::Infinite => Some(f64::INFINITY),
            Friction::Angle(_) => GivenDoubles::new(&arch, None).friction,
        };
        let texts: [&dyn Display; 3] =
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
