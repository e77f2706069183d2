//! The paper: every equation once, over the weakest number that carries it.
//!
//! | paper | here |
//! |---|---|
//! | statics of the half arch | [`statics`] |
//! | (2)–(5), `A(alpha)` | [`thrust`] |
//! | (6) | [`Ring`] |
//! | (7), (8), (12) | [`cubic`] |
//! | (9)–(11) | [`closed_form`] |
//! | (13)–(16) | [`overturning`] |
//! | (17), (18) | [`sliding`] |
//! | the same in angles, without roots | [`cycloid`] |
//! | (2)–(5) by the square of the joint | [`haunch`] |
//! | (2), (4), (5), (17) of flat arches | [`flat`] |
//! | (19), (20), the conditions at one joint | [`joint`] |
//! | the same on the whole arch, with a vertical force in the crown | [`whole`] |
//! | asymmetric solutions of (19) | [`asymmetric`] |
//! | the same equations where the half opening is small | [`small`] |
//! | admissibility, least thickness | [`contact`] |
//! | lines of thrust beyond the faces of a thinner arch | [`beyond`] |
//! | the same under a horizontal acceleration | [`tilt`] |
//! | how the blocks move at collapse | [`mechanism`] |
//!
//! Lengths are in units of the centreline radius `r`, forces in units of `w r` (weight per unit
//! length of centreline times radius), angles in radians. No equation loops, compares or rounds:
//! code that needs to belongs to `solve` or `certify`. What is asked of the equations, landmarks and
//! collapse modes, is in [`problem`](crate::problem).

pub mod asymmetric;
pub mod beyond;
pub mod closed_form;
pub mod contact;
pub mod cubic;
pub mod cycloid;
pub mod flat;
pub mod haunch;
pub mod joint;
pub mod mechanism;
pub mod overturning;
mod quotient;
pub mod sliding;
pub mod small;
pub mod statics;
pub mod thrust;
pub mod tilt;
mod variables;
mod weight;
pub mod whole;

pub use quotient::Quotient;
pub use variables::{Configuration, Unknown};
pub use weight::{NoWeight, PerWeight, Ring, SelfWeight};
