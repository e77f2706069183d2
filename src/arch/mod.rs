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
//! | the seven collapse modes | [`Mode`] |
//! | landmark points, Tables 1–4 | [`Landmark`], [`System`], [`published`] |
//! | the same equations where the half opening is small | [`small`] |
//! | how often what was evaluated | [`tally`] |
//!
//! Lengths are in units of the centreline radius `r`, forces in units of `w r` (weight per unit
//! length of centreline times radius), angles in radians. No equation loops, compares or rounds:
//! code that needs to belongs to `solve` or `certify`.

pub mod closed_form;
pub mod contact;
pub mod cubic;
mod landmark;
mod mode;
pub mod overturning;
pub mod published;
mod quantity;
mod quotient;
pub mod sliding;
pub mod small;
pub mod statics;
mod system;
pub mod tally;
pub mod thrust;
mod weight;

pub use landmark::Landmark;
pub use mode::Mode;
pub use quantity::Quantity;
pub use quotient::Quotient;
pub use system::{Configuration, Equation, Fixed, Point, System, Unknown};
pub use weight::{Ring, SelfWeight};
