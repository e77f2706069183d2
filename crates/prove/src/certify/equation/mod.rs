//! Equations of the paper in balls: (7)–(12) at a rotational joint, and those that give a value.
//!
//! An equation is stated once, in [`arch`](crate::arch); here it is evaluated to any number of digits, each proved.
//!
//! | file | what it does |
//! |---|---|
//! | `numbered` | the table of the equations, and the values of (2)–(6) and (13)–(18) |
//! | `closed` | (9)–(11) over any number, in trigonometric form |
//! | `polynomial` | the polynomials (7), and all of their real roots |
//! | `at_joint` | one equation at one joint, at one precision |
//! | `evaluated` | what is proved |

mod at_joint;
mod closed;
mod evaluated;
mod numbered;
mod polynomial;

pub use crate::arch::closed_form::ClosedForm;
pub use closed::{RootBranch, Trigonometric, trigonometric};
pub use evaluated::{ClosedAt, EquationValue, Evaluated, LinkAt, PolynomialAt, RadicandAt, RootAt};
pub use numbered::NumberedEquation;

pub(crate) use at_joint::{solves, touched_thicknesses};

#[cfg(test)]
mod tests;
