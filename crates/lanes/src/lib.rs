//! Lanes: states of arches in double-doubles, proved many at a time by texts without a branch.
//!
//! | file | what it does |
//! |---|---|
//! | `sine` | sines and roots of the numbers of a proof |
//! | `start` | tables of start values |
//! | `root` | the proof that an equation has one root |
//! | `margins` | signs that make the root a state |
//! | `rotation`, `shoulder`, `inner`, `crown` | states that rotate, that slide at the shoulder, that slide inside, that turn about the crown |
//! | `sliding` | the thrust at which an inner joint slides; the purely sliding friction |
//! | `touching` | lines of thrust that touch the intrados at a thickness |
//! | `piece`, `width` | arches that go through a proof together; what a processor has for them |
//! | `answer` | an answer |
//! | `asking`, `asked` | rows of one proof; arches that are asked together, each proved by the proof of its mode |
//! | `arches` | arches of a weight: the door |
//!
//! Rows take it before anything else where they ask for what it has (`certify::batch`).
//!
//! The equations are those of [`arch`], over balls of one and of two doubles and their gradients.
//! All that an arch goes through has to be one piece for the compiler to put many into its lanes: so each function of
//! it is `#[inline(always)]`, here and where the equations are.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

mod answer;
mod arches;
mod asked;
mod asking;
mod crown;
mod inner;
mod margins;
mod piece;
mod root;
mod rotation;
mod shoulder;
mod sine;
mod sliding;
mod start;
mod touching;
mod width;

pub use answer::{FromFriction, LaneAnswer, LaneFrictions, LaneRoots, LaneState};
pub use arches::Lanes;
pub use asked::LaneArch;
pub use width::Width;

use couplet_check::{arch, problem};
use couplet_number::number;
use couplet_solve as solve;
