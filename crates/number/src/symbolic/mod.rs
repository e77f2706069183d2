//! Polynomials and fractions over the rationals: one more number, over which the equations of
//! `arch` evaluate to formulas.
//!
//! | idea | here |
//! |---|---|
//! | the letters of the paper | [`Symbol`] |
//! | sparse polynomials, derivations, evaluation | [`Polynomial`] |
//! | exact division, greatest common divisor, square-free part | `division.rs` |
//! | quotients, a [`Field`](crate::number::Field) | [`Fraction`] |
//! | numbers that are exact where they can be, else balls | [`Known`] |
//! | `S² + C² = 1` and square roots: normal forms | [`Relations`] |
//! | resultant with its cofactors, discriminant | [`eliminate`], [`discriminant`] |
//! | truncated power series, a field too | [`Series`] |
//! | text and LaTeX | [`Notation`] |
//!
//! Everything is exact. A zero normal form **proves** an identity wherever the relations hold and no
//! denominator vanishes; a non-zero one proves nothing by itself, see [`Relations`].

mod display;
mod division;
mod elimination;
mod fraction;
mod known;
mod letters;
mod polynomial;
mod relations;
mod series;
mod symbol;

pub use display::Notation;
pub use elimination::{Elimination, discriminant, eliminate};
pub use fraction::Fraction;
pub use known::Known;
pub use letters::Letters;
pub use polynomial::Polynomial;
pub use relations::{Relations, along_the_joint, along_the_opening};
pub use series::Series;
pub use symbol::Symbol;
