//! An arch: its state is proved once, and what is asked of each thickness.

use super::computable::{Computable, Shared};
use super::expected;
use super::same::arch_key;
use crate::certify::state::{Answer, AssessmentDigits, Inquiry, Wanted};
use crate::certify::{Error, Refused};
use crate::number::ExactNumber;
use crate::problem::{Arch, Quantity};
use rug::Rational;
use std::collections::BTreeMap;

/// An arch and what is asked of it.
#[derive(Debug)]
pub(super) struct ArchNode<'s> {
    /// The arch.
    pub arch: &'s Arch,
    /// The digits in which its state is asked for, and whether with the frictions at which the mode
    /// changes.
    pub states: BTreeMap<usize, bool>,
    /// The thicknesses with which it is asked about, each with its digits, and the question.
    pub thicknesses: BTreeMap<(Rational, usize), (ExactNumber, Wanted)>,
    /// True if a format asks for the errors of doubles, of which more is known with more bits.
    pub errors: bool,
}

/// Certain knowledge of an arch.
pub(super) struct ArchPiece {
    /// States by the number of digits.
    pub states: BTreeMap<usize, Result<Answer, Error>>,
    /// Thicknesses, each with its digits.
    pub thicknesses: BTreeMap<(Rational, usize), Result<AssessmentDigits, Refused>>,
}

impl<'s> ArchNode<'s> {
    /// An arch of which nothing is asked.
    pub(super) fn new(arch: &'s Arch) -> Self {
        Self { arch, states: BTreeMap::new(), thicknesses: BTreeMap::new(), errors: false }
    }

    /// Asks for the state, or for what holds with a thickness.
    pub(super) fn ask(
        &mut self,
        thickness: Option<&ExactNumber>,
        quantities: &[Quantity],
        digits: usize,
    ) {
        let Some(thickness) = thickness else {
            *self.states.entry(digits).or_default() |= quantities.iter().any(|q| q.is_friction());
            return;
        };
        let new = || (thickness.clone(), Wanted::Standing);
        let asked = self.thicknesses.entry((thickness.to_rational(), digits)).or_insert_with(new);
        asked.1 = asked.1.max(Wanted::of(quantities));
    }

    /// Digits that are asked, and whether the frictions at which the mode changes are, of a state alone: it shares the
    /// proofs of its half opening.
    pub(super) fn shared(&self) -> Option<(usize, bool)> {
        let mut states = self.states.iter().map(|(digits, frictions)| (*digits, *frictions));
        let first = states.next().filter(|_| self.thicknesses.is_empty() && !self.errors);
        first.filter(|_| states.next().is_none())
    }

    /// Tells whether the frictions at which the mode changes are asked for.
    pub(super) fn frictions(&self) -> bool {
        self.states.values().any(|frictions| *frictions)
    }

    /// The most digits that are asked for.
    pub(super) fn digits(&self) -> usize {
        let thicknesses = self.thicknesses.keys().map(|(_, digits)| *digits);
        self.states.keys().copied().chain(thicknesses).max().unwrap_or(1)
    }

    /// Proves what is asked of it.
    pub(super) fn piece(&self, shared: &Shared) -> ArchPiece {
        if let Some(asked) = self.shared()
            && let Some(openings) = shared.openings.get(&asked)
        {
            let states = BTreeMap::from([(asked.0, openings.state(self.arch))]);
            return ArchPiece { states, thicknesses: BTreeMap::new() };
        }
        let inquiry = Inquiry::new(self.arch, self.digits(), self.frictions());
        let states = self.states.iter();
        let states = states.map(|(&digits, &with)| (digits, inquiry.state(digits, with)));
        let thicknesses = self
            .thicknesses
            .iter()
            .map(|(key, (eta, wanted))| (key.clone(), inquiry.assess(eta, key.1, *wanted)));
        ArchPiece { states: states.collect(), thicknesses: thicknesses.collect() }
    }
}

impl Computable for ArchNode<'_> {
    fn key(&self) -> String {
        arch_key(self.arch)
    }

    fn lines(&self) -> Vec<String> {
        let (alpha, mu) = (self.arch.half_opening(), self.arch.friction());
        let mut lines = vec![
            format!("half opening {alpha}, friction {mu}, {}", self.arch.weight().name()),
            expected::in_words(self.arch),
        ];
        lines.extend(self.states.iter().map(|(digits, frictions)| {
            let with = if *frictions { " and the frictions at which its mode changes" } else { "" };
            format!("to {digits} digits: its state{with}")
        }));
        lines.extend(self.thicknesses.iter().map(|((_, digits), (eta, wanted))| {
            let what = match wanted {
                Wanted::Standing => "whether it stands",
                Wanted::Everything => "whether it stands, and the range of thrusts",
            };
            format!("to {digits} digits, thickness {eta}: {what}")
        }));
        lines
    }
}
