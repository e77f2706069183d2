//! Drawing that is asked for, and its file.

use super::branches::Branches;
use super::canvas::{Axes, Canvas};
use super::framed::FramedMap;
use super::lines::LinesPicture;
use super::map_picture::MapPicture;
use super::mark::{self, Mark};
use super::plane::Plane;
use super::sheet::Sheet;
use crate::atlas::{Border, Level, Trace};
use crate::picture::Print;
use std::io;

/// The picture that some curves are drawn as.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// View that it shows.
    pub view: View,
    /// The axes of a map.
    pub axes: Axes,
    /// The arches that are marked in a map.
    pub marks: Vec<Mark>,
    /// The command that makes it, for its caption.
    pub command: String,
}

/// View of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// The map of one weight in a plane; of several, of the first.
    Map(Plane),
    /// The lines of all weights over thickness and friction.
    Lines,
    /// The pure states of all weights, as graphs.
    Branches(Branches),
}

impl View {
    /// View of a figure of the paper; it has 2 to 6.
    pub fn of_figure(number: usize) -> Option<Self> {
        Some(match number {
            2 => Self::Branches(Branches::Rotation),
            3 => Self::Branches(Branches::Overturning),
            4 => Self::Branches(Branches::Joined),
            5 => Self::Lines,
            6 => Self::Map(Plane::ThicknessFriction),
            _ => return None,
        })
    }
}

impl Drawing {
    /// The map of each weight in each plane, with the levels that are lines there and its marks.
    pub(crate) fn framed_maps(&self, traces: &[Trace], levels: &[Level]) -> Vec<FramedMap> {
        let framed = |sheet: &Sheet| {
            let marks = mark::of_weight(&self.marks, sheet.weight);
            Plane::ALL.map(|plane| FramedMap::new(&sheet.crossing(plane), plane, &marks))
        };
        Sheet::all(traces, levels, &[]).iter().flat_map(framed).collect()
    }

    /// The picture of some curves and levels as SVG; nothing to draw is an error.
    pub(crate) fn svg(
        &self,
        (traces, levels, borders): (&[Trace], &[Level], &[Border]),
        print: &Print,
    ) -> io::Result<String> {
        let sheets = Sheet::all(traces, levels, borders);
        let command = &self.command;
        match self.view {
            View::Map(plane) => {
                let first = sheets.first();
                let sheet = first.ok_or_else(|| io::Error::other("there is nothing to draw"))?;
                let canvas = Canvas::new(plane, &self.axes);
                MapPicture { sheet, canvas, marks: &self.marks, command }.svg(print)
            }
            View::Lines => LinesPicture { sheets: &sheets, command }.svg(print),
            View::Branches(branches) => branches.svg(&sheets, command, print),
        }
    }
}
