//! Sine and cosine of a short number by bit-burst.
//!
//! The number is cut into pieces of growing length, `y = r_1 + r_2 + …`, each a short number that is smaller the
//! longer it is (Brent 1976). The sine of a piece is summed by binary splitting; the last piece, which is
//! small, by Taylor's series; and the pieces are put together by products.

use super::small_angle::SmallAngle;
use super::turn::Turn;
use rug::Integer;

/// Each piece ends at this many times the bits at which the one before ended.
const GROWTH: u32 = 3;
/// The first piece ends here at the earliest.
const FIRST: u32 = 72;

/// The angle `y` in units of `2^-short`, below a quarter in size, as a turn of `places >= short` binary places. The
/// fewer bits `y` has, the faster.
pub(super) fn turn(y: &Integer, short: u32, places: u32) -> Turn {
    let mut rest = Integer::from(y.abs_ref());
    let mut turn = Turn::none(places);
    let mut end = GROWTH * (short - rest.significant_bits());
    while !rest.is_zero() {
        let small = short - rest.significant_bits();
        let piece = if u64::from(small) * series_from(places) > u64::from(places) {
            SmallAngle::by_series(&(std::mem::take(&mut rest) << (places - short)), places)
        } else {
            // A gap of zeros is skipped.
            while end <= small + small / 2 {
                end *= GROWTH;
            }
            let p = end.max(FIRST).min(short);
            let u = Integer::from(&rest >> (short - p));
            rest.keep_bits_mut(short - p);
            end = p.saturating_mul(GROWTH);
            SmallAngle::by_splitting(&u, p, places)
        };
        turn = turn.by_small(&piece);
    }
    if *y < 0 { turn.back() } else { turn }
}

/// Beyond this part of the places Taylor's series is faster for a rest so small; measured.
fn series_from(places: u32) -> u64 {
    match places {
        0..60_000 => 1000,
        60_000..600_000 => 500,
        _ => 300,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Magnitude;
    use proptest::prelude::*;
    use rug::Float;

    proptest! {
        #![proptest_config(crate::number::test_config::config(64))]
        /// Against MPFR at a higher precision: arguments of all lengths, with long runs of zeros too.
        #[test]
        fn the_true_values_are_held_and_close(
            head in any::<u64>(), gap in 0u32..2000, tail in any::<u32>(), negative in any::<bool>(), small in 2u32..200,
            places in 3000u32..40_000,
        ) {
            let y = (Integer::from(head) << (gap + 32)) + tail;
            let short = y.significant_bits() + small;
            prop_assume!(short <= places);
            let y = if negative { -y } else { y };
            let turn = turn(&y, short, places);
            let x = Float::with_val(y.significant_bits().max(2), &y) >> short;
            let (sin, cos) = (Float::with_val(places + 100, x.sin_ref()), Float::with_val(places + 100, x.cos_ref()));
            prop_assert!(turn.error < Magnitude::power_of_two(8 - i64::from(places)));
            let ours = turn.balls(places);
            for (ours, truth) in [(ours.0, sin), (ours.1, cos)] {
                prop_assert!(ours.lower() <= truth && truth <= ours.upper(), "{ours:?} {truth:.20}");
            }
        }
    }
}
