//! Where the search for the state of an arch starts: doubles, good to a few digits.
//!
//! Why the root found is the admissible one. All states with hinges at the haunch lie where the line
//! of thrust touches the intrados. At a given thrust and thickness that happens at one joint only,
//! because (5) fixes `beta cot(beta)`, which falls strictly from 1 on `(0, pi)`. So
//!
//! - the purely rotational states are **one curve**, along which the thickness grows and the thrust
//!   falls strictly from `alpha = 0` to the end `l`; it is tabulated once and looked up by the half
//!   opening or by the thrust, both of which are monotone on it, with series at its two ends;
//! - with a sliding inner joint the friction fixes the thrust, and the thickness is the zero of one
//!   function of one variable, the gap between the moments about the touching joint and about the
//!   shoulder, which grows with the thickness: it is bracketed and bisected.
//!
//! None of this is trusted: the proof shows existence, admissibility of the whole arch, and that no
//! thinner arch stands.

mod curve;
mod ends;
mod quick;
mod scaled;
mod slide;
mod touch;

pub use curve::{rotational, rotational_with_thickness, rotational_with_thrust, seems_to_rotate};
pub use quick::{QuickState, quick_state};
pub use scaled::{
    scaled_largest_thrust, scaled_rotational, scaled_shoulder_sliding, scaled_sliding,
};
pub use slide::{inner_sliding, sliding};
pub use touch::{InnerStart, largest_thrust, rotational_sliding};

/// The least start value of a joint: nearer to zero Newton's method finds the way by halving.
const LEAST_JOINT: f64 = 1e-9;
