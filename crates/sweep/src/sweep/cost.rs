//! Number of rows that make a part: at most half a minute of work if the sweep has many, on any machine of today.

use crate::scene::{SweepArches, SweepRecord};

/// Proofs of single arches that take half a minute one by one: 15 µs each. A part has then 60 to 200 MB.
const PART: f64 = 2_000_000.0;
/// A part of a short sweep takes a tenth of a second at least, one by one.
const SMALLEST: f64 = 6_500.0;
/// Parts that a sweep is divided among, until they are as large as parts are.
const PARTS: f64 = 64.0;
/// Cost of a half opening, paid once, and each of its frictions, in single arches: most share what is proved
/// once. Measured on 400 half openings by 1,000 frictions.
const COLUMN: f64 = 3.0;
const SHARED: f64 = 0.1;
/// Digits up to which balls of double-doubles are enough.
const SHORT: usize = 25;
/// Bytes of a row of a file, by and large: how many rows it has is not known before it is read.
const ROW: f64 = 30.0;

/// The most rows of a part; the files of a data set have so many bytes.
pub(super) fn rows_of_a_part(plan: &SweepRecord, bytes: u64) -> u64 {
    if plan.chunk > 0 {
        return plan.chunk;
    }
    // Of numbers of MPFR, by and large.
    let longer = if plan.digits > SHORT { 8.0 + plan.digits as f64 / 50.0 } else { 1.0 };
    let part = |work: f64| (work / PARTS).clamp(SMALLEST, PART);
    let rows = match &plan.arches {
        SweepArches::Grid { half_opening, friction } => {
            let is_shared = !plan.quantities.iter().any(|of| of.is_friction());
            let frictions = friction.len() as f64;
            let column = if is_shared { COLUMN + SHARED * frictions } else { frictions } * longer;
            let columns = (half_opening.len() * plan.weights.len()) as f64;
            let part = part(columns * column);
            match part < column {
                // A column that is too long is divided.
                true => (frictions * part / column).max(1.0),
                false => (part / column).floor() * frictions,
            }
        }
        SweepArches::Sample { .. } => part(plan.rows as f64 * longer) / longer,
        SweepArches::Data { .. } => part(bytes as f64 / ROW * longer) / longer,
    };
    (rows as u64).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::read_sweep;

    #[test]
    fn a_part_is_half_a_minute_and_a_short_sweep_has_several() {
        let rows = |rest: &str, bytes: u64| {
            let text = format!("schema = \"couplet.sweep/1\"\n{rest}\n");
            rows_of_a_part(&read_sweep(text.as_bytes()).unwrap().0, bytes)
        };
        let sample = |count: &str| rows(&format!("[sample]\ncount = {count}"), 0);
        assert_eq!(sample("1_000_000_000"), 2_000_000);
        assert_eq!(sample("800_000"), 12_500);
        assert_eq!(sample("100"), 6_500);
        assert_eq!(rows("digits = 1000\n[sample]\ncount = 100_000_000", 0), 71_428);
        assert_eq!(rows("chunk = 7\n[sample]\ncount = 100", 0), 7);
        let grid = |steps: usize, frictions: usize| {
            let range = |steps| format!("{{ from = 0.01, to = 3, steps = {steps} }}");
            let (alpha, mu) = (range(steps), range(frictions));
            rows(&format!("[grid]\nhalf_opening = {alpha}\nfriction = {mu}"), 0)
        };
        assert_eq!(grid(400, 1000), 63_000);
        assert_eq!(grid(10_000, 10_000), 1_560_000);
        assert_eq!(grid(100_000, 100_000), 19_900_000);
        assert_eq!(grid(2, 100_000), 64_980);
        assert_eq!(rows("[data]\nfiles = \"a\"", 0), 6_500);
        assert_eq!(rows("[data]\nfiles = \"a\"", 30_000_000), 15_625);
    }
}
