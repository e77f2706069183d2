//! Arches as pictures: the arch, its lines of thrust and of friction, and how it falls.
//!
//! | file | what it does |
//! |---|---|
//! | `picture` | the page: panels, legend, caption |
//! | `panel` | one arch |
//! | `blocks` | the blocks as they fall, at rest or moving |
//! | `strip` | a thin arch, unrolled |
//! | `scale` | from units of `r` to the page |
//! | `look` | colours and lines |
//! | `legend` | what is what |
//! | `caption` | what is said above and below |
//! | `json`, `dxf` | the geometry for other programs |

mod blocks;
mod caption;
mod dxf;
mod json;
mod legend;
mod look;
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

/// Arches to be drawn, beside each other.
#[derive(Debug)]
pub struct Sketched {
    /// The arches.
    pub sketches: Vec<Sketch>,
    /// How they are drawn.
    pub style: Style,
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
    /// Each arch with a mode in which it falls, or with none.
    fn panels(&self) -> impl Iterator<Item = (&Sketch, Option<&Collapse>)> {
        self.sketches.iter().flat_map(|sketch| {
            let alone = sketch.collapses.is_empty().then_some((sketch, None));
            sketch.collapses.iter().map(move |collapse| (sketch, Some(collapse))).chain(alone)
        })
    }
}

#[cfg(test)]
mod tests;
