//! The one policy of arithmetic for the digits of an arch.

use super::assess::{AssessmentDigits, Wanted};
use super::digits::Answer;
use super::inquiry::Inquiry;
use super::quick;
use crate::number::ExactNumber;
use crate::problem::Arch;
use crate::prover::{Error, Refused};

/// Balls that are asked first. Digits and nearest doubles are the same either way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Balls {
    /// The numbers that are asked for the digits, in the order of [`Tier::of`](super::Tier::of).
    DoubleDoubles,
    /// Balls of MPFR alone: more is known of the error of each double, and the nearest quadruple.
    Mpfr,
}

impl Balls {
    /// The state of an arch to `digits` digits, with the frictions at which its mode changes if they are asked for.
    pub fn state(self, arch: &Arch, digits: usize, frictions: bool) -> Result<Answer, Error> {
        let quick = (self == Self::DoubleDoubles).then(|| quick::state(arch, digits, frictions));
        let mpfr = || Inquiry::new(arch, digits, frictions).state(digits, frictions);
        quick.flatten().map_or_else(mpfr, Ok)
    }

    /// Answers that are wanted of an arch with a thickness in `(0, 2]`, to `digits` digits; more where these alone stay
    /// open.
    pub fn assess(
        self,
        arch: &Arch,
        thickness: &ExactNumber,
        digits: usize,
        wanted: Wanted,
    ) -> Result<AssessmentDigits, Refused> {
        Refused::thickness(thickness)?;
        let quick = || quick::assess(arch, thickness, digits, wanted);
        let quick = (self == Self::DoubleDoubles).then(quick);
        // Next to the least thickness friction is another way to tell.
        let all = Wanted::Everything;
        let mpfr = || Inquiry::new(arch, digits, false).assess(thickness, digits, all);
        quick.flatten().map_or_else(mpfr, Ok)
    }
}
