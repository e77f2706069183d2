//! Content of a panel.

use crate::picture::scale::Scale;

/// Lines over two axes.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Title above the panel; may be empty.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Lines with one label look the same in all panels.
    pub lines: Vec<PlottedLine>,
}

/// Range and name of an axis.
#[derive(Clone, Debug)]
pub struct Axis {
    /// The quantity, with its unit.
    pub label: String,
    /// Scale on which values lie.
    pub scale: Scale,
}

/// Points with a label.
#[derive(Clone, Debug)]
pub struct PlottedLine {
    /// Written at the right end.
    pub label: String,
    /// Points in the order in which they are joined. A point without a place on the axes (a NaN, an infinity,
    /// what is not positive on a logarithmic scale) is a gap.
    pub points: Vec<(f64, f64)>,
    /// Way in which they are joined.
    pub kind: Kind,
}

/// Way in which the points of a line are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// Straight, with markers at the points; where points are dense, at some of them.
    Measured,
    /// Points that are not joined: a marker at every point, and nothing is said of what lies between.
    Points,
    /// Line as [`Kind::Measured`], in a wider stroke and above all others.
    Bold,
    /// A thin bar from each point to the next, up to a gap: the spread of the line that has the same label, without
    /// a name of its own.
    Spread,
    /// A crossed ring at each point: where the line that has the same label has no value, without a name of its own.
    Failures,
    /// Straight, dashed and grey, without markers.
    Reference,
    /// A value holds until the next point; a few markers tell the lines apart.
    Steps,
}

impl PlottedLine {
    /// Tells whether the line is named beside the frame.
    pub(super) fn is_named(&self) -> bool {
        !matches!(self.kind, Kind::Spread | Kind::Failures)
    }
}
