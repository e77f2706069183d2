//! Arches for whoever tests a solver of their own: drawn from a seed, or by `proptest` strategies.
//!
//! [`samples`] and [`assemblies`] draw from a seed. The others are strategies and have the feature `proptest`:
//!
//! | strategy | what it draws |
//! |---|---|
//! | `weight` | a self-weight model |
//! | `query` | a question as exact text: ordinary arches, and the hard ones |
//! | `arch` | the same, ready to be certified |
//! | `standing` | arches that stand, with what is proved of them |
//! | `collapsing` | the same for one collapse mode, however small its place on the map |
//! | `assessed` | arches with a thickness, and whether they stand with it |
//! | `assembly` | stones that just stand or just fall, with the proof |
//! | `half_opening`, `friction` | the numbers of a query alone |
//!
//! Hard are openings like `1e-60` or `0.9999pi`, frictions like `1e80`, `0` and `inf`, and the
//! neighbourhood of each landmark, where modes meet. A failure shrinks towards ordinary
//! arches, of Heyman's weight with a friction of `inf`, 1 or 0.5 and a half opening of few
//! decimals, and is printed as the command that answers it.

mod assemblies;
mod assembly;
mod blocks;
#[cfg(feature = "proptest")]
mod drawn;
mod margin;
mod places;
mod sample;

pub use assemblies::assemblies;
pub use assembly::{Assembly, AssemblyProof, Near, Surveyed};
pub use blocks::{Block, Blocks, Point};
#[cfg(feature = "proptest")]
pub use drawn::*;
pub use margin::Margin;
pub use sample::{Draw, Sample, samples};
