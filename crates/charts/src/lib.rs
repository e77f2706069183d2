//! The curves of the map in every format: a summary for a person, their nodes, pictures, and a page to point at.
//!
//! | file | what it does |
//! |---|---|
//! | `drawing` | which picture is asked for, and its file |
//! | `plane` | what lies along the axes |
//! | `canvas` | a plane with its axes, in the units and ranges asked for |
//! | `chain` | a proved curve as Bézier arcs in a plane |
//! | `domain` | the domains of the modes, by the curves around them |
//! | `look` | how the modes and the weights look |
//! | `sheet` | what a picture is drawn from: proved curves of one weight |
//! | `spot` | where the names of landmarks stand |
//! | `names` | the names of landmarks and modes |
//! | `content` | what a map shows, in its frame or in an inset |
//! | `inset` | small frames that show a part of the map larger |
//! | `framed` | the map of one weight in one plane, for a page that places what is around it |
//! | `page` | the page of a map: its frame with the axes, and what is said below |
//! | `margin` | the values of levels, outside the frame |
//! | `mark`, `marked` | arches that are marked in a map, and how they are asked for |
//! | `map_picture` | the map of one weight |
//! | `lines`, `known` | the lines of both weights, with their landmarks and tangents in digits |
//! | `branches`, `graph` | the pure states along the half opening, as graphs |
//! | `asymmetric` | what asymmetric branches reach |
//! | `difference` | what two weights make of the lines, as graphs |
//! | `caption` | what is said below |
//! | `asked` | what is to be shown, and whether it goes together |
//! | `map`, `branch` | the records of a map, of the differences of two weights, and of asymmetric branches |
//!
//! A piece of a curve is proved to lie in a tube about a cubic of the parameter, and the drawn Bézier arc is that
//! cubic: the line in the picture is nowhere further from the true one than the tube is wide, but for the thousandth of
//! a unit to which the file is rounded.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

mod asked;
mod asymmetric;
mod branch;
mod branches;
mod canvas;
mod caption;
mod chain;
mod content;
mod difference;
mod domain;
mod drawing;
mod framed;
mod graph;
mod inset;
mod known;
mod lines;
mod look;
mod map;
mod map_picture;
mod margin;
mod mark;
mod marked;
mod names;
mod page;
mod plane;
#[cfg(test)]
#[path = "../../draw/src/picture/reading.rs"]
mod reading;
mod sheet;
mod spot;

pub use asked::MapAsked;
pub use branch::{BranchArch, BranchArches};
pub use branches::Branches;
pub use canvas::{Axes, Shown, Unit};
pub use drawing::{Drawing, View};
pub use map::{Map, MapDifferences, MapPoint};
pub use mark::Mark;
pub use marked::Marked;
pub use plane::Plane;

use couplet_ask as ask;
use couplet_atlas as atlas;
use couplet_check::{arch, problem};
use couplet_draw::picture;
use couplet_number::number;
use couplet_prove::certify;
use couplet_report as report;

#[cfg(test)]
mod tests;
