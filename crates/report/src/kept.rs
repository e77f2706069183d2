//! A value that a query has beside the arch.

/// Value that is handed on from a query to its answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kept {
    /// A text.
    Text(String),
    /// JSON, as it was written.
    Json(String),
}

impl Kept {
    /// The text, or the JSON as it was written.
    pub fn text(&self) -> &str {
        match self {
            Self::Text(text) | Self::Json(text) => text,
        }
    }
}
