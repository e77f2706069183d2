//! Number of rows that make a part: about two seconds of work, whatever the machine makes of it.

use crate::scene::{SweepArches, SweepPlan};

/// Proofs of single arches that take about two seconds: 15 µs each.
const PART: f64 = 130_000.0;
/// A part of a short sweep takes a tenth of a second at least.
const SMALLEST: f64 = 6_500.0;
/// The most rows of a part that nobody asks for: it is held in memory, in about 600 bytes a row.
const ROWS: f64 = 250_000.0;
/// Parts that a short sweep is divided among.
const PARTS: f64 = 64.0;
/// The most parts of a sweep: they are listed.
pub(super) const MAX_PARTS: u64 = 1_000_000;
/// Cost of a half opening, paid once, and each of its frictions, in single arches: most share what is proved
/// once. Measured on 400 half openings by 1,000 frictions.
const COLUMN: f64 = 3.0;
const SHARED: f64 = 0.1;
/// Digits up to which balls of double-doubles are enough.
const SHORT: usize = 25;

/// The most rows of a part.
pub(super) fn rows_of_a_part(plan: &SweepPlan) -> u64 {
    if let Some(chunk) = plan.chunk {
        return chunk as u64;
    }
    // Of numbers of MPFR, by and large.
    let longer = if plan.digits > SHORT { 8.0 + plan.digits as f64 / 50.0 } else { 1.0 };
    let part = |work: f64| (work / PARTS).clamp(SMALLEST, PART);
    let rows = match &plan.arches {
        SweepArches::Grid { half_openings, frictions } => {
            let is_shared = !plan.quantities.iter().any(|of| of.is_friction());
            let frictions = frictions.len() as f64;
            let column = if is_shared { COLUMN + SHARED * frictions } else { frictions } * longer;
            let columns = (half_openings.len() * plan.weights.len()) as f64;
            let together = (part(columns * column) / column).min(ROWS / frictions).floor().max(1.0);
            // A column that is too long is divided.
            (together * frictions).min(ROWS)
        }
        SweepArches::Sample { count, .. } => part(*count as f64 * longer) / longer,
        // How long files are is not known before they are read.
        SweepArches::Data { .. } => PART / longer,
    };
    (rows as u64).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::read_sweep;

    #[test]
    fn a_part_is_about_two_seconds_and_a_short_sweep_has_several() {
        let rows = |rest: &str| {
            let text = format!("schema = \"couplet.sweep/1\"\n{rest}\n");
            rows_of_a_part(&read_sweep(text.as_bytes()).unwrap())
        };
        assert_eq!(rows("[sample]\ncount = 100_000_000"), 130_000);
        assert_eq!(rows("[sample]\ncount = 800_000"), 12_500);
        assert_eq!(rows("[sample]\ncount = 100"), 6_500);
        assert_eq!(rows("digits = 1000\n[sample]\ncount = 100_000_000"), 4_642);
        assert_eq!(rows("chunk = 7\n[sample]\ncount = 100"), 7);
        let grid = |steps: usize, frictions: usize| {
            let range = |steps| format!("{{ from = 0.01, to = 3, steps = {steps} }}");
            let (alpha, mu) = (range(steps), range(frictions));
            rows(&format!("[grid]\nhalf_opening = {alpha}\nfriction = {mu}"))
        };
        assert_eq!(grid(400, 1000), 63_000);
        assert_eq!(grid(100_000, 1000), 250_000);
        assert_eq!(grid(1000, 100_000), 200_000);
        assert_eq!(rows("[data]\nfiles = \"a\""), 130_000);
    }
}
