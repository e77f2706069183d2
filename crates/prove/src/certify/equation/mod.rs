//! Equations of the paper in balls: (7)–(12) at a rotational joint, and those that give a value.
//!
//! An equation is stated once, in [`arch`](crate::arch); here it is evaluated to any number of digits, each proved.
//!
//! | file | what it does |
//! |---|---|
//! | `closed` | (9)–(11) over any number, as printed and in trigonometric form |
//! | `polynomial` | the polynomials (7), and all of their real roots |
//! | `at_joint` | one equation at one joint, at one precision |
//! | `evaluated` | what is proved |
//! | `values` | (2)–(6) and (13)–(18) |

mod at_joint;
mod closed;
mod evaluated;
mod polynomial;
mod values;

pub use closed::{ClosedForm, RootBranch, Trigonometric, trigonometric};
pub use evaluated::{ClosedAt, Evaluated, LinkAt, PolynomialAt, RadicandAt, RootAt};
pub use values::{EquationValue, ValueEquation};

pub(crate) use at_joint::{solves, touched_thicknesses};

use self::at_joint::AtJoint;
use self::values::number;
use crate::arch::SelfWeight;
use crate::certify::CertifiedLandmark;
use crate::number::{Ball, Enclosure, ExactNumber, Ternary, bits_of};
use crate::problem::Landmark;
use crate::prover::{Error, Refused, Undecided, raise};
use crate::symbolic::Known;

/// An equation of the paper that is evaluated at a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointEquation {
    /// (7), the cubics in `A`, `eta` and `h`.
    Cubics,
    /// (8), the link of the abbreviations `f`, `g`, `S`, `C` and `beta`.
    Link,
    /// (9), the closed form of `A`.
    OpeningVariable,
    /// (10), the closed form of `eta`.
    Thickness,
    /// (11), the closed form of `h`.
    Thrust,
    /// (12), the radicand of the square root in (9)–(11).
    Radicand,
}

impl JointEquation {
    /// All of them, in the order of their numbers.
    pub const ALL: [Self; 6] = [
        Self::Cubics,
        Self::Link,
        Self::OpeningVariable,
        Self::Thickness,
        Self::Thrust,
        Self::Radicand,
    ];

    /// Number of the equation in the paper.
    pub fn number(self) -> u8 {
        match self {
            Self::Cubics => 7,
            Self::Link => 8,
            Self::OpeningVariable => 9,
            Self::Thickness => 10,
            Self::Thrust => 11,
            Self::Radicand => 12,
        }
    }

    /// Equation of a number, with its brackets or without.
    pub fn named(text: &str) -> Option<Self> {
        let number = number(text)?;
        Self::ALL.into_iter().find(|equation| equation.number() == number)
    }

    /// Closed form that the equation is, if it is one.
    pub fn closed_form(self) -> Option<ClosedForm> {
        match self {
            Self::OpeningVariable => Some(ClosedForm::OpeningVariable),
            Self::Thickness => Some(ClosedForm::Thickness),
            Self::Thrust => Some(ClosedForm::Thrust),
            Self::Cubics | Self::Link | Self::Radicand => None,
        }
    }
}

/// Bits beyond the digits asked for, at the first attempt.
const GUARD: u32 = 48;
/// Powers of a small joint that the equations lose to cancellation, at the most: a start only.
const POWERS_LOST: u32 = 12;

/// Evaluates an equation at an exact rotational joint, every value to `digits` significant digits.
///
/// Refused: a joint that is not between 0 and pi; a closed form of Heyman's weight, which the paper does not have,
/// or at a joint beyond the widest one, where its values are not real. Where the sign of (12) stays open, the roots
/// of (7) do, and the closed forms.
///
/// ```
/// use couplet_prove::prelude::*;
/// use couplet_prove::certify::equation::{Evaluated, JointEquation, evaluate};
/// let joint = "1.0".parse().unwrap();
/// let found = evaluate(JointEquation::Thickness, SelfWeight::Milankovitch, &joint, 12)?;
/// let Evaluated::Closed(_, branches) = found else { panic!() };
/// assert_eq!(branches[0].printed.to_string(), "0.142745381947");
/// # Ok::<(), couplet_prove::certify::Error>(())
/// ```
pub fn evaluate(
    equation: JointEquation,
    weight: SelfWeight,
    joint: &ExactNumber,
    digits: usize,
) -> Result<Evaluated, Error> {
    Refused::digits(digits)?;
    Refused::rotation_joint(joint)?;
    if equation.closed_form().is_some() && weight == SelfWeight::Heyman {
        return Err(Refused::ClosedFormOfHeyman.into());
    }
    let size: Ball = joint.enclosure(64);
    let small = size.mid().get_exp().unwrap_or(0).min(0).unsigned_abs();
    let first = bits_of(digits) + GUARD + POWERS_LOST * small;
    let at = |bits: u32| AtJoint { weight, joint: Known::angle(joint, bits), bits, digits };
    if equation.closed_form().is_some() {
        is_up_to_widest(weight, joint, |bits| at(bits).is_beyond_widest(), first)?;
    }
    let found = raise(first, |bits| {
        let at = at(bits);
        match (equation, equation.closed_form()) {
            (_, Some(form)) => at.closed(form),
            (JointEquation::Radicand, _) => at.radicand(),
            (JointEquation::Link, _) => at.link(),
            (_, None) => at.cubics(),
        }
    });
    match found {
        Err(open) if equation == JointEquation::Cubics => {
            let coefficients = |bits| Ok(at(bits).cubics_without_roots(&open));
            Ok(raise(first, coefficients).map_err(|_| open.clone())?)
        }
        found => Ok(found?),
    }
}

/// Bits with which a joint is compared with the widest one at first.
const COMPARED: u32 = 128;

/// Checks that a joint is not beyond the widest one: by the landmark, or next to it by the sign of (12).
fn is_up_to_widest(
    weight: SelfWeight,
    joint: &ExactNumber,
    by_sign: impl Fn(u32) -> Result<bool, Undecided>,
    first: u32,
) -> Result<(), Error> {
    let widest = CertifiedLandmark::new(Landmark::WidestJoint, weight)?.enclosure(COMPARED)?;
    let widest = &widest.configuration().rotation_joint.rad;
    let is_beyond = match joint.enclosure::<Ball>(COMPARED).is_less_than(widest) {
        Ternary::True => false,
        Ternary::False => true,
        Ternary::Undecided => raise(first, |bits| by_sign(bits).map(Some))?,
    };
    match is_beyond {
        true => Err(Refused::BeyondWidestJoint(joint.clone()).into()),
        false => Ok(()),
    }
}

#[cfg(test)]
mod tests;
