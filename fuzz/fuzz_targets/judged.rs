//! Whatever the results of another program: each row is judged, or what is wrong with it is told in one line.
#![no_main]

use couplet_fuzz::{is_told, rows};
use couplet_judge::judge::Demand;
use couplet_sweep::rows::{Judge, Purpose, Syntax};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let syntax = if bytes.starts_with(b"{") { Syntax::Json } else { Syntax::Csv };
    let Some((reader, rows)) = rows(syntax, Purpose::Judge, bytes) else { return };
    let judge = Judge { reader, demand: Demand::USUAL };
    // Each row that can be read has its proof.
    for row in judge.rows(rows.take(4).collect()) {
        let _ = row.outcome.map_err(is_told);
    }
});
