//! The paper, place by place, with what became of the claims that decide each sentence: text, and JSON,
//! `couplet.index/1`. Fields may be added, none changes its meaning.

use super::decided::as_printed;
use super::text::lines;
use crate::claims::{Decided, Decision, Sentence, index};
use crate::report::fields::Fields;
use crate::report::json;
use crate::report::words::count;
use std::io;

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
}

/// The word for what decides a sentence.
fn decided(sentence: &Sentence) -> &'static str {
    match sentence.decided {
        Decided::Claims(_) => "claims",
        Decided::Audit => "audit",
        Decided::Open(_) => "open",
    }
}

/// The index as a file.
pub(crate) fn json(report: &Index, out: &mut dyn io::Write) -> io::Result<()> {
    let claim = |(id, found): (&str, &str)| Fields::named("id found", [id.into(), found.into()]);
    let entry = |sentence: Sentence| {
        let mut fields = Fields::default();
        fields.add("place", sentence.place);
        fields.add("says", sentence.says);
        fields.add("decided", decided(&sentence));
        fields.add_list("claims", report.claims(&sentence).into_iter().map(claim));
        let reason = match sentence.decided {
            Decided::Open(reason) => Some(reason),
            Decided::Claims(_) | Decided::Audit => None,
        };
        fields.add("reason", reason);
        fields
    };
    let mut file = Fields::of("couplet.index/1");
    file.add_list("sentences", index().into_iter().map(entry));
    json::write(&file, out)
}

/// The index for a person at a terminal.
pub(crate) fn text(report: &Index, out: &mut dyn io::Write) -> io::Result<()> {
    let all = index();
    let place = all.iter().map(|sentence| sentence.place.chars().count()).max().unwrap_or(0);
    let indent = " ".repeat(place + 2);
    for sentence in &all {
        let first = format!("{:<place$}  ", sentence.place);
        lines(sentence.says, &first, &indent, out)?;
        match sentence.decided {
            Decided::Claims(_) => {
                for (id, found) in report.claims(sentence) {
                    writeln!(out, "{indent}{found:<10} {id}")?;
                }
            }
            Decided::Audit => writeln!(out, "{indent}{:<10} couplet audit", "digits")?,
            Decided::Open(reason) => lines(reason, &format!("{indent}open       "), &indent, out)?,
        }
    }
    let of = |kind| all.iter().filter(|sentence| decided(sentence) == kind).count();
    writeln!(
        out,
        "{}: {} by claims, {} by couplet audit, {} open",
        count(all.len(), "sentence", "sentences"),
        of("claims"),
        of("audit"),
        of("open")
    )
}
