//! Results of `couplet prove`: text for a person, LaTeX for a document, JSON for a program.

mod decided;
mod index;
mod json;
mod latex;
mod text;

pub use decided::Claims;
pub use index::Index;
pub(super) use index::{json as index_json, text as index_text};
pub(super) use json::claims as json;
pub(super) use latex::claims as latex;
pub(super) use text::claims as text;
