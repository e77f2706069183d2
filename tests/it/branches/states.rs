//! Certified states on either side of `l` lie next to the common tangent.

use super::{BITS, Tangent};
use crate::arches::at_landmark;
use crate::hard::{config, weights};
use couplet::arch::{SelfWeight, Unknown, thrust};
use couplet::certify::state::{Certify, Outcome};
use couplet::number::{Angle, Ball};
use couplet::problem::{Arch, Friction, Landmark, Mode};
use proptest::prelude::*;
use rug::{Rational, ops::Pow};

/// The purely rotational or overturning state at a half opening `step` away from that of `l`.
fn state(weight: SelfWeight, step: &Rational) -> (Ball, couplet::certify::state::State) {
    let alpha = at_landmark(Landmark::RotationEnd, weight, Unknown::HalfOpening, BITS);
    let alpha = alpha.mid().to_rational().unwrap() + step;
    let text = format!("{}/{}", alpha.numer(), alpha.denom());
    let arch = Arch::new(weight, text.parse().unwrap(), Friction::Infinite).unwrap();
    let proved = [BITS, 2 * BITS, 4 * BITS].into_iter().find_map(|bits| arch.state(bits).ok());
    let Some(Outcome::Stands(state)) = proved else { panic!("{weight:?} {step}") };
    let a = thrust::opening_variable(&Angle::new(Ball::enclosing(&alpha, BITS))).value();
    (a, *state)
}

proptest! {
    #![proptest_config(config(24))]

    #[test]
    fn states_on_either_side_follow_one_tangent(
        weight in weights(), wider in any::<bool>(), mantissa in 1i32..1000, places in 7u32..60,
    ) {
        let size = Rational::from(mantissa) / rug::Integer::from(10).pow(places);
        let step = if wider { size } else { -size };
        let (a, state) = state(weight, &step);
        let side = if wider { Mode::Overturning } else { Mode::Rotational };
        prop_assert_eq!(state.mode, side);
        let tangent = Tangent::at_end(weight);
        let gap = tangent.gap(&a, &state.thickness);
        prop_assert!(tangent.holds(&a, &state.thickness), "{:?}: {:?}", weight, gap);
        // The thrust joins with the slope zero.
        prop_assert!(tangent.is_flat(&a, &state.thrust));
        if places > 10 {
            let twin = tangent.turned();
            prop_assert!(!twin.holds(&a, &state.thickness), "a slope off by a thousandth is seen");
        }
    }
}
