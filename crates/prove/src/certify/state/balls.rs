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
    /// Those of [`Tier::of`] the digits, in that order.
    DoubleDoubles,
    /// Balls of MPFR alone: more is known of the error of each double, and the nearest quadruple.
    Mpfr,
}

/// Arithmetic in which a proof runs: the same text over other numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tier {
    /// Double-doubles, many arches at a time.
    Lanes,
    /// Balls of double-doubles.
    DoubleDoubles,
    /// Balls of three words.
    ThreeWords,
    /// Balls of MPFR.
    Mpfr,
}

impl Tier {
    /// What is asked for `digits` digits, each of what those before leave open or do not have.
    ///
    /// | digits | first | µs a row with its frictions, `couplet states` on one thread |
    /// |---|---|---|
    /// | 17 | what doubles are told from is decided by lanes, but for what lies next to a boundary | 33 |
    /// | 18 to 20 | double-doubles still decide nearly all | 63 to 67 |
    /// | 21 to 25 | they decide fewer and fewer: asked where there are no three words, as for remedies | 85 to 107 |
    /// | 26 to 36 | three words | 112 to 204 |
    /// | 37 | balls of MPFR | 411 |
    pub fn of(digits: usize) -> &'static [Self] {
        use Tier::{DoubleDoubles, Lanes, Mpfr, ThreeWords};
        match digits {
            1..=17 => &[Lanes, DoubleDoubles, Mpfr],
            18..=20 => &[DoubleDoubles, ThreeWords, Mpfr],
            21..=25 => &[ThreeWords, DoubleDoubles, Mpfr],
            26..=36 => &[ThreeWords, Mpfr],
            _ => &[Mpfr],
        }
    }

    /// Tells whether it is asked for `digits` digits.
    pub fn has(self, digits: usize) -> bool {
        Self::of(digits).contains(&self)
    }
}

impl Balls {
    /// The state of an arch to `digits` digits, with the frictions at which its mode changes if they are asked for.
    pub fn state(self, arch: &Arch, digits: usize, frictions: bool) -> Result<Answer, Error> {
        let quick = (self == Self::DoubleDoubles).then(|| quick::state(arch, digits, frictions));
        let mpfr = || Inquiry::new(arch, digits, frictions).state(digits, frictions);
        quick.flatten().map_or_else(mpfr, Ok)
    }

    /// Everything that holds for an arch with a thickness in `(0, 2]`, to `digits` digits.
    pub fn assess(
        self,
        arch: &Arch,
        thickness: &ExactNumber,
        digits: usize,
    ) -> Result<AssessmentDigits, Refused> {
        Refused::thickness(thickness)?;
        let quick = (self == Self::DoubleDoubles).then(|| quick::assess(arch, thickness, digits));
        let wanted = Wanted::Everything;
        let mpfr = || Inquiry::new(arch, digits, false).assess(thickness, digits, wanted);
        quick.flatten().map_or_else(mpfr, Ok)
    }
}
