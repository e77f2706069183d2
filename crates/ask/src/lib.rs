//! Questions about arches, read once for every door. Each fills one [`ArchAsked`] with exact text: the options of a
//! command, the columns of a row, the fields of the page. One reader makes an [`ArchGiven`] of it, or a [`Misfit`] that
//! names what is wrong in the words of the door.
//!
//! | file | what it does |
//! |---|---|
//! | `asked` | what an arch may be given by, as text |
//! | `question` | which of it a question takes and needs, and why not the rest |
//! | `arc` | the half opening and the radius of any two measures |
//! | `given` | the reader: text to an arch, its measures, thickness, stones and tilt |
//! | `stones` | numbers of stones, and ranges of them |
//! | `survey` | the reader of ranges: text to all arches between two ends |
//! | `range` | ranges: the exact texts of both ends |
//! | `boxes` | a range in parts that touch, or in steps |
//! | `note` | what may have been meant otherwise |
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

mod arc;
mod asked;
mod boxes;
mod given;
mod note;
mod question;
mod range;
mod stones;
mod survey;

pub use asked::{ArchAsked, Field, quoted};
pub use boxes::{boxes, steps};
pub use given::ArchGiven;
pub use note::{array_note, notes, tilt_note};
pub use question::{ArchQuestion, Misfit, Spelling, makes_an_arc};
pub use range::Range;
pub use stones::{MOST_NUMBERS, StonesAsked};
pub use survey::SurveyGiven;

use couplet_check::{arch, problem};
use couplet_number::number;
