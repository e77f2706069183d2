//! A row as a whole.

use super::boundary::Boundary;
use super::claim::RowClaim;
use super::comparable::Comparable;
use super::number::{CorrectDigits, Judged, compared_digits};
use super::truth::ProvedArch;
use crate::certify::Undecided;
use crate::certify::state::{Assessment, Fall, Outcome, Tier, raised};
use crate::number::{Ball, DoubleDoubleBall, ExactNumber, TripleWordBall, worded};
use crate::problem::{Arch, Mode};
use std::cmp::Ordering;

worded! {
    /// The verdict on a row, from best to worst, then the rows that cannot be judged.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Verdict {
        /// Every number is the correct rounding of the truth, and all else is right.
        CorrectlyRounded = "correctly rounded",
        /// Everything is right, to the digits demanded.
        Correct = "correct",
        /// A number other than the thickness has fewer correct digits, or is one where there is none.
        Inaccurate = "inaccurate",
        /// The thickness has fewer correct digits, and is too large: the safe side.
        Thicker = "thicker than the least thickness",
        /// The arch collapses in another mode.
        WrongMode = "wrong mode",
        /// The arch stands at some thickness.
        Stands = "claims that an arch falls which stands",
        /// The thickness has fewer correct digits, and is too small: such an arch falls.
        Thinner = "thinner than the least thickness",
        /// No thickness is enough.
        Falls = "claims an arch that cannot stand",
        /// The row says nothing.
        NoClaim = "no claim",
        /// The certified state could not be told.
        Undecided = "undecided",
        /// The row cannot be read.
        BadRow = "bad row",
    }
    /// All verdicts.
    pub const ALL;
    /// The words used in files; stable.
    pub fn name -> &'static str;
}

impl Verdict {
    /// Tells whether the row passes.
    pub fn is_accepted(self) -> bool {
        self <= Self::Correct
    }

    /// Tells whether the row was compared with a certified state at all.
    pub fn is_judged(self) -> bool {
        self <= Self::Falls
    }
}

/// Demand on every number of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Demand {
    /// Correct digits.
    pub digits: usize,
    /// True if fewer digits are enough for a number that is right to the digits with which it is printed.
    pub or_as_printed: bool,
}

/// Correct digits without which a least thickness that is too small is not accepted, however few are
/// printed: what is rounded to the unsafe side is not right because it is coarse.
const LEAST_IF_TOO_THIN: CorrectDigits = CorrectDigits::Digits(3);

impl Default for Demand {
    fn default() -> Self {
        Self::USUAL
    }
}

impl Demand {
    /// Numbers that are right to the digits with which they are printed, of which no program in doubles is
    /// asked for more than 12.
    pub const USUAL: Self = Self { digits: 12, or_as_printed: true };

    fn is_met(self, number: &Judged) -> bool {
        let is_fine = !number.is_too_thin() || number.correct_digits >= LEAST_IF_TOO_THIN;
        number.correct_digits >= CorrectDigits::Digits(self.digits)
            || (self.or_as_printed && number.is_right_as_printed() && is_fine)
    }
}

/// Certain knowledge of the arch.
#[derive(Clone, Debug)]
pub enum Standing {
    /// The arch stands from a least thickness on, and collapses there in this mode.
    Stands(Mode),
    /// The arch does not stand at any thickness.
    Falls(Fall),
    /// The standing of the arch could not be told.
    Undecided(Undecided),
}

/// Side of the truth on which a thickness is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ErrorSide {
    /// Too small: the unsafe side.
    Thinner,
    /// Too large: the safe side.
    Thicker,
}

/// A claim beside the certified state.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// Standing of the arch.
    pub standing: Standing,
    /// True if the arch stands at the thickness that it has, if it has one and that is certain.
    pub stands: Option<bool>,
    /// The row as a whole.
    pub verdict: Verdict,
    /// Boundary to the mode that is claimed, where it is wrong: one within the rounding of what is given.
    pub boundary: Option<Boundary>,
    /// Numbers of the row, unless the row is wrong about whether the arch stands.
    pub numbers: Vec<Judged>,
}

impl Judgement {
    fn bare(standing: Standing, stands: Option<bool>, verdict: Verdict) -> Self {
        Self { standing, stands, verdict, boundary: None, numbers: Vec::new() }
    }

    /// The digits to which every number is correct; `None` where there is no number.
    pub fn correct_digits(&self) -> Option<CorrectDigits> {
        self.numbers.iter().map(|number| number.correct_digits).min()
    }

    /// Side on which the claimed thickness is, if on any.
    pub fn side(&self) -> Option<ErrorSide> {
        let thickness = self.numbers.iter().find(|number| number.is_least_thickness())?;
        match thickness.order? {
            Ordering::Less => Some(ErrorSide::Thinner),
            Ordering::Equal => None,
            Ordering::Greater => Some(ErrorSide::Thicker),
        }
    }
}

