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
//! | `question` | an arch, as it is asked about |
//! | `root`, `rotation` | part 1 |
//! | `choice` | part 4: which mode, and its start values |
//! | `small` | parts 1 to 3 for small half openings |
//! | [`conditions`](crate::problem::conditions) | parts 2 and 3 |
//! | `assess` | an arch of a given thickness |
//! | `digits` | raises the precision until every digit is decided |
//! | `inquiry` | several questions about one arch, which share its state |

mod assess;
mod choice;
mod digits;
mod inquiry;
mod question;
mod root;
mod rotation;
mod small;

pub use assess::{Assessment, Limit, Touch, Wanted};
pub use choice::{Fall, Frictions, Outcome, State};
pub use digits::{Answer, AssessmentDigits, Digits, Figure, LimitDigits};
pub use inquiry::Inquiry;
pub use question::{Arch, ArchError, Doubt, Friction, is_thickness};
