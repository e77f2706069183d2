//! Questions and answers of commands, for doors that are no command line.

pub use super::assess::QUESTION as ASSESS;
pub use super::certify::{
    ARCH as CERTIFY_ARCH, ASYMMETRIC as CERTIFY_ASYMMETRIC, STATE as CERTIFY_STATE,
    SURVEY as CERTIFY_SURVEY,
};
pub use super::complementarity::QUESTION as COMPLEMENTARITY;
pub use super::draw::QUESTION as DRAW;
pub use super::state::QUESTION as STATE;
pub use super::tilt::tilted;
pub use super::voussoirs::{QUESTION as VOUSSOIRS, divisions, of_stones};