/// Judges what is claimed of an arch by what is proved of it, raising the precision until every comparison
/// is decided.
pub fn judge(arch: &Arch, claim: &RowClaim, demand: Demand) -> Judgement {
    let digits = claim.numbers.iter().map(compared_digits).max().unwrap_or(1);
    let in_bits = |bits| Ok(compare(claim, &proved::<Ball>(arch, claim, bits)?, demand));
    let by_mpfr = || raised(arch, digits, in_bits);
    let compared = match Tier::DoubleDoubles.has(digits) {
        true => quickly::<DoubleDoubleBall>(arch, claim, demand)
            .or_else(|| quickly::<TripleWordBall>(arch, claim, demand))
            .map_or_else(by_mpfr, Ok),
        false => by_mpfr(),
    };
    // What cannot be told is not accepted either: nearer to a line than can be told is not on it.
    let mut judgement = compared.unwrap_or_else(|doubt| {
        Judgement::bare(Standing::Undecided(doubt), None, Verdict::Undecided)
    });
    if let (Some(claimed), Standing::Stands(mode)) = (claim.mode, &judgement.standing)
        && claimed != *mode
    {
        judgement.boundary = Boundary::near(arch, claimed);
    }
    judgement
}

/// A claim beside what is proved in numbers that have the bits that they have, if these are enough.
fn quickly<E: Comparable>(arch: &Arch, claim: &RowClaim, demand: Demand) -> Option<Judgement> {
    compare(claim, &proved::<E>(arch, claim, 0).ok()?, demand)
}

/// Proof of what the row speaks of, in numbers of `bits` bits.
fn proved<E: Comparable>(
    arch: &Arch,
    claim: &RowClaim,
    bits: u32,
) -> Result<ProvedArch<E>, Undecided> {
    let frictions = claim.numbers.iter().any(|number| number.quantity.is_friction());
    let outcome = E::state(arch, bits, frictions)?;
    let asked = frictions && matches!(outcome, Outcome::Falls(_));
    let assessed = claim.thickness.as_ref().map(|eta| assessed(arch, eta, claim, bits));
    Ok(ProvedArch {
        sliding_friction: asked.then(|| E::sliding_friction(arch, bits)).transpose()?,
        assessment: assessed.transpose()?,
        outcome,
    })
}

/// The arch at a thickness, with all that is claimed of it decided.
fn assessed<E: Comparable>(
    arch: &Arch,
    thickness: &ExactNumber,
    claim: &RowClaim,
    bits: u32,
) -> Result<Assessment<E>, Undecided> {
    let found = E::assessment(arch, thickness, bits)?;
    if claim.stands.is_some() {
        found.stands.clone()?;
    }
    match claim.numbers.iter().find_map(|number| found.why_open(number.quantity)) {
        Some(open) => Err(open.clone()),
        None => Ok(found),
    }
}

/// A claim beside what is proved; `None` asks for a narrower enclosure.
fn compare<E: Comparable>(
    claim: &RowClaim,
    proved: &ProvedArch<E>,
    demand: Demand,
) -> Option<Judgement> {
    let (standing, mode) = match &proved.outcome {
        Outcome::Stands(state) => (Standing::Stands(state.mode), Some(state.mode)),
        Outcome::Falls(fall) => (Standing::Falls(*fall), None),
    };
    let stands = proved.assessment.as_ref().and_then(|found| found.stands.clone().ok());
    let bare = |verdict| Some(Judgement::bare(standing.clone(), stands, verdict));
    if claim.is_empty() {
        return bare(Verdict::NoClaim);
    }
    let questions = [(claim.can_stand, Some(mode.is_some())), (claim.stands, stands)];
    for (claimed, found) in questions {
        match (claimed, found) {
            (Some(true), Some(false)) => return bare(Verdict::Falls),
            (Some(false), Some(true)) => return bare(Verdict::Stands),
            _ => {}
        }
    }
    let numbers: Vec<Judged> = claim
        .numbers
        .iter()
        .map(|claimed| Judged::new(claimed, proved.truth(claimed.quantity)))
        .collect::<Option<_>>()?;
    let mut verdict = match numbers.iter().all(Judged::is_correctly_rounded) {
        true if mode.is_some() && !numbers.is_empty() => Verdict::CorrectlyRounded,
        _ => Verdict::Correct,
    };
    if mode.is_some() && claim.mode.is_some() && claim.mode != mode {
        verdict = Verdict::WrongMode;
    }
    for number in numbers.iter().filter(|number| !demand.is_met(number)) {
        verdict = verdict.max(match (number.is_least_thickness(), number.order) {
            (true, Some(Ordering::Less)) => Verdict::Thinner,
            (true, Some(Ordering::Greater)) => Verdict::Thicker,
            _ => Verdict::Inaccurate,
        });
    }
    Some(Judgement { numbers, ..Judgement::bare(standing, stands, verdict) })
}
