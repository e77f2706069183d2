//! Arches as pictures: the arch, its lines of thrust and of friction, and how it falls, with all that is said of them.
//! [`sketch`] draws the arch itself.
//!
//! | file | what it does |
//! |---|---|
//! | `page` | the page: panels, legend, caption |
//! | `sheet` | what stands above and below all of it |
//! | `beside` | the room beside arches |
//! | `panel` | one arch with its heading and names |
//! | `joints` | the names of its joints |
//! | `strip` | a thin arch, unrolled |
//! | `metres` | what an arch measures |
//! | `dimensions` | that beside the picture |
//! | `legend` | what is what |
//! | `caption` | what is said above and below |
//! | `numbers`, `motion` | numbers, and words on motions, of both |
//! | `falling` | what is proved of an arch that falls, and what is a drawing only |
//! | `notation` | the symbols, as Figure 1 has them |
//! | `figures` | which arches the paper shows |
//! | `json`, `dxf` | the geometry for other programs |
//! | `formats` | the formats in which arches are drawn |
//! | `lean` | JSON with lists on one line |
//! | `survey` | all arches of a question with ranges |
//! | `tilt` | an arch under the largest acceleration that it bears |
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

mod beside;
mod caption;
mod dimensions;
mod dxf;
mod falling;
mod figures;
mod formats;
mod joints;
mod json;
mod lean;
mod legend;
mod metres;
mod motion;
mod notation;
mod numbers;
mod page;
mod panel;
#[cfg(test)]
#[path = "../../draw/src/picture/reading.rs"]
mod reading;
mod sheet;
mod strip;
mod survey;
mod tilt;

pub use figures::arches_of_figure;
pub use survey::BandedArches;
pub use tilt::TiltDrawing;

use crate::arch::mechanism::Contact;
use crate::atlas::{Collapse, Sketch};
use crate::number::Ball;
use crate::problem::measures::Measures;
use couplet_atlas as atlas;
use couplet_check::{arch, problem};
use couplet_draw::{picture, sketch};
use couplet_number::number;
use couplet_report as report;
use metres::Metres;
use std::ops::RangeInclusive;

/// Arches to be drawn, beside each other.
#[derive(Debug)]
pub struct Sketched {
    /// The arches.
    pub sketches: Vec<Sketch>,
    /// Style in which they are drawn.
    pub style: Style,
    /// Measures of the arches, if they are measured.
    pub measures: Option<Measures>,
    /// Frictions between which each arch collapses as it is drawn, where modes of one half opening are beside each
    /// other.
    pub between: Vec<[Option<Ball>; 2]>,
    /// The command that makes it, for its caption.
    pub command: String,
}

/// Style of an arch.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// Distance by which the corner that moves most has moved, in units of `r`.
    pub amplitude: f64,
    /// True if only the right half is drawn.
    pub half: bool,
    /// Arrows from where the blocks were to where they are.
    pub arrows: bool,
    /// The blocks move.
    pub animate: bool,
    /// The symbols of the paper, as Figure 1 has them, with the mechanism on the right.
    pub notation: bool,
}

impl Style {
    /// Amplitudes that can be asked for, in units of `r`.
    pub const AMPLITUDES: RangeInclusive<f64> = 0.001..=1.0;
    /// Stones that can be asked for.
    pub const STONES: RangeInclusive<u32> = 2..=500;

    /// Style of a figure of the paper.
    pub fn of_figure(number: usize) -> Self {
        Self { notation: number == 1, ..Self::default() }
    }
}

impl Default for Style {
    fn default() -> Self {
        let (half, arrows, animate) = (false, false, false);
        Self { amplitude: 0.12, half, arrows, animate, notation: false }
    }
}

impl Sketched {
    /// Measures of an arch, if it has any.
    fn metres(&self, sketch: &Sketch) -> Option<Metres> {
        Some(Metres::new(self.measures.as_ref()?, sketch))
    }

    /// Tells whether the sizes of the arches, if there are any, can be drawn: a radius from a millimetre to a
    /// thousand kilometres, and forces that doubles hold.
    pub fn can_be_drawn(&self) -> bool {
        self.sketches.iter().filter_map(|sketch| self.metres(sketch)).all(|of| of.can_be_drawn())
    }

    /// Panels: each arch with a mode in which it falls, or with none.
    fn panels(&self) -> impl Iterator<Item = (&Sketch, Option<&Collapse>)> {
        self.sketches.iter().flat_map(|sketch| shown(sketch).map(move |one| (sketch, one)))
    }
}

/// The joints that give way in a mode, or of none those at their limits.
fn at_limit(sketch: &Sketch, collapse: Option<&Collapse>) -> Vec<(Contact, f64)> {
    let marks = || sketch.forces.iter().flat_map(|of| &of.marks).map(|mark| mark.place());
    collapse.map_or_else(|| marks().collect(), Collapse::joints_at_limit)
}

/// The modes in which an arch is shown, or none.
fn shown(sketch: &Sketch) -> impl Iterator<Item = Option<&Collapse>> {
    let alone = sketch.collapses.is_empty().then_some(None);
    sketch.collapses.iter().map(Some).chain(alone)
}

#[cfg(test)]
mod tests;
