//! Starts of Newton's method: candidates good to a few digits, found without a table and not trusted.
//!
//! Why the root found is the admissible one. All states with hinges at the haunch lie where the line of
//! thrust touches the intrados. At a given thrust and thickness that happens at one joint only, because (5)
//! fixes `beta cot(beta)`, which falls strictly from 1 on `(0, pi)`. So the purely rotational states are one
//! curve (`rotation`); with a sliding inner joint, whose friction fixes the thrust, the thickness is the
//! zero of one growing function (`touch`). The proof that follows shows existence, admissibility and that no
//! thinner arch stands, whatever the start ([`arch::contact`](crate::arch::contact)).

mod landmark;
mod line;
mod quick;
mod rotation;
mod scale;
mod scaled;
mod sliding;
mod touch;
mod wide;

pub use landmark::landmark;
pub use line::on_line;
pub use quick::{QuickState, quick_state};
pub use rotation::{
    rotational, rotational_with_thickness, rotational_with_thrust, scaled_rotational,
    seems_to_rotate,
};
pub use scale::Start;
pub use scaled::{scaled_largest_thrust, scaled_shoulder_sliding, scaled_sliding};
pub use sliding::{inner_sliding, sliding};
pub use touch::{InnerStart, largest_thrust, rotational_sliding, touching_square_below};
pub use wide::{
    tangent_joint, widest_rotational, widest_sliding, widest_touching, widest_without_sliding,
};
