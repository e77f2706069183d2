//! Figures: panels of labelled lines.
//!
//! | file | what it does |
//! |---|---|
//! | `drawing` | panels in rows, under a title |
//! | `panel` | what a panel shows |
//! | `drawn` | the room that a panel needs, and how it is drawn |
//! | `ink` | the colour, dashes and marker of a line |
//!
//! The text is the same whenever the figure is the same.

mod drawing;
mod drawn;
mod ink;
mod panel;

pub use crate::picture::scale::Scale;
pub use drawing::Figure;
pub use panel::{Axis, Kind, Panel, PlottedLine};

#[cfg(test)]
mod tests;
