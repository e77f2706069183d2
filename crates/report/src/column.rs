//! Columns of rows that are no fields: each finds its cells, which CSV, JSON and Parquet write alike.

use serde_json::Value as Json;
use std::fmt::{Display, Write};

/// Way to find the cells of a column; each may be missing.
#[derive(Clone, Copy)]
pub enum Column<R> {
    /// A text.
    Text(fn(&R) -> Option<&str>),
    /// A text that is made of several.
    Made(fn(&R) -> Option<String>),
    /// A value, written as it is shown.
    Shown(fn(&R) -> Option<&dyn Display>),
    /// A double.
    Double(fn(&R) -> Option<f64>),
    /// A whole number.
    Integer(fn(&R) -> Option<u64>),
    /// True or false.
    Truth(fn(&R) -> Option<bool>),
}

/// A column with its name.
pub type NamedColumn<R> = (&'static str, Column<R>);

impl<R> Column<R> {
    /// The cell of a row, empty where there is nothing.
    pub fn text(&self, row: &R) -> String {
        let mut text = String::new();
        self.write(row, &mut text);
        text
    }

    /// Writes the cell of a row behind a text.
    pub fn write(&self, row: &R, text: &mut String) {
        // A text takes everything.
        let _ = match self {
            Self::Text(cell) => cell(row).map_or(Ok(()), |cell| text.write_str(cell)),
            Self::Made(cell) => cell(row).map_or(Ok(()), |cell| text.write_str(&cell)),
            Self::Shown(cell) => cell(row).map_or(Ok(()), |cell| write!(text, "{cell}")),
            Self::Double(cell) => cell(row).map_or(Ok(()), |x| write!(text, "{x:?}")),
            Self::Integer(cell) => cell(row).map_or(Ok(()), |x| write!(text, "{x}")),
            Self::Truth(cell) => cell(row).map_or(Ok(()), |x| write!(text, "{x}")),
        };
    }

    /// The field of a row; an infinite number is the text `inf`.
    pub fn json(&self, row: &R) -> Json {
        let number = |x: f64| if x.is_finite() { Json::from(x) } else { "inf".into() };
        match self {
            Self::Text(cell) => cell(row).into(),
            Self::Made(cell) => cell(row).into(),
            Self::Shown(cell) => cell(row).map(ToString::to_string).into(),
            Self::Double(cell) => cell(row).map_or(Json::Null, number),
            Self::Integer(cell) => cell(row).into(),
            Self::Truth(cell) => cell(row).into(),
        }
    }
}
