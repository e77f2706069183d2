//! Statements that are proved of an equation.

use super::closed::RootBranch;
use crate::arch::closed_form::ClosedForm;
use crate::number::{Ball, Decimal, Enclosure, Rounded};
use crate::prover::{Figure, Undecided};

/// Result that is proved of an equation of the paper at given values.
#[derive(Clone, Debug)]
pub enum Evaluated {
    /// (2)–(6) and (13)–(18).
    Values(Vec<EquationValue>),
    /// (7): the polynomials in `A`, `eta` and `h`, in this order.
    Cubics(Vec<PolynomialAt>),
    /// (8): left side less right side.
    Link(Box<LinkAt>),
    /// (9), (10) or (11), upper signs first.
    Closed(ClosedForm, Vec<ClosedAt>),
    /// (12).
    Radicand(Box<RadicandAt>),
}

/// A value of an equation.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct EquationValue {
    /// Name in files.
    pub name: &'static str,
    /// Symbol of the paper.
    pub symbol: &'static str,
    /// The value.
    pub figure: Figure,
}

/// A polynomial (7) at a joint.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct PolynomialAt {
    /// Unknown of the polynomial, by the closed form that is a root of it.
    pub unknown: ClosedForm,
    /// Coefficients, that of the highest power first.
    pub coefficients: Vec<Figure>,
    /// Real roots, all of them in their order, or why they are not told apart.
    pub roots: Result<Vec<RootAt>, Undecided>,
}

impl PolynomialAt {
    /// Tells whether the other roots are complex; `None` if that is open.
    pub fn has_complex_pair(&self) -> Option<bool> {
        let roots = self.roots.as_ref().ok()?;
        Some(roots.len() + 1 < self.coefficients.len())
    }
}

/// A real root of a polynomial (7), alone in its box.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct RootAt {
    /// The root.
    pub value: Figure,
    /// Bounds of the polynomial on the enclosure of the root.
    pub residual: [Decimal; 2],
    /// Thickness that belongs to it: the root of the second cubic of the same state.
    pub thickness: Figure,
    /// Branch of the purely rotational state; `None` if its thickness is not between 0 and 2.
    pub branch: Option<RootBranch>,
}

/// The identity (8) at a joint.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct LinkAt {
    /// `S`, `f` and `g`.
    pub abbreviations: Vec<EquationValue>,
    /// Bounds of the left side less the right side.
    pub difference: [Decimal; 2],
    /// True if zero is between them.
    pub holds: bool,
}

/// A closed form at a joint with one of its signs.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ClosedAt {
    /// Branch of the signs.
    pub branch: RootBranch,
    /// Value as printed, from complex roots.
    pub printed: Figure,
    /// Bounds of its imaginary part, which is zero.
    pub imaginary: [Decimal; 2],
    /// Digits that the printed form loses to cancellation, at most.
    pub printed_loss: u32,
    /// Value of the trigonometric form.
    pub trigonometric: Figure,
    /// Digits that the trigonometric form loses, at most.
    pub trigonometric_loss: u32,
}

/// The radicand (12) at a joint.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct RadicandAt {
    /// The value.
    pub value: Figure,
    /// True if it is positive, as between the widest joint and a second zero beyond 2.5; it is not zero.
    pub is_positive: bool,
}

/// Digits of bounds.
const FEW: usize = 3;

/// Decimal bounds of a ball, rounded outward; `None` of the whole line.
pub(super) fn outward(x: &Ball) -> Option<[Decimal; 2]> {
    if !x.is_bounded() {
        return None;
    }
    let rounded = |end: rug::Float| Rounded::from_rational(&end.to_rational()?, FEW);
    Some([rounded(x.lower())?.lower, rounded(x.upper())?.upper])
}
