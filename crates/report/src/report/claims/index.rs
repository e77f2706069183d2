//! The paper, place by place, with what became of the claims that decide each sentence, `couplet.index/1`. Fields may
//! be added, none changes its meaning.

use super::decided::as_printed;
use super::text::lines;
use crate::claims::{Decided, Decision, Sentence, index};
use crate::report::format::Content;
use crate::report::record::Record;
use crate::report::reported::Reported;
use crate::report::tabular::Tabular;
use crate::report::words::count;

/// The index of the paper.
#[derive(Debug)]
pub struct Index {
    /// Decisions, one per claim, as they were decided.
    pub decisions: Vec<Decision>,
}

impl Index {
    /// The claims that decide a sentence, each with the word for what became of it.
    fn claims(&self, sentence: &Sentence) -> Vec<(&str, &str)> {
        let Decided::Claims(ids) = sentence.decided else { return Vec::new() };
        let decision = |id: &&str| self.decisions.iter().find(|d| d.claim.id == *id);
        let entry = |d: &Decision| (d.claim.id, as_printed(d));
        ids.iter().filter_map(decision).map(entry).collect()
    }

    /// A sentence, behind its place in `width` characters.
    fn sentence(&self, sentence: &Sentence, width: usize) -> Record {
        let mut record = Record::default();
        let indent = " ".repeat(width + 2);
        record.say_all(lines(sentence.says, &format!("{:<width$}  ", sentence.place), &indent));
        record.add("place", sentence.place);
        record.add("says", sentence.says);
        record.add("decided", decided(sentence));
        let claim = |(id, found): (&str, &str)| {
            let mut record = Record::named("id found", [id.into(), found.into()]);
            record.say(format!("{indent}{found:<10} {id}"));
            record
        };
        record.add_list("claims", self.claims(sentence).into_iter().map(claim));
        let reason = match sentence.decided {
            Decided::Open(reason) => {
                record.say_all(lines(reason, &format!("{indent}open       "), &indent));
                Some(reason)
            }
            Decided::Audit => {
                record.say(format!("{indent}{:<10} couplet audit", "digits"));
                None
            }
            Decided::Claims(_) => None,
        };
        record.add("reason", reason);
        record
    }
}

/// The word for what decides a sentence.
fn decided(sentence: &Sentence) -> &'static str {
    match sentence.decided {
        Decided::Claims(_) => "claims",
        Decided::Audit => "audit",
        Decided::Open(_) => "open",
    }
}

impl Reported for Index {
    fn content() -> Content {
        Content(&["text", "json", "csv", "csv2", "latex", "markdown"])
    }

    fn records(&self) -> Vec<Record> {
        let mut record = Record::of("couplet.index/1");
        let all = index();
        let place = all.iter().map(|sentence| sentence.place.chars().count()).max().unwrap_or(0);
        record.add_list("sentences", all.iter().map(|sentence| self.sentence(sentence, place)));
        let of = |kind| all.iter().filter(|sentence| decided(sentence) == kind).count();
        let sentences = count(all.len(), "sentence", "sentences");
        let [claims, audit, open] = ["claims", "audit", "open"].map(of);
        record
            .say(format!("{sentences}: {claims} by claims, {audit} by couplet audit, {open} open"));
        vec![record]
    }

    fn tabular(&self) -> Tabular {
        let rows = index().into_iter().map(|sentence| {
            let mut row = self.sentence(&sentence, 0);
            let ids: Vec<&str> = self.claims(&sentence).into_iter().map(|(id, _)| id).collect();
            row.add("claims", ids.join("; "));
            row
        });
        Tabular::of("place says decided claims reason", rows)
    }
}
