//! A row as a whole.

use super::claim::Claim;
use super::number::{CorrectDigits, Judged, compared_digits};
use super::truth::Truth;
use crate::certify::Undecided;
use crate::certify::state::{Certify, Fall, Outcome, State, raised};
use crate::problem::Arch;
use crate::problem::{Mode, Quantity};
use std::cmp::Ordering;

/// The verdict on a row, from best to worst, then the rows that cannot be judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// Every number is the correct rounding of the truth, and all else is right.
    CorrectlyRounded,
    /// Everything is right, to the digits demanded.
    Correct,
    /// A number other than the thickness has fewer correct digits.
    Inaccurate,
    /// The thickness has fewer correct digits, and is too large: the safe side.
    Thicker,
    /// The arch collapses in another mode.
    WrongMode,
    /// The arch stands at some thickness.
    Stands,
    /// The thickness has fewer correct digits, and is too small: such an arch falls.
    Thinner,
    /// No thickness is enough.
    Falls,
    /// The row says nothing.
    NoClaim,
    /// The certified state could not be told.
    Undecided,
    /// The row cannot be read.
    BadRow,
}

impl Verdict {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::CorrectlyRounded,
        Self::Correct,
        Self::Inaccurate,
        Self::Thicker,
        Self::WrongMode,
        Self::Stands,
        Self::Thinner,
        Self::Falls,
        Self::NoClaim,
        Self::Undecided,
        Self::BadRow,
    ];

    /// The words used in files; stable.
    pub fn name(self) -> &'static str {
        match self {
            Self::CorrectlyRounded => "correctly rounded",
            Self::Correct => "correct",
            Self::Inaccurate => "inaccurate",
            Self::Thicker => "thicker than the least thickness",
            Self::WrongMode => "wrong mode",
            Self::Stands => "claims that an arch falls which stands",
            Self::Thinner => "thinner than the least thickness",
            Self::Falls => "claims an arch that cannot stand",
            Self::NoClaim => "no claim",
            Self::Undecided => "undecided",
            Self::BadRow => "bad row",
        }
    }

    /// Whether the row passes.
    pub fn is_accepted(self) -> bool {
        self <= Self::Correct
    }

    /// Whether the row was compared with a certified state at all.
    pub fn is_judged(self) -> bool {
        self <= Self::Falls
    }
}

/// What is demanded of every number of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Demand {
    /// Correct digits.
    pub digits: usize,
    /// Whether fewer are enough where no more are printed, correctly rounded.
    pub or_all_printed: bool,
}

impl Demand {
    fn is_met(self, number: &Judged) -> bool {
        number.correct_digits >= CorrectDigits::Digits(self.digits)
            || (self.or_all_printed && number.is_correctly_rounded())
    }
}

/// What is certain of the arch.
#[derive(Clone, Debug)]
pub enum Standing {
    /// It stands from a least thickness on, and collapses there in this mode.
    Stands(Mode),
    /// It does not stand at any thickness.
    Falls(Fall),
    /// This could not be told.
    Undecided(Undecided),
}

/// On which side of the truth a thickness is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Too small: the unsafe side.
    Thinner,
    /// Too large: the safe side.
    Thicker,
}

/// A claim beside the certified state.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// What is certain of the arch.
    pub standing: Standing,
    /// The row as a whole.
    pub verdict: Verdict,
    /// Its numbers, if the arch stands and is claimed to.
    pub numbers: Vec<Judged>,
}

impl Judgement {
    /// The digits to which every number is correct; `None` where there is no number.
    pub fn correct_digits(&self) -> Option<CorrectDigits> {
        self.numbers.iter().map(|number| number.correct_digits).min()
    }

    /// On which side the claimed thickness is, if on any.
    pub fn side(&self) -> Option<Side> {
        let thickness = self.numbers.iter().find(|n| n.quantity == Quantity::Thickness)?;
        match thickness.order? {
            Ordering::Less => Some(Side::Thinner),
            Ordering::Equal => None,
            Ordering::Greater => Some(Side::Thicker),
        }
    }
}

/// Judges what is claimed of an arch by its certified state, raising the precision until every
/// comparison is decided.
pub fn judge(arch: &Arch, claim: &Claim, demand: Demand) -> Judgement {
    let bare = |standing, verdict| Judgement { standing, verdict, numbers: Vec::new() };
    let digits = claim.numbers.iter().map(compared_digits).max().unwrap_or(1);
    let frictions = claim.numbers.iter().any(|number| number.quantity.is_friction());
    let compared = raised(arch, digits, |bits| {
        let outcome = if frictions { arch.state(bits)? } else { arch.state_alone(bits)? };
        Ok(match (outcome, claim.stands) {
            (Outcome::Falls(fall), stands) => {
                let verdict = match stands {
                    None => Verdict::NoClaim,
                    Some(true) => Verdict::Falls,
                    Some(false) => Verdict::Correct,
                };
                Some(bare(Standing::Falls(fall), verdict))
            }
            (Outcome::Stands(state), Some(true)) => compare(claim, &state, demand),
            (Outcome::Stands(state), stands) => {
                let verdict = if stands.is_none() { Verdict::NoClaim } else { Verdict::Stands };
                Some(bare(Standing::Stands(state.mode), verdict))
            }
        })
    });
    // What cannot be told is not accepted either: nearer to a line than can be told is not on it.
    compared.unwrap_or_else(|doubt| bare(Standing::Undecided(doubt), Verdict::Undecided))
}

/// A claim beside a proved state; `None` asks for a narrower enclosure.
fn compare(claim: &Claim, state: &State, demand: Demand) -> Option<Judgement> {
    let numbers: Vec<Judged> = claim
        .numbers
        .iter()
        .map(|claimed| Judged::new(claimed, Truth::new(claimed.quantity, state)))
        .collect::<Option<_>>()?;
    let mut verdict = match numbers.iter().all(Judged::is_correctly_rounded) {
        true if !numbers.is_empty() => Verdict::CorrectlyRounded,
        _ => Verdict::Correct,
    };
    if claim.mode.is_some_and(|mode| mode != state.mode) {
        verdict = Verdict::WrongMode;
    }
    for number in numbers.iter().filter(|number| !demand.is_met(number)) {
        verdict = verdict.max(match (number.quantity, number.order) {
            (Quantity::Thickness, Some(Ordering::Less)) => Verdict::Thinner,
            (Quantity::Thickness, Some(Ordering::Greater)) => Verdict::Thicker,
            _ => Verdict::Inaccurate,
        });
    }
    Some(Judgement { standing: Standing::Stands(state.mode), verdict, numbers })
}
