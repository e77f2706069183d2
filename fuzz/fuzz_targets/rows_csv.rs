//! Whatever the table of arches: each row is read, or what is wrong with it is told in one line.
#![no_main]

use couplet_fuzz::arches;
use couplet_sweep::rows::Syntax;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| arches(Syntax::Csv, bytes));
