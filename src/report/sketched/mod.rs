//! Arches as pictures: the arch, its lines of thrust and of friction, and how it falls.
//!
//! | file | what it does |
//! |---|---|
//! | `picture` | the page: panels, legend, caption |
//! | `panel` | one arch |
//! | `blocks` | the blocks as they fall, at rest or moving |
//! | `strip` | a thin arch, unrolled |
//! | `metres` | what an arch measures |
//! | `dimensions` | that beside the picture |
//! | `scale` | from units of `r` to the page |
//! | `look` | colours and lines |
//! | `legend` | what is what |
//! | `caption` | what is said above and below |
//! | `json`, `dxf` | the geometry for other programs |
//! | `arcs` | a chain of points as few arcs |

mod arcs;
mod blocks;
mod caption;
mod dimensions;
mod dxf;
mod json;
mod legend;
mod look;
mod metres;
mod panel;
mod picture;
mod scale;
mod strip;

pub(super) use dxf::dxf;
pub(super) use json::json;
#[cfg(feature = "plots")]
pub(super) use picture::png;
pub(super) use picture::svg;

use crate::atlas::{Collapse, Sketch};
use crate::problem::measures::Measures;
use metres::Metres;

/// Arches to be drawn, beside each other.
#[derive(Debug)]
pub struct Sketched {
    /// The arches.
    pub sketches: Vec<Sketch>,
    /// How they are drawn.
    pub style: Style,
    /// How large they are, if they are measured.
    pub measures: Option<Measures>,
    /// The command that makes it, for its caption.
    pub command: String,
}

/// How an arch is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// How far the corner that moves most has moved, in units of `r`.
    pub amplitude: f64,
    /// Only the right half.
    pub half: bool,
    /// Arrows from where the blocks were to where they are.
    pub arrows: bool,
    /// Stones of the whole arch, to be shown by their joints.
    pub stones: Option<u32>,
    /// The blocks move.
    pub animate: bool,
}

impl Sketched {
    /// What an arch measures, if it does.
    fn metres(&self, sketch: &Sketch) -> Option<Metres> {
        Some(Metres::new(self.measures.as_ref()?, sketch))
    }

    /// Whether its sizes, if there are any, can be drawn: a radius from a millimetre to a thousand kilometres, and forces
    /// that doubles hold.
    pub fn can_be_drawn(&self) -> bool {
        self.sketches.iter().filter_map(|sketch| self.metres(sketch)).all(|of| of.can_be_drawn())
    }

    /// Each arch with a mode in which it falls, or with none.
    fn panels(&self) -> impl Iterator<Item = (&Sketch, Option<&Collapse>)> {
        self.sketches.iter().flat_map(|sketch| shown(sketch).map(move |one| (sketch, one)))
    }
}

/// The modes in which an arch is shown, or none.
fn shown(sketch: &Sketch) -> impl Iterator<Item = Option<&Collapse>> {
    let alone = sketch.collapses.is_empty().then_some(None);
    sketch.collapses.iter().map(Some).chain(alone)
}

#[cfg(test)]
mod tests;
