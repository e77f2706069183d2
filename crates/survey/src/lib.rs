//! Verdicts on every arch of a [survey](crate::problem::survey), and the ranges of what is asked of one.
//!
//! | file | what it does |
//! |---|---|
//! | `answer` | the answer: verdict, ranges and the arches at their ends |
//! | `corners` | the two arches that decide |
//! | `modes` | the modes that occur |
//! | `sought` | the widest half opening, or the least friction, of all |
//! | `stones` | arches of given stones |
//! | `question` | the question |
//! | `certificate` | the certificate of a verdict |
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

mod answer;
mod certificate;
mod corners;
mod modes;
mod question;
mod sought;
mod stones;
#[cfg(test)]
mod tests;

pub use crate::problem::survey::SurveyVerdict;
pub use answer::{EndValue, ModesFound, QuantityRange, RangeEnd, SurveyAnswer, SurveyedArch};
pub use certificate::certify_survey;
pub use question::survey;
pub use sought::sought;
pub use stones::survey_of_stones;

use couplet_check::{arch, check, problem};
use couplet_number::number;
use couplet_prove::{certify, prover};
