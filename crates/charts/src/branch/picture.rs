//! A branch as a picture.

use super::BranchArches;
use crate::atlas::{Branch, Level};
use crate::branch_picture;
use crate::picture::Print;
use crate::report::words::model;
use std::io;

/// The picture as SVG.
pub(crate) fn picture(all: &BranchArches, print: &Print) -> io::Result<String> {
    let found = all.arches.iter().filter_map(|arch| arch.found.as_ref().ok());
    let found: Vec<(&Branch, &Level)> = found.map(|(branch, least)| (branch, least)).collect();
    let Some((branch, _)) = found.first() else {
        let why = all.arches.first().and_then(|arch| arch.found.as_ref().err());
        let why = why.map_or_else(String::new, ToString::to_string);
        return Err(io::Error::other(format!("there is nothing to draw: {why}")));
    };
    let weights: Vec<String> = match &found[..] {
        [(one, _)] => vec![model(one.weight)],
        all => {
            let panel = |(branch, letter): (&(&Branch, &Level), char)| {
                format!("{} ({letter})", model(branch.0.weight))
            };
            all.iter().zip('a'..).map(panel).collect()
        }
    };
    let open: Vec<String> = all.arches.iter().flat_map(super::BranchArch::open).collect();
    let words = format!("half opening {}, {}", branch.half_opening, weights.join(" and "));
    branch_picture::branches(&found, (&words, &open, &all.command), print)
}
