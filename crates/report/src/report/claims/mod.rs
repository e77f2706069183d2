//! Results of `couplet prove`, `couplet.claims/3`, and the index of the paper.

mod decided;
mod index;
mod latex;
mod record;
mod text;

pub use decided::Claims;
pub use index::Index;
