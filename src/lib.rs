//! couplet
pub mod arch;
pub mod certify;
pub mod number;
pub mod solve;
