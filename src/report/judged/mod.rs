//! Other people's results, judged: every row, or what there is to say of all of them.

mod json;
mod rows;
mod summary;
mod table;

pub use rows::JudgedRows;
pub use summary::JudgeSummary;

use super::reason;
use crate::judge::{CorrectDigits, Judgement, Standing, Verdict};
use std::io;

/// A row of results, judged or not.
#[derive(Clone, Debug)]
pub struct JudgedRow {
    /// Its line in the file.
    pub line: u64,
    /// The self-weight model as given.
    pub weight: String,
    /// The half opening as given.
    pub half_opening: String,
    /// The friction as given.
    pub friction: String,
    /// Whether it is claimed that the arch stands.
    pub claimed_stands: Option<bool>,
    /// The mode that is claimed.
    pub claimed_mode: Option<&'static str>,
    /// The judgement, or why the row cannot be read.
    pub outcome: Result<Judgement, String>,
}

impl JudgedRow {
    /// What is said of it as a whole.
    pub fn verdict(&self) -> Verdict {
        self.outcome.as_ref().map_or(Verdict::BadRow, |judgement| judgement.verdict)
    }

    /// Whether the arch stands, if that is certain.
    fn stands(&self) -> Option<bool> {
        match self.outcome.as_ref().ok()?.standing {
            Standing::Stands(_) => Some(true),
            Standing::Falls(_) => Some(false),
            Standing::Undecided(_) => None,
        }
    }

    /// The certified mode, or all that meet where it is not decided.
    fn modes(&self) -> String {
        match self.outcome.as_ref().map(|judgement| &judgement.standing) {
            Ok(Standing::Stands(mode)) => mode.label().to_owned(),
            Ok(Standing::Undecided(doubt)) => {
                doubt.between.iter().map(|mode| mode.label()).collect::<Vec<_>>().join(" ")
            }
            _ => String::new(),
        }
    }

    /// Why it falls, is undecided or cannot be read.
    fn reason(&self) -> &str {
        match &self.outcome {
            Err(error) => error,
            Ok(judgement) => match &judgement.standing {
                Standing::Stands(_) => "",
                Standing::Falls(fall) => reason(*fall),
                Standing::Undecided(doubt) => doubt.question,
            },
        }
    }
}

/// A number of digits, or `inf` for a number that is exactly the truth.
fn digits(correct: CorrectDigits) -> String {
    match correct {
        CorrectDigits::Digits(digits) => digits.to_string(),
        CorrectDigits::Exact => "inf".to_owned(),
    }
}

impl JudgeSummary {
    /// Writes it for a person.
    pub fn write_table(&self, out: &mut dyn io::Write) -> io::Result<()> {
        table::write(self, out)
    }

    /// Writes how many rows have which verdict, and how many pass, for a person.
    pub fn write_verdicts(&self, out: &mut dyn io::Write) -> io::Result<()> {
        table::verdicts(self, out)
    }

    /// Writes it for a program.
    pub fn write_json(&self, out: &mut dyn io::Write) -> io::Result<()> {
        json::summary(self, out)
    }
}
