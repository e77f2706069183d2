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
//! (accepted preprint, 25 March 2025), "the paper" in all that follows.
//!
//! # A short tour
//!
//! Every equation is written once, over a number type. In `f64` it is a quick look:
//!
//! ```
//! use couplet::arch::{Ring, SelfWeight, thrust};
//! use couplet::number::Angle;
//!
//! let ring = Ring::new(SelfWeight::Milankovitch, &0.1);
//! let thrust = thrust::lower(&Angle::new(0.95), &ring).value();
//! assert!((thrust - 0.63).abs() < 0.01);
//! ```
//!
//! Over balls the same text encloses, over dual numbers it differentiates, over rationals it is
//! exact:
//!
//! ```
//! use couplet::arch::cubic;
//! use couplet::number::{Angle, Ball};
//! use rug::Rational;
//!
//! // Identity (8) at a rational point of the unit circle: exactly zero.
//! let joint = Angle { rad: Rational::from((7, 5)), sin: (3, 5).into(), cos: (4, 5).into() };
//! assert_eq!(cubic::link(&joint), 0);
//!
//! // And enclosed, at a real angle.
//! let joint = Angle::new(Ball::integer(1, 200));
//! assert!(cubic::link(&joint).contains(&Rational::from(0)));
//! ```
//!
//! A landmark is a square system of equations. [`certify::CertifiedLandmark::new`] finds its root and
//! proves it; there is no other way to get one:
//!
//! ```
//! use couplet::arch::{Landmark, Quantity, SelfWeight};
//! use couplet::certify::{CertifiedLandmark, Value};
//!
//! let triple = CertifiedLandmark::new(Landmark::Triple, SelfWeight::Milankovitch)?;
//! let constants = triple.constants(30, &|| ())?;
//! let thickness = constants.iter().find(|c| c.quantity == Quantity::Thickness).unwrap();
//! let Value::Finite(digits) = &thickness.value else { panic!() };
//! assert_eq!(digits.value.to_string(), "0.618318241074323446374432256517");
//! # Ok::<(), couplet::certify::Undecided>(())
//! ```
//!
//! And the state of any arch, from exact input:
//!
//! ```
//! use couplet::arch::{Mode, SelfWeight};
//! use couplet::certify::state::{Answer, Arch, Friction};
//!
//! let friction = Friction::Coefficient("0.38".parse()?);
//! let arch = Arch::new(SelfWeight::Heyman, "pi/2".parse()?, friction)?;
//! let Ok(Answer::Stands(state)) = arch.certify(12) else { panic!() };
//! assert_eq!(state.mode, Mode::SlidingRotational);
//! assert_eq!(state.thickness.decimal.value.to_string(), "0.122191586363");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Over polynomials the same equations are formulas, and an identity is proved by its normal form:
//!
//! ```
//! use couplet::arch::cubic;
//! use couplet::number::Field;
//! use couplet::symbolic::{Relations, Symbol, along_the_joint};
//!
//! let joint = Symbol::joint();
//! let slope = (joint.rad.clone() * &joint.sin).derivative(&along_the_joint());
//! let difference = slope - cubic::abbreviations(&joint).f;
//! assert!(difference.vanishes(&Relations::trigonometric())); // (8): f = (beta S)'
//! ```
//!
//! What is certified can be handed on with a proof that needs no solver to check:
//!
//! ```
//! use couplet::arch::{Landmark, SelfWeight};
//! use couplet::certify::certify_landmark;
//! use couplet::check::check;
//! use couplet::number::AstroInterval;
//!
//! let certificate = certify_landmark(Landmark::Border, SelfWeight::Heyman, 40)?;
//! let file = serde_json::to_vec(&certificate)?;
//! let accepted = check::<AstroInterval>(&file, 1000)?;
//! assert_eq!(accepted.digits, 40);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
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
//! | what is claimed of them, proved or refuted | [`claims`] |
//! | collapse modes, admissibility, least thickness | [`arch::Mode`], [`arch::contact`] |
//! | Tables 1–4, 16-digit values of the text | [`arch::published`] |
//!
//! # What is proved, and what is not
//!
//! Proved, for each landmark: the equations listed for it have exactly one solution in the stated box
//! (Krawczyk operator in ball arithmetic), the solution lies in the physical range, and each printed
//! value is the correct rounding of it, between outward bounds. For each state: the four parts of
//! [`certify::state`].
//!
//! Taken on trust: the compiler, GMP and MPFR, the hardware, and that the equations describe masonry.

pub mod arch;
#[cfg(feature = "full")]
pub mod certify;
pub mod check;
#[cfg(feature = "full")]
pub mod claims;
pub mod cli;
pub mod number;
#[cfg(feature = "full")]
pub mod report;
#[cfg(feature = "full")]
pub mod scene;
#[cfg(feature = "full")]
pub mod solve;
#[cfg(feature = "full")]
pub mod study;
#[cfg(feature = "full")]
pub mod symbolic;
