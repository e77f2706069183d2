//! Certificates as Coq theorems.
//!
//! | file | what it does |
//! |---|---|
//! | `certificate` | the file of a certificate: its numbers, which Coq checks by computing |
//! | `last_digit` | what follows from a landmark's certificate for the values that the paper prints |
//! | `survey` | the certificate of a survey, with those of its arches |
//! | `value` | numbers, quantities and decimals as Coq reads them |
//!
//! The mathematics is in the hand-written files of `proofs/coq`; what is printed here are numbers, and statements on
//! printed values. **Only the statements matter**: Coq checks everything else.

mod certificate;
mod last_digit;
mod survey;
mod value;

pub use certificate::certificate;
