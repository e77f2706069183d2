//! Whatever the bytes of the plan of a sweep: it is read, or its faults are told, each in one line.
#![no_main]

use couplet_fuzz::is_told;
use couplet_sweep::scene::read_sweep;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Err(faults) = read_sweep(bytes) {
        assert!(!faults.is_empty(), "refused without a fault");
        faults.iter().for_each(|fault| is_told(&fault.message));
    }
});
