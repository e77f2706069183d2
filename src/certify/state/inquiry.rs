//! Several questions about one arch, which share what is proved on the way.

use super::assess::Wanted;
use super::choice::{Asked, Outcome};
use super::digits::{Answer, AssessmentDigits, GUARD, raised};
use super::question::{Arch, Attempt, Doubt, Friction, Query};
use crate::number::{ExactNumber, bits_of};
use std::collections::BTreeMap;

/// Questions about an arch. Its state is proved once at each precision, whoever asks.
pub struct Inquiry<'a> {
    arch: &'a Arch,
    /// What the state is asked for at every precision.
    asked: Asked,
    /// Bits enough for the question with the most digits, if the equations lose none.
    bits: u32,
    states: BTreeMap<u32, Attempt<Outcome>>,
    /// States with unlimited friction.
    unlimited: BTreeMap<u32, Attempt<Outcome>>,
}

impl<'a> Inquiry<'a> {
    /// Questions of at most so many digits; `frictions` says whether any asks for the frictions at which
    /// the mode changes.
    pub fn new(arch: &'a Arch, most_digits: usize, frictions: bool) -> Self {
        let bits = bits_of(most_digits) + GUARD;
        let asked = if frictions { Asked::Frictions } else { Asked::Nothing };
        let (states, unlimited) = (BTreeMap::new(), BTreeMap::new());
        Self { arch, asked, bits, states, unlimited }
    }

    /// The state to so many digits. The frictions at which the mode changes are left out unless they are
    /// asked for here and in [`Inquiry::new`].
    pub fn state(&mut self, digits: usize, frictions: bool) -> Result<Answer, Doubt> {
        let lost = if self.arch.is_small(self.bits) { 0 } else { self.arch.bits_lost() };
        raised(self.bits + lost, |bits| {
            Ok(match self.outcome(bits)? {
                Outcome::Falls(fall) => Some(Answer::Falls(fall)),
                Outcome::Stands(mut state) => {
                    state.frictions = state.frictions.filter(|_| frictions);
                    state.digits(digits).map(|digits| Answer::Stands(Box::new(digits)))
                }
            })
        })
    }

    /// What holds for the arch with a given thickness, in `(0, 2)`, to so many digits.
    pub fn assess(
        &mut self,
        thickness: &ExactNumber,
        digits: usize,
        wanted: Wanted,
    ) -> Result<AssessmentDigits, Doubt> {
        let first = self.bits + self.arch.bits_lost();
        raised(first, |bits| Ok(self.assessment(thickness, bits, wanted)?.digits(digits)))
    }

    /// The state of the arch with numbers of `bits` bits.
    pub(super) fn outcome(&mut self, bits: u32) -> Attempt<Outcome> {
        let (arch, asked) = (self.arch, self.asked);
        let state = self.states.entry(bits);
        state.or_insert_with(|| Query::new(arch, bits).outcome(asked)).clone()
    }

    /// The same with unlimited friction.
    pub(super) fn unlimited(&mut self, bits: u32) -> Attempt<Outcome> {
        if *self.arch.friction() == Friction::Infinite {
            return self.outcome(bits);
        }
        let arch = self.arch;
        let state = self.unlimited.entry(bits);
        state.or_insert_with(|| arch.with_friction(Friction::Infinite).state_alone(bits)).clone()
    }

    /// The arch of the questions.
    pub(super) fn arch(&self) -> &'a Arch {
        self.arch
    }
}
