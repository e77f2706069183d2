//! couplet
pub mod arch;
pub mod certify;
pub mod cli;
pub mod number;
pub mod report;
pub mod solve;
