//! Whatever the bytes: the checker answers, without a panic, without hanging, in little memory. What it
//! refuses it names in one line.
#![no_main]

use couplet_check::check::check_file;
use couplet_number::number::AstroInterval;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Err(refusal) = check_file::<AstroInterval>(bytes, 40) {
        let words = refusal.to_string();
        assert!(!words.contains(char::is_control), "{words:?}");
        assert!(words.len() < 1000, "{} bytes of reason", words.len());
    }
});
