//! Pictures: strokes, fills and texts as SVG, and that as pixels or as a page.
//!
//! | file | what it does |
//! |---|---|
//! | `color` | the colours |
//! | `path` | straight and curved lines |
//! | `svg` | the one writer of SVG |
//! | `page` | what is drawn, and its words below |
//! | `print` | how a picture is printed: its width, its letters, its words |
//! | `text` | the width of a text, its lines, powers of ten |
//! | `scale` | where a value lies on an axis, and the ticks |
//! | `spread` | labels pushed apart |
//! | `frame` | a window onto a plane, with its axes |
//! | `room`, `labels` | where a label has room: in an area, beside a point |
//! | [`figure`] | panels of labelled lines |
//! | `arcs` | a chain of points as few arcs |
//! | `dxf` | the writer of DXF |
//! | `tree` | SVG as a renderer reads it (feature `plots`) |
//! | `png`, `pdf` | that as pixels, and as a page (feature `plots`) |
//!
//! The text is the same whenever the picture is the same. What is drawn is decided elsewhere: nothing here
//! knows of arches; a file of DXF names its unit, which may be their radius.

pub mod arcs;
pub mod color;
pub mod dxf;
pub mod figure;
pub mod frame;
pub mod labels;
pub mod page;
pub mod path;
#[cfg(feature = "plots")]
pub mod pdf;
#[cfg(feature = "plots")]
pub mod png;
pub mod print;
#[cfg(test)]
mod reading;
pub mod room;
pub mod scale;
pub mod spread;
pub mod svg;
pub mod text;
#[cfg(feature = "plots")]
pub mod tree;

pub use color::Color;
pub use frame::{Frame, FrameSide};
pub use page::Page;
pub use path::{Path, Point};
pub use print::{Font, PaperLength, Print};
pub use svg::{Anchor, Hatch, Name, Rigid, Stroke, Svg, Type};
