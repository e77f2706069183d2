//! The letters of the paper, as indeterminates.

/// An indeterminate.
///
/// The sine and cosine of an angle are indeterminates of their own, tied by a
/// [relation](super::Relations); so is a square root. The order of the variants is the order in
/// which a polynomial is sorted: what it is solved for comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Symbol {
    /// `A = alpha cot(alpha/2)`.
    OpeningVariable,
    /// `h`.
    Thrust,
    /// `eta`.
    Thickness,
    /// `mu`.
    Friction,
    /// `u`, a cube root.
    CubeRoot,
    /// `q`, a square root: `SQRT` in (9)–(12).
    SquareRoot,
    /// `i√3`, with the square -3.
    RootOfMinusThree,
    /// `p`, the moment of the crown thrust.
    CrownMoment,
    /// `v`, the vertical force in the crown.
    CrownShear,
    /// `e0`, the eccentricity at the crown.
    CrownEccentricity,
    /// `f`, where it is kept as a letter.
    F,
    /// `g`, where it is kept as a letter.
    G,
    /// `beta`.
    Joint,
    /// `S = sin(beta)`.
    Sine,
    /// `C = cos(beta)`.
    Cosine,
    /// `beta_s`, where another joint is `beta`.
    SlidingJoint,
    /// `sin(beta_s)`.
    SineOfSliding,
    /// `cos(beta_s)`.
    CosineOfSliding,
    /// `alpha`.
    HalfOpening,
    /// `sin(alpha)`.
    SineOfOpening,
    /// `cos(alpha)`.
    CosineOfOpening,
    /// `delta_M`.
    Flag,
    /// `r`, a radius as a length.
    Radius,
    /// `d`, the depth out of the plane.
    Depth,
    /// `gamma`, the weight per unit volume.
    SpecificWeight,
}

impl Symbol {
    /// How many there are.
    pub const COUNT: usize = 25;

    /// All of them, in order.
    pub const ALL: [Self; Self::COUNT] = [
        Self::OpeningVariable,
        Self::Thrust,
        Self::Thickness,
        Self::Friction,
        Self::CubeRoot,
        Self::SquareRoot,
        Self::RootOfMinusThree,
        Self::CrownMoment,
        Self::CrownShear,
        Self::CrownEccentricity,
        Self::F,
        Self::G,
        Self::Joint,
        Self::Sine,
        Self::Cosine,
        Self::SlidingJoint,
        Self::SineOfSliding,
        Self::CosineOfSliding,
        Self::HalfOpening,
        Self::SineOfOpening,
        Self::CosineOfOpening,
        Self::Flag,
        Self::Radius,
        Self::Depth,
        Self::SpecificWeight,
    ];

    /// How it is written in text and in LaTeX.
    pub fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::OpeningVariable => ("A", "A"),
            Self::Thrust => ("h", "h"),
            Self::Thickness => ("eta", r"\eta"),
            Self::Friction => ("mu", r"\mu"),
            Self::CubeRoot => ("u", "u"),
            Self::SquareRoot => ("q", "q"),
            Self::RootOfMinusThree => ("k", "k"),
            Self::CrownMoment => ("p", "p"),
            Self::CrownShear => ("v", "v"),
            Self::CrownEccentricity => ("e0", "e_0"),
            Self::F => ("f", "f"),
            Self::G => ("g", "g"),
            Self::Joint => ("beta", r"\beta"),
            Self::Sine => ("S", "S"),
            Self::Cosine => ("C", "C"),
            Self::SlidingJoint => ("beta_s", r"\beta_s"),
            Self::SineOfSliding => ("Ss", r"\sin\beta_s"),
            Self::CosineOfSliding => ("Cs", r"\cos\beta_s"),
            Self::HalfOpening => ("alpha", r"\alpha"),
            Self::SineOfOpening => ("Sa", r"\sin\alpha"),
            Self::CosineOfOpening => ("Ca", r"\cos\alpha"),
            Self::Flag => ("delta", r"\delta_M"),
            Self::Radius => ("r", "r"),
            Self::Depth => ("d", "d"),
            Self::SpecificWeight => ("gamma", r"\gamma"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_symbol_stands_at_its_place() {
        for (place, symbol) in Symbol::ALL.into_iter().enumerate() {
            assert_eq!(symbol as usize, place);
        }
        let mut names: Vec<_> = Symbol::ALL.map(|s| s.names().0).to_vec();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), Symbol::COUNT, "two symbols share a name");
    }
}
