//! Certified values of the finite-friction Couplet–Heyman problem.
//!
//! How thin can a symmetric circular masonry arch be and still stand under its own weight, when its
//! radial joints have only finite friction, and how does it fall at that thickness? The answer is a
//! map of seven collapse modes with a few landmark points. This crate computes the state of any arch
//! and the landmark points to any number of digits, each with a proof: that the solution exists, that
//! it is the only one in a box, that it is admissible, and that every digit shown is right.
//!
//! The problem and its equations are those of *Finite-friction least-thickness self-standing domains
//! of symmetric circular masonry arches, Part II: Milankovitch-like self-weight distribution*
//! (accepted preprint, 25 March 2025, University of Bergamo), "the paper" in all that follows.
//!
//! A program that certifies takes `default-features = false`; one that checks what others have certified
//! takes the crate `couplet-check`, pure Rust. The page `docs/features.md` of the
//! repository has all features, and what each costs.
#![doc = ""]
#![doc = include_str!("../docs/rust.md")]
//!
//! # Where an equation is
//!
//! | paper | code |
//! |---|---|
//! | normal force, shear force, line of thrust | [`arch::statics`] |
//! | (2), (3) thrust from the moments above and below a joint | [`arch::thrust::lower`], [`arch::thrust::upper`] |
//! | (4) thrust from the whole half arch, `A(alpha)` | [`arch::thrust::whole`], [`arch::thrust::opening_variable`] |
//! | (5) tangency at the intrados | [`arch::thrust::tangency`] |
//! | (6) centroid factor | [`arch::Ring`] |
//! | (7) cubics in `A`, `eta`, `h` | [`arch::cubic::in_opening_variable`], [`arch::cubic::in_thickness`], [`arch::cubic::in_thrust`] |
//! | (8) `f`, `g` and their link | [`arch::cubic::abbreviations`], [`arch::cubic::link`] |
//! | (9)–(11) closed forms | [`arch::closed_form`] |
//! | (12) radicand | [`arch::cubic::radicand`] |
//! | (13)–(15) purely overturning states | [`arch::overturning::opening_variable`], [`arch::overturning::thickness`] |
//! | (16) end of rotation, corrected | [`arch::overturning::end_of_rotation`] |
//! | (17) shoulder sliding | [`arch::sliding::shoulder`], [`arch::sliding::shoulder_thrust`] |
//! | (18) inner sliding | [`arch::sliding::inner`], [`arch::sliding::steepest`] |
//! | (2), (4), (5), (17), (18) where the half opening is small | [`arch::small`] |
//! | any of them at given values, to any number of digits | [`certify::equation`] |
//! | what is claimed of them, proved or refuted | [`claims`] |
//! | collapse modes, admissibility, least thickness | [`problem::Mode`], [`arch::contact`] |
//! | Tables 1–4, 16-digit values of the text | [`judge::published`] |
//!
//! # What is proved, and what is not
//!
//! Proved, for each landmark: the equations listed for it have exactly one solution in the stated box
//! (Krawczyk operator in ball arithmetic), the solution lies in the physical range, and each printed
//! value is the correct rounding of it, between outward bounds. For each state: the four parts of
//! [`certify::state`].
//!
//! Taken on trust: the compiler, GMP and MPFR, the hardware, and that the equations describe masonry.
#![cfg_attr(not(test), warn(clippy::unwrap_used))]

/// The program of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;

/// The crate rug 1: the numbers of GMP and MPFR that balls are made of. With rug 2 this crate would be another minor
/// version.
pub use rug;

pub use certify::{Error, Refused, Undecided};

pub use couplet_ask as ask;
pub use couplet_atlas as atlas;
pub use couplet_check::{arch, check, problem};
#[cfg(feature = "formats")]
pub use couplet_claims as claims;
#[doc(hidden)]
pub use couplet_draw::{picture, sketch};
pub use couplet_judge::{judge, strategies};
pub use couplet_lanes as lanes;
pub use couplet_number::{number, symbolic};
pub use couplet_prove::prelude;
#[doc(hidden)]
pub use couplet_prove::prover;
#[cfg(feature = "formats")]
pub mod report {
    //! Results in every format: [answers](couplet_report), [maps](couplet_charts), [pictures](couplet_pictures).

    pub use couplet_charts::*;
    pub use couplet_pictures::*;
    pub use couplet_report::*;
}
#[doc(hidden)]
pub use couplet_solve as solve;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub use couplet_study as study;
#[cfg(feature = "formats")]
#[doc(hidden)]
pub use couplet_sweep::{self as sweep, scene};

/// Proofs: of landmarks and states, of arches of stones, and of all arches between measured ends.
pub mod certify {
    pub use couplet_prove::certify::*;
    pub use couplet_stones::*;
    pub use couplet_survey as survey;
    pub use couplet_survey::certify_survey;
}

#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod cli;
#[cfg(feature = "formats")]
#[doc(hidden)]
pub mod door;
