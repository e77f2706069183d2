//! Lanes: purely rotational states of arches in doubles, proved many at a time by one text without a branch.
//!
//! | file | what it does |
//! |---|---|
//! | `ball` | balls in which nothing is decided on the way |
//! | `start` | tables: start values, and where sines are found from |
//! | `rotation` | the proof of a state |
//! | `state` | a state that is proved |
//! | `width` | the proof for what a processor has |
//!
//! Rows of doubles take it before anything else where they ask for what it has (`certify::batch`).
//!
//! The equations are those of [`arch`](couplet_check::arch), over balls of one and of two doubles and their gradients.
//! All that an arch goes through has to be one piece for the compiler to put many into its lanes: so each function of
//! it is `#[inline(always)]`, here and where the equations are.

mod ball;
mod rotation;
mod start;
mod state;
mod width;

pub use state::RotationalState;
pub use width::Width;
