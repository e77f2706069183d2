//! Verdicts on every arch of a [survey](crate::problem::survey), and the ranges of what is asked of one.
//!
//! | file | what it does |
//! |---|---|
//! | `answer` | the answer: verdict, ranges and the arches at their ends |
//! | `corners` | the two arches that decide |
//! | `largest` | the order in which halving goes on |
//! | `mean` | the mean of the least thickness |
//! | `modes` | the modes that occur |
//! | `patch` | the states of a mode, all at once |
//! | `share` | the part that stands |
//! | `sought` | the widest half opening, or the least friction, of all |
//! | `stones` | arches of given stones |
//! | `survey` | the question |

mod answer;
mod corners;
mod largest;
mod mean;
mod modes;
mod patch;
mod share;
mod sought;
mod stones;
#[allow(clippy::module_inception, reason = "the folder is named after what it answers")]
mod survey;
#[cfg(test)]
mod tests;

pub use crate::problem::survey::SurveyVerdict;
pub use answer::{EndValue, ModesFound, QuantityRange, RangeEnd, SurveyAnswer, SurveyedArch};
pub use share::{Share, share};
pub use sought::sought;
pub use stones::survey_of_stones;
pub use survey::survey;
