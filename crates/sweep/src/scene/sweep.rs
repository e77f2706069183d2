//! Request of a sweep: `couplet.sweep/1`. Keys may be added, none changes its meaning.

use super::fault::Fault;
use crate::arch::SelfWeight;
use crate::number::ExactNumber;
use crate::problem::{Friction, Quantity};

/// The name and the version of the schema: of a plan, of its record, and of the parts that are written.
pub const SWEEP_SCHEMA: &str = "couplet.sweep/1";

/// A plan with every key and what it means, which is itself a plan.
pub const SWEEP_EXAMPLE: &str = include_str!("sweep.toml");

/// Digits that tell the nearest double; with more a value is written as text too.
pub const SWEEP_DIGITS: usize = 17;

/// The most arches of a sample.
pub(crate) const MAX_SAMPLE: usize = 10_000_000_000;
/// The most rows of a part.
pub(crate) const MAX_CHUNK: usize = 100_000_000;

/// Many arches, and what is asked of each.
#[derive(Clone, Debug)]
pub struct SweepPlan {
    /// The weights of a grid, in the order in which they are swept; of a data set one, that of the rows without.
    pub weights: Vec<SelfWeight>,
    /// The values that are computed, in the order of [`Quantity::STATE_ROW`].
    pub quantities: Vec<Quantity>,
    /// Significant digits.
    pub digits: usize,
    /// Rows of a part, if the plan says how many.
    pub chunk: Option<usize>,
    /// The arches.
    pub arches: SweepArches,
    /// Remarks on what is swept all the same.
    pub notes: Vec<Fault>,
}

/// The arches of a sweep.
#[derive(Clone, Debug)]
pub enum SweepArches {
    /// Every weight with every half opening and every friction, in this order.
    Grid {
        /// Half openings in `(0, pi)`, rad.
        half_openings: Vec<ExactNumber>,
        /// The frictions.
        frictions: Vec<Friction>,
    },
    /// Arches drawn from a seed.
    Sample {
        /// Number of arches.
        count: usize,
        /// Seed that the first are drawn from.
        seed: u64,
        /// True if the arches are hard ones.
        hard: bool,
    },
    /// The rows of files: paths as they are written.
    Data {
        /// Files, one after the other.
        files: Vec<String>,
    },
}
