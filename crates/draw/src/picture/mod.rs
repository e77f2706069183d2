//! Pictures: strokes, fills and texts as SVG, and that as pixels.
//!
//! | file | what it does |
//! |---|---|
//! | `color` | the colours |
//! | `path` | straight and curved lines |
//! | `svg` | the one writer of SVG |
//! | `text` | the width of a text, its lines, powers of ten |
//! | `scale` | where a value lies on an axis, and the ticks |
//! | `spread` | labels pushed apart |
//! | `frame` | a window onto a plane, with its axes |
//! | `room` | where a label has room |
//! | [`figure`] | panels of labelled lines |
//! | `png` | SVG as pixels (feature `plots`) |
//!
//! The text is the same whenever the picture is the same. What is drawn is decided elsewhere: nothing here
//! knows of arches.

pub mod color;
pub mod figure;
pub mod frame;
pub mod path;
#[cfg(feature = "plots")]
pub mod png;
#[cfg(test)]
mod reading;
pub mod room;
pub mod scale;
pub mod spread;
pub mod svg;
pub mod text;

pub use color::Color;
pub use frame::{Frame, FrameSide};
pub use path::{Path, Point};
pub use svg::{Anchor, Hatch, Rigid, Stroke, Svg, Type};
