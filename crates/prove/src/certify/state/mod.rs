//! The state of an arch at its least thickness, proved.
//!
//! For a half opening, a friction and a weight: does the arch stand at any thickness, how thin can it
//! be, and how does it collapse there? The proof has four parts, all in balls:
//!
//! 1. the equations of the mode have exactly one solution in a box (Krawczyk);
//! 2. that state is statically admissible on the whole half arch;
//! 3. no thinner arch has an admissible state, and the mechanism has positive rates;
//! 4. the mode is the only one for which this can be proved, and every comparison that it takes to know
//!    that nothing stands is decided.
//!
//! Parts 2 and 3 come down to a few signs; [`crate::arch::contact`] has the lemma, and why a proved state
//! has one mode. A comparison that is not decided raises the precision; if it stays undecided, that is the
//! answer.
//!
//! | file | what it does |
//! |---|---|
//! | `certify` | the questions, as methods of an arch |
//! | `query` | an arch at one precision; part 1 for the printed equations |
//! | `rotation` | part 1 for pure rotation |
//! | `inner` | part 1 where an inner joint slides, and which mode that is |
//! | `small` | parts 1 to 3 for small half openings |
//! | `mode` | parts 2 to 4: which mode, and its start values |
//! | `state` | the outcome |
//! | `thrust_range`, `assess` | an arch of a given thickness |
//! | `enough` | what would be enough for an arch that falls |
//! | `digits` | the outcome in digits |
//! | `measured` | the same in metres and kilonewtons |
//! | [`find`] | questions the other way round |
//! | `inquiry` | several questions about one arch, which share its state |
//! | `kept` | the states that were proved last |
//! | `balls`, `tier` | which numbers are asked, in which order |
//! | `quick` | the same proofs in balls of double-doubles, where these are enough |
//! | `in_lanes` | states and assessments that are proved many at a time |

mod assess;
mod balls;
mod certify;
mod digits;
mod enough;
pub mod find;
mod in_lanes;
mod inner;
mod inquiry;
mod kept;
mod measured;
mod mode;
mod query;
mod quick;
mod rotation;
mod small;
#[allow(clippy::module_inception, reason = "the folder is named after what it proves")]
mod state;
mod thrust_range;
mod tier;

pub use crate::prover::Figure;
pub use assess::{Assessment, AssessmentDigits, Wanted};
pub use balls::Balls;
pub use certify::{Certify, NoState};
pub use digits::{Answer, Digits, SomeDigits};
pub(super) use enough::AtOpening;
pub use enough::Enough;
pub use in_lanes::{
    InLanes, LaneColumns, LaneOutcome, RowAnswer, answers_in_lanes, outcomes_in_lanes,
};
pub(super) use in_lanes::{LaneFound, LaneWants, each_in_lanes};
pub use inquiry::Inquiry;
pub use measured::{
    KnownRatios, Measured, least_in_metres, measured_assessment, measured_least, measured_of,
    measured_state,
};
pub(crate) use query::DOUBLE_DOUBLE;
#[doc(hidden)]
pub use query::bits_lost;
#[doc(hidden)]
pub use query::raised;
pub(super) use quick::critical_frictions;
pub use quick::state_in_double_doubles;
#[doc(hidden)]
pub use quick::{
    assessment_enclosed, sliding_configuration, state_enclosed, steepest_configuration,
};
#[doc(hidden)]
pub use quick::{decided, quick_outcome, quick_sliding, sliding_enclosed};
pub use state::{Fall, Frictions, Outcome, State};
pub use thrust_range::{Limit, Touch};
pub use tier::Tier;
