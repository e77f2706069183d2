//! The letters of the paper, as indeterminates.

use crate::number::worded;

worded! {
    /// An indeterminate.
    ///
    /// The sine and cosine of an angle are indeterminates of their own, tied by a
    /// [relation](super::Relations); so is a square root. The order of the variants is the order in
    /// which a polynomial is sorted: what it is solved for comes first.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
    #[non_exhaustive]
    pub enum Symbol {
        /// `A = alpha cot(alpha/2)`.
        OpeningVariable = ("A", "A"),
        /// `h`.
        Thrust = ("h", "h"),
        /// `eta`.
        Thickness = ("eta", r"\eta"),
        /// `mu`.
        Friction = ("mu", r"\mu"),
        /// `u`, a cube root.
        CubeRoot = ("u", "u"),
        /// `q`, a square root: `SQRT` in (9)–(12).
        SquareRoot = ("q", "q"),
        /// `i√3`, with the square -3.
        RootOfMinusThree = ("k", "k"),
        /// `p`, the moment of the crown thrust.
        CrownMoment = ("p", "p"),
        /// `v`, the vertical force in the crown.
        CrownShear = ("v", "v"),
        /// `e0`, the eccentricity at the crown.
        CrownEccentricity = ("e0", "e_0"),
        /// `f`, where it is kept as a letter.
        F = ("f", "f"),
        /// `g`, where it is kept as a letter.
        G = ("g", "g"),
        /// `beta`.
        Joint = ("beta", r"\beta"),
        /// `S = sin(beta)`.
        Sine = ("S", "S"),
        /// `C = cos(beta)`.
        Cosine = ("C", "C"),
        /// `beta_s`, where another joint is `beta`.
        SlidingJoint = ("beta_s", r"\beta_s"),
        /// `sin(beta_s)`.
        SineOfSliding = ("Ss", r"\sin\beta_s"),
        /// `cos(beta_s)`.
        CosineOfSliding = ("Cs", r"\cos\beta_s"),
        /// `alpha`.
        HalfOpening = ("alpha", r"\alpha"),
        /// `sin(alpha)`.
        SineOfOpening = ("Sa", r"\sin\alpha"),
        /// `cos(alpha)`.
        CosineOfOpening = ("Ca", r"\cos\alpha"),
        /// `delta_M`.
        Flag = ("delta", r"\delta_M"),
        /// `r`, a radius as a length.
        Radius = ("r", "r"),
        /// `d`, the depth out of the plane.
        Depth = ("d", "d"),
        /// `gamma`, the weight per unit volume.
        SpecificWeight = ("gamma", r"\gamma"),
        /// `s`, the span of a circle as a length.
        Span = ("s", "s"),
        /// The rise of a circle as a length.
        Rise = ("rise", r"\mathrm{rise}"),
        /// `t`, the thickness as a length.
        MeasuredThickness = ("t", "t"),
        /// The constant pi.
        Pi = ("pi", r"\pi"),
        /// The square root of two.
        RootOfTwo = ("√2", r"\sqrt{2}"),
        /// The square root of three.
        RootOfThree = ("√3", r"\sqrt{3}"),
    }
    /// The indeterminates in order.
    pub const ALL;
    /// The symbol in text and in LaTeX.
    pub fn names -> (&'static str, &'static str);
}

impl Symbol {
    /// The number of indeterminates.
    pub const COUNT: usize = Self::ALL.len();
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
