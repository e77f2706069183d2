//! The paper, place by place, with what became of the claims that decide each sentence, `couplet.index/1`. Fields may
//! be added, none changes its meaning.

use super::decided::as_printed;
use super::text::lines;
use crate::claims::{Claim, Decided, Decision, Sentence, claims, index};
use crate::format::Content;
use crate::record::Record;
use crate::reported::Reported;
use crate::tabular::Tabular;
use crate::words::count;

/// The index of the paper.
#[derive(Debug)]
pub struct Index {
    /// Decisions, one per claim, as they were decided.
    pub decisions: Vec<Decision>,
}

/// Verdicts on a sentence, from the one that outweighs all others on: a sentence is what its weakest claim is.
const VERDICTS: [&str; 8] =
    ["refuted", "undecided", "measured", "equality", "proved", "digits", "opinion", "open"];

/// The word for what became of a claim that decides a sentence: a claim beneath it may be none of the paper.
fn found(decision: &Decision) -> &'static str {
    match as_printed(decision) {
        "not stated" => "proved",
        word => word,
    }
}

impl Index {
    /// The claims that decide a sentence, each with the word for what became of it.
    fn claims(&self, sentence: &Sentence) -> Vec<(&str, &str)> {
        let (Decided::Claims(ids) | Decided::Reading(ids, _)) = sentence.decided else {
            return Vec::new();
        };
        let decision = |id: &&str| self.decisions.iter().find(|d| d.claim.id == *id);
        let entry = |d: &Decision| (d.claim.id, found(d));
        ids.iter().filter_map(decision).map(entry).collect()
    }

    /// Verdict on a sentence.
    fn verdict(&self, sentence: &Sentence) -> &'static str {
        match sentence.decided {
            Decided::Audit => "digits",
            Decided::Claims(_) => {
                let found = self.claims(sentence);
                let is_found = |word: &&&str| found.iter().any(|(_, other)| other == *word);
                VERDICTS.iter().find(is_found).copied().unwrap_or("undecided")
            }
            Decided::Opinion | Decided::Reading(..) | Decided::Open(_) => decided(sentence),
        }
    }

    /// A sentence, behind its place in `width` characters.
    fn sentence(&self, sentence: &Sentence, width: usize) -> Record {
        let mut record = Record::default();
        let indent = " ".repeat(width + 2);
        record.say_all(lines(sentence.says, &format!("{:<width$}  ", sentence.place), &indent));
        record.add("place", sentence.place);
        record.add("says", sentence.says);
        record.add("decided", decided(sentence));
        record.add("verdict", self.verdict(sentence));
        let claim = |(id, found): (&str, &str)| {
            let mut record = Record::named("id found", [id.into(), found.into()]);
            record.say(format!("{indent}{found:<10} {id}"));
            record
        };
        record.add_list("claims", self.claims(sentence).into_iter().map(claim));
        let reason = match sentence.decided {
            Decided::Open(reason) | Decided::Reading(_, reason) => {
                let verdict = self.verdict(sentence);
                record.say_all(lines(reason, &format!("{indent}{verdict:<10} "), &indent));
                Some(reason)
            }
            Decided::Audit => {
                record.say(format!("{indent}{:<10} couplet audit", "digits"));
                None
            }
            Decided::Opinion => {
                record.say(format!("{indent}opinion"));
                None
            }
            Decided::Claims(_) => None,
        };
        record.add("reason", reason);
        record
    }

    /// Number of sentences with each verdict, in words.
    fn summary(&self, all: &[Sentence]) -> String {
        let of = |word: &str| all.iter().filter(|sentence| self.verdict(sentence) == word).count();
        let told = VERDICTS.iter().map(|word| (of(word), word)).filter(|(of, _)| *of > 0);
        let parts: Vec<String> = told.map(|(of, word)| format!("{of} {word}")).collect();
        format!("{}: {}", count(all.len(), "sentence", "sentences"), parts.join(", "))
    }
}

/// The word for what decides a sentence.
fn decided(sentence: &Sentence) -> &'static str {
    match sentence.decided {
        Decided::Claims(_) => "claims",
        Decided::Audit => "audit",
        Decided::Opinion | Decided::Reading(..) => "opinion",
        Decided::Open(_) => "open",
    }
}

/// Claims that decide no sentence.
fn ours() -> Vec<Claim> {
    claims().into_iter().filter(Claim::is_ours).collect()
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
        record.say(self.summary(&all));
        let ours: Vec<_> = ours().iter().map(|claim| claim.id).collect();
        record.say_all(lines(&ours.join(", "), "ours: ", "      "));
        record.add("ours", ours);
        vec![record]
    }

    /// One row a sentence, and one for each claim that decides none.
    fn tabular(&self) -> Tabular {
        let sentences = index().into_iter().map(|sentence| {
            let mut row = self.sentence(&sentence, 0);
            let ids: Vec<&str> = self.claims(&sentence).into_iter().map(|(id, _)| id).collect();
            row.add("claims", ids.join("; "));
            row
        });
        let ours = ours().into_iter().map(|Claim { id, place, statement, .. }| {
            let values = [place, statement, "ours", "proved", id].map(Into::into);
            Record::named("place says decided verdict claims", values)
        });
        Tabular::of(
            "place says decided verdict claims reason",
            sentences.chain(ours).collect::<Vec<_>>(),
        )
    }
}
