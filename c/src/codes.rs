//! What functions return, and what stands in arrays.

use couplet::certify::batch::RowVerdict;
use std::ffi::c_int;

/// Everything asked was proved; also that an arch falls.
pub const COUPLET_PROVED: c_int = 0;
/// Something is undecided, or a certificate or a row of an array is refused.
pub const COUPLET_OPEN: c_int = 1;
/// The question makes no sense: `couplet_reason` says what was wrong and what is allowed.
pub const COUPLET_USAGE: c_int = 2;
/// Threads cannot be started, or a certificate has more digits than its checker is meant for.
pub const COUPLET_RESOURCE: c_int = 3;
/// A fault of couplet's own, which did not leave it.
pub const COUPLET_FAULT: c_int = 4;

/// For `couplet_text`: the bound below the value.
pub const COUPLET_LOWER: c_int = -1;
/// For `couplet_text`: the value, correctly rounded.
pub const COUPLET_VALUE: c_int = 0;
/// For `couplet_text`: the bound above the value.
pub const COUPLET_UPPER: c_int = 1;

/// In `verdict`: the arch stands, at some thickness or at the one that it has.
pub const COUPLET_STANDS: u8 = 0;
/// In `verdict`: it does not.
pub const COUPLET_FALLS: u8 = 1;
/// In `verdict`: nothing is known.
pub const COUPLET_UNDECIDED: u8 = 2;
/// In `verdict`: the row makes no sense: a number is none, or out of its range.
pub const COUPLET_REFUSED: u8 = 3;
/// In `mode`: there is none.
pub const COUPLET_NO_MODE: u8 = 255;

// The header has them as numbers.
const _: () = {
    assert!(COUPLET_STANDS == RowVerdict::Stands as u8 && COUPLET_FALLS == RowVerdict::Falls as u8);
    assert!(COUPLET_UNDECIDED == RowVerdict::Undecided as u8);
    assert!(COUPLET_REFUSED == RowVerdict::Refused as u8);
};
