//! Proves: existence and uniqueness in a box, digits, exact values, inequalities.
//!
//! A proof either succeeds or says why nothing is known ([`Undecided`]); nothing in between.




mod isolate;
pub mod krawczyk;
mod refine;

mod verdict;




pub use isolate::{Isolated, isolate};
pub use refine::{Refined, refine};

pub use verdict::{Undecided, Verdict};
