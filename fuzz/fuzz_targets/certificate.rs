//! Whatever the bytes: the checker answers, without a panic, without hanging, in little memory. What it
//! refuses it names in one line.
#![no_main]

use couplet_check::check::check_file;
use couplet_fuzz::is_told;
use couplet_number::number::AstroInterval;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let _ = check_file::<AstroInterval>(bytes, 40).map_err(is_told);
});
