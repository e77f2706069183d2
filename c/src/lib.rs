//! couplet for C, and for every language that calls C: thin, over the library. `docs/c.md` is its manual, and
//! `include/couplet_c.h`, which is made of this source, what a program includes.
//!
//! | file | what it does |
//! |---|---|
//! | `codes` | what functions return, and what stands in arrays |
//! | `asked` | one question at a time |
//! | `question` | what a question about an arch takes, and the certificate that answers it |
//! | `surveyed` | the same of all arches of ranges |
//! | `arrays` | many arches, in arrays of doubles |
//! | `answer` | what comes back, and what reads it |
//! | `texts`, `failure` | small helpers for texts; why a call has no answer |
//! | `border` | pointers become slices and texts, a panic becomes a code |
//! | `threads` | threads of a call |
#![allow(
    clippy::missing_safety_doc,
    reason = "the header says once what a pointer has to be, and C has no other functions"
)]

// The header has them in this order.
mod codes;

mod asked;

mod arrays;

mod answer;

mod texts;

mod border;
mod failure;
mod question;
mod surveyed;
mod threads;

pub use answer::*;
pub use arrays::*;
pub use asked::*;
pub use codes::*;
pub use texts::*;
