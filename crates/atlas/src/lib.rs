//! The map as data: its curves from end to end, each proved for every value of a parameter.
//!
//! A [`Curve`] is followed by [`Trace::new`] in pieces. On each a [tube](Trace) about a cubic holds exactly one
//! solution for every parameter; neighbouring tubes join; the ends are landmarks. A [`Level`] is the line of one
//! half opening, thickness or friction, mode by mode; a [`Difference`] is that of two weights along the lines;
//! [`boundary`] has the domains of the modes as loops of curves. A [`Sketch`] is an arch to be drawn.
//!
//! ```
//! use couplet_check::arch::SelfWeight;
//! use couplet_atlas::{Curve, Trace};
//! let curve = Curve::named("rrr/srr").unwrap();
//! let trace = Trace::new(curve, SelfWeight::Heyman, 1e-4)?;
//! assert_eq!(trace.gaps().count(), 0);
//! assert!(trace.width() <= 1e-4);
//! # Ok::<(), couplet_prove::certify::Undecided>(())
//! ```
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

mod arc;
mod asymmetric;
mod cell;
mod cells;
mod contour;
mod crossing;
mod cubic;
mod curve;
mod difference;
mod domain;
mod end;
mod form;
mod law;
mod level;
mod part;
mod place;
mod point;
mod rotation_end;
mod search;
mod section;
mod sketched;
mod spot;
mod tangent;
mod trace;
mod tube;
mod variable;
mod walk;

pub use arc::{Coordinate, CubicArc, arc};
pub use asymmetric::{Border, BorderLine, Branch, Meeting, NoBranch, Stretch};
pub use cells::Areas;
pub use contour::Contour;
pub use curve::Curve;
pub use difference::{Difference, DifferencePoint, Divide, LEAST_DIFFERENCE, Step};
pub use domain::{Corner, DomainSide, boundary};
pub use end::CurveEnd;
pub use level::{Level, NoLevel};
pub use part::Part;
pub use place::Place;
pub use point::{NoPoint, point};
pub use rotation_end::{over_joint, rotation_end, rotation_start};
pub use section::Section;
pub use sketched::{
    BandedArch, Block, Bound, Collapse, Forces, Mark, Moved, NoSketch, Passed, Sketch,
    SketchedLine, Stability, Subject, moved,
};
pub use tangent::tangent;
pub use trace::{LEAST_TOLERANCE, Piece, Trace, TracePoint};
pub use variable::Variable;

use couplet_check::{arch, check, problem};
use couplet_draw::sketch;
use couplet_number::number;
use couplet_prove::{certify, prover};
use couplet_solve as solve;
