//! Many arches at once: arches of one half opening and weight share its proofs, wherever they stand, and no bit
//! depends on it.
//!
//! | file | what it does |
//! |---|---|
//! | `row` | a row: verdict, mode, and values in doubles |
//! | `opening` | many frictions of one half opening, which share its proofs |
//! | `openings` | arches as they come, which do so where a half opening comes again |
//! | `arches`, `batch` | arches that are there; these answered as rows |
//! | `columns` | rows by columns |
//! | `in_lanes` | rows that are proved many at a time |
//! | `doubles` | arches in arrays of doubles |

mod arches;
#[allow(clippy::module_inception, reason = "the folder is named after what it answers")]
mod batch;
mod columns;
mod doubles;
mod in_lanes;
mod opening;
mod openings;
mod row;

pub use crate::certify::state::{InLanes, LaneColumns};
pub use crate::lanes::LaneArch;
pub use arches::{BatchArches, Threads, grouped};
pub use batch::Batch;
pub use columns::BatchColumns;
pub use doubles::{DoubleArches, DoubleUnits};
pub use opening::SharedOpening;
pub use openings::SharedOpenings;
pub use row::RowVerdict;
