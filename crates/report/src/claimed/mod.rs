//! Results of `couplet prove`, `couplet.claims/3`, and the index of the paper.

mod decided;
mod index;
mod latex;
mod record;
mod text;

pub use decided::Claims;
pub use index::Index;

use crate::format::{Content, Format};
use crate::record::Record;
use crate::reported::Reported;
use crate::tabular::Tabular;
use decided::summary;
use std::io;

impl Reported for Claims {
    fn content() -> Content {
        Content(&["text", "json", "csv", "csv2", "latex", "markdown"])
    }

    fn records(&self) -> Vec<Record> {
        let mut all = Record::of("couplet.claims/3");
        all.add_list("claims", self.decisions.iter().map(|of| record::of(self, of)));
        all.say(summary(&self.decisions));
        vec![all]
    }

    fn tabular(&self) -> Tabular {
        let columns = "id place statement as_printed verdict counterexample corrected reason";
        Tabular::of(columns, self.decisions.iter().map(|of| record::of(self, of)))
    }

    /// A document, with the derivations.
    fn write_as(&self, format: &Format, out: &mut dyn io::Write) -> Option<io::Result<()>> {
        (format.name == "latex").then(|| latex::claims(self, out))
    }
}
