//! What `couplet prove` found: text for a person, LaTeX for a document, JSON for a program.

mod json;
mod latex;
mod text;

use crate::claims::{Decision, Finding};
use std::io;

/// An output format for claims.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ClaimFormat {
    /// For a person at a terminal.
    Text,
    /// A document.
    Latex,
    /// For a program; the schema `couplet.claims/1` is stable.
    Json,
}

/// Claims with what was found of them.
#[derive(Debug)]
pub struct Claims {
    /// One per claim, in the order of the paper.
    pub decisions: Vec<Decision>,
    /// Whether to give the derivations too.
    pub show: bool,
    /// Whether to say how long each took, which is another time in every run.
    pub timed: bool,
}

impl Claims {
    /// Writes the report.
    pub fn write(&self, format: ClaimFormat, out: &mut dyn io::Write) -> io::Result<()> {
        match format {
            ClaimFormat::Text => text::claims(self, out),
            ClaimFormat::Latex => latex::claims(self, out),
            ClaimFormat::Json => json::claims(self, out),
        }
    }
}

/// The word for what became of the statement as it is printed.
fn as_printed(decision: &Decision) -> &'static str {
    match decision.outcome {
        Ok(Finding::AsPrinted) => "proved",
        Ok(Finding::Implicit) => "not stated",
        Ok(Finding::Misprint { .. }) => "refuted",
        Err(_) => "undecided",
    }
}

/// How many claims there are of each kind, in words.
fn summary(decisions: &[Decision]) -> String {
    let count = |word| decisions.iter().filter(|decision| as_printed(decision) == word).count();
    let plural = if decisions.len() == 1 { "" } else { "s" };
    let kinds = [
        ("proved", "proved as printed"),
        ("not stated", "proved, not stated in the paper"),
        ("refuted", "refuted as printed and proved as corrected"),
        ("undecided", "undecided"),
    ];
    let parts: Vec<String> = kinds
        .into_iter()
        .map(|(word, words)| (count(word), words))
        .filter(|(count, _)| *count > 0)
        .map(|(count, words)| format!("{count} {words}"))
        .collect();
    format!("{} claim{plural}: {}", decisions.len(), parts.join(", "))
}
