//! An arch as it is drawn: its lines of thrust and of friction, the joints at their limits, how it falls, and all
//! that as SVG.
//!
//! | file | what it does |
//! |---|---|
//! | `line` | a line through the arch as a chain of points |
//! | `forces` | a thrust with the lines that belong to it |
//! | `collapse` | a mode: joints, rates, twists, the balance of power |
//! | `falling` | an arch that does not stand: a line of thrust that leaves it, and the mechanism that its weight drives |
//! | `moved` | the blocks after a finite motion |
//! | `blocks` | the same on the page, at rest or moving |
//! | `linkage` | the blocks of the whole arch after a finite motion, where its halves differ |
//! | `view` | one arch on the page |
//! | `whole` | one arch whose halves differ on the page |
//! | `hull` | the room that an arch takes |
//! | `scale` | from units of `r` to the page |
//! | `look` | colours and lines |
//! | `picture` | that arch alone, as a picture |
//!
//! It is one text over any enclosure that can be seen as doubles: balls of MPFR for `couplet draw`, balls of
//! double-doubles where there is no C compiler, as in a browser. What it says is as certain as the configuration
//! that it is given.

mod blocks;
mod collapse;
mod falling;
mod forces;
mod hull;
mod line;
mod linkage;
pub mod look;
mod moved;
mod picture;
mod scale;
mod view;
mod whole;

pub use blocks::{Blocks, arrow};
pub use collapse::{Collapse, NoCollapse};
pub use falling::{falling, furthest_haunch};
pub use forces::{Forces, Lines, Mark, joints_of, moment_of};
pub use hull::Hull;
pub use line::{SketchedLine, across};
pub use linkage::Linkage;
pub use moved::{Block, Moved, moved};
pub use picture::picture;
pub use scale::{PageScale, faces, polar};
pub use view::{ArchView, CROWN, on_sides};
pub use whole::WholeView;
