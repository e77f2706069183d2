//! Several questions about one arch, which share what is proved on the way.

use super::assess::{Assessment, AssessmentDigits, Wanted, assessment};
use super::digits::{Answer, Digits};
use super::enough::enough;
use super::kept::{kept_outcome, kept_query};
use super::query::{GUARD, bits_lost, bits_lost_unless_small};
use super::state::Outcome;
use crate::number::{ExactNumber, bits_of};
use crate::problem::Arch;
use crate::prover::refused::MAX_DIGITS;
use crate::prover::{Error, Refused, Undecided, raise};

/// Questions about an arch, which share its state: it is proved once at each precision.
pub struct Inquiry<'a> {
    arch: &'a Arch,
    /// True if the frictions at which the mode changes are asked for at every precision.
    frictions: bool,
    /// Bits enough for the question with the most digits, if the equations lose none.
    bits: u32,
}

impl<'a> Inquiry<'a> {
    /// Questions of at most `most_digits` digits; `frictions` says whether any asks for the frictions at which
    /// the mode changes.
    pub fn new(arch: &'a Arch, most_digits: usize, frictions: bool) -> Self {
        let bits = bits_of(most_digits.min(MAX_DIGITS)) + GUARD;
        Self { arch, frictions, bits }
    }

    /// The state to `digits` digits. The frictions at which the mode changes are left out unless they are
    /// asked for here and in [`Inquiry::new`]. Digits beyond [`MAX_DIGITS`] are refused.
    pub fn state(&self, digits: usize, frictions: bool) -> Result<Answer, Error> {
        Refused::digits(digits)?;
        let lost = bits_lost_unless_small(self.arch, self.bits);
        let answer = raise(self.bits + lost, |bits| {
            Ok(match self.outcome(bits, true)? {
                Outcome::Falls(fall) => Some(Answer::Falls { fall, enough: None }),
                Outcome::Stands(mut state) => {
                    state.frictions = state.frictions.filter(|_| frictions);
                    Digits::new(&state, digits).map(|digits| Answer::Stands(Box::new(digits)))
                }
            })
        })?;
        Ok(match answer {
            Answer::Falls { fall, .. } if frictions => {
                Answer::Falls { fall, enough: Some(Box::new(enough(self.arch, digits, false))) }
            }
            answer => answer,
        })
    }

    /// Proves what holds for the arch with a given thickness, in `(0, 2]`, to `digits` digits; any other
    /// thickness, and digits beyond [`MAX_DIGITS`], are refused.
    pub fn assess(
        &self,
        thickness: &ExactNumber,
        digits: usize,
        wanted: Wanted,
    ) -> Result<AssessmentDigits, Refused> {
        Refused::digits(digits)?;
        Refused::thickness(thickness)?;
        let first = self.bits + bits_lost(self.arch);
        let at = |bits| self.assessment(thickness, bits, wanted).rounded(digits, bits);
        let mut found: Option<AssessmentDigits> = None;
        // What stays open says so itself.
        let _ = raise(first, |bits| {
            let all = match found.take() {
                Some(before) => before.or(at(bits)),
                None => at(bits),
            };
            let open = all.first_open().cloned();
            found = Some(all);
            open.map_or(Ok(Some(())), Err)
        });
        Ok(found.unwrap_or_else(|| at(first)))
    }

    /// Proves what holds for the arch with a given thickness, in `(0, 2]`, in enclosures of `bits` bits.
    pub(super) fn assessment(
        &self,
        thickness: &ExactNumber,
        bits: u32,
        wanted: Wanted,
    ) -> Assessment {
        let query = kept_query(self.arch, bits);
        assessment(self.arch, thickness, query, wanted, |is_own, bits| self.outcome(bits, is_own))
    }

    /// The state of the arch with numbers of `bits` bits, with its own friction or with unlimited friction.
    fn outcome(&self, bits: u32, is_own: bool) -> Result<Outcome, Undecided> {
        match is_own {
            true => kept_outcome(self.arch, bits, self.frictions),
            false => kept_outcome(&self.arch.unlimited(), bits, false),
        }
    }
}
