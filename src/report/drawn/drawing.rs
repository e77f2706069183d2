//! Which picture is asked for, and its file.

use super::branches::Branches;
use super::lines::LinesPicture;
use super::map::MapPicture;
use super::plane::Plane;
use super::sheet::Sheet;
use crate::atlas::Trace;
use std::io;

/// The picture that some curves are drawn as.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// What it shows.
    pub view: View,
    /// The command that makes it, for its caption.
    pub command: String,
}

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// The map of one weight in a plane; of several, of the first.
    Map(Plane),
    /// The lines of all weights over thickness and friction.
    Lines,
    /// The pure states of all weights, as graphs.
    Branches(Branches),
}

impl Drawing {
    /// The picture of some curves as SVG; nothing to draw is an error.
    pub(in crate::report) fn svg(&self, traces: &[Trace]) -> io::Result<String> {
        let sheets = Sheet::all(traces);
        let command = &self.command;
        Ok(match self.view {
            View::Map(plane) => {
                let first = sheets.first();
                let sheet = first.ok_or_else(|| io::Error::other("there is nothing to draw"))?;
                MapPicture { sheet, plane, command }.svg()
            }
            View::Lines => LinesPicture { sheets: &sheets, command }.svg(),
            View::Branches(branches) => branches.svg(&sheets, command),
        })
    }
}
