//! Claims with what was found of them, and the words for it.

use crate::claims::{Argument, Decision, Finding, Support};
use crate::words::count;

/// Claims with what was found of them.
#[derive(Debug)]
pub struct Claims {
    /// Decisions, one per claim, in the order of the paper.
    pub decisions: Vec<Decision>,
    /// True if the derivations are given too.
    pub show: bool,
    /// True if the time that each took is given, which is another time in every run.
    pub timed: bool,
}

/// The word for what became of the statement as it is printed.
pub(super) fn as_printed(decision: &Decision) -> &'static str {
    match decision.outcome {
        Ok(Finding::AsPrinted) => "proved",
        Ok(Finding::Implicit) => "not stated",
        Ok(Finding::Equality { .. }) => "equality",
        Ok(Finding::Measured { .. }) => "measured",
        Ok(Finding::Misprint { .. }) => "refuted",
        Err(_) => "undecided",
    }
}

/// Verdict on the statement, in one of three words: what holds with equality in some places, or with a
/// number, is proved.
pub(super) fn verdict(decision: &Decision) -> &'static str {
    match decision.outcome {
        Ok(Finding::Misprint { .. }) => "refuted",
        Ok(_) => "proved",
        Err(_) => "undecided",
    }
}

/// Remarks beside the verdict, each with what it is: `as printed`, `corrected`, `holds with`.
pub(super) fn remarks(decision: &Decision) -> Vec<(&'static str, &str)> {
    match &decision.outcome {
        Ok(Finding::AsPrinted | Finding::Implicit) => Vec::new(),
        Ok(Finding::Equality { at }) => vec![("equal", at)],
        Ok(Finding::Measured { holds_with, fails_with }) => {
            vec![("holds with", holds_with), ("does not hold with", fails_with)]
        }
        Ok(Finding::Misprint { counterexample, corrected }) => {
            vec![("as printed", counterexample), ("corrected", corrected)]
        }
        Err(undecided) => vec![("reason", &undecided.reason)],
    }
}

/// The word before a step, in a text and in a document.
pub(super) fn lead(support: Support) -> [&'static str; 2] {
    match support {
        Support::Hypothesis => ["given", "Given: "],
        Support::Definition => ["let", "Let: "],
        Support::Algebra => ["exact", "Exactly: "],
        Support::Balls => ["balls", "By balls: "],
        Support::Claim => ["by", "By "],
        Support::Theorem => ["coq", "In Coq: "],
        Support::Conclusion => ["so", "So: "],
        Support::Argument => ["words", "In words: "],
    }
}

/// Number of claims of each kind, in words.
pub(super) fn summary(decisions: &[Decision]) -> String {
    let of = |word| decisions.iter().filter(|decision| as_printed(decision) == word).count();
    let kinds = [
        ("proved", "proved as printed"),
        ("not stated", "proved, not stated in the paper"),
        ("equality", "proved with equality in some places"),
        ("measured", "proved with a number"),
        ("refuted", "refuted as printed and proved as corrected"),
        ("undecided", "undecided"),
    ];
    let parts: Vec<String> = kinds
        .into_iter()
        .map(|(word, words)| (of(word), words))
        .filter(|(of, _)| *of > 0)
        .map(|(of, words)| format!("{of} {words}"))
        .collect();
    let with = |support: Support, words: &str| {
        let has = |d: &&Decision| d.derivation.steps().iter().any(|step| step.support == support);
        match decisions.iter().filter(has).count() {
            0 => String::new(),
            of => format!("; {of} {words}"),
        }
    };
    let theorems = with(Support::Theorem, "by theorems of Coq");
    let sentences = with(Support::Conclusion, "joined by sentences");
    let argued =
        |place| decisions.iter().filter(|d| d.derivation.argument() == Some(place)).count();
    let arguments = match [Argument::Own, Argument::Beneath].map(argued) {
        [0, 0] => String::new(),
        [own, beneath] => format!("; {own} by an argument in words, {beneath} resting on one"),
    };
    format!(
        "{}: {}{theorems}{arguments}{sentences}",
        count(decisions.len(), "claim", "claims"),
        parts.join(", ")
    )
}
