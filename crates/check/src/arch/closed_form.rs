//! The closed forms (9)–(11) of the purely rotational state.
//!
//! Each is Cardano's formula for one of the cubics (7), for Milankovitch's self-weight:
//!
//! ```text
//! x = scale (shift + (1 ± k)/2 P/u + 2/(1 ± k) u)        u³ = X + c q
//! ```
//!
//! with `q` = `SQRT` of (12), so that `q²` is the [radicand](super::cubic::radicand), and `k = i√3`.
//! They are written over any field in which such `q`, `u`, `k` exist: formulas modulo these relations,
//! or complex numbers. Where the paper has `±` a function takes `k` and stands for the upper sign, with
//! `-k` for the lower; the same `k` in all three gives one state.
//!
//! In (9) the cube root of 2 is printed besides. As `2^(2/3) v = 2 (v / 2^(1/3))`, it is gone if `u` is
//! the cube root of **half** the bracket, and the formula has the shape of the other two.

use super::cubic::{self, Abbreviations};
use crate::number::{Field, worded};

worded! {
    /// A closed form of Cardano's kind, by the unknown of the cubic (7) of which it is a root.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum ClosedForm {
        /// (9), `A_M`.
        OpeningVariable = ["A", "opening_variable"],
        /// (10), `eta_M`.
        Thickness = ["eta", "thickness"],
        /// (11), `h_M`.
        Thrust = ["h", "thrust"],
    }
    /// All three, in the order of the cubics (7).
    pub const ALL;
    /// Letter of the unknown, and its name in files.
    pub fn words -> [&'static str; 2];
}

/// `2c` of (9): `3g - 2S`, the factor of the square root in the bracket.
pub fn opening_root_factor<T: Field>(at: &Abbreviations<T>) -> T {
    at.g.int(3) * &at.g - at.sin.int(2) * &at.sin
}

impl ClosedForm {
    /// The cubic (7) of which it is a root, with `delta_M` kept.
    pub fn cubic<T: Field>(self, at: &Abbreviations<T>, delta: &T, x: &T) -> T {
        match self {
            Self::OpeningVariable => cubic::in_opening_variable(at, delta, x),
            Self::Thickness => cubic::in_thickness(at, delta, x),
            Self::Thrust => cubic::in_thrust(at, delta, x),
        }
    }

    /// The closed form as printed, from a cube root `u` of [`ClosedForm::cube`]. The signs of (10) are printed the
    /// other way round, `∓`.
    pub fn value<T: Field>(self, at: &Abbreviations<T>, u: &T, k: &T) -> T {
        let k = match self {
            Self::Thickness => -k.clone(),
            _ => k.clone(),
        };
        let turn = k.int(1) + &k;
        let terms = turn.clone() / k.int(2) * self.product(at) / u + k.int(2) / turn * u;
        self.of_terms(at, terms)
    }

    /// The closed form from the sum of its two terms: `scale (shift + terms)`.
    pub fn of_terms<T: Field>(self, at: &Abbreviations<T>, terms: T) -> T {
        let Abbreviations { sin, f, g } = at;
        match self {
            Self::OpeningVariable => {
                let scale = g.clone() / (sin.clone() * opening_root_factor(at));
                scale * (f.clone() - g + terms)
            }
            Self::Thickness => (terms - (f.clone() + g)) / sin,
            Self::Thrust => (f.int(3) * f - g - sin.int(2) * sin + terms) / (sin.int(6) * sin),
        }
    }

    /// `P`, of which the modulus of `u` is the square root:
    ///
    /// ```text
    /// (9)   (f + g)² - f (g + 2S)
    /// (10)  (f + g)² + 4S (g - S)
    /// (11)  3f² + g² - 4S (2g - S)
    /// ```
    pub fn product<T: Field>(self, at: &Abbreviations<T>) -> T {
        let Abbreviations { sin, f, g } = at;
        let square = || (f.clone() + g).square();
        match self {
            Self::OpeningVariable => square() - (g.clone() + sin.int(2) * sin) * f,
            Self::Thickness => square() + sin.int(4) * sin * (g.clone() - sin),
            Self::Thrust => {
                f.int(3) * f.square() + g.square() - sin.int(4) * sin * (g.int(2) * g - sin)
            }
        }
    }

    /// `u³`, with `q` the square root of the radicand:
    ///
    /// ```text
    /// (9)   half of (g - f)(2(f + g)² + f(g - 6S)) + 2S(3g - 2S)² + (3g - 2S) SQRT
    /// (10)  (f + g)³ + 6gS (f + g) - 12fS² + 2S SQRT
    /// (11)  -g (9f² - g²) - 2S (9f (g - f) - 12g (g - S) - 4S²) + 3 (g - f) SQRT
    /// ```
    pub fn cube<T: Field>(self, at: &Abbreviations<T>, q: &T) -> T {
        let Abbreviations { sin, f, g } = at;
        let (sum, excess) = (f.clone() + g, g.clone() - f);
        match self {
            Self::OpeningVariable => {
                let inner = f.int(2) * sum.square() + (g.clone() - sin.int(6) * sin) * f;
                let factor = opening_root_factor(at);
                let bracket = excess * inner + sin.int(2) * sin * factor.square() + factor * q;
                bracket / f.int(2)
            }
            Self::Thickness => {
                let middle = g.int(6) * g * sin * &sum;
                sum.square() * &sum + middle - f.int(12) * f * sin.square() + sin.int(2) * sin * q
            }
            Self::Thrust => {
                let first = (f.int(9) * f.square() - g.square()) * g;
                let second = f.int(9) * f * &excess
                    - g.int(12) * g * (g.clone() - sin)
                    - sin.int(4) * sin.square();
                f.int(3) * excess * q - first - sin.int(2) * sin * second
            }
        }
    }
}
