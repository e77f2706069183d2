//! Compares, and proves nothing: the numbers that the paper prints, and other programs' results,
//! against certified values.
//!
//! A claim is what a row of results says: that the arch stands or falls, the mode, some numbers. Each
//! number is compared with a proved enclosure, which is narrowed until every comparison is decided;
//! no double decides anything.
//!
//! A number is **correct to `k` digits** if its error is at most half a unit of the `k`-th significant
//! digit of the true value; where that is exactly zero, of the `k`-th decimal place. The audit of the paper
//! counts in the same way. The verdict also says how the last printed place was rounded.
//!
//! ```
//! use couplet_judge::judge::{RowClaim, CorrectDigits, Demand, Said, Verdict, judge};
//! use couplet_prove::prelude::*;
//!
//! let arch = Arch::parse("heyman", "90deg", "0.38")?;
//! let said = Said { numbers: vec![(Quantity::Thickness, "0.12220", false)], ..Said::default() };
//! let judgement = judge(&arch, &RowClaim::read(&said)?, Demand::USUAL);
//! assert_eq!(judgement.verdict, Verdict::Correct);
//! assert_eq!(judgement.numbers[0].correct_digits, CorrectDigits::Digits(4));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | file | what it does |
//! |---|---|
//! | `audit` | every printed number of the paper, and the two weights beside each other |
//! | [`published`] | the numbers that the paper prints |
//! | `printed` | a printed number: its error, and how good its last place is |
//! | `printed_rational` | the rational numbers that are printed |
//! | `claim` | what a row says |
//! | `possible` | a number that an arch may have or not |
//! | `comparable` | what a printed number is compared with |
//! | `truth` | what is proved of a quantity |
//! | `number` | one number against its enclosure |
//! | `verdict` | the row as a whole |
//! | `boundary` | how near another mode is |

mod audit;
mod boundary;
mod claim;
mod comparable;
mod number;
mod possible;
mod printed;
mod printed_rational;
pub mod published;
mod truth;
mod verdict;

pub use audit::{
    Audited, Comparison, Relation, audit, audit_of, compare_weights, compare_weights_of, enclosed,
};
pub use boundary::Boundary;
pub use claim::{ClaimError, Claimed, RowClaim, Said};
pub use number::{Certified, CorrectDigits, Errors, Judged};
pub use possible::Possible;
pub use printed::PrintedVerdict;
pub use verdict::{Demand, ErrorSide, Judgement, ReadClaim, Standing, Verdict, judge, judge_all};
