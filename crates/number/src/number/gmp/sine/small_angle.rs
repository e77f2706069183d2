//! Sine and versine of a small angle in fixed point.

use super::product::square;
use super::rectangular::SineArgument;
use super::splitting;
use rug::Integer;

/// `sin d` and `vers d = 1 - cos d` in units of `2^-places`, below `2^-small` and `2^-(2 small)` in size.
pub(super) struct SmallAngle {
    pub sin: Integer,
    pub versine: Integer,
    pub small: u32,
}

/// Up to this many terms the versine by its own series is cheaper than by a square root.
const FEW_TERMS: u32 = 24;

impl SmallAngle {
    /// A bound of the errors of sine and versine, in units.
    pub(super) const ERROR: u64 = 3;

    /// `d` units of `2^-places`, `|d| < 1/4`; by Taylor's series.
    pub(super) fn by_series(d: &Integer, places: u32) -> Self {
        let Some(argument) = SineArgument::new(&Integer::from(d.abs_ref()), places) else {
            return Self { sin: Integer::new(), versine: Integer::new(), small: places };
        };
        let (sin, small) = (argument.sine(), argument.small());
        let versine = if 2 * small >= places {
            // Less than half a unit.
            Integer::new()
        } else if argument.terms() <= FEW_TERMS {
            argument.versine()
        } else {
            versine_of(&sin, places)
        };
        Self { sin: if *d < 0 { -sin } else { sin }, versine, small }
    }

    /// `u/2^p`, short and positive, below a quarter; by binary splitting.
    pub(super) fn by_splitting(u: &Integer, p: u32, places: u32) -> Self {
        let sin = splitting::sine(u, p, places);
        let versine = versine_of(&sin, places);
        Self { sin, versine, small: p - u.significant_bits() }
    }
}

/// `1 - sqrt(1 - s²)` in units of `2^-places`, for the sine of an angle below a quarter.
///
/// Error: three units of the sine move the cosine by the tangent, below 0.26, times as much; its square and the root
/// are rounded down, which is at most 0.52 and 1: less than three units.
fn versine_of(sine: &Integer, places: u32) -> Integer {
    let one = Integer::from(1) << places;
    let squared_cosine: Integer = &one - (square(sine) >> places);
    one - (squared_cosine << places).sqrt()
}

#[cfg(test)]
mod tests {
    use super::super::product::scrambled;
    use super::*;
    use proptest::prelude::*;
    use rug::Float;

    proptest! {
        #![proptest_config(crate::number::test_config::config(100))]
        #[test]
        fn the_errors_are_as_stated(
            places in 100u32..6000, small in 2u32..3000, seed in any::<u64>(), negative in any::<bool>(), split in any::<bool>(),
        ) {
            let small = small.min(places - 40);
            let bits = if split { (places - small).min(300) } else { places - small };
            let u = scrambled(seed, bits);
            let (ours, size) = match split {
                true => (SmallAngle::by_splitting(&u, small + bits, places), Float::with_val(places, &u) >> (small + bits)),
                false => {
                    let d = if negative { Integer::from(-&u) } else { u.clone() };
                    (SmallAngle::by_series(&d, places), Float::with_val(places, &d) >> places)
                }
            };
            prop_assert_eq!(ours.small, small);
            let high = 2 * places + 100;
            let (sin, cos) = (Float::with_val(high, size.sin_ref()), Float::with_val(high, size.cos_ref()));
            let off = |ours: &Integer, truth: Float| Float::with_val(64, (truth << places) - ours).abs();
            prop_assert!(off(&ours.sin, sin) < SmallAngle::ERROR);
            prop_assert!(off(&ours.versine, 1 - cos) < SmallAngle::ERROR);
        }
    }
}
