//! Arches for property tests: [`proptest`] strategies for whoever tests a solver of their own.
//!
//! | strategy | what it draws |
//! |---|---|
//! | [`weight`] | a self-weight model |
//! | [`query`] | a question as exact text: ordinary arches, and the hard ones |
//! | [`arch`] | the same, ready to be certified |
//! | [`standing`] | arches that stand, with what is proved of them |
//! | [`collapsing`] | the same for one collapse mode, however small its place on the map |
//! | [`half_opening`], [`friction`] | the numbers of a query alone |
//!
//! Hard are openings like `1e-60` or `0.9999pi`, frictions like `1e80`, `0` and `inf`, and the
//! neighbourhood of each landmark, where modes meet. A failure shrinks towards an ordinary arch of
//! Heyman's weight whose numbers have few decimals, and is printed as the command that answers it.
//!
//! ```
//! use couplet::strategies::standing;
//! use proptest::test_runner::TestRunner;
//!
//! let mut runner = TestRunner::deterministic();
//! let verdict = runner.run(&standing(9), |(query, state)| {
//!     // A solver of one's own would be asked about `query` here, and compared with `state`. As doubles
//!     // some thicknesses are 0 (at an opening of 1e-100) or 2 (next to `L`), which they are not.
//!     let thickness = state.thickness.double;
//!     assert!((0.0..=2.0).contains(&thickness), "{query}: {thickness}");
//!     Ok(())
//! });
//! assert!(verdict.is_ok());
//! ```

mod arches;
mod numbers;
mod places;
mod queries;

pub use arches::{arch, collapsing, standing};
pub use numbers::{friction, half_opening};
pub use queries::{Query, query};

use crate::arch::SelfWeight;
use proptest::prelude::Strategy;
use proptest::sample::select;

/// Either self-weight model; shrinks to Heyman's.
pub fn weight() -> impl Strategy<Value = SelfWeight> + Clone {
    select(&SelfWeight::ALL)
}
