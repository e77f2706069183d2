//! Three-valued truth: what a comparison of enclosures can say.

/// The answer of a comparison of enclosures. `False` is a proof too; "don't know" is `Undecided`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ternary {
    /// Proved.
    True,
    /// The statement's opposite is proved.
    False,
    /// Nothing is known: at this precision it could be either.
    Undecided,
}

impl Ternary {
    /// Both. `False` wins over `Undecided`.
    ///
    /// ```
    /// use couplet_number::number::Ternary::*;
    /// assert_eq!(True.and(Undecided), Undecided);
    /// assert_eq!(False.and(Undecided), False);
    /// ```
    pub fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::False, _) | (_, Self::False) => Self::False,
            (Self::True, Self::True) => Self::True,
            _ => Self::Undecided,
        }
    }

    /// Tells whether the statement is proved; `false` for a refuted **and** for an undecided one.
    #[inline(always)]
    pub fn is_proved(self) -> bool {
        matches!(self, Self::True)
    }
}

impl std::ops::Not for Ternary {
    type Output = Self;

    fn not(self) -> Self {
        match self {
            Self::True => Self::False,
            Self::False => Self::True,
            Self::Undecided => Self::Undecided,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Ternary::*;

    #[test]
    fn undecided_is_neither() {
        assert_eq!(!Undecided, Undecided);
        assert!(!Undecided.is_proved() && !(!Undecided).is_proved());
        assert_eq!(True.and(True), True);
        assert_eq!(Undecided.and(False), False);
    }
}
