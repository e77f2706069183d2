//! Verdicts on every arch of a [survey](crate::problem::survey), and the ranges of what is asked of one.
//!
//! | file | what it does |
//! |---|---|
//! | `answer` | the answer: verdict, ranges and the arches at their ends |
//! | `corners` | the two arches that decide |
//! | `modes` | the modes that occur |
//! | `sought` | the widest half opening, or the least friction, of all |
//! | `stones` | arches of given stones |
//! | `survey` | the question |

mod answer;
mod corners;
mod modes;
mod sought;
mod stones;
#[allow(clippy::module_inception, reason = "the folder is named after what it answers")]
mod survey;
#[cfg(test)]
mod tests;

pub use crate::problem::survey::SurveyVerdict;
pub use answer::{EndValue, ModesFound, QuantityRange, RangeEnd, SurveyAnswer, SurveyedArch};
pub use sought::sought;
pub use stones::survey_of_stones;
pub use survey::survey;
