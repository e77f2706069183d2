//! Values that are handed on from the rows of the input to those of the output.

use super::columns::{Cells, Columns};
use super::object::JsonObject;
use crate::report::Kept;
use crate::report::words::shortened;
use std::mem;

/// A row as it was read.
pub struct ReadRow {
    /// Cells that are read.
    pub cells: Cells,
    /// Values that are handed on.
    pub kept: Vec<(String, Kept)>,
}

/// Choice of the columns or keys that are handed on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Keep {
    /// All that are not read.
    All,
    /// The columns or keys that are named.
    Named(Vec<String>),
}

impl Keep {
    /// As it is asked for: names, or `all`.
    pub fn new(names: &[String]) -> Self {
        match names {
            [all] if all == "all" => Self::All,
            names => Self::Named(names.to_vec()),
        }
    }

    /// The names that are asked for.
    pub fn named(&self) -> Vec<String> {
        if let Self::Named(names) = self { names.clone() } else { Vec::new() }
    }

    /// The names of the columns of a table that are handed on, with their places.
    pub fn places(
        &self,
        header: &[String],
        columns: &Columns,
    ) -> Result<Vec<(String, usize)>, String> {
        let names: Vec<&String> = match self {
            Self::All => header.iter().filter(|name| !columns.have(name)).collect(),
            Self::Named(names) => names.iter().collect(),
        };
        let place = |name: &String| {
            let mut places = (0..header.len()).filter(|&place| header[place] == *name);
            let count = match (places.next(), places.next()) {
                (Some(place), None) => return Ok((name.clone(), place)),
                (None, _) => "no column",
                (Some(_), Some(_)) => "two columns",
            };
            Err(format!("the file has {count} '{}' to keep", shortened(name)))
        };
        names.into_iter().map(place).collect()
    }

    /// A row of a table, by the places of its cells and of what is handed on.
    pub fn row(mut row: Vec<String>, places: &[usize], kept: &[(String, usize)]) -> ReadRow {
        let text = |place: &usize| Some(Kept::Text(row.get(*place)?.clone()));
        let kept = kept.iter().filter_map(|(name, place)| Some((name.clone(), text(place)?)));
        let kept = kept.collect();
        // Each place is that of one column.
        let cells = places.iter().map(|&place| row.get_mut(place).map(mem::take)).collect();
        ReadRow { cells, kept }
    }

    /// The entries of an object that are handed on.
    pub fn entries(&self, object: &JsonObject, columns: &Columns) -> Vec<(String, Kept)> {
        let is_kept = |name: &str| match self {
            Self::All => !columns.have(name),
            Self::Named(names) => names.iter().any(|kept| kept == name),
        };
        let names = object.names().filter(|name| is_kept(name));
        let entry = |name: &str| Some((name.to_owned(), Kept::Json(object.raw(name)?.to_owned())));
        names.filter_map(entry).collect()
    }
}
