//! Kinematics of the collapse: how the rigid blocks of the half arch move.
//!
//! The unit of length is `r`, the origin is the centre, `x` points to the right and `y` up; the right half is meant.
//! Blocks are counted from the fixed shoulder to the crown. A joint at its limit ([`Contact`]) adds a relative
//! [`Twist`] "crown side less shoulder side", at a rate that is not negative; a block's twist is the sum of those
//! below it. The crown is a joint too: beyond it lies the axis of symmetry, which moves up and down and neither turns
//! nor moves sideways. So a motion has **two equations of compatibility**, the rotation and the horizontal velocity
//! behind the crown, [`Mechanism::gap`]. They are dual to the thrust and the crown moment of the statics.
//!
//! | file | what is in it |
//! |---|---|
//! | `twist` | the velocity of a rigid block, and the power of its weight |
//! | `contact` | how a joint is at its limit, and how it gives way |
//! | `modes` | the joints of each mode and their rates |
//! | `motion` | finite motions of the blocks, in closed form |
//!
//! Sliding is without dilatancy. With it, the flow rule associated to Coulomb's law, a joint that slides opens too;
//! then the slips are others, and the hinges turn as they do without.

mod contact;
mod modes;
mod motion;
mod twist;

pub use contact::{Contact, Joint};
pub use modes::{
    Mechanism, overturning, overturning_sliding, rotation, shoulder_sliding, sliding,
    sliding_above_haunch, sliding_below_haunch,
};
pub use motion::{
    Motion, moves_keystone, moves_overturning, moves_overturning_sliding, moves_rotating,
    moves_sliding, moves_sliding_above_haunch, moves_sliding_below_haunch,
    moves_with_shoulder_sliding,
};
pub use twist::Twist;
