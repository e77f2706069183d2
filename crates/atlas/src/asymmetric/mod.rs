//! Asymmetric solutions of Eq. (19) as curves.
//!
//! | file | what it does |
//! |---|---|
//! | `kind` | the equations of each kind of mechanism over the vertical force |
//! | `course` | where the curve of one half opening probably runs |
//! | `meeting` | the points where it begins, where its kind changes, and where it ends |
//! | `stretch` | a proved part of it, of one kind |
//! | `admissible` | that each state of a part is admissible, with rates that are not negative |
//! | `branch` | the curve of one half opening from end to end, over friction |
//! | `border` | between which half openings and frictions branches run |
//!
//! The kinds have five equations in common, and one that closes: an inner joint slides, the shoulder opens, or the
//! hinges fit. In each state the left sides of the other two are not negative; where one of them becomes zero the
//! kind changes.

mod admissible;
mod border;
mod branch;
mod course;
mod kind;
mod meeting;
mod stretch;

pub use border::{Border, BorderLine};
pub use branch::{Branch, NoBranch};
pub use meeting::Meeting;
pub use stretch::Stretch;
