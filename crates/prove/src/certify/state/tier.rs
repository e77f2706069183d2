//! The numbers in which so many digits are proved.

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
    /// The numbers that are asked for `digits` digits, each of what those before leave open or do not have.
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
