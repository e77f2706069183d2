//! A row as a whole.

use super::boundary::Boundary;
use super::claim::RowClaim;
use super::comparable::Comparable;
use super::number::{CorrectDigits, Judged};
use super::truth::ProvedArch;
use crate::certify::Undecided;
use crate::certify::batch::{SharedOpening, Threads};
use crate::certify::state::{
    Assessment, Fall, LaneOutcome, Outcome, Tier, outcomes_in_lanes, raised,
};
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

    /// The judgement with the boundary to the mode that is claimed, where that is wrong.
    fn with_boundary(self, arch: &Arch, claim: &RowClaim) -> Self {
        let boundary = match (claim.mode, &self.standing) {
            (Some(claimed), Standing::Stands(mode)) if claimed != *mode => {
                Boundary::near(arch, claimed)
            }
            _ => None,
        };
        Self { boundary, ..self }
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
    let digits = claim.digits();
    let in_bits = |bits| Ok(compare(claim, &proved::<Ball>(arch, claim, bits)?, demand));
    let by_mpfr = || raised(arch, digits, in_bits);
    let compared = match Tier::DoubleDoubles.has(digits) {
        true => quickly::<DoubleDoubleBall>(arch, claim, demand)
            .or_else(|| quickly::<TripleWordBall>(arch, claim, demand))
            .map_or_else(by_mpfr, Ok),
        false => by_mpfr(),
    };
    // What cannot be told is not accepted either: nearer to a line than can be told is not on it.
    let judgement = compared.unwrap_or_else(|doubt| {
        Judgement::bare(Standing::Undecided(doubt), None, Verdict::Undecided)
    });
    judgement.with_boundary(arch, claim)
}

/// Arch of a row with what is claimed of it, or why the row cannot be read.
pub type ReadClaim = Result<(Arch, RowClaim), String>;

/// Rows whose states are proved together.
const PIECE: usize = 128;

/// Judges what is claimed of arches as [`judge`] judges each, but that their states are proved many at a time, by the
/// threads of the pool of rayon in which it is asked; a row that cannot be read keeps its reason.
pub fn judge_all(rows: &[ReadClaim], demand: Demand) -> Vec<Result<Judgement, String>> {
    let pieces: Vec<&[ReadClaim]> = rows.chunks(PIECE).collect();
    let known = Threads::Pool.each(&pieces, |rows| known(rows)).concat();
    let asked: Vec<_> = rows.iter().zip(known).collect();
    Threads::Pool.each(&asked, |(row, known)| {
        let (arch, claim) = row.as_ref().map_err(Clone::clone)?;
        let compared = known.clone().and_then(|(outcome, sliding_friction)| {
            let proved = ProvedArch { outcome, sliding_friction, assessment: None };
            Some(compare(claim, &proved, demand)?.with_boundary(arch, claim))
        });
        Ok(compared.unwrap_or_else(|| judge(arch, claim, demand)))
    })
}

/// Outcomes that lanes prove of those rows that ask for no more.
fn known(rows: &[ReadClaim]) -> Vec<Option<LaneOutcome>> {
    fn quick(row: &ReadClaim) -> Option<&(Arch, RowClaim)> {
        let is_quick =
            |claim: &RowClaim| claim.thickness.is_none() && Tier::DoubleDoubles.has(claim.digits());
        row.as_ref().ok().filter(|(_, claim)| is_quick(claim))
    }
    let frictions = rows.iter().filter_map(quick).any(|(_, claim)| claim.tells_frictions());
    let arch = |(arch, _): &(Arch, _)| (arch.weight(), SharedOpening::enclosed_arch(arch));
    outcomes_in_lanes(rows.iter().map(|row| quick(row).map(arch)), frictions)
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
    let frictions = claim.tells_frictions();
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

#[cfg(test)]
mod tests {
    use super::super::Said;
    use super::*;
    use crate::arch::SelfWeight;
    use crate::certify::state::{Answer, Certify};
    use crate::problem::Quantity;

    /// A claim about an arch: the true thickness to 17 digits with a thrust that is wrong, or a mode, or frictions.
    fn row(arch: Arch, which: usize) -> ReadClaim {
        let thickness = match arch.certify(17).map_err(|error| error.to_string())? {
            Answer::Stands(state) => state.thickness.to_string(),
            Answer::Falls { .. } => "0.1".to_owned(),
        };
        let numbers = match which % 4 {
            0 => vec![(Quantity::Thickness, &*thickness), (Quantity::Thrust, "0.5")],
            1 => vec![(Quantity::SlidingFriction, "0.3"), (Quantity::RotationalFriction, "inf")],
            // More digits than double-doubles decide.
            2 => vec![(Quantity::Thickness, "0.123456789012345678901234567890123")],
            _ => vec![],
        };
        let numbers = numbers.into_iter().map(|(of, text)| (of, text, false)).collect();
        let thickness = (which % 5 == 4).then(|| "0.2".parse().unwrap());
        let mode = (which % 4 == 3).then_some("[r,r,s]");
        let said = Said { numbers, thickness, mode, ..Said::default() };
        Ok((arch, RowClaim::read(&said).map_err(|error| error.to_string())?))
    }

    #[test]
    fn rows_are_judged_together_as_each_alone() {
        let frictions = ["0.05", "0.3", "0.6", "1.35", "2.5", "inf"];
        let openings = ["0.03", "0.7", "80deg", "2.45", "2.61", "3"];
        let arches = SelfWeight::ALL.into_iter().flat_map(|weight| {
            let of =
                move |alpha| frictions.map(|mu| Arch::parse(weight.name(), alpha, mu).unwrap());
            openings.into_iter().flat_map(of)
        });
        let mut rows: Vec<_> = arches.enumerate().map(|(which, arch)| row(arch, which)).collect();
        rows.insert(5, Err("the friction is empty".to_owned()));
        let alone = |row: &ReadClaim| {
            row.as_ref()
                .map_err(Clone::clone)
                .map(|(arch, claim)| judge(arch, claim, Demand::USUAL))
        };
        let together = judge_all(&rows, Demand::USUAL);
        assert!(known(&rows).iter().flatten().count() > rows.len() / 3, "most are proved in lanes");
        let verdicts = together.iter().flatten().map(|found| found.verdict);
        assert!(verdicts.collect::<std::collections::BTreeSet<_>>().len() > 4);
        for (row, found) in rows.iter().zip(together) {
            assert_eq!(format!("{found:?}"), format!("{:?}", alone(row)), "{row:?}");
        }
        // Nothing depends on whether another row tells frictions.
        rows.retain(|row| row.as_ref().is_ok_and(|(_, claim)| !claim.tells_frictions()));
        for (row, found) in rows.iter().zip(judge_all(&rows, Demand::USUAL)) {
            assert_eq!(format!("{found:?}"), format!("{:?}", alone(row)), "{row:?}");
        }
    }
}
